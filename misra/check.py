#!/usr/bin/env python3
"""MISRA C++:2023 over src/firmware and the generated headers, by checkers that are themselves tested.

misra/run BUILD_FOLDER [OUTPUT_FOLDER]

A rule's folder misra/rules/RULE/ holds its checkers (rule.query: clang-query matchers that bind "finding"; rule.checks:
clang-tidy checks, warnings among them as clang-diagnostic-NAME; rule.pattern: regular expressions, `raw ` before those that
look into comments and literals too) and its examples: bad*.?pp, whose lines marked `// flagged` it must flag and no others,
good*.?pp, where it must flag nothing. Then every finding in the firmware needs a record in deviations.toml.
"""
import concurrent.futures
import csv
import datetime
import fnmatch
import hashlib
import json
import os
import pathlib
import re
import subprocess
import sys
import tempfile
import tomllib
from typing import NamedTuple

ROOT = pathlib.Path(__file__).resolve().parent.parent
HERE = ROOT / "misra"
LANGUAGE = ["-std=c++17", "-Isrc"]
WARNINGS = ["-Weverything", "-Wno-pragma-once-outside-header", "-Wno-c++98-compat", "-Wno-c++98-compat-pedantic"]
CHUNK = 6  # files a run of a tool: clang-query keeps all their syntax trees


class Finding(NamedTuple):
    rule: str
    path: str
    line: int


class Rules:
    """The checkers of every rule, read from misra/rules/."""

    def __init__(self):
        self.folders = {folder.name: folder for folder in sorted((HERE / "rules").iterdir()) if folder.is_dir()}
        self.checks = {}  # pattern of a check's name → rules
        self.patterns = []  # (rule, compiled, whether comments and literals count)
        self.matchers = ["set output diag", "set bind-root false"]
        for rule, folder in self.folders.items():
            for check in self._lines(folder / "rule.checks"):
                self.checks.setdefault(check, set()).add(rule)
            for pattern in self._lines(folder / "rule.pattern"):
                raw = pattern.startswith("raw ")
                self.patterns.append((rule, re.compile(pattern.removeprefix("raw "), re.MULTILINE), raw))
            for matcher in self._lines(folder / "rule.query"):
                self.matchers.append(matcher.replace('bind("finding")', f'bind("{rule}")'))

    @staticmethod
    def _lines(path):
        return [line for line in path.read_text().splitlines() if line] if path.exists() else []

    def of_check(self, name):
        return {rule for pattern, rules in self.checks.items() if fnmatch.fnmatchcase(name, pattern) for rule in rules}

    def examples(self):
        return [path for folder in self.folders.values() for path in sorted(folder.glob("*.?pp"))]


class Faults(list):
    """What is wrong with the checkers, the plan or the records: any of them fails the run."""

    def add(self, text):
        if text not in self:
            self.append(text)


def short_path(path, generated):
    """As records and reports name a file: from the root of the sources, or generated/…"""
    path = os.path.realpath(path)
    for base, prefix in ((os.path.realpath(generated), ""), (str(ROOT), "")):
        if path.startswith(base + os.sep):
            return prefix + path[len(base) + 1 :]
    return path


def run_tool(command):
    result = subprocess.run(command, cwd=ROOT, capture_output=True, text=True, check=False)
    return result.returncode, result.stdout + result.stderr


def query(rules, files, generated, faults):
    with tempfile.NamedTemporaryFile("w", suffix=".query") as script:
        script.write("\n".join(rules.matchers) + "\n")
        script.flush()
        status, output = run_tool(["clang-query-19", "-f", script.name, *map(str, files), "--", *LANGUAGE, f"-I{generated}"])
    if status != 0:
        faults.add("clang-query-19 failed:\n" + output[-2000:])
    for error in re.findall(r"^.*\berror: .*$", output, re.MULTILINE):
        faults.add("under clang-query: " + error)
    for path, line, rule in re.findall(r'^([^\s:]+):(\d+):\d+: note: "([\d.]+)" binds here$', output, re.MULTILINE):
        yield Finding(rule, short_path(ROOT / path, generated), int(line))


