#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""tests/foreign/pcapng.py PROGRAM: reads with tshark the files that canproof (PROGRAM) writes with `--log FILE.pcapng` and `--log
FILE.pcap`. Each frame must have the identifier, flags, length and data that it had on the bus, in pcapng the direction as well, and times
must not decrease. Installs tshark if it is missing."""
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile

program = str(pathlib.Path(sys.argv[1]).resolve())
REQUESTS = "603#4000100000000000\n603#4018100400000000\n703#R\n1FFFFF03#0102\n7FF#\n"
FIELDS = ["frame.time_epoch", "can.id", "can.flags.xtd", "can.flags.rtr", "can.len", "data.data",
          "frame.interface_name", "frame.packet_flags_direction"]


def install():
    print("installing: tshark")
    as_root = [] if os.geteuid() == 0 else ["sudo"]
    subprocess.run([*as_root, "env", "DEBIAN_FRONTEND=noninteractive", "apt-get", "install", "-y", "-qq",
                    "--no-install-recommends", "tshark"], check=True, stdout=subprocess.DEVNULL)


def run(*words):
    """Runs one device on the in-process bus for half a second, with the requests as its input."""
    subprocess.run([program, "run", "cbx-ao412@3", "--plain", "--seconds", "0.5", *words], input=REQUESTS, text=True,
                   check=True, stdout=subprocess.PIPE)


def read(path):
    """Returns for each frame in the file `path` the values of FIELDS, as tshark prints them."""
    fields = [word for field in FIELDS for word in ("-e", field)]
    said = subprocess.run(["tshark", "-n", "-r", str(path), "-T", "fields", "-E", "separator=/t", *fields],
                          check=True, capture_output=True, text=True).stdout
    return [line.split("\t") for line in said.splitlines()]


def truth(text):
    return text in ("1", "True")


def check(path):
    """Checks the frames of one run, logged to this path. Returns their number."""
    run("--log", str(path))
    frames = read(path)
    seen = {(int(f[1], 0), truth(f[2]), truth(f[3]), int(f[4] or 0), f[5]) for f in frames}
    times = [float(f[0]) for f in frames]
    expected = {(0x703, False, False, 1, "00"), (0x603, False, False, 8, "4000100000000000"),
                (0x583, False, False, 8, "4300100091010800"), (0x703, False, True, 0, ""),
                (0x1FFFFF03, True, False, 2, "0102"), (0x7FF, False, False, 0, "")}
    assert expected <= seen, (path.name, expected - seen)
    assert times == sorted(times) and times[-1] < 1.0, times
    if path.suffix == ".pcapng":
        assert {f[6] for f in frames} == {"inproc"}, frames
        for f in frames:
            own = int(f[1], 0) in (0x583, 0x703) and not truth(f[3])
            assert int(f[7], 0) == (2 if own else 1), f  # outbound, inbound
    return len(frames)


with tempfile.TemporaryDirectory() as name:
    if shutil.which("tshark") is None:
        install()
    counts = [check(pathlib.Path(name) / file) for file in ("run.pcapng", "run.pcap")]
print(f"{counts[0]} frames of pcapng and {counts[1]} of pcap, as they were sent")
