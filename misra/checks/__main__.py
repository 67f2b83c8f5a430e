# SPDX-License-Identifier: Apache-2.0
"""Checks the firmware and the generated headers against MISRA C++:2023, with checkers that are themselves tested.

misra/run [--root PROJECT] [--json] BUILD_FOLDER [OUTPUT_FOLDER]
misra/run [--root PROJECT] review BUILD_FOLDER FILE RULE --by NAME --judgement TEXT

Exit status 0: no open finding and no fault in checkers or records; 1: a finding or a fault; 2: wrong use or a missing tool.
"""
import argparse
import datetime
import pathlib
import re
import shutil
import sys
import tempfile
import time

from .cache import drop_unused, folder
from .callgraph import check_call_graph
from .examples import prove_rules
from .records import add_review, apply_deviations, apply_reviews, read_deviations, read_plan, read_reviews
from .reports import Outcome, lead, outcome_json, write_all
from .rules import HOME, ROOT, Faults, Rules, firmware_files, named, short_path
from .served import check_served
from .seeds import prove_on_firmware
from .structure import archives, check_layers, check_symbols
from .tools import TOOLS, compile_each, find


def scope(generated):
    """Returns the translation units of the project's firmware, and its headers together with the generated headers. The wiring of
    a device counts as a unit, because no unit of the firmware includes it."""
    units = [named(path) for pattern in ("*.cpp", "wiring.hpp") for path in firmware_files(ROOT / "src", pattern)]
    headers = [named(path) for path in firmware_files(ROOT / "src", "*.hpp")]
    headers += sorted(str(path) for path in pathlib.Path(generated).rglob("*.hpp"))
    return units, headers


class Progress:
    """Writes one line per step to a stream, with the time so far."""

    def __init__(self, stream):
        self.start = time.monotonic()
        self.stream = stream

    def step(self, text):
        print(f"[{time.monotonic() - self.start:4.0f} s] {text}", file=self.stream, flush=True)


def version_of(home):
    """Returns the version of canproof in its CMakeLists, which is also the version of its checkers."""
    found = re.search(r"project\(canproof VERSION ([0-9.]+)", (home / "CMakeLists.txt").read_text())
    return found.group(1) if found else "0.0.0"


def print_lines(outcome):
    """Prints the open findings and the faults, then the stack of each device and a summary."""
    for finding in outcome.open:
        if finding.rule in outcome.reviewed_rules:
            print(f"{finding.path}:{finding.line}: no valid review for {finding.rule}; judge the file, then "
                  f"`canproof misra review {finding.path} {finding.rule} --by NAME --judgement TEXT`")
        else:
            print(f"{finding.path}:{finding.line}: MISRA C++:2023 rule {finding.rule}")
    for fault in outcome.faults:
        print(fault)
    for name, (used, allowed) in outcome.figures["stack"].items():
        print(f"stack of {name}: {used} of {allowed} bytes")
    print(f"misra: {lead(outcome)}")


def check(build, output, as_json):
    progress, faults, rules = Progress(sys.stderr if as_json else sys.stdout), Faults(), Rules()
    drop_unused(folder())
    generated = build / "generated"
    plan = read_plan(rules, faults)
    progress.step(f"proving the checkers of {len(rules.folders)} guidelines on their examples")
    prove_rules(rules, generated, faults)
    progress.step("proving the checkers on violations seeded into copies of the firmware")
    seeds, unseen = prove_on_firmware(rules, generated, faults)
    units, headers = scope(generated)
    progress.step(f"checking {len(units)} units and {len(headers)} headers of the firmware ({seeds} seeds seen, {unseen} unseen)")
    with tempfile.TemporaryDirectory() as graphs:
        found = find(rules, units, headers, generated, graphs, faults, together=True)
        progress.step("call graph, stack, symbols, layers")
        if ROOT != HOME:  # the stack of a device includes that of the shared firmware
            shared = sorted((HOME / "src" / "firmware").rglob("*.cpp"))
            compile_each([named(path) for path in shared], generated, graphs, faults)
        figures = check_call_graph(graphs, generated, faults)
        figures.update(check_served(generated, faults))
    check_layers(faults)
    check_symbols(build, faults)

    in_scope = {short_path(HOME / path, generated) for path in [*units, *headers]}
    found = {item for item in found if item.path in in_scope}
    reviewed = {item for item in found if item.rule in rules.scopes}
    records, reviews = read_deviations(), read_reviews()
    open_findings, deviated = apply_deviations(found - reviewed, generated, datetime.date.today(), records, faults)
    unjudged = list(apply_reviews(reviewed, generated, reviews, faults))
    outcome = Outcome(version_of(HOME), plan, sorted([*open_findings, *unjudged]), deviated, reviews, figures, faults, records,
                      frozenset(rules.scopes))
    write_all(output, outcome)
    progress.step(f"wrote {output}/misra.sarif, compliance.md, misra.html")
    if as_json:
        print(outcome_json(outcome))
    else:
        print_lines(outcome)
    return 1 if outcome.open or faults else 0


def main(arguments):
    if arguments[:1] == ["review"]:
        parser = argparse.ArgumentParser(prog="misra/run review")
        for name in ("build", "file", "rule"):
            parser.add_argument(name)
        parser.add_argument("--by", required=True)
        parser.add_argument("--judgement", required=True)
        parsed = parser.parse_args(arguments[1:])
        add_review(parsed, pathlib.Path(parsed.build) / "generated")
        return 0
    as_json = arguments[:1] == ["--json"]
    arguments = arguments[1:] if as_json else arguments
    if len(arguments) not in (1, 2):
        print(__doc__.strip(), file=sys.stderr)
        return 2
    build = pathlib.Path(arguments[0]).resolve()
    missing = [tool for tool in TOOLS if shutil.which(tool) is None]
    if missing:
        print(f"misra: not installed: {', '.join(missing)}; `./run setup` installs the missing tools", file=sys.stderr)
        return 2
    if not all(path.exists() for path in archives(build)) or not (build / "generated").is_dir():
        print(f"misra: {build} contains no built firmware; build the firmware with `./run build`, or name another build folder",
              file=sys.stderr)
        return 2
    return check(build, pathlib.Path(arguments[1] if len(arguments) == 2 else build / "misra"), as_json)


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