def tidy(rules, files, generated, faults):
    checks = "-*," + ",".join(sorted(rules.checks))
    _, output = run_tool(
        ["clang-tidy-19", "--quiet", f"--checks={checks}", "--header-filter=.*", "--config={}", *map(str, files), "--",
         *LANGUAGE, *WARNINGS, f"-I{generated}"])
    for path, line, kind, text, names in re.findall(r"^([^\s:]+):(\d+):\d+: (warning|error): (.*) \[([^\]]+)\]$", output, re.MULTILINE):
        if "clang-diagnostic-error" in names:
            faults.add(f"does not compile: {path}:{line}: {text}")
        for name in names.split(","):
            for rule in rules.of_check(name):
                yield Finding(rule, short_path(ROOT / path, generated), int(line))


def without_comments_and_literals(text):
    """Same length and lines, with comments and the insides of literals blank."""
    whole = re.compile(r'//[^\n]*|/\*.*?\*/|"(?:[^"\\\n]|\\.)*"|(?<!\w)\'(?:[^\'\\\n]|\\.)+\'', re.DOTALL)
    return whole.sub(lambda match: re.sub(r"[^\n]", " ", match.group()), text)


def search(rules, files, generated):
    for path in files:
        text = (ROOT / path).read_text()
        code = without_comments_and_literals(text)
        header = str(path).endswith(".hpp")
        for rule, pattern, raw in rules.patterns:
            if "header" in pattern.groupindex and not header:
                continue
            for match in pattern.finditer(text if raw else code):
                start = match.start("at") if "at" in pattern.groupindex else match.start()
                yield Finding(rule, short_path(ROOT / path, generated), text.count("\n", 0, start) + 1)


def find(rules, units, headers, generated, faults):
    """All findings in the units, in what they include, and (by pattern) in the headers."""
    chunks = [units[at : at + CHUNK] for at in range(0, len(units), CHUNK)]
    found = set(search(rules, [*units, *headers], generated))
    with concurrent.futures.ThreadPoolExecutor(max_workers=os.cpu_count()) as pool:
        jobs = [pool.submit(lambda t=tool, c=chunk: list(t(rules, c, generated, faults))) for chunk in chunks for tool in (query, tidy)]
        for job in jobs:
            found.update(job.result())
    return found


def prove_rules(rules, generated, faults):
    """Every rule's checkers flag the marked lines of its bad examples, and nothing else there or in its good ones."""
    found = find(rules, [str(path.relative_to(ROOT)) for path in rules.examples()], [], generated, faults)
    for rule, folder in rules.folders.items():
        kinds = {path.name.split(".")[0].split("_")[0] for path in folder.glob("*.?pp")}
        if not {"bad", "good"} <= kinds:
            faults.add(f"rule {rule} lacks a bad or a good example")
        for path in sorted(folder.glob("*.?pp")):
            name = str(path.relative_to(ROOT))
            lines = path.read_text().splitlines()
            expected = {at for at, text in enumerate(lines, 1) if "// flagged" in text}
            if path.name.startswith("bad") != bool(expected):
                faults.add(f"{name}: marks must stand in bad examples, and only there")
            flagged = {finding.line for finding in found if finding.rule == rule and finding.path == name}
            if flagged != expected:
                faults.add(f"{name}: flagged in line(s) {sorted(flagged)}, must be {sorted(expected)}")


