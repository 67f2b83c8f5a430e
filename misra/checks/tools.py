# SPDX-License-Identifier: Apache-2.0
"""Runs the tools and parses their outputs: clang-query, clang-tidy (with clang's warnings and analyzer), cppcheck, g++."""
import concurrent.futures
import itertools
import os
import pathlib
import re

from .cache import run_cached
from .definitions import hidden_and_renamed, one_definition, same_aliases
from .joined import Joined, Separate, unit_of
from .rules import HOME, ROOT, Finding, short_path, without_comments_and_literals
from .scans import scan

LANGUAGE = ["-std=c++17", "-Isrc"]
CLANG_WARNINGS = ["-Weverything", "-Wno-pragma-once-outside-header", "-Wno-c++98-compat", "-Wno-c++98-compat-pedantic"]
# The analyzer of g++ does not look for uninitialised values: in g++ 12 it does not follow constructors. clang's analyzer does.
GCC = ["-O1", "-fno-exceptions", "-fno-rtti", "-fanalyzer", "-Wno-analyzer-use-of-uninitialized-value", "-Wno-analyzer-too-complex",
       "-fdiagnostics-plain-output", "-fdiagnostics-path-format=none", "-Wall", "-Wextra", "-Wnull-dereference", "-Wduplicated-cond",
       "-Wduplicated-branches", "-Wlogical-op", "-Wfloat-equal", "-Wdouble-promotion", "-fcallgraph-info=su"]
# clang-tidy refuses to run without a check of its own; no firmware calls the functions that this one looks for
NO_CHECK = "darwin-avoid-spinlock"
# With such an error, cppcheck looks at no code of the unit.
BLIND = re.compile(r"^([^\s:]+):.* \[(?:preprocessorErrorDirective|syntaxError|internalError|internalAstError|cppcheckError|unknownMacro)\]$", re.MULTILINE)
CHUNK = 6  # number of separate files for each run of a tool; clang-query keeps all their syntax trees in memory
TOOLS = ["clang-query-19", "clang-tidy-19", "cppcheck", "g++", "nm", "c++filt"]


def language(files):
    """Returns the compiler flags for these files. A project outside canproof has its own headers and absolute paths."""
    elsewhere = ROOT != HOME and any(pathlib.Path(path).is_absolute() for path in files)
    return [*LANGUAGE, *([f"-I{ROOT}/src"] if elsewhere else [])]


def query(rules, unit, generated, scratch, faults):
    """Runs all matchers over the files of a unit."""
    status, output = run_cached(["clang-query-19", "-f", "@script@", *unit.sources, "--", *language(unit.files), f"-I{generated}"],
                                unit.sources, generated, script="\n".join(rules.matchers) + "\n", scratch=scratch)
    output = unit.own_places(output)
    if status != 0:
        wrong = re.findall(r"^\d+:\d+: .*$", output, re.MULTILINE)  # errors in a matcher
        faults.add("clang-query-19 failed:\n" + "\n".join(wrong or [output[-2000:]]))
    for path, message in re.findall(r"^([^\s:]+)(.*\berror: .*)$", output, re.MULTILINE):
        faults.add(f"under clang-query: {path}{message}")
    for path, line, rule in re.findall(r'^([^\s:]+):(\d+):\d+: note: "([\d.]+)" binds here$', output, re.MULTILINE):
        yield Finding(rule, short_path(HOME / path, generated), int(line))


