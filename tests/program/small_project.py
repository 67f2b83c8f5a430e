# SPDX-License-Identifier: Apache-2.0
"""A project with one manual of two sections and a device with one requirement. The marks (hashes) of the manual's passages are
computed here by their definition in spec/README.md."""
import hashlib
import pathlib
import re
import subprocess

MANUAL = """key = "M1"
title = "Lamp"
publisher = "Nobody"
revision = "1"
date = "2020-02-03"
[[section]]
ref = "1"
title = "Lamp"
disposition = "normative"
[[section]]
ref = "2"
title = "Rates"
disposition = "normative"
"""
DEVICE = """name = "box"
title = "Box 1"
vendor = "Nobody"
prefix = "BOX"
manual = "M1"
part_numbers = ["B.1"]
node_id = 3
bit_rate = 125000
bit_rates = [125000]
source = ["M1:1"]
"""
ITEM = """[[requirement]]
id = "BOX-R-1"
text = "The box shall be green."
source = ["M1:1"]
kind = "functional"
verify = ["test"]
"""
TEXT = "# 1. Lamp\nThe lamp is\n**green**. It never sleeps.\n# 2. Rates\nTen times a second.\n"
VERDICTS = ('<testsuites><testsuite name="S"><testcase classname="S" name="Green" status="run" file="tests/a_test.cpp">'
            '<properties><property name="BOX-R-1" value="test"/></properties></testcase></testsuite></testsuites>')

# A source whose function `idle` no test calls, and its coverage in the format of `llvm-cov export`.
SOURCE = "int run(bool a) {\n    return a ? 1 : 2;\n}\nint idle() {\n    return 4;\n}\n"
MEASURED = {"version": "2.0.1", "data": [{
    "files": [{"filename": "/elsewhere/src/firmware/base/one.cpp", "segments": [[1, 17, 1, True, True, False], [3, 2, 0, False, False, False],
                                                                                  [4, 12, 0, True, True, False], [6, 2, 0, False, False, False]],
               "branches": [[2, 12, 2, 13, 1, 0, 0, 0, 4]], "mcdc_records": [], "expansions": [], "summary": {}}],
    "functions": [{"name": "_ZN8canproof3runEb", "count": 1, "filenames": ["/elsewhere/src/firmware/base/one.cpp"],
                   "regions": [[1, 17, 3, 2, 1, 0, 0, 0]], "branches": [], "mcdc_records": []},
                  {"name": "_ZN8canproof4idleEv", "count": 0, "filenames": ["/elsewhere/src/firmware/base/one.cpp"],
                   "regions": [[4, 12, 6, 2, 0, 0, 0, 0]], "branches": [], "mcdc_records": []}]}]}


def mark(passage):
    kept = re.sub("[^a-z0-9]", "", passage.lower())
    return f"{len(kept)}:{hashlib.sha256(kept.encode()).hexdigest()[:12]}"


def statement(section, passage, rest):
    return f'[[statement]]\nsection = "{section}"\ntext = "Ours."\nmark = "{mark(passage)}"\n{rest}\n'


class Project:
    def __init__(self, program, folder):
        self.program = pathlib.Path(program).resolve()
        self.root = pathlib.Path(folder)
        for path, text in (("spec/manuals/lamp.toml", MANUAL), ("spec/devices/box/device.toml", DEVICE),
                           ("spec/devices/box/items.toml", ITEM), ("verdicts/tests.xml", VERDICTS), ("manual.txt", TEXT),
                           ("src/firmware/a.hpp", "static_assert(implements<req::BOX_R_1>);\nvoid green() {}\n")):
            self.write(path, text)

    def write(self, path, text):
        file = self.root / path
        file.parent.mkdir(parents=True, exist_ok=True)
        file.write_text(text)

    def statements(self, *all_of_them):
        self.write("spec/manuals/lamp/all.toml", "".join(all_of_them))

    def call(self, *words):
        done = subprocess.run([self.program, *words], cwd=self.root, capture_output=True, text=True, timeout=120)
        return done.returncode, done.stdout, done.stderr

    def audit(self, *words):
        return self.call("audit", *words, "--verdicts", "verdicts")


GREEN = statement("1", "The lamp is green", 'covered = ["BOX-R-1"]')
AWAKE = statement("1", "It never sleeps", 'reason = "a lamp has no sleep"')
RATE = statement("2", "Ten times a second", 'covered = ["BOX-R-1"]')
