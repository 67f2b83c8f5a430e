#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""tests/program/shards.py PROGRAM: checks that `canproof mutate --code` of PROGRAM (canproof) in three shards writes the same
bytes as in one piece, also when tests/mutation/in_parts is stopped and started again.

A script replaces build/mutation/code_mutants, the test program that contains the mutants. The script pretends to contain
eleven mutants, of which every third survives. The scripts of fuzz/cluster run the shards. Compares the output, the exit
status, code_mutation.json and the exhibit (the result for the evidence pack)."""
import os
import pathlib
import subprocess
import sys
import tempfile

program = pathlib.Path(sys.argv[1]).resolve()
cluster = pathlib.Path(__file__).resolve().parents[2] / "fuzz" / "cluster"
STAND_IN = r'''#!/usr/bin/env python3
import os, sys
MUTANTS = range(11)
word = sys.argv[1] if len(sys.argv) > 1 else ""
if word == "--cells":
    for one in MUTANTS:
        print(one, "src/firmware/canopen/nmt.cpp", f"f{one % 2}, line {one}", "a -> true", sep="\t")
elif word == "--serve":
    for line in sys.stdin:
        number = int(line.split("\t")[0])
        print(number, "survived" if number % 3 == 0 else "killed\tNmt.Starts", sep="\t", flush=True)
elif "CANPROOF_TOLD" in os.environ:
    with open(os.environ["CANPROOF_TOLD"], "w") as told:
        print("Nmt.Starts", "tests/conformance/nmt_test.cpp", "0.010", *MUTANTS, sep="\t", file=told)
'''


def make_project(folder):
    programs = folder / "build" / "mutation"
    programs.mkdir(parents=True)
    (programs / "code_mutants").write_text(STAND_IN)
    (programs / "code_mutants").chmod(0o755)
    (folder / "reports").mkdir()
    (folder / "reports" / "code_mutation.toml").write_text('''[[survivor]]
item = "src/firmware/canopen/nmt.cpp"
cell = "f0, line 6"
change = "a -> true"
reason = "An example of a reason."
''')


def run(*words, status=0, **environment):
    done = subprocess.run([*map(str, words)], capture_output=True, text=True, check=False, env={**os.environ, **environment})
    assert done.returncode == status, f"{words}: status {done.returncode}\n{done.stdout}{done.stderr}"
    return done


def written(folder):
    files = [folder / "build/mutation/code_mutation.json", *sorted((folder / "build/exhibits").rglob("*.*"))]
    return {str(file.relative_to(folder)): file.read_bytes() for file in files}


with tempfile.TemporaryDirectory() as name:
    one, three, shards = (pathlib.Path(name) / part for part in ("one", "three", "shards"))
    make_project(one)
    make_project(three)
    whole = run(program, "mutate", "--code", "--root", one, status=1)
    where = {"CANPROOF": str(program), "PROGRAMS": str(three / "build/mutation"), "MUTATE_OPTIONS": f"--root {three}"}
    run(cluster / "prepare", shards, **where)
    for number in (3, 1, 2):
        said = run(cluster / "shard", "code", number, 3, shards, **where).stdout
        assert f"shard {number}/3: {4 if number < 3 else 3} of 11 alterations judged" in said, said
    assert not (three / "build/mutation/code_mutation.json").exists()
    merged = run(cluster / "merge", "code", shards, status=1, **where)
    assert merged.stdout == whole.stdout, f"{merged.stdout}\n---\n{whole.stdout}"
    assert "11 places altered, 7 noticed, 1 survive with a reason, 3 without" in merged.stdout, merged.stdout
    assert written(three) == written(one) and len(written(one)) == 5, written(three).keys()
    (shards / "code_mutation-2-of-3.json").unlink()
    lost = run(cluster / "merge", "code", shards, status=2, **where).stderr
    assert "shard 2/3 is missing" in lost, lost
    assert "is not a shard" in run(program, "mutate", "--code", "--root", one, "--shard", "4/3", status=2).stderr
    refused = run(program, "mutate", "--code", "--root", one, "--shard", "1/3", "--merge", shards, status=2).stderr
    assert "--shard" in refused, refused

    in_parts = cluster.parents[1] / "tests/mutation/in_parts"
    made = three / "build/mutation/shards"

    def judged():
        """Runs in_parts. Returns the numbers of the parts that it tested."""
        said = run(in_parts, "code", 3, status=1, **where).stdout
        assert "11 places altered, 7 noticed, 1 survive with a reason, 3 without" in said, said
        assert written(three) == written(one), said
        return [int(line.split()[1]) for line in said.splitlines() if line.startswith("part ")]

    for file in made.glob("*"):
        file.unlink()
    assert judged() == [1, 2, 3]
    second = made / "code_mutation-2-of-3.json"
    second.unlink()  # as if in_parts was stopped after the first part, and another machine made the third
    assert judged() == [2]
    second.write_text(second.read_text()[:20])  # half written
    assert judged() == [2]
    second.write_text(second.read_text().replace('"sources": "', '"sources": "other'))
    assert judged() == [1, 2], "a part of other sources is judged again"
print("three shards leave the bytes of one machine, in one run or in two")