def prove_on_firmware(rules, generated, faults):
    """seeds.toml: violations appended to copies of firmware files, each flagged in its line under its rule."""
    seeds = tomllib.loads((HERE / "seeds.toml").read_text())["seed"]
    with tempfile.TemporaryDirectory() as scratch:
        expected = []
        for file in sorted({seed["file"] for seed in seeds}):
            copy = pathlib.Path(scratch).resolve() / file.replace("/", "_")
            lines = (ROOT / file).read_text().splitlines()
            for seed in (seed for seed in seeds if seed["file"] == file):
                lines.append(seed["line"])
                expected.append(Finding(seed["rule"], str(copy), len(lines)))
            copy.write_text("\n".join(lines) + "\n")
        found = find(rules, sorted({finding.path for finding in expected}), [], generated, faults)
    for finding in set(expected) - found:
        faults.add(f"a seeded violation of rule {finding.rule} goes unseen: {finding.path}:{finding.line}")


def read_plan(rules, faults):
    """plan.csv: the 179 guidelines, each once; what is `enforced` has a tested checker, and the other way round."""
    with open(HERE / "plan.csv", newline="", encoding="utf-8") as file:
        plan = list(csv.DictReader(file))
    numbers = [row["guideline"] for row in plan]
    if numbers != (HERE / "guidelines.txt").read_text().split():
        faults.add("plan.csv does not hold the guidelines of guidelines.txt, each once and in order")
    for row in plan:
        number, how = row["guideline"], row["enforcement"]
        if how not in ("enforced", "review", "not applicable", "planned"):
            faults.add(f"plan.csv {number}: unknown enforcement {how}")
        if (how == "enforced") != (number in rules.folders) and how != "planned":
            faults.add(f"plan.csv {number} is {how}: rules/{number} {'missing' if how == 'enforced' else 'not expected'}")
        if how != "enforced" and not row["note"]:
            faults.add(f"plan.csv {number}: {how} without a reason")
        weaker = {"mandatory": [], "required": ["mandatory"], "advisory": ["mandatory", "required", "disapplied"]}
        if row["recategorised"] and row["recategorised"] not in weaker[row["category"]]:
            faults.add(f"plan.csv {number}: a {row['category']} guideline cannot become {row['recategorised']}")
    for number in rules.folders.keys() - set(numbers):
        faults.add(f"rules/{number} is no guideline")
    return plan


def source_line(finding, generated):
    base = pathlib.Path(generated) if finding.path.startswith("generated/") else ROOT
    return (base / finding.path).read_text().splitlines()[finding.line - 1]


def apply_deviations(findings, generated, today, records, faults):
    """The findings that no record covers, and those that one does."""
    open_findings, deviated, used = [], [], set()
    for at, record in enumerate(records):
        missing = {"rule", "place", "line", "reason", "risk", "expiry"} - record.keys()
        if missing:
            faults.add(f"deviation {at + 1} lacks {', '.join(sorted(missing))}")
        elif record["expiry"] < today:
            faults.add(f"deviation {at + 1} (rule {record['rule']}) expired on {record['expiry']}")
    for finding in sorted(findings):
        text = source_line(finding, generated)
        for at, record in enumerate(records):
            if finding.rule == record["rule"] and fnmatch.fnmatchcase(finding.path, record["place"]) and re.search(record["line"], text):
                used.add(at)
                deviated.append((finding, record))
                break
        else:
            open_findings.append(finding)
    for at, record in enumerate(records):
        if at not in used:
            faults.add(f"deviation {at + 1} (rule {record.get('rule')} in {record.get('place')}) matches no finding")
    return open_findings, deviated


def check_reviews(plan, faults):
    """reviews.toml: a record holds for the content it was written for. A guideline under review has records for all it names."""
    path = HERE / "reviews.toml"
    reviews = tomllib.loads(path.read_text()).get("review", []) if path.exists() else []
    for review in reviews:
        file = ROOT / review["file"]
        content = hashlib.sha256(file.read_bytes()).hexdigest() if file.exists() else ""
        if content != review["sha256"]:
            faults.add(f"review of {review['file']} for {review['rule']} ({review['date']}) is stale: now {content or 'gone'}")
    for row in plan:
        if row["enforcement"] == "review" and row["guideline"] not in {review["rule"] for review in reviews}:
            faults.add(f"plan.csv {row['guideline']}: under review, without a record in reviews.toml")
    return reviews


