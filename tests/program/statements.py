#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""statements.py PROGRAM: runs `spec statements`, `spec check` and `audit` of PROGRAM (canproof) on a small manual with statements, and
checks the statements of the manuals of this repository."""
import json
import pathlib
import re
import sys
import tempfile

sys.dont_write_bytecode = True
from small_project import AWAKE, GREEN, RATE, Project, mark, statement

SPEC = pathlib.Path(__file__).resolve().parents[2] / "spec"


def listed(project):
    status, out, err = project.call("spec", "statements", "M1")
    assert status == 2 and "M1 has no statements; write them below spec/manuals/lamp/" in err, err
    project.statements(GREEN, AWAKE)
    status, out, _ = project.call("spec", "statements", "M1")
    assert status == 1 and "2 Rates: normative, and no statement\n" in out, out
    assert re.search(r"^  M1:1/1 +covered +Ours\.\n +\[BOX-R-1\]$", out, re.MULTILINE), out
    assert re.search(r"^  M1:1/2 +explained ", out, re.MULTILINE) and "(a lamp has no sleep)" in out, out
    assert "2 statement(s), 0 open; 1 normative section(s) without a statement\n" in out, out
    project.statements(GREEN, AWAKE, RATE)
    assert project.call("spec", "statements", "M1")[0] == 0
    status, _, err = project.call("spec", "statements", "M9")
    assert status == 2 and "no manual has the key M9; the keys are M1" in err, err


def compared(project):
    project.statements(GREEN, RATE)
    status, out, _ = project.call("spec", "statements", "M1", "--text", "manual.txt")
    # "The lamp is green" and "Ten times a second" have 14 + 15 letters. "It never sleeps" has 13 letters and the headings have 11.
    assert status == 0 and out == ("3: 1: It never sleeps.\n2 passage(s), 0 not in the text\n"
                                   "letters and digits of normative sections: 69.0 % of 42 covered, 1 line(s) not fully covered\n"
                                   "letters and digits of the whole text: 54.7 % of 53 covered\n"), out
    project.statements(GREEN, statement("2", "Eleven times a second", 'covered = ["BOX-R-1"]'))
    status, out, _ = project.call("spec", "statements", "M1", "--text", "manual.txt")
    assert status == 1 and f"not in the text: M1:2/1: {mark('Eleven times a second')}\n" in out, out
    status, _, err = project.call("spec", "statements", "M1", "--text", "none.txt")
    assert status == 2 and "cannot read none.txt" in err, err


def checked(project):
    project.statements(GREEN, AWAKE, RATE)
    status, out, err = project.call("spec", "check")
    assert status == 0 and "3 statement(s), 0 fault(s), 1 warning(s)" in out, out
    assert "warning: spec/manuals/lamp/all.toml:15: M1:2/1 is covered by BOX-R-1, but none of these items names 2 as its source" in err, err
    assert project.call("spec", "check", "--strict")[0] == 1
    project.statements(GREEN.replace("BOX-R-1", "BOX-R-9"))
    status, _, err = project.call("spec", "check")
    assert status == 1 and "spec/manuals/lamp/all.toml:5: M1:1/1 is covered by BOX-R-9, which does not exist" in err, err


def audited(project):
    project.statements(GREEN, AWAKE, statement("2", "Ten times a second", ""))
    _, out, _ = project.audit()
    assert "  M1:2/1: no item covers the statement, and the statement has no reason (Ours.)\n" in out, out
    assert "  M1: 3 statements, 0 shown, 1 explained, 1 suspect, 1 open, 0 failed\n" in out, out
    status, out, _ = project.audit("--untested")
    assert status == 1 and "M1:2/1" in out and "M1:1/1" not in out, out
    status, out, _ = project.audit("M1:1/1")
    assert status == 1 and "passed S.Green tests/a_test.cpp" in out and "verdict      suspect" in out, out
    whole = json.loads(project.audit("--json")[1])
    states = {one["id"]: one["status"] for part in whole["parts"] for one in part.get("statements", [])}
    assert states == {"M1:1/1": "suspect", "M1:1/2": "explained", "M1:2/1": "open"}, states
    some = json.loads(project.audit("--json", "--section", "M1:2")[1])
    assert [one["id"] for part in some["parts"] for one in part.get("statements", [])] == ["M1:2/1"], some


def shipped(project):
    """Checks that each manual of this repository has statements in every normative section, that each statement has an item or a reason,
    and that no requirement demands several things."""
    status, _, err = project.call("spec", "check", "--spec", str(SPEC))
    assert status == 0 and "demands several things" not in err and "second condition" not in err, err
    manuals = sorted((SPEC / "manuals").glob("*.toml"))
    assert manuals, f"no manual in {SPEC}"
    for manual in manuals:
        key = re.search(r'^key *= *"([^"]+)"', manual.read_text(), re.MULTILINE)[1]
        status, out, err = project.call("spec", "statements", key, "--spec", str(SPEC))
        assert status == 0, out[-2000:] + err
        found = re.search(r"^(\d+) statement\(s\), 0 open; 0 normative section\(s\) without a statement$", out, re.MULTILINE)
        assert found and int(found[1]) >= len(list((SPEC / "manuals" / manual.stem).glob("*.toml"))), out[-2000:]


with tempfile.TemporaryDirectory() as scratch:
    small = Project(sys.argv[1], scratch)
    listed(small)
    compared(small)
    checked(small)
    audited(small)
    shipped(small)
print("statements: listed, compared with a text, checked, audited")
