# SPDX-License-Identifier: Apache-2.0
"""Tests the checkers on each rule's examples."""
import tempfile

from .rules import HOME, named
from .tools import find


def prove_rules(rules, generated, faults):
    """Checks that each rule's checkers flag the marked lines of its bad examples, and no other lines of its examples."""
    with tempfile.TemporaryDirectory() as graphs:
        found = find(rules, [named(path) for path in rules.examples()], [], generated, graphs, faults)
    for rule, folder in rules.folders.items():
        kinds = {path.name.split(".")[0].split("_")[0] for path in folder.glob("*.?pp")}
        if not {"bad", "good"} <= kinds:
            faults.add(f"rule {rule} lacks a bad or a good example")
        for path in sorted(folder.glob("*.?pp")):
            name = named(path)
            lines = path.read_text().splitlines()
            expected = {at for at, text in enumerate(lines, 1) if "// flagged" in text}
            if path.name.startswith("bad") != bool(expected):
                faults.add(f"{name}: each bad example needs a line marked with `// flagged`, and no good example may have one")
            flagged = {finding.line for finding in found if finding.rule == rule and finding.path == name}
            if flagged != expected:
                faults.add(f"{name}: the checkers of rule {rule} flag the lines {sorted(flagged)}, "
                           f"but `// flagged` marks {sorted(expected)}")