def parted(files, refused):
    """Returns the files that are not in `refused`, and those that are; if one of these lists would be empty, two halves of `files`."""
    apart = [path for path in files if path in refused]
    if len(apart) in (0, len(files)):
        apart = files[: len(files) // 2]
    return [path for path in files if path not in apart], apart


def joined_units(files, generated, scratch):
    """Returns units that together contain these files, as few as g++ accepts: files that define the same name are in different units."""
    units, waiting = [], [list(files)]
    while waiting:
        group = waiting.pop()
        unit = unit_of(group, scratch)
        if len(group) > 1:
            status, output = run_cached(["g++", *language(group), f"-I{generated}", "-fsyntax-only", *unit.sources], unit.sources,
                                        generated, scratch=scratch)
            if status != 0:
                refused = set(re.findall(r"^([^\s:]+):\d+:\d+: (?:fatal )?error: ", unit.own_places(output), re.MULTILINE))
                waiting += parted(unit.files, refused)
                continue
        units.append(unit)
    return units


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


def run_tidy(tool, flags, rules, unit, generated, scratch, faults):
    """Runs the checks of `tool`: clang-tidy also contains clang's warnings and analyzer."""
    checks = ",".join(["-*", NO_CHECK, *rules.checks_of(tool, unit.files)])
    _, output = run_cached(
        ["clang-tidy-19", "--quiet", f"--checks={checks}", "--header-filter=.*", "--config={}", *unit.sources, "--",
         *language(unit.files), *flags, f"-I{generated}"], unit.sources, generated, scratch=scratch)
    if "Error: no checks enabled" in output:
        faults.add(f"clang-tidy-19 knows none of the checks {checks}")
    yield from named_findings(rules, unit.own_places(output), "", generated, faults)


def tidy(*arguments):
    """Runs the checks of clang-tidy itself."""
    yield from run_tidy("clang-tidy", [], *arguments)


def clang(*arguments):
    """Runs clang's warnings and its analyzer, on files alone. Their time is that of the functions rather than that of the headers. In a
    joined unit, the analyzer would skip a function after a call in another file, and then know only the arguments of this call. A
    name of a local variable would hide the names of all other files."""
    yield from run_tidy("clang", CLANG_WARNINGS, *arguments)


def cppcheck(rules, unit, generated, scratch, faults):
    status, output = run_cached(
        ["cppcheck", "--quiet", "--enable=warning,performance,portability,style", "--std=c++17", "--language=c++",
         *language(unit.files)[1:], f"-I{generated}", "--template={file}:{line}:{column}: {severity}: {message} [{id}]", *unit.sources],
        unit.sources, generated, scratch=scratch)
    output = unit.own_places(output)
    blind = set(BLIND.findall(output))
    if blind and isinstance(unit, Joined):
        for part in parted(unit.files, blind):
            yield from cppcheck(rules, unit_of(part, scratch), generated, scratch, faults)
        return
    if status != 0:
        faults.add("cppcheck failed:\n" + output[-2000:])
    yield from named_findings(rules, output, "cppcheck-", generated, faults)


def compile_with_gcc(rules, unit, generated, graphs, faults, flags=GCC):
    """Runs g++ with warnings and analyzer. It also writes the call graph with stack use to the folder `graphs`."""
    for path in unit.sources:
        name = path.removeprefix(os.path.realpath(graphs) + os.sep).replace("/", "_")  # the same in each run: the cache compares it
        target = pathlib.Path(graphs) / f"{name}.o"
        graph = target.with_suffix(".ci")
        status, output = run_cached(["g++", *language(unit.files), *flags, f"-I{generated}", "-c", path, "-o", str(target)],
                                    [path], generated, scratch=graphs, leaves=graph)
        output = unit.own_places(output)
        if status != 0:
            faults.add("does not compile with g++:\n" + output[-2000:])
        else:
            graph.write_text(unit.own_places(graph.read_text()))
        output = re.sub(r"(?: \[CWE-\d+\])? \[-W([\w+=-]+)\]$", r" [\1]", output, flags=re.MULTILINE)
        yield from named_findings(rules, output, "gcc-", generated, faults)


class NoRules:
    """Replaces the rules where the findings do not count."""

    @staticmethod
    def of_check(name, text):
        return ()


def compile_each(units, generated, graphs, faults, flags=GCC, together=False):
    """Writes the call graphs of units and ignores their findings. `together`: as in find()."""
    with concurrent.futures.ThreadPoolExecutor(max_workers=os.cpu_count()) as pool:
        of_units = in_units(pool, units, generated, graphs) if together else [Separate([path]) for path in units]
        list(pool.map(lambda unit: list(compile_with_gcc(NoRules, unit, generated, graphs, faults, flags)), of_units))


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


def in_units(pool, files, generated, scratch):
    """Returns few units with these files; each unit contains files of one folder."""
    folders = [list(group) for _, group in itertools.groupby(files, key=os.path.dirname)]
    return [unit for units in pool.map(lambda group: joined_units(group, generated, scratch), folders) for unit in units]


def in_chunks(files, count=CHUNK):
    return [Separate(files[at : at + count]) for at in range(0, len(files), count)]


def find(rules, units, headers, generated, graphs, faults, together=False):
    """Returns all findings in the units and in the files that they include. The checks of text also search `headers`. `together`:
    the units of a folder may be in one unit for the tools, because they are parts of one program. Only clang and g++ read each unit
    alone. They show that it has all includes that it needs, and g++ computes the stack of its functions as in the firmware."""
    texts = {short_path(HOME / path, generated): (HOME / path).read_text() for path in [*units, *headers]}
    found = {*search(rules, [*units, *headers], generated), *one_definition(texts), *same_aliases(texts), *hidden_and_renamed(texts)}
    judged = {tool: [path for path in units if rules.concerns(tool, path)] for tool in ("clang", "clang-tidy", "cppcheck", "g++")}
    with concurrent.futures.ThreadPoolExecutor(max_workers=os.cpu_count()) as pool:
        joined = in_units(pool, units, generated, graphs) if together else None
        work = [(tool, unit) for tool, name in ((clang, "clang"), (compile_with_gcc, "g++")) for unit in in_chunks(judged[name], 1)]
        work += [(query, unit) for unit in joined or in_chunks(units)]
        work += [(tool, unit) for tool, name in ((tidy, "clang-tidy"), (cppcheck, "cppcheck")) for unit in joined or in_chunks(judged[name])]
        jobs = [pool.submit(lambda t=tool, u=unit: list(t(rules, u, generated, graphs, faults))) for tool, unit in work]
        for job in concurrent.futures.as_completed(jobs):
            found.update(job.result())
    return found
