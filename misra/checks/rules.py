# SPDX-License-Identifier: Apache-2.0
"""Reads the rules' checkers in misra/rules/, and defines their findings."""
import fnmatch
import functools
import os
import pathlib
import re
import subprocess
from typing import NamedTuple

HERE = pathlib.Path(__file__).resolve().parent.parent
HOME = HERE.parent  # canproof with the checkers and the shared firmware; the tools run in this folder
ROOT = pathlib.Path(os.environ.get("CANPROOF_ROOT") or HOME).resolve()  # the project that is checked
# suffix of copies of firmware files whose seeded violations need exceptions or run-time types; g++ does not check these copies
NO_GCC = "_without_gcc"


def records_of(name):
    """Returns the paths of the record files with this name: that of canproof, and that of the checked project."""
    return [path for path in dict.fromkeys((HERE / name, ROOT / "misra" / name)) if path.exists()]


def firmware_files(sources, pattern):
    """Returns the firmware's files that match `pattern` below `sources`: in firmware/**, devices/NAME/firmware/**,
    target/stm32f405/** and target/zynqmp/** (the drivers of both ports), and devices/NAME/target/wiring.hpp (the device's pins)."""
    drivers = [sources / "target" / port for port in ("stm32f405", "zynqmp")]
    folders = [sources / "firmware", *sorted(sources.glob("devices/*/firmware")), *drivers]
    files = [path for folder in folders for path in sorted(folder.rglob(pattern))]
    return files + [path for path in sorted(sources.glob("devices/*/target/wiring.hpp")) if fnmatch.fnmatch(path.name, pattern)]


def named(path):
    """Returns a path for the tools: relative to their working folder, or absolute for a file of another project."""
    path = pathlib.Path(path)
    return str(path.relative_to(HOME) if path.is_relative_to(HOME) else path)


class Finding(NamedTuple):
    rule: str
    path: str
    line: int


OUTSIDE = "unless(isExpansionInSystemHeader())"
MATCH = re.compile(rf"match ((?P<node>\w+)\((?P<outside>{re.escape(OUTSIDE)}[,)])?.*)")

ROOTS = {"decl": ("decl",), "stmt": ("stmt", "expr", "operator", "case", "literal")}  # matcher of all such nodes → ends of names


def in_few_walks(commands):
    """Returns commands of clang-query that find the same nodes as `commands`. For each command `match`, clang-query walks through the
    whole syntax tree. So all matchers of declarations become one, and those of statements and expressions become another one.
    Matchers that begin with OUTSIDE have a command of their own, which tests this once for each node."""
    first, walks = [], {}
    for command in commands:
        match = MATCH.fullmatch(command)
        root = next((root for root, ends in ROOTS.items() if match and match["node"].lower().endswith(ends)), None)
        if root is None:
            first.append(command)
        else:
            walks.setdefault((root, match["outside"] is not None), []).append(match[1])
    for (root, outside), matchers in walks.items():
        each = f"eachOf({', '.join(matchers)})" if len(matchers) > 1 else matchers[0]
        first.append(f"match {root}({f'{OUTSIDE}, ' if outside else ''}{each})")
    return first


def tool_of(check):
    """Returns the tool that has the check of this name in a rule.checks."""
    tools = {"cppcheck-": "cppcheck", "gcc-": "g++", "clang-diagnostic-": "clang", "clang-analyzer-": "clang"}
    return next((tool for start, tool in tools.items() if check.startswith(start)), "clang-tidy")


class Rules:
    """The checkers of every rule, read from misra/rules/."""

    def __init__(self):
        self.folders = {folder.name: folder for folder in sorted((HERE / "rules").iterdir()) if folder.is_dir()}
        self.checks = {}  # pattern of a check's name → rules, each with the text that a finding must contain
        self.patterns = []  # (rule, compiled pattern, whether the pattern also searches comments and literals)
        matchers = []
        self.scopes = set()  # rules whose matcher finds the places for a review
        for rule, folder in self.folders.items():
            for line in self._lines(folder / "rule.checks"):
                check, _, text = line.partition(" ")
                self.checks.setdefault(check, {})[rule] = text
            for pattern in self._lines(folder / "rule.pattern"):
                raw = pattern.startswith("raw ")
                self.patterns.append((rule, re.compile(pattern.removeprefix("raw "), re.MULTILINE), raw))
            if (folder / "review.query").exists():
                self.scopes.add(rule)
            for matcher in self._lines(folder / "rule.query") + self._lines(folder / "review.query"):
                matchers.append(matcher.replace('bind("finding")', f'bind("{rule}")'))
        self.matchers = ["set output diag", "set bind-root false", *in_few_walks(matchers)]

    @staticmethod
    def _lines(path):
        return [line for line in path.read_text().splitlines() if line] if path.exists() else []

    def of_check(self, name, text):
        """Returns the rules to which the finding `text` of the check `name` belongs."""
        return {rule for pattern, rules in self.checks.items() if fnmatch.fnmatchcase(name, pattern)
                for rule, part in rules.items() if part in text}

    def checks_of(self, tool, files):
        """Returns the checks of a tool that judge these files. An example is judged only by the checks of its own rule, because it may
        violate others."""
        folders = [(HOME / path).parent for path in files]
        own = {folder.name for folder in folders if folder.parent == HERE / "rules"}
        every = any(folder.parent != HERE / "rules" for folder in folders)
        return sorted(name for name, rules in self.checks.items() if tool_of(name) == tool and (every or own & rules.keys()))

    def concerns(self, tool, path):
        """Returns whether a check of the tool judges this file."""
        if tool == "g++" and pathlib.Path(path).stem.endswith(NO_GCC):
            return False
        return bool(self.checks_of(tool, [path]))

    def examples(self):
        return [path for folder in self.folders.values() for path in sorted(folder.glob("*.?pp"))]


class Faults(list):
    """The faults of checkers, plan and records; any fault fails the run."""

    def add(self, text):
        if text not in self:
            self.append(text)


TOKENS = re.compile(
    r"(?P<number>(?<![\w.])\.?\d(?:[eEpP][+-]|'?[\w.])*)|(?P<comment>//(?:\\\n|[^\n])*|/\*.*?\*/)|"
    r"(?P<raw>(?<!\w)(?:u8|[uUL])?R\"(?P<mark>[^()\\\s\"]{0,16})\(.*?\)(?P=mark)\")|"
    r"(?P<literal>\"(?:[^\"\\\n]|\\.)*\"|'(?:[^'\\\n]|\\.)+')", re.DOTALL)


@functools.lru_cache(maxsize=None)
def without_comments_and_literals(text):
    """Returns the text with blanks in place of comments and literals; length and lines stay the same."""
    return TOKENS.sub(lambda token: token.group() if token["number"] else re.sub(r"[^\n]", " ", token.group()), text)


def short_path(path, generated):
    """Returns a path for records and reports: relative to the root of the sources, or generated/…"""
    path = os.path.realpath(path)
    for base in (os.path.realpath(generated), str(ROOT), str(HOME)):
        if path.startswith(base + os.sep):
            return path[len(base) + 1 :]
    return path


def run_tool(command):
    result = subprocess.run(command, cwd=HOME, capture_output=True, text=True, check=False)
    return result.returncode, result.stdout + result.stderr
