# SPDX-License-Identifier: Apache-2.0
"""Runs the tools and parses their outputs: clang-query, clang-tidy (with clang's warnings and analyzer), cppcheck, g++."""
import concurrent.futures
import hashlib
import itertools
import os
import pathlib
import re

from .cache import run_cached
from .definitions import hidden_and_renamed, one_definition, same_aliases
from .rules import HOME, ROOT, Finding, short_path, without_comments_and_literals
from .scans import scan

LANGUAGE = ["-std=c++17", "-Isrc"]
CLANG_WARNINGS = ["-Weverything", "-Wno-pragma-once-outside-header", "-Wno-c++98-compat", "-Wno-c++98-compat-pedantic"]
# The analyzer of g++ does not look for uninitialised values: in g++ 12 it does not follow constructors. clang's analyzer does.
GCC = ["-O1", "-fno-exceptions", "-fno-rtti", "-fanalyzer", "-Wno-analyzer-use-of-uninitialized-value", "-Wno-analyzer-too-complex",
       "-fdiagnostics-plain-output", "-fdiagnostics-path-format=none", "-Wall", "-Wextra", "-Wnull-dereference", "-Wduplicated-cond",
       "-Wduplicated-branches", "-Wlogical-op", "-Wfloat-equal", "-Wdouble-promotion", "-fcallgraph-info=su"]
CHUNK = 6  # number of files for each run of a tool; clang-query keeps all their syntax trees in memory
TOOLS = ["clang-query-19", "clang-tidy-19", "cppcheck", "g++", "nm", "c++filt"]


def language(files):
    """Returns the compiler flags for these files. A project outside canproof has its own headers and absolute paths."""
    elsewhere = ROOT != HOME and any(pathlib.Path(path).is_absolute() for path in files)
    return [*LANGUAGE, *([f"-I{ROOT}/src"] if elsewhere else [])]


def run_query(rules, files, generated, scratch, faults):
    """Runs all matchers over files. Returns the findings, and the compiler's errors as (path, message)."""
    status, output = run_cached(["clang-query-19", "-f", "@script@", *map(str, files), "--", *language(files), f"-I{generated}"],
                                files, generated, script="\n".join(rules.matchers) + "\n", scratch=scratch)
    if status != 0:
        wrong = re.findall(r"^\d+:\d+: .*$", output, re.MULTILINE)  # errors in a matcher
        faults.add("clang-query-19 failed:\n" + "\n".join(wrong or [output[-2000:]]))
    found = [Finding(rule, short_path(HOME / path, generated), int(line))
             for path, line, rule in re.findall(r'^([^\s:]+):(\d+):\d+: note: "([\d.]+)" binds here$', output, re.MULTILINE)]
    return found, re.findall(r"^([^\s:]+)(.*\berror: .*)$", output, re.MULTILINE)


def query(rules, files, generated, scratch, faults):
    found, errors = run_query(rules, files, generated, scratch, faults)
    for path, message in errors:
        faults.add(f"under clang-query: {path}{message}")
    yield from found


