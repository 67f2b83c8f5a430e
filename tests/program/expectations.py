# SPDX-License-Identifier: Apache-2.0
"""For the scripts of this folder whose first argument is the path of canproof: runs the program, and collects the failed expectations."""
import pathlib
import subprocess
import sys

PATIENCE = 120  # seconds until a program counts as hanging; no test waits for this time
PROGRAM = str(pathlib.Path(sys.argv[1]).resolve())
ROOT = pathlib.Path(__file__).resolve().parents[2]
failures = []


def expect(holds, what):
    if not holds:
        failures.append(what)
        print(f"FAILED  {what}")


def canproof(*words, **how):
    """Runs PROGRAM in the project's folder. Words are strings, bytes, paths or numbers. `how` are arguments of subprocess.run(); by default
    standard input is empty and both outputs are kept."""
    given = [word if isinstance(word, bytes) else str(word) for word in words]
    how = {"stdout": subprocess.PIPE, "stderr": subprocess.PIPE, "text": True, "cwd": ROOT, **how}
    if "input" not in how:
        how.setdefault("stdin", subprocess.DEVNULL)
    return subprocess.run([PROGRAM, *given], timeout=PATIENCE, check=False, **how)


def refused(says, *words, **how):
    """Expects that PROGRAM ends with status 2 and that its output contains `says`."""
    result = canproof(*words, **how)
    text = result.stdout + result.stderr
    expect(result.returncode == 2 and says in text, f"{' '.join(map(str, words))}: status {result.returncode}, `{says}` is not in {text!r}")
    return result


def finish(says):
    """Ends the script: with status 1 after a failed expectation, otherwise prints `says`."""
    if not failures:
        print(says)
    sys.exit(1 if failures else 0)