def against_the_layers(folder):
    """Includes against the arrows base ← canopen, blocks ← devices, under folder/firmware; blocks know no object dictionary."""
    allowed = {
        "base": ("firmware/base/",),
        "canopen": ("firmware/base/", "firmware/canopen/", "generated/"),
        "blocks": ("firmware/base/", "firmware/blocks/", "generated/"),
        "devices": ("firmware/", "generated/"),
    }
    for path in sorted((folder / "firmware").rglob("*.?pp")):
        layer = path.relative_to(folder / "firmware").parts[0]
        for at, text in enumerate(path.read_text().splitlines(), 1):
            include = re.match(r'\s*#\s*include\s*"([^"]+)"', text)
            if include is None:
                continue
            name = include.group(1)
            dictionary = name.startswith("generated/canopen/") or name.endswith("/objects.hpp")
            if not name.startswith(allowed.get(layer, ())) or (layer == "blocks" and dictionary):
                yield str(path), at


def check_layers(faults):
    bad = HERE / "layers" / "bad"
    expected = {
        (str(path), at)
        for path in bad.rglob("*.?pp")
        for at, text in enumerate(path.read_text().splitlines(), 1)
        if "// flagged" in text
    }
    if not expected or set(against_the_layers(bad)) != expected:
        faults.add("the include check does not flag just the marked lines of misra/layers/bad")
    for path, at in against_the_layers(ROOT / "src"):
        faults.add(f"{os.path.relpath(path, ROOT)}:{at}: an include against the layers")


# Allocation, exceptions, run-time type information, ending the program: what the firmware must not pull in.
FORBIDDEN = re.compile(
    r"^(?:malloc|calloc|realloc|free|aligned_alloc|_Zn[wa]\w*|_Zd[la]\w*|__cxa_(?!pure_virtual|guard_)\w*|__gxx_personality\w*|"
    r"_Unwind_\w*|__dynamic_cast|_ZSt\d+__throw_\w*|_ZSt9terminatev|abort|exit|printf|puts)$")


def forbidden_symbols(archive):
    _, output = run_tool(["nm", "--undefined-only", "--format=just-symbols", str(archive)])
    return sorted({name for name in output.split() if FORBIDDEN.match(name)})


def check_symbols(build, faults):
    with tempfile.TemporaryDirectory() as scratch:
        seeded = pathlib.Path(scratch) / "bad.o"
        status, output = run_tool(["g++", "-std=c++17", "-c", str(HERE / "symbols" / "bad.cpp"), "-o", str(seeded)])
        names = forbidden_symbols(seeded) if status == 0 else []
        if not {"_Znwm", "__cxa_throw", "__dynamic_cast"} <= set(names):
            faults.add(f"the symbol check misses what misra/symbols/bad.cpp holds: {names} {output}")
    archive = pathlib.Path(build) / "libcanproof_firmware.a"
    if not archive.exists():
        faults.add(f"{archive} is not built: the symbols are unchecked")
        return
    for name in forbidden_symbols(archive):
        faults.add(f"the firmware library needs {name}")


def write_sarif(folder, plan, open_findings, deviated):
    def result(finding, record=None):
        location = {"artifactLocation": {"uri": finding.path}, "region": {"startLine": finding.line}}
        entry = {
            "ruleId": finding.rule,
            "level": "error",
            "message": {"text": f"MISRA C++:2023 {finding.rule}"},
            "locations": [{"physicalLocation": location}],
        }
        if record:
            entry["suppressions"] = [{"kind": "external", "status": "accepted", "justification": record["reason"]}]
        return entry

    descriptors = [{"id": row["guideline"], "shortDescription": {"text": row["topic"]}} for row in plan]
    run = {
        "tool": {"driver": {"name": "canproof misra", "rules": descriptors}},
        "results": [result(finding) for finding in open_findings] + [result(finding, record) for finding, record in deviated],
    }
    sarif = {"$schema": "https://json.schemastore.org/sarif-2.1.0.json", "version": "2.1.0", "runs": [run]}
    (folder / "misra.sarif").write_text(json.dumps(sarif, indent=1) + "\n")


