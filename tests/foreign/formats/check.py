#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""check.py PROGRAM [PACK]…: checks the files that canproof (PROGRAM) writes for other tools: those of a small project, and those in each
evidence pack PACK. Each kind of file must exist, and the check must refuse a damaged copy of it, so that no check passes without a file."""
import json
import pathlib
import re
import subprocess
import sys
import tempfile
import xml.etree.ElementTree

sys.dont_write_bytecode = True
HERE = pathlib.Path(__file__).resolve().parent
ROOT = HERE.parents[2]
sys.path += [str(ROOT / "tests/program"), str(ROOT / "misra")]
from checks.reports import Outcome, write_sarif
from checks.rules import Finding
from small_project import AWAKE, GREEN, MEASURED, SOURCE, Project

MOST_LINES = 20  # lines of xmllint that are shown
# Damage to a file of each kind: a text, and the text that replaces its first occurrence.
DAMAGE = {"junit": (" tests=", " test="), "cobertura": (' hits="', ' hits="x'), "reqif": ("LAST-CHANGE=", "LAST-CHANGED="),
          "sacm": (' source="', ' source="no-'), "cyclonedx": ('"type": "application"', '"type": "appliance"'), "sarif": ('"level": "error"', '"level": "fatal"')}


def faults_in_xml(kind, files):
    done = subprocess.run(["xmllint", "--noout", "--relaxng", HERE / f"{kind}.rng", *files], capture_output=True, text=True)
    yield from [line for line in done.stderr.splitlines() if not line.endswith(" validates")][:MOST_LINES]
    for file in files if kind in REFERENCES else ():
        root = xml.etree.ElementTree.parse(file).getroot()
        identifier, references = REFERENCES[kind]
        known = {one.get(identifier) for one in root.iter()}
        yield from (f"{file}: no element is {name}" for name in references(root) if name not in known)


def references_of_reqif(root):
    return (one.text for one in root.iter() if one.tag.endswith("-REF"))


def references_of_sacm(root):
    return (name for one in root.iter() for role in ("source", "target", "referencedArtifactElement") for name in one.get(role, "").split())


# For each kind of XML: the attribute with the identifier of an element, and the function that returns all references to identifiers.
REFERENCES = {"reqif": ("IDENTIFIER", references_of_reqif), "sacm": ("{http://www.omg.org/XMI}id", references_of_sacm)}


def faults_in_json(kind, files):
    words = [word for file in files for word in (kind, file)]
    done = subprocess.run(["node", HERE / "check_json.js", *words], capture_output=True, text=True)
    assert done.returncode in (0, 1), done.stderr
    yield from done.stdout.splitlines() + done.stderr.splitlines()


def faults(kind, files):
    return list((faults_in_json if kind in ("cyclonedx", "sarif") else faults_in_xml)(kind, files))


def files_of_pack(pack):
    names = {"junit": "junit.xml", "cobertura": "cobertura.xml", "reqif": "register.reqif", "cyclonedx": "sbom.cdx.json",
             "sarif": "misra.sarif", "sacm": "argument.sacm.xmi"}
    return [(kind, pack / "data" / name) for kind, name in names.items() if (pack / "data" / name).exists()]


def made_files(project):
    """Makes a file of each kind: SARIF with the writer of the MISRA checkers, all others with canproof."""
    project.statements(GREEN, AWAKE)
    project.write("src/firmware/base/one.cpp", SOURCE)
    project.write("measured.json", json.dumps(MEASURED))
    project.write("reports/argument.toml", '[[claim]]\nid = "C"\ntext = "Tests pass."\nevidence = ["tests"]\n')
    project.write("run", "packages=(libc6 bash)\n")
    project.write("reports/packages.toml", '[[package]]\nname = "libc6"\nscope = "required"\nlicence = "LGPL-2.1-or-later"\n')
    for words in (("evidence", "--verdicts", "verdicts", "--out", "pack"), ("coverage", "measured.json", "--cobertura", "cobertura.xml"),
                  ("conform", "ax188001", "--case", "2.1", "--report", "conform")):
        status, out, err = project.call(*words)
        assert status in (0, 1), f"{words}: {out}{err}"
    row = {"guideline": "0.1.1", "topic": "unused values", "category": "advisory", "enforcement": "enforced"}
    finding = Finding("0.1.1", "src/firmware/base/one.cpp", 2)
    write_sarif(project.root, Outcome("1.0.0", [row], [finding], [(finding, {"reason": "An example."})], [], {}, ["A fault."], [], frozenset()))
    return [*files_of_pack(project.root / "pack"), ("cobertura", project.root / "cobertura.xml"),
            ("junit", project.root / "conform/junit.xml"), ("sarif", project.root / "misra.sarif")]


def refuses_damage(kind, file, folder):
    old, new = DAMAGE[kind]
    text = file.read_text()
    assert old in text, f"{file} has no `{old}`"
    damaged = folder / f"damaged.{kind}"
    damaged.write_text(re.sub(re.escape(old), new, text, count=1))
    return faults(kind, [damaged]) != []


with tempfile.TemporaryDirectory() as scratch:
    small = Project(sys.argv[1], scratch)
    made = made_files(small)
    by_kind = {kind: [file for one, file in made if one == kind] for kind in DAMAGE}
    for kind, files in by_kind.items():
        assert files, f"no file is of the kind {kind}"
        assert refuses_damage(kind, files[0], small.root), f"a damaged file of the kind {kind} passes"
    for pack in map(pathlib.Path, sys.argv[2:]):
        for kind, file in files_of_pack(pack):
            by_kind[kind].append(file)
    told = [fault for kind, files in by_kind.items() for fault in faults(kind, files)]
print("\n".join(told) if told else f"{sum(map(len, by_kind.values()))} files are as their formats demand: {', '.join(by_kind)}")
sys.exit(1 if told else 0)
