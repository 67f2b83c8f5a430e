#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""json_outputs.py PROGRAM: checks that each command of PROGRAM (canproof) prints with `--json` one JSON object with the members that
src/host/app/README.md lists, and nothing else on standard output. Values are those of a small project. The checkers of `canproof misra`
take minutes: here only their JSON writer is called, with a made-up result."""
import json
import pathlib
import re
import subprocess
import sys
import tempfile

sys.dont_write_bytecode = True
from small_project import AWAKE, GREEN, MEASURED, SOURCE, VERDICTS, Project

ROOT = pathlib.Path(__file__).resolve().parents[2]
MUTANTS = r'''#!/usr/bin/env python3
import os, sys
word = sys.argv[1] if len(sys.argv) > 1 else ""
if word == "--cells":
    for one in range(5):
        print(one, "src/firmware/base/one.cpp", f"run, line {one}", "a -> true", sep="\t")
elif word == "--serve":
    for line in sys.stdin:
        number = int(line.split("\t")[0])
        print(number, "survived" if number == 3 else "killed\tNmt.Starts", sep="\t", flush=True)
elif "CANPROOF_TOLD" in os.environ:
    with open(os.environ["CANPROOF_TOLD"], "w") as told:
        print("Nmt.Starts", "tests/nmt_test.cpp", "0.010", *range(5), sep="\t", file=told)
'''
# A stand-in for a test program: it writes its test results, has one cell (value of a table) to alter, and notices no
# alteration.
TESTS = r'''#!/usr/bin/env python3
import sys
for word in sys.argv[1:]:
    if word.startswith("--gtest_output=xml:"):
        open(word.split(":", 1)[1], "w").write("""VERDICTS""")
if "--cells" in sys.argv:
    print(0, "BOX-R-1", "row 1", "1 -> 2", sep="\t")
if "--serve" in sys.argv:
    for line in sys.stdin:
        print(line.split("\t")[0], "survived", sep="\t", flush=True)
'''
MISRA = r'''#!/usr/bin/env bash
printf '{"words": "%s"}\n' "$*"
'''


def listed():
    """Returns {command: description of the members of its JSON}, from the table in src/host/app/README.md."""
    text = (ROOT / "src/host/app/README.md").read_text()
    rows = re.findall(r"^\| (`[^|]*) \| ([^|]*) \|$", text.split("## JSON for other programs")[1].split("\n## ")[0], re.MULTILINE)
    return {command.replace("`", ""): members for command, members in rows}


def listed_members():
    """Returns {command: names of the members of its JSON}."""
    return {command: set(re.findall(r"`(\w+)`", members)) for command, members in listed().items()}


def listed_elements():
    """Returns {command: {member: (names, names that may be absent)}} for each member whose elements this table describes as `each with …`."""
    elements = {}
    for command, members in listed().items():
        for member, words in re.findall(r"`(\w+)`[^`;|]*each with ([^;|]*)", members):
            always, _, sometimes = words.partition(" when ")
            names = [set(re.findall(r"\w+", part)) - {"and", "or", "measured"} for part in (always, sometimes)]
            elements.setdefault(command, {})[member] = names
    return elements


LISTED = listed_members()
ELEMENTS = listed_elements()


def said(project, what, status, *words):
    """Runs a command with --json, checks exit status and members of the JSON object, and returns it. `what` is the command as the README names it."""
    got, out, err = project.call(*words, "--json")
    assert got == status, f"{words}: status {got}\n{out}{err}"
    made = json.loads(out)
    assert set(made) == LISTED.pop(what), f"{words}: {sorted(made)}"
    for member, (always, sometimes) in ELEMENTS.get(what, {}).items():
        elements = made[member].values() if isinstance(made[member], dict) else made[member]
        for element in elements:
            assert always <= set(element) <= always | sometimes, f"{words}: an element of {member} has {sorted(element)}"
    return made


def said_again(project, *words):
    return json.loads(project.call(*words, "--json")[1])


def audits(project):
    project.statements(GREEN, AWAKE)
    where = ("--verdicts", "verdicts")
    whole = said(project, "audit", 1, "audit", *where)
    assert whole["tests"] == 1 and whole["failed"] == 0, whole
    some = said(project, "audit with a filter", 0, "audit", *where, "--section", "1", "--status", "explained")
    assert [one["id"] for part in some["parts"] for one in part.get("statements", [])] == ["M1:1/2"], some
    story = said(project, "audit with an id, a section, a statement, a file or a test", 1, "audit", "BOX-R-1", *where)
    assert story["subject"] == "BOX-R-1" and story["open"] is True and "The box shall be green." in story["story"], story
    project.write("spec/manuals/lamp.toml", (project.root / "spec/manuals/lamp.toml").read_text() + 'conditions = ["Keep it dry."]\n')
    kept = said(project, "audit --kind condition-of-use", 0, "audit", *where, "--kind", "condition-of-use")
    assert kept == {"conditions": [{"section": "M1:2", "text": "Keep it dry."}]}, kept


def register(project):
    checked = said(project, "spec check", 0, "spec", "check")
    assert checked["items"] >= 1 and checked["statements"] == 2 and checked["faults"] == [], checked


def changes(project):
    git = ["git", "-C", project.root, "-c", "user.name=t", "-c", "user.email=t@example.org", "-c", "commit.gpgsign=false"]
    for words in (["init", "-q"], ["add", "."], ["commit", "-q", "-m", "first"]):
        subprocess.run([*git, *words], check=True)
    items = project.root / "spec/devices/box/items.toml"
    items.write_text(items.read_text().replace("shall be green", "shall be red"))
    changed = said(project, "diff", 0, "diff", "HEAD", "--verdicts", "verdicts")
    assert [(one["id"], one["change"]) for one in changed["items"]] == [("BOX-R-1", "changed")] and changed["files"] == [], changed
    assert changed["stale"] == [] and project.call("diff", "HEAD", "--verdicts", "verdicts", "--exit-code")[0] == 1
    items.write_text(items.read_text().replace("shall be red", "shall be green"))
    assert project.call("diff", "HEAD", "--verdicts", "verdicts", "--exit-code")[0] == 0
    code = project.root / "src/firmware/a.hpp"
    text = code.read_text()
    code.write_text(text.replace("void green", "/* A comment. */ void  green"))
    assert said_again(project, "diff", "HEAD", "--verdicts", "verdicts")["stale"] == []
    code.write_text(text.replace("{}", "{ lamp(); }"))
    assert said_again(project, "diff", "HEAD", "--verdicts", "verdicts")["stale"] == [
        {"id": "BOX-R-1", "code": True, "tests": False, "changed": [{"name": "green", "place": "src/firmware/a.hpp:1"}]}]
    _, out, _ = project.call("diff", "HEAD", "--verdicts", "verdicts")
    assert "stale BOX-R-1: its code has changed\n    changed   green src/firmware/a.hpp:1\nnext: run `./test`; then" in out, out
    code.write_text(text)


def coverage(project):
    project.write("src/firmware/base/one.cpp", SOURCE)
    project.write("measured.json", json.dumps(MEASURED))
    project.write("reports/coverage.toml", '[[record]]\nfile = "src/firmware/base/one.cpp"\nkind = "function"\ncode = "gone()"\nreason = "An example."\n')
    found = said(project, "coverage", 1, "coverage", "measured.json")
    assert "idle" in json.dumps(found["gaps"]) and found["holds"] is False, found
    stale = said(project, "coverage --records", 1, "coverage", "--records")
    assert stale["records"] == 1 and [one["code"] for one in stale["stale"]] == ["gone()"], stale
    project.write("reports/coverage.toml", "")


def mutants(project):
    program = project.root / "build/mutation/code_mutants"
    project.write("build/mutation/code_mutants", MUTANTS)
    program.chmod(0o755)
    judged = said(project, "mutate", 1, "mutate", "--code")
    assert (judged["altered"], judged["noticed"], judged["justified"]) == (5, 4, 0), judged
    assert [(one["cell"], one["reason"]) for one in judged["survivors"]] == [("run, line 3", "")], judged
    shard = said(project, "mutate --shard", 0, "mutate", "--code", "--shard", "1/2")
    assert shard["shard"] == "1/2" and shard["judged"] == 3 and shard["of"] == 5, shard
    for name in ("canproof_tests", "canproof_properties"):
        project.write(f"build/mutation/{name}", TESTS.replace("VERDICTS", VERDICTS if name == "canproof_tests" else "<testsuites/>"))
        (project.root / "build/mutation" / name).chmod(0o755)
    project.write("tests/a_test.cpp", "TEST(S, Green) {\n    EXPECT_TRUE(true);\n}\n")
    kills = said(project, "mutate --kills", 0, "mutate", "--kills")
    assert kills == {"tests": 1, "notice_nothing": 1}, kills


def checkers(project):
    """Checks that `canproof misra` passes --json on to the checkers, and that their report lists the open findings."""
    project.write("build/release/home.txt", f"{project.root}/home\n")
    project.write("home/misra/run", MISRA)
    (project.root / "home/misra/run").chmod(0o755)
    status, out, _ = project.call("misra", "--build", "build/release", "--json")
    assert status == 0 and " --json " in json.loads(out)["words"], out
    sys.path.insert(0, str(ROOT / "misra"))
    from checks.reports import Outcome, outcome_json
    from checks.rules import Finding

    figures = {"stack": {"box": (10, 20)}, "all_functions": 7, "unserved": 1}
    outcome = Outcome("1.0.0", [{"enforcement": "enforced"}], [Finding("0.1.1", "a.cpp", 3), Finding("0.2.3", "a.cpp", 4)],
                      [(Finding("0.1.1", "b.cpp", 5), {"reason": "An example."})], [], figures, ["A fault."], [], frozenset(["0.2.3"]))
    made = json.loads(outcome_json(outcome))
    assert set(made) == LISTED.pop("misra"), sorted(made)
    assert [(one["line"], one["needs_review"]) for one in made["findings"]] == [(3, False), (4, True)], made
    assert made["holds"] is False and made["faults"] == ["A fault."] and made["deviations"][0]["reason"] == "An example.", made


def packs(project):
    project.write("reports/argument.toml", '[[claim]]\nid = "C"\ntext = "Tests pass."\nevidence = ["tests"]\n')
    argument = said(project, "evidence", 0, "evidence", "--verdicts", "verdicts", "--out", "pack")
    assert [(one["id"], one["solutions"]) for one in argument["goals"]] == [("C", ["tests"])], argument
    assert said(project, "evidence verify", 0, "evidence", "verify", "pack") == {"signature_verified": False, "faults": []}


def sheets(project):
    project.write("a.eds", project.call("eds", "ax188001")[1])
    found = said(project, "eds check", 0, "eds", "check", "a.eds")
    assert found["errors"] == 0 and found["fixed"] == [], found
    rules = said(project, "eds check --rules", 0, "eds", "check", "--rules")["rules"]
    assert any(rule["rule"] == "fileinfo-name-differs" for rule in rules), rules[:3]
    other = said_again(project, "eds", "check", "a.eds", "--fix", "b.eds")
    assert any(one["what"].endswith("the name of the file is b.eds") for one in other["findings"]), other


def injection(project):
    project.write("bus.log", "(1.0) can0 603#4000100000000000\n")
    made = said(project, "inject", 0, "inject", "cbx-ao412", "bus.log", "--node", "3", "--faults", "5")
    assert (made["device"], made["faults"], sum(made["effects"].values())) == ("cbx-ao412", 5, 5), made


def conformance(project):
    report = said(project, "conform", 0, "conform", "ax188001", "--case", "2.1")
    assert report["exit_status"] == 0 and report["counts"]["passed"] == len(report["cases"]) > 0, report["counts"]
    cases = said(project, "conform --list", 0, "conform", "--list")["cases"]
    assert any("2.1" in one["public"] for one in cases), cases[:3]


with tempfile.TemporaryDirectory() as scratch:
    small = Project(sys.argv[1], scratch)
    for check in (audits, register, changes, coverage, mutants, checkers, packs, sheets, injection, conformance):
        check(small)
assert not LISTED, f"the README lists what no check here runs: {sorted(LISTED)}"
print("JSON of each command has the listed members")