def compliance(row, open_rules, deviated_rules):
    """A guideline's level as MISRA Compliance:2020 has it."""
    if row["recategorised"] == "disapplied":
        return "disapplied"
    if row["enforcement"] == "planned":
        return "not yet checked"
    if row["enforcement"] == "not applicable":
        return "compliant (not applicable)"
    if row["guideline"] in open_rules:
        return "violations"
    return "deviations" if row["guideline"] in deviated_rules else "compliant"


def write_summary(folder, plan, open_findings, deviated):
    open_rules = {finding.rule for finding in open_findings}
    deviated_rules = {finding.rule for finding, _ in deviated}
    lines = ["# Guideline compliance summary: MISRA C++:2023", "", "| guideline | category | recategorised | enforcement | compliance |", "|---|---|---|---|---|"]
    for row in plan:
        level = compliance(row, open_rules, deviated_rules)
        lines.append(f"| {row['guideline']} | {row['category']} | {row['recategorised'] or '–'} | {row['enforcement']} | {level} |")
    (folder / "compliance.md").write_text("\n".join(lines) + "\n")


def scope(generated):
    """The firmware's units, and every header with the generated ones."""
    units = sorted(str(path.relative_to(ROOT)) for path in (ROOT / "src/firmware").rglob("*.cpp"))
    headers = sorted(str(path.relative_to(ROOT)) for path in (ROOT / "src/firmware").rglob("*.hpp"))
    headers += sorted(str(path) for path in pathlib.Path(generated).rglob("*.hpp"))
    return units, headers


def main(arguments):
    if len(arguments) not in (1, 2):
        print("misra/run BUILD_FOLDER [OUTPUT_FOLDER]", file=sys.stderr)
        return 2
    build = pathlib.Path(arguments[0]).resolve()
    output = pathlib.Path(arguments[1] if len(arguments) == 2 else build / "misra")
    generated = build / "generated"
    faults = Faults()
    rules = Rules()
    plan = read_plan(rules, faults)
    prove_rules(rules, generated, faults)
    prove_on_firmware(rules, generated, faults)
    check_layers(faults)
    check_symbols(build, faults)
    reviews = check_reviews(plan, faults)

    units, headers = scope(generated)
    enforced = {row["guideline"] for row in plan if row["enforcement"] == "enforced"}
    in_scope = {short_path(ROOT / path, generated) for path in [*units, *headers]}
    found = {item for item in find(rules, units, headers, generated, faults) if item.path in in_scope}
    records = tomllib.loads((HERE / "deviations.toml").read_text()).get("deviation", [])
    planned = [item for item in found if item.rule not in enforced]
    open_findings, deviated = apply_deviations(found - set(planned), generated, datetime.date.today(), records, faults)

    output.mkdir(parents=True, exist_ok=True)
    write_sarif(output, plan, open_findings, deviated)
    write_summary(output, plan, open_findings, deviated)
    for finding in open_findings:
        print(f"{finding.path}:{finding.line}: MISRA C++:2023 rule {finding.rule}")
    for fault in faults:
        print(fault)
    count = {how: sum(row["enforcement"] == how for row in plan) for how in ("enforced", "review", "not applicable", "planned")}
    print(", ".join(f"{number} {how}" for how, number in count.items()) + f" of {len(plan)} guidelines")
    print(f"misra: {len(open_findings)} open finding(s), {len(deviated)} under {len(records)} deviation(s), "
          f"{len(reviews)} review(s), {len(faults)} fault(s) in checkers or records")
    return 1 if open_findings or faults else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
