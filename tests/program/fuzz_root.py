#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""tests/program/fuzz_root.py PROGRAM: checks that `canproof fuzz --root FOLDER` of PROGRAM (canproof) works on the project in FOLDER from
any other folder. It must use the fuzz targets of FOLDER, and write corpus and report below FOLDER. Relative folders in other options are
relative to the current folder.

A script takes the place of the fuzz target. It writes one new input into the corpus."""
import os
import pathlib
import subprocess
import sys
import tempfile

program = pathlib.Path(sys.argv[1]).resolve()
STAND_IN = r"""#!/bin/sh
for a; do case $a in
    -fork=*) mode=fuzz ;;
    -merge=1) mode=merge ;;
    -*) ;;
    *) if [ -z "$first" ]; then first=$a; else second=${second:-$a}; fi ;;
esac; done
case $mode in
    fuzz) printf one > "$first/one"; echo '#100: cov: 10 ft: 20 corp: 1 exec/s: 100 oom/timeout/crash: 0/0/0 time: 2s job: 1 dft_time: 0' ;;
    merge) cp "$second/one" "$first/one" ;;
esac
"""


def make_project(folder, build):
    (folder / build).mkdir(parents=True)
    (folder / build / "fuzz_targets.txt").write_text(f"box\t{folder / 'sources'}\t{folder / 'seeds'}\n")
    (folder / build / "box_fuzz").write_text(STAND_IN)
    (folder / build / "box_fuzz").chmod(0o755)


def fuzz(here, *words):
    done = subprocess.run([program, "fuzz", "--minutes", "0.01", "--seed", "1", "--plain", "--no-second-pass", "--no-coverage", *words],
                          cwd=here, capture_output=True, text=True, timeout=120, check=False)
    return done.returncode, done.stdout + done.stderr


with tempfile.TemporaryDirectory() as name:
    project, here = pathlib.Path(name, "project").resolve(), pathlib.Path(name, "here").resolve()
    here.mkdir()
    status, told = fuzz(here, "--root", str(project))
    assert status == 2 and f"{project}/build/fuzz" in told, told
    make_project(project, "build/fuzz")
    status, told = fuzz(here, "--root", str(project))
    assert status == 0 and "no finding in" in told, told
    assert (project / "build/fuzz-corpus/box/one").read_text() == "one", told
    assert (project / "build/exhibits/fuzz/report.json").exists(), told
    assert os.listdir(here) == [], os.listdir(here)
    make_project(here, "elsewhere")
    status, told = fuzz(here, "--root", str(project), "--build", "elsewhere", "--corpus", "inputs", "--out", "report")
    assert status == 0 and (here / "inputs/box/one").exists() and (here / "report/report.json").exists(), told
    status, told = fuzz(project)
    assert status == 0 and "no finding in" in told, told
print("fuzz --root works on a project elsewhere")
