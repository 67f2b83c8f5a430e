#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""remap.py PROGRAM: remaps a PDO of each device and saves the mapping, with the frames that python-canopen would send by the data sheet.

python-canopen is not in Debian. Its behaviour that matters here:
- python-canopen reads integers of a data sheet with a base prefix or as decimals, reals as decimals, `$NODEID+…` as a sum.
- python-canopen takes the mapping entries from the RECORD in the data sheet. Of an ARRAY, it visits as many entries as sub-index 0
  contains, which it has just set to 0. So it cannot remap a PDO of such a data sheet.
- python-canopen makes the PDO invalid. Then it writes transmission type, inhibit time and event time if they are writable.
- Then python-canopen sets the number of entries to 0, writes the entries, sets their number, and makes the PDO valid again.
The frames go through `canproof replay`, so the test needs neither a socket nor wall time. A second replay with the same memory is the next
power-on. The expected answers are those of CiA 301: 60h for a download, 4xh with the value for an upload.
"""
import configparser
import re
import subprocess
import sys
import tempfile

PROGRAM = sys.argv[1]
NODE = 5
INVALID = 0x80000000
# For each device: PDO communication object, mapping object, and the entries to map: those of the data sheet in another order.
CASES = {
    "ax130751": (0x1800, 0x1A00, [0x23700210, 0x23700110]),
    "ax188001": (0x1800, 0x1A00, [0x71300210, 0x71300110]),
    "ax060805": (0x1800, 0x1A00, [0x40400010, 0x40300010, 0x40500010]),
    "cbx-ao412": (0x1401, 0x1601, [0x64110410, 0x64110310, 0x64110210, 0x64110110]),
}
WIDTH = {0x05: 1, 0x06: 2, 0x07: 4}  # UNSIGNED8, UNSIGNED16, UNSIGNED32
REALS = (0x08, 0x11)
TEXTS = (0x09, 0x0A, 0x0F)


def number(text):
    """Returns an integer of the data sheet. `$NODEID+…` gives the sum with the node-ID."""
    term = re.fullmatch(r"\$NODEID\s*\+\s*(\w+)", text, re.IGNORECASE)
    return NODE + int(term.group(1), 0) if term else int(text, 0)


def read_sheet(device, form):
    """Returns every entry of the sheet by (index, sub-index). Refuses what python-canopen would refuse."""
    text = subprocess.run([PROGRAM, "eds", device, "--format", form], check=True, capture_output=True, text=True).stdout
    sheet = configparser.RawConfigParser()
    sheet.optionxform = str
    sheet.read_string(text)
    entries = {}
    for name in sheet.sections():
        found = re.fullmatch(r"([0-9A-F]{4})(?:sub([0-9A-F]+))?", name)
        if not found:
            continue
        section = sheet[name]
        index, sub = int(found.group(1), 16), int(found.group(2) or "0", 16)
        if section["ObjectType"] in ("0x8", "0x9"):
            entries[index, None] = section["ObjectType"]
            continue
        kind = int(section["DataType"], 0)
        if kind in REALS and form == "eds":
            float(section["DefaultValue"])
            assert "LowLimit" not in section and "HighLimit" not in section, f"{name}: a limit of a real"
        elif kind in REALS:
            int(section["DefaultValue"], 0)
        elif kind not in TEXTS:
            for key in ("DefaultValue", "LowLimit", "HighLimit"):
                if key in section:
                    number(section[key])
        entries[index, sub] = section
    return entries


class Session:
    """Frames of a client, 10 ms apart, and the expected answer to each."""

    def __init__(self):
        self.frames = []
        self.answers = []

    def request(self, data, answer):
        self.frames.append(f"({0.5 + 0.01 * len(self.frames):.6f}) can0 {0x600 + NODE:03X}#{data.hex().upper()}")
        self.answers.append((0x580 + NODE, answer))

    def write(self, index, sub, value, width):
        multiplexer = index.to_bytes(2, "little") + bytes([sub])
        command = 0x23 | (4 - width) << 2
        self.request(bytes([command]) + multiplexer + value.to_bytes(width, "little").ljust(4, b"\0"),
                     b"\x60" + multiplexer + bytes(4))

    def read(self, index, sub, value, width):
        multiplexer = index.to_bytes(2, "little") + bytes([sub])
        self.request(b"\x40" + multiplexer + bytes(4),
                     bytes([0x43 | (4 - width) << 2]) + multiplexer + value.to_bytes(width, "little").ljust(4, b"\0"))

    def play(self, device, memory):
        command = [PROGRAM, "replay", device, "--node", str(NODE), "--nvm", memory, "-"]
        run = subprocess.run(command, input="\n".join(self.frames) + "\n", capture_output=True, text=True)
        assert run.returncode == 0, run.stderr
        heard = [line.split()[2] for line in run.stdout.splitlines() if line.startswith("(")]
        got = [one for one in heard if one.startswith(f"{0x580 + NODE:03X}#")]
        wanted = [f"{identifier:03X}#{data.hex().upper()}" for identifier, data in self.answers]
        assert got == wanted, f"{device}: {next(pair for pair in zip(got + [None], wanted + [None]) if pair[0] != pair[1])}"


def remap(device, memory):
    entries = read_sheet(device, "eds")
    read_sheet(device, "eds-lely")
    communication, mapping, wanted = CASES[device]
    assert entries[mapping, None] == "0x9", f"{mapping:04X}h is no RECORD"
    cob_id = number(entries[communication, 1]["DefaultValue"])
    first = Session()
    first.write(communication, 1, cob_id | INVALID, 4)
    for sub in (2, 3, 5):
        entry = entries.get((communication, sub))
        if entry is not None and entry["AccessType"] == "rw":
            first.write(communication, sub, number(entry["DefaultValue"]), WIDTH[int(entry["DataType"], 0)])
    first.write(mapping, 0, 0, 1)
    for sub, value in enumerate(wanted, start=1):
        first.write(mapping, sub, value, 4)
    first.write(mapping, 0, len(wanted), 1)
    first.write(communication, 1, cob_id & ~INVALID, 4)
    first.write(0x1010, 1, int.from_bytes(b"save", "little"), 4)
    first.play(device, memory)
    again = Session()
    again.read(mapping, 0, len(wanted), 1)
    for sub, value in enumerate(wanted, start=1):
        again.read(mapping, sub, value, 4)
    again.read(communication, 1, cob_id & ~INVALID, 4)
    again.play(device, memory)
    return sum(1 for key in entries if key[1] is not None)


def main():
    with tempfile.TemporaryDirectory() as folder:
        for device in CASES:
            count = remap(device, f"{folder}/{device}.nvm")
            print(f"{device}: {count} entries read; {CASES[device][1]:04X}h remapped, saved, kept")


main()