def query_together(rules, files, generated, scratch, faults):
    """Runs all matchers over one unit that includes these files: most of the time is spent on headers, which the unit contains
    only once. Files that define the same name cannot be in one unit: those that the compiler refuses are in another unit."""
    waiting = [list(files)]
    while waiting:
        group = waiting.pop()
        if len(group) == 1:
            yield from query(rules, group, generated, scratch, faults)
            continue
        unit = pathlib.Path(scratch) / f"together_{hashlib.sha256(repr(group).encode()).hexdigest()[:16]}.cpp"
        unit.write_text("".join(f'#include "{HOME / path}"\n' for path in group))
        found, errors = run_query(rules, [unit], generated, scratch, faults)
        if not errors:
            yield from found
            continue
        refused = {os.path.realpath(HOME / path) for path, _ in errors}
        apart = [path for path in group if os.path.realpath(HOME / path) in refused]
        if len(apart) in (0, len(group)):
            apart = group[: len(group) // 2]
        waiting += [[path for path in group if path not in apart], apart]


def named_findings(rules, output, prefix, generated, faults):
    """Parses lines `file:line:column: severity: text [name]` of any tool. Returns a finding for each rule to
    which the check `name` belongs."""
    pattern = r"^([^\s:]+):(\d+):\d+: (?:fatal )?(warning|error|style|performance|portability): (.*) \[([^\]]+)\]$"
    for path, line, _, text, names in re.findall(pattern, output, re.MULTILINE):
        if "clang-diagnostic-error" in names:
            faults.add(f"does not compile: {path}:{line}: {text}")
        for name in names.split(","):
            for rule in rules.of_check(prefix + name, text):
                yield Finding(rule, short_path(HOME / path, generated), int(line))


def tidy(rules, files, generated, scratch, faults):
    checks = "-*," + ",".join(sorted(name for name in rules.checks if not name.startswith(("cppcheck-", "gcc-"))))
    _, output = run_cached(
        ["clang-tidy-19", "--quiet", f"--checks={checks}", "--header-filter=.*", "--config={}", *map(str, files), "--",
         *language(files), *CLANG_WARNINGS, f"-I{generated}"], files, generated, scratch=scratch)
    yield from named_findings(rules, output, "", generated, faults)


def cppcheck(rules, files, generated, scratch, faults):
    status, output = run_cached(
        ["cppcheck", "--quiet", "--enable=warning,performance,portability,style", "--std=c++17", "--language=c++",
         *language(files)[1:], f"-I{generated}", "--template={file}:{line}:{column}: {severity}: {message} [{id}]", *map(str, files)],
        files, generated, scratch=scratch)
    if status != 0:
        faults.add("cppcheck failed:\n" + output[-2000:])
    yield from named_findings(rules, output, "cppcheck-", generated, faults)


def compile_with_gcc(rules, files, generated, graphs, faults, flags=GCC):
    """Runs g++ with warnings and analyzer. It also writes the call graph with stack use to the folder `graphs`."""
    for path in files:
        target = pathlib.Path(graphs) / (str(path).replace("/", "_") + ".o")
        status, output = run_cached(["g++", *language([path]), *flags, f"-I{generated}", "-c", str(path), "-o", str(target)],
                                    [path], generated, scratch=graphs, leaves=target.with_suffix(".ci"))
        if status != 0:
            faults.add("does not compile with g++:\n" + output[-2000:])
        output = re.sub(r"(?: \[CWE-\d+\])? \[-W([\w+=-]+)\]$", r" [\1]", output, flags=re.MULTILINE)
        yield from named_findings(rules, output, "gcc-", generated, faults)


def compile_each(units, generated, graphs, faults, flags=GCC):
    """Writes the call graphs of units and ignores their findings."""
    class NoRules:
        @staticmethod
        def of_check(name, text):
            return ()
    with concurrent.futures.ThreadPoolExecutor(max_workers=os.cpu_count()) as pool:
        list(pool.map(lambda unit: list(compile_with_gcc(NoRules, [unit], generated, graphs, faults, flags)), units))


def search(rules, files, generated):
    for path in files:
        text = (HOME / path).read_text()
        code = without_comments_and_literals(text)
        yield from scan(short_path(HOME / path, generated), text)
        header = str(path).endswith(".hpp")
        for rule, pattern, raw in rules.patterns:
            if "header" in pattern.groupindex and not header:
                continue
            for match in pattern.finditer(text if raw else code):
                start = match.start("at") if "at" in pattern.groupindex else match.start()
                yield Finding(rule, short_path(HOME / path, generated), text.count("\n", 0, start) + 1)


def find(rules, units, headers, generated, graphs, faults, together=False):
    """Returns all findings in the units and in the files that they include. The checks of text also search `headers`. `together`:
    the units of a folder may be in one unit for clang-query, because they are parts of one program."""
    chunks = [units[at : at + CHUNK] for at in range(0, len(units), CHUNK)]
    texts = {short_path(HOME / path, generated): (HOME / path).read_text() for path in [*units, *headers]}
    found = {*search(rules, [*units, *headers], generated), *one_definition(texts), *same_aliases(texts), *hidden_and_renamed(texts)}
    if together:
        work = [(query_together, list(group)) for _, group in itertools.groupby(units, key=os.path.dirname)]
    else:
        work = [(query, chunk) for chunk in chunks]
    work += [(tidy, chunk) for chunk in chunks]
    work += [(cppcheck, [path for path in chunk if rules.concerns("cppcheck-", path)]) for chunk in chunks]
    work += [(compile_with_gcc, [path for path in chunk if rules.concerns("gcc-", path)]) for chunk in chunks]
    with concurrent.futures.ThreadPoolExecutor(max_workers=os.cpu_count()) as pool:
        jobs = [pool.submit(lambda t=tool, c=chunk: list(t(rules, c, generated, graphs, faults))) for tool, chunk in work if chunk]
        for job in concurrent.futures.as_completed(jobs):
            found.update(job.result())
    return found
