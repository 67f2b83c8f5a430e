# SPDX-License-Identifier: Apache-2.0
"""Finds functions of the firmware that serve no item of the requirements register: they implement no item, and no function that
serves an item calls them.

A function serves an item in three cases:
- A link (`static_assert(implements<req::…>)`) is in it, or directly above it or its declaration.
- A serving function calls it.
- It constructs a class with a serving function.
The functions that every device has (src/devices/README.md, step 2) only forward calls and need no item.
reports/functions.toml contains the other functions, each with a reason. A record that names no such function is a
fault. The compiler's call graph contains the calls."""
import collections
import pathlib
import re
import tempfile
import tomllib

from .callgraph import CallGraph
from .rules import HOME, ROOT, Faults, firmware_files, named, records_of, without_comments_and_literals
from .tools import compile_each

# Without inlining, every function is in the call graph.
UNOPTIMISED = ["-O0", "-fcallgraph-info=su,da"]
LINK = re.compile(r"\bimplements<req::")
INTERFACE = re.compile(r"::Device::(?:power_on|receive|set_inputs|advance|next_deadline|outputs|node_id|bit_rate|state|objects)$")
FIRMWARE = re.compile(r"(?:^|/)(src/(?:firmware|devices/[^/]+/firmware)/.+)$")
NAME = re.compile(r"((?:[\w{}~]+(?:<.*?>)?::)*~?[\w=<>!+*/&|^-]+)(?:\(|$)")


class Source:
    """One file: the lines of its implements<> assertions, and the functions or classes directly below them."""

    def __init__(self, path):
        self.lines = without_comments_and_literals(path.read_text()).splitlines()
        self.links = [at for at, line in enumerate(self.lines) if LINK.search(line)]

    def below(self, link):
        """Returns the number of the first line below the implements<> assertion at line `link` and the assertions that directly
        follow it. Also returns the text from this line to the body."""
        at = link
        while at < len(self.lines) and ";" not in self.lines[at]:
            at += 1
        at += 1
        while at < len(self.lines) and ("static_assert(" in self.lines[at] or LINK.search(self.lines[at]) or not self.lines[at].strip()):
            at += 1
        return at, re.split(r"[{;]", " ".join(self.lines[at : at + 6]), maxsplit=1)[0]

    def end(self, first):
        """Returns the last line of the function that begins at `first`."""
        depth, opened = 0, False
        for at in range(first, len(self.lines)):
            depth += self.lines[at].count("{") - self.lines[at].count("}")
            opened = opened or "{" in self.lines[at]
            if (opened and depth <= 0) or (not opened and self.lines[at].rstrip().endswith(";")):
                return at
        return len(self.lines)


def plain(name):
    """Returns the name of the function in a label of the call graph, such as `canproof::Node::advance`: without types, arguments
    and template arguments."""
    name = re.sub(r" \[with .*", "", name)
    depth, out = 0, ""
    for char in name:
        depth += char == "<"
        out += char if depth == 0 else ""
        depth -= char == ">"
    out = out.replace("operator()", "operator_call").replace("{anonymous}::", "").split("(")[0]
    return out.split(" ")[-1].lstrip("*&") if "operator" not in out else out


class Served:
    def __init__(self, graph, files):
        self.graph = graph
        self.sources = {path: Source(full) for path, full in files.items()}
        self.functions = collections.defaultdict(list)  # file → (line, title)
        self.places = {}
        for title, place in graph.places.items():
            path, line, _ = place.rsplit(":", 2)
            match = FIRMWARE.search(path)
            name = match[1] if match else path
            if name in self.sources:
                self.functions[name].append((int(line) - 1, title))
                self.places[title] = f"{name}:{line}"
        self.plain = {title: plain(graph.names[title]) for title in self.places}

    def linked(self):
        """Returns the functions that have a link (implements<>) of their own."""
        found = set()
        named = collections.defaultdict(set)  # functions and classes whose declaration has a link, by path without extension
        for path, source in self.sources.items():
            for link in source.links:
                first, text = source.below(link)
                here = [title for line, title in self.functions[path] if line <= link <= source.end(line)] or self.beginning(path, first)
                found.update(here)
                declared = re.search(r"\b(?:class|struct)\s+(\w+)", text) or re.search(r"(~?\w+)\s*\(", text)
                if declared and not here:
                    named[path.rsplit(".", 1)[0]].add(declared[1])
        for title, place in self.places.items():
            parts = self.plain[title].split("::")
            if named[place.rsplit(".", 1)[0]].intersection(parts[-2:]):
                found.add(title)
        return found

    def beginning(self, path, first):
        """Returns the functions that begin nearest to line `first`, at most three lines below it."""
        near = [(line, title) for line, title in self.functions[path] if first <= line <= first + 3]
        return [title for line, title in near if line == min(near)[0]]

    def served(self):
        found = set(self.linked())
        while True:
            waiting = list(found)
            while waiting:
                for callee in self.graph.calls.get(waiting.pop(), ()):
                    if callee in self.places and callee not in found:
                        found.add(callee)
                        waiting.append(callee)
            classes = {"::".join(self.plain[title].split("::")[:-1]) for title in found}
            made = {title for title in self.places if title not in found and self.is_constructor(title)
                    and "::".join(self.plain[title].split("::")[:-1]) in classes}
            if not made:
                return found
            found |= made

    def is_constructor(self, title):
        parts = self.plain[title].split("::")
        return len(parts) > 1 and parts[-1].lstrip("~") == parts[-2]


