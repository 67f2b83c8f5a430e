#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""dbc.py PROGRAM: lets canmatrix read the DBC that PROGRAM (canproof) writes for each device, and decode frames of the manuals by this
DBC.

Frames and values are written by hand. Sources: CAN-CBX-AO412, 7.9.2 (device type 191h with 0008h) and 7.10.2.3 (3EB3h
is 5.0 V, C14Dh -5.0 V). AX188001: two INTEGER16 in TPDO 1. CiA 301 for the rest.
"""
import os
import subprocess
import sys
import tempfile

import canmatrix.formats

PROGRAM = sys.argv[1]
NODE = 3
faults = []


def device_names():
    """Returns the names of the catalogue: the words at the beginning of a line of `canproof devices`, below its heading."""
    lines = subprocess.run([PROGRAM, "devices"], stdout=subprocess.PIPE, text=True, check=True).stdout.splitlines()[1:]
    return [line.split()[0] for line in lines if line[:1].strip()]


def matrix_of(device, folder):
    path = os.path.join(folder, device + ".dbc")
    with open(path, "w", encoding="ascii") as out:
        subprocess.run([PROGRAM, "eds", device, "--format", "dbc", "--node", str(NODE)], stdout=out, check=True)
    return canmatrix.formats.loadp_flat(path)


def decode(matrix, identifier, data):
    frame = matrix.frame_by_id(canmatrix.ArbitrationId(identifier, extended=False))
    assert frame is not None, f"no frame {identifier:03X}h"
    return frame.decode(bytes.fromhex(data))


def expect(what, found, wanted):
    if found != wanted:
        faults.append(f"{what}: {found}, not {wanted}")


def check_every(device, matrix):
    expect(f"{device}: load errors", matrix.load_errors, [])
    names = [frame.name for frame in matrix.frames]
    expect(f"{device}: names", len(set(names)), len(names))
    state = decode(matrix, 0x700 + NODE, "7F")["State"]
    expect(f"{device}: heartbeat 7Fh", (state.raw_value, state.named_value), (127, "pre-operational"))
    error = decode(matrix, 0x080 + NODE, "3081110000000000")
    expect(f"{device}: EMCY 8130h", (error["ErrorCode"].raw_value, error["ErrorRegister"].raw_value), (0x8130, 0x11))


def the_only(decoded, prefix):
    found = [signal for name, signal in decoded.items() if name.startswith(prefix)]
    return found[0].raw_value if len(found) == 1 else found


def check_telegrams(matrices):
    cbx = matrices["cbx-ao412"]
    expect("1000h", the_only(decode(cbx, 0x583, "4300100091010800"), "x1000_00_"), 0x00080191)
    expect("6411h:01", the_only(decode(cbx, 0x603, "2B116401B33E0000"), "x6411_01_"), 0x3EB3)
    outputs = decode(cbx, 0x303, "B33E4DC100000100")
    expect("RPDO 2", [signal.raw_value for signal in outputs.values()], [0x3EB3, 0xC14D - 0x10000, 0, 1])
    inputs = decode(matrices["ax188001"], 0x183, "FFFF0200")
    expect("TPDO 1", [signal.raw_value for signal in inputs.values()], [-1, 2])


with tempfile.TemporaryDirectory() as scratch:
    all_matrices = {device: matrix_of(device, scratch) for device in device_names()}
for name, one in all_matrices.items():
    check_every(name, one)
check_telegrams(all_matrices)
for fault in faults:
    print(fault, file=sys.stderr)
print(f"{len(all_matrices)} databases, {sum(len(one.frames) for one in all_matrices.values())} frames, {len(faults)} fault(s)")
sys.exit(1 if faults else 0)
