"""Proof of the checkers: on each rule's examples, and on violations put into copies of firmware files."""
import pathlib
import tempfile
import tomllib

from .rules import HERE, HOME, ROOT, Finding, named
from .tools import find


def prove_rules(rules, generated, faults):
    """Every rule's checkers flag the marked lines of its bad examples, and nothing else there or in its good ones."""
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
                faults.add(f"{name}: marks must stand in bad examples, and only there")
            flagged = {finding.line for finding in found if finding.rule == rule and finding.path == name}
            if flagged != expected:
                faults.add(f"{name}: flagged in line(s) {sorted(flagged)}, must be {sorted(expected)}")


def prove_on_firmware(rules, units, generated, faults):
    """seeds.toml: violations appended to copies of firmware files, each flagged in its line under its rule. Another project
    has its own first unit in place of a device of canproof's. Returns their number."""
    seeds = tomllib.loads((HERE / "seeds.toml").read_text())["seed"]
    for seed in seeds:
        if ROOT != HOME and not seed["file"].startswith("src/firmware/"):
            seed["file"] = units[0]
    with tempfile.TemporaryDirectory() as scratch:
        expected = []
        for file in sorted({seed["file"] for seed in seeds}):
            copy = pathlib.Path(scratch).resolve() / file.replace("/", "_")
            lines = (HOME / file).read_text().splitlines()
            for seed in (seed for seed in seeds if seed["file"] == file):
                lines.append(seed["line"])
                expected.append(Finding(seed["rule"], str(copy), len(lines)))
            copy.write_text("\n".join(lines) + "\n")
        found = find(rules, sorted({finding.path for finding in expected}), [], generated, scratch, faults)
    for finding in set(expected) - found:
        faults.add(f"a seeded violation of rule {finding.rule} goes unseen: {finding.path}:{finding.line}")
    if len({finding.rule for finding in expected}) < 10:
        faults.add("seeds.toml holds violations of fewer than ten rules")
    return len(seeds)
