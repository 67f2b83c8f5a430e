#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""tests/program/inputs.py PROGRAM: runs PROGRAM (canproof) with real logs, real times and values out of range."""
import pathlib
import sys
import tempfile

sys.dont_write_bytecode = True
from expectations import canproof, expect, finish

EPOCH = "(1436509052.249713) vcan0 603#4000100000000000\n"
HEADING = "seconds,signal,value\n"


def replay(log, *words):
    return canproof("replay", *words, input=log)


def refused(log, says, *words):
    result = replay(log, *words)
    expect(result.returncode == 2 and says in result.stderr, f"{words}: {result.returncode}, {result.stderr!r}")


def logs_of_the_clock():
    """Checks a log of `candump -L`, whose times are times of day: replay must start at the time of the first frame and print this time."""
    result = replay(EPOCH, "ax060805", "--node", 3, "-")
    expect(result.returncode == 0, f"a log of the clock: {result.stderr!r}")
    expect("power-on is at 1436509052.249713" in result.stderr, f"nothing of the start in {result.stderr!r}")
    lines = result.stdout.splitlines()
    expect(len(lines) == 2 and lines[0] == "(1436509052.249713) vcan0 703#00" and " 583#43001000" in lines[1],
           f"a log of the clock gives {lines}")
    result = replay(EPOCH, "cbx-ao412", "--node", 3, "--start", "1436509050", "-")
    expect(result.stdout.startswith("(1436509050.000000) vcan0 703#00\n(1436509052.249713) vcan0 583#"),
           f"--start: {result.stdout!r}")
    result = replay(EPOCH, "cbx-ao412", "--node", 3, "--start", "0", "-")
    expect(result.returncode == 0 and "leaves out 1436505452 s" in result.stderr, f"--start 0: {result.stderr!r}")
    refused(EPOCH, "before the start", "cbx-ao412", "--until", "5", "-")


def what_candump_writes():
    """Checks a log with error frames, length codes and a byte order mark: replay must count or skip these and answer all other frames."""
    log = ("\ufeff(1.0) can0 20000004#0001000000000000\n(1.1) can0 603#4000100000000000_F\n"
           "(1.2) can0 20000080#0000000000000000\n")
    result = replay(log, "cbx-ao412", "--node", 3, "-")
    expect(result.returncode == 0 and "(1.100000) can0 583#4300100091010800" in result.stdout,
           f"error frames and length codes: {result.stderr!r}")
    expect("2 error frame(s)" in result.stderr and "1 frame(s) with a length code" in result.stderr,
           f"no count in {result.stderr!r}")


def times_out_of_range():
    for value in ("nan", "-1", "1e300", "inf", "x", "-nan", "4000000001"):
        refused("", "is no time from 0 to", "cbx-ao412", f"--until={value}", "-")
        refused("", "is no time from 0 to", "cbx-ao412", f"--start={value}", "-")
        result = canproof("run", "cbx-ao412", f"--seconds={value}")
        expect(result.returncode == 2 and "is no time from 0 to" in result.stderr, f"--seconds={value}: {result}")


def values_out_of_range(folder):
    file = folder / "stimuli.csv"
    for device, signal, value, says in (
            ("ax060805", "noise_seed", "1e300", "from 0 to 4294967295"), ("ax060805", "noise_seed", "-1", "from 0 to"),
            ("ax060805", "pitch", "181", "from -180 to 180"), ("ax130751", "supply", "-0.1", "from 0 to 60"),
            ("cbx-ao412", "switch_low", "16", "from 0 to 15"), ("cbx-ao412", "can_state", "4", "from 0 to 3")):
        file.write_text(f"{HEADING}1,{signal},{value}\n")
        refused("", f"stimuli.csv:2: {signal} takes", device, "-", "--stimulus", file)
        refused("", says, device, "-", "--stimulus", file)


def outputs_go_forward(folder):
    stimuli, outputs = folder / "fault.csv", folder / "outputs.csv"
    stimuli.write_text(f"{HEADING}3,internal_fault,1\n")
    result = replay("", "cbx-ao412", "-", "--stimulus", stimuli, "--outputs", outputs, "--until", "5")
    times = [float(line.split(",")[0]) for line in outputs.read_text().splitlines()[1:]]
    expect(result.returncode == 0 and times == sorted(times) and times[-1] >= 3.0, f"times of outputs: {times}")


def stimuli_of_several_devices(folder):
    """Checks that replay takes the stimuli of its own device from a file for a run of several devices, and names those it leaves out."""
    file, outputs = folder / "several.csv", folder / "several_outputs.csv"

    def red_led(line, *words):
        """Returns whether the CAN-CBX-AO412's error LED is lit at the end, and the messages of the replay."""
        file.write_text(f"{HEADING}{line}\n")
        result = replay("", *words, "-", "--stimulus", file, "--outputs", outputs, "--until", "2")
        expect(result.returncode == 0, f"{words} with {line}: {result.stderr!r}")
        lit = [row.split(",")[2] for row in outputs.read_text().splitlines() if ",led_m," in row] if result.returncode == 0 else ["?"]
        return "1" in lit, result.stderr

    box = ("cbx-ao412", "--node", 3)
    for signal in ("internal_fault", "cbx-ao412.internal_fault", "cbx-ao412@3.internal_fault", "cbx-ao412@03.internal_fault",
                   "C.3040.02@3.internal_fault"):
        expect(red_led(f"1,{signal},1", *box) == (True, ""), f"{signal}: not of this device")
    expect(red_led("1,cbx-ao412@3.internal_fault,1", "cbx-ao412@3") == (True, ""), "cbx-ao412@3")
    for device in ("cbx-ao412@4", "C.3040.02"):
        lit, says = red_led(f"1,{device}.internal_fault,1", *box)
        expect(not lit and says.endswith(f"several.csv: the stimuli of other devices are left out: {device}\n"), f"{device}: {says!r}")
    expect("left out: ax060805\n" in red_led("1,ax060805.pitch,1\n2,ax060805.pitch,2", *box)[1], "ax060805")
    for line, says in (("1,cbx-ao41.internal_fault,1", "several.csv:2: there is no device `cbx-ao41`"),
                       ("1,ax060805.pich,1", "several.csv:2: there is no input `pich`"),
                       ("1,ax060805.pitch,181", "several.csv:2: pitch takes"), ("1,cbx-ao412@300.can_state,1", "no node-ID"),
                       ("1,cbx-ao412@3.pitch,1", "several.csv:2: there is no input `pitch`"), ("1,.pitch,1", "no device ``")):
        file.write_text(f"{HEADING}{line}\n")
        refused("", says, *box, "-", "--stimulus", file)


with tempfile.TemporaryDirectory() as name:
    place = pathlib.Path(name)
    logs_of_the_clock()
    what_candump_writes()
    times_out_of_range()
    values_out_of_range(place)
    outputs_go_forward(place)
    stimuli_of_several_devices(place)
finish("every input is used or refused")
