#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""tests/program/inject_shards.py PROGRAM: checks that `canproof inject`, divided into three shards as for three machines, prints
the same bytes as in one piece. PROGRAM is canproof.

One of the 300 faults with seed 3 inverts a bit of a pointer. Its effect depends on the addresses and the content of the memory
beside the device. So the bytes are the same only if addresses and memory are the same in each run."""
import pathlib
import subprocess
import sys
import tempfile

program = pathlib.Path(sys.argv[1]).resolve()
ROOT = pathlib.Path(__file__).resolve().parents[2]


def inject(*words):
    done = subprocess.run([program, "inject", "cbx-ao412", "--root", ROOT, *words], capture_output=True, text=True, check=False)
    assert done.returncode == 0, f"{words}: status {done.returncode}\n{done.stdout}{done.stderr}"
    return done.stdout


for seed in ("3", "4"):
    campaign = ("--faults", "300", "--seed", seed)
    with tempfile.TemporaryDirectory() as shards:
        for number in (2, 3, 1):
            inject(*campaign, "--shard", f"{number}/3", "--out", shards)
        merged = inject("--merge", shards, "--json")
    for jobs in ("1", "2"):
        assert merged == inject(*campaign, "--json", "--jobs", jobs), f"seed {seed}: the shards have other effects than {jobs} job(s)"
print("three shards of inject have the effects of one machine")
