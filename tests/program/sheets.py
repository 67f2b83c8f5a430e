#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""tests/program/sheets.py PROGRAM: runs `canproof eds check` and `canproof eds --format dbc` of PROGRAM (canproof), and checks
output, files and exit status."""
import json
import pathlib
import sys
import tempfile

sys.dont_write_bytecode = True
from expectations import canproof, expect, finish


def statuses(folder, sheet):
    """Checks the exit status: 0 for an EDS without errors, 1 with errors, 2 for another file. With --strict, a warning counts as an
    error."""
    good = folder / "cbx-ao412.eds"
    good.write_text(sheet)
    result = canproof("eds", "check", good)
    expect((result.returncode, result.stdout) == (0, "0 error(s), 0 warning(s)\n"), f"a good sheet: {result}")
    good.write_text(sheet.replace("[FileInfo]\n", "[FileInfo]\nAuthor=Nobody\n"))
    result = canproof("eds", "check", good)
    expect(result.returncode == 0 and result.stdout.startswith(f"{good}:2: warning fileinfo-key-unknown: Author "),
           f"a warning: {result}")
    expect(canproof("eds", "check", "--strict", good).returncode == 1, "--strict")
    good.write_text(sheet.replace("NrOfRXPDO=", "NrOfRXPDO=9"))
    result = canproof("eds", "check", good)
    expect(result.returncode == 1 and result.stdout.endswith("1 error(s), 0 warning(s)\n"), f"an error: {result}")
    for text in ("", "<?xml version='1.0'?><a/>\n"):
        good.write_text(text)
        result = canproof("eds", "check", good)
        expect(result.returncode == 2 and len(result.stderr.splitlines()) == 1, f"no EDS: {result}")
    expect(canproof("eds", "check", folder / "none.eds").returncode == 2, "no file")
    expect(canproof("eds", "check").returncode == 2 and canproof("eds").returncode == 2, "no word")


def fixes(folder, sheet):
    """Checks that --fix FILE writes the corrected EDS to FILE and reports the changes. FILE may be the checked EDS or another file."""
    bad, better = folder / "bad.eds", folder / "better.eds"
    text = sheet.replace("FileName=cbx-ao412.eds", "FileName=bad.eds").replace("[FileInfo]", "[fileinfo]")
    bad.write_text(text)
    result = canproof("eds", "check", bad, "--fix", better)
    expect(result.returncode == 0 and f"{better}:1: fixed section-case: " in result.stdout, f"--fix: {result}")
    expect(result.stdout.endswith("0 error(s), 0 warning(s), 1 fixed\n"), f"--fix: {result}")
    expect(bad.read_text() == text and better.read_text() == text.replace("[fileinfo]", "[FileInfo]"), "--fix writes")
    report = json.loads(canproof("eds", "check", "--json", bad, "--fix", bad).stdout)
    expect([one["rule"] for one in report["fixed"]] == ["section-case"] and not report["findings"], f"{report}")
    expect(bad.read_text() == better.read_text(), "--fix in place")
    expect(canproof("eds", "check", bad, "--fix", folder / "bad.eds" / "x").returncode == 2, "--fix into a file")
    names = sorted(path.name for path in folder.iterdir())
    expect(names == ["bad.eds", "better.eds", "cbx-ao412.eds"], f"files left: {names}")


def control_characters(folder):
    """Checks that texts of an EDS are printed without their control characters."""
    evil = folder / "better.eds"
    evil.write_text("[FileInfo]\nFileVersion=\x1b[2J\nFile\tVersion=1\nstrange\x7f\n")
    result = canproof("eds", "check", evil)
    expect(result.returncode == 1 and "\x1b" not in result.stdout and "\x7f" not in result.stdout, f"{result}")


def databases(folder):
    """Checks that --format dbc works for a device and for an EDS file, and accepts --node only where it has a meaning."""
    of_device = canproof("eds", "ax188001", "--format", "dbc", "--node", 5)
    expect(of_device.returncode == 0 and "BO_ 1797 ax188001_Heartbeat: 1 ax188001\n" in of_device.stdout, "dbc")
    by_number = canproof("eds", "c.3040.02", "--format", "dbc", "--node", 5)  # the part number of the CAN-CBX-AO412
    by_name = canproof("eds", "cbx-ao412", "--format", "dbc", "--node", 5)
    expect(by_number.returncode == 0 and by_number.stdout == by_name.stdout, f"dbc of a part number: {by_number}")
    sheet = folder / "ax188001.eds"
    sheet.write_text(canproof("eds", "ax188001").stdout)
    of_file = canproof("eds", sheet, "--format", "dbc", "--node", 5)
    wanted = [line for line in of_device.stdout.splitlines() if line.startswith("BO_ ")]
    found = [line for line in of_file.stdout.splitlines() if line.startswith("BO_ ")]
    expect(found == wanted and len(wanted) > 5, f"dbc of a file: {found}, not {wanted}")
    for words in (["ax188001", "--node", 5], [sheet], ["ax188001", "--format", "dbc", "--node", 128]):
        expect(canproof("eds", *words).returncode == 2, f"eds {words}")


with tempfile.TemporaryDirectory() as scratch:
    place = pathlib.Path(scratch)
    own = canproof("eds", "cbx-ao412").stdout
    statuses(place, own)
    fixes(place, own)
    control_characters(place)
    databases(place)
finish("the checks and fixes of EDS and the DBC are as described")
