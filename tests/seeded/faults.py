# SPDX-License-Identifier: Apache-2.0
"""Reads the seeded faults (tests/seeded/*.patch) and applies each to copies of the files that it changes."""
import pathlib
import re
import subprocess

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
FOLDER = ROOT / "tests" / "seeded"


class Wrong(Exception):
    """An invalid patch. The text of the exception names the reason."""


def layers():
    """Returns the layers that the name of a patch may begin with: shared firmware (`canopen`), each device, buses of the host (`bus`),
    self-tests of the microcontroller (`selftest`)."""
    devices = sorted(folder.parent.name for folder in (ROOT / "src" / "devices").glob("*/firmware"))
    return ["canopen", *devices, "bus", "selftest"]


class Fault:
    """One patch, with its `layer`, its `kind`, and `says`: the sentence on its first line, which describes the fault."""

    def __init__(self, path):
        self.path = pathlib.Path(path).resolve()
        self.name = self.path.stem
        lines = self.path.read_text(encoding="utf-8").splitlines()
        found = [layer for layer in layers() if self.name.startswith(layer + "-")]
        if not found:
            raise Wrong(f"{self.name}: name it LAYER-what-is-wrong.patch; layers: {', '.join(layers())}")
        if len(lines) < 4 or not re.fullmatch(r"[A-Z].*\.", lines[0]):
            raise Wrong(f"{self.name}: line 1 is one sentence that says what is wrong")
        kind = re.fullmatch(r"Kind: ([a-z][a-z -]*)", lines[1])
        if not kind:
            raise Wrong(f"{self.name}: line 2 is \"Kind: \" and the kind of fault, such as reset or timer")
        if lines[2] or not re.match(r"(diff --git a/|--- a/)", lines[3]):
            raise Wrong(f"{self.name}: line 3 is empty, and the unified diff follows, from the root, with a/ and b/")
        self.layer = found[0]
        self.kind = kind[1]
        self.says = lines[0]
        self.files = [line[6:] for line in lines if line.startswith("+++ b/")]
        outside = [file for file in self.files if not file.startswith("src/")]
        if outside or not self.files:
            raise Wrong(f"{self.name}: a fault is one of src/, not of {', '.join(outside) or 'nothing'}")

    def patch(self, tree, *options):
        """Runs patch(1). The context must match exactly; lines may have moved."""
        return subprocess.run(["patch", "-s", "-f", "-F0", "-p1", "-r", "-", *options, "-d", str(tree), "-i", str(self.path)],
                              capture_output=True, text=True, check=False)

    def apply(self, tree):
        done = self.patch(tree)
        if done.returncode != 0:
            raise Wrong(f"{self.name} does not apply; write it again: {done.stdout.strip()}")

    def check(self, tree):
        """Checks whether the patch applies, without writing."""
        done = self.patch(tree, "--dry-run")
        if done.returncode != 0:
            raise Wrong(f"{self.name} does not apply; write it again: {done.stdout.strip()}")


def all_patches():
    return sorted(FOLDER.glob("*.patch"))


def read_faults(paths):
    """Returns the faults, or raises one exception that names every invalid patch."""
    faults, wrong = [], []
    for path in paths:
        try:
            faults.append(Fault(path))
        except (Wrong, OSError, UnicodeDecodeError) as error:
            wrong.append(str(error))
    if wrong:
        raise Wrong("\n".join(wrong))
    return faults