def unserved(graph, files):
    """Returns the place of each function that serves no item, by the function's name, and the number of different names of functions."""
    all_of = Served(graph, files)
    served = {all_of.plain[title] for title in all_of.served()}
    rest = {}
    for title, name in all_of.plain.items():
        if name not in served and not INTERFACE.search(name):
            rest.setdefault(name, all_of.places[title])
    return rest, len(set(all_of.plain.values()))


def prove(generated, faults):
    """Tests the check on misra/callgraph/served.cpp, whose comments name the functions that the check must report."""
    path = HOME / "misra" / "callgraph" / "served.cpp"
    with tempfile.TemporaryDirectory() as scratch:
        compile_each(["misra/callgraph/served.cpp"], generated, scratch, faults, UNOPTIMISED)
        rest, _ = unserved(CallGraph(scratch), {"misra/callgraph/served.cpp": path})
    wanted = set(re.findall(r"// the check must report: (\S+)", path.read_text()))
    if set(rest) != wanted:
        faults.add(f"the check of functions finds {sorted(rest)} in misra/callgraph/served.cpp, but its comments name {sorted(wanted)}")


def graph_of_firmware(generated, faults):
    units = [named(path) for root in dict.fromkeys((HOME, ROOT)) for path in firmware_files(root / "src", "*.cpp")]
    with tempfile.TemporaryDirectory() as folder:
        compile_each(units, generated, folder, faults, UNOPTIMISED, together=True)
        graph = CallGraph(folder)
    graph.resolve([one for path in records_of("callgraph.toml") for one in tomllib.loads(path.read_text()).get("indirect", [])], Faults())
    return graph


def check_served(generated, faults):
    """Reports functions that serve no item and have no recorded reason, and unused reasons. Returns figures for the report."""
    prove(generated, faults)
    graph = graph_of_firmware(generated, faults)
    files = {str(path.relative_to(root)): path for root in dict.fromkeys((HOME, ROOT)) for pattern in ("*.hpp", "*.cpp")
             for path in firmware_files(root / "src", pattern)}
    rest, count = unserved(graph, files)
    if ROOT != HOME:  # canproof itself checks the shared firmware
        own = {str(path.relative_to(ROOT)) for pattern in ("*.hpp", "*.cpp") for path in firmware_files(ROOT / "src", pattern)}
        rest = {name: place for name, place in rest.items() if place.rsplit(":", 1)[0] in own}
    reasons = {}
    for root in dict.fromkeys((HOME, ROOT)):
        path = pathlib.Path(root) / "reports" / "functions.toml"
        for record in tomllib.loads(path.read_text()).get("function", []) if path.exists() else []:
            if not record.get("reason"):
                faults.add(f"{path.name}: {record.get('name')} has no reason; add the field `reason`")
            reasons[record["name"]] = root
    for name, place in sorted(rest.items(), key=lambda one: one[1]):
        if name not in reasons:
            faults.add(f"{place}: {name} serves no item of the register; link the function, remove it, or write a reason to reports/functions.toml")
    for name, root in reasons.items():
        if root == ROOT and name not in rest:
            faults.add(f"reports/functions.toml: {name} serves an item or no longer exists; remove the record")
    return {"all_functions": count, "unserved": len(rest)}
