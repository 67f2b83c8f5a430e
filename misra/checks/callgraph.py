# SPDX-License-Identifier: Apache-2.0
"""Checks the call graph that g++ writes for each object file: no recursion, no unlisted indirect call, bounded stack.

callgraph.toml lists the indirect calls by the reference that they use, with the classes that they can reach. "host_stack" in a
device's target/budgets.toml limits the stack of its public calls. A call through a reference adds edges to all listed classes."""
import pathlib
import re
import tempfile
import tomllib

from .rules import HOME, ROOT, records_of
from .tools import compile_each

NODE = re.compile(r'^node: \{ title: "([^"]+)" label: "([^"]*?)\\n([^"\\]*?)\\n(\d+) bytes \(([a-z,]+)\)', re.MULTILINE)
EDGE = re.compile(r'^edge: \{ sourcename: "([^"]+)" targetname: "([^"]+)"(?: label: "([^"]*)")? \}', re.MULTILINE)
CALL = re.compile(r"(\w+)(?:\.|->)(\w+)$")
INDIRECT = "__indirect_call"


def called_through(place):
    """Returns the object and the function of the call at `place`: for `memory_.read(…)`, (`memory_`, `read`).

    `place` is file:line:column of the opening parenthesis or of a letter of the function's name.
    """
    path, line, column = place.rsplit(":", 2)
    text = (HOME / path).read_text().splitlines()[int(line) - 1]
    before = re.match(r"[\s\S]*", text[: int(column) - 1]).group()
    rest = re.match(r"\w*", text[int(column) - 1 :]).group()
    match = CALL.search(before + rest)
    return match.groups() if match else ("", before[-20:] + rest)


class CallGraph:
    def __init__(self, folder):
        self.stack, self.names, self.places, self.calls, self.indirect = {}, {}, {}, {}, []
        for path in sorted(pathlib.Path(folder).glob("*.ci")):
            text = path.read_text()
            for title, name, place, size, kind in NODE.findall(text):
                self.stack[title] = int(size)
                self.names[title] = name
                self.places[title] = place
                if kind not in ("static", "dynamic,bounded"):
                    self.stack[title] = 1 << 30  # unbounded
            for caller, callee, place in EDGE.findall(text):
                if callee == INDIRECT:
                    self.indirect.append((caller, place))
                else:
                    self.calls.setdefault(caller, set()).add(callee)

    def resolve(self, listed, faults):
        """Adds edges for the indirect calls. An unlisted call is a fault, and so is an entry of `listed` that no call uses."""
        used = set()
        for caller, place in sorted(set(self.indirect)):
            through, method = called_through(place)
            entry = next((one for one in listed if through in one["through"]), None)
            if entry is None:
                faults.add(f"{place}: an indirect call that callgraph.toml does not list ({through}.{method}); "
                           "add an entry with the classes that the call can reach")
                continue
            used.add(entry["interface"])
            for title, name in self.names.items():
                if any(re.search(rf"\b{target}::{method}\(", name) for target in entry["reaches"]):
                    self.calls.setdefault(caller, set()).add(title)
        for entry in listed:
            if entry["interface"] not in used:
                faults.add(f"callgraph.toml lists calls through {entry['interface']}, but there are no such calls; remove the entry")

    def deepest(self, title, path=(), known=None):
        """Returns the greatest stack use, in bytes, of this function with all functions that it calls. Also returns the cycle of a
        recursion, or None."""
        known = {} if known is None else known
        if title in path:
            return 0, path[path.index(title) :]
        if title not in known:
            depth, cycle = 0, None
            for callee in self.calls.get(title, ()):
                below, found = self.deepest(callee, (*path, title), known)
                depth, cycle = max(depth, below), cycle or found
            if cycle:
                return depth + self.stack.get(title, 0), cycle
            known[title] = (depth + self.stack.get(title, 0), None)
        return known[title]


def check(graph, listed, bounds, faults):
    """Checks the call graph for recursion, unlisted indirect calls and stack use. Returns the figures for the report."""
    graph.resolve(listed, faults)
    known = {}
    for title in sorted(graph.stack):
        _, cycle = graph.deepest(title, (), known)
        if cycle:
            faults.add("recursion: " + " → ".join(graph.names.get(one, one) for one in cycle))
    used = {}
    for bound in bounds:
        titles = [title for title, name in graph.names.items() if re.search(bound["entry"], name)]
        if not titles:
            faults.add(f"{bound['name']}: no function matches the entry {bound['entry']}")
            continue
        used[bound["name"]] = (max(graph.deepest(title, (), known)[0] for title in titles), bound["bytes"])
        if used[bound["name"]][0] > bound["bytes"]:
            faults.add(f"stack: {bound['name']} may use {used[bound['name']][0]} bytes, {bound['bytes']} are allowed")
    return {"functions": len(graph.stack), "indirect_calls": len(set(graph.indirect)), "stack": used}


def device_bounds():
    """Yields for each device the number of bytes of stack that each of its public calls may use."""
    for path in sorted((ROOT / "src" / "devices").glob("*/target/budgets.toml")):
        name = path.parent.parent.name.replace("-", "_")
        yield {"name": name, "entry": rf"\bcanproof::{name}::Device::\w+\(", "bytes": tomllib.loads(path.read_text())["host_stack"]}


def check_call_graph(graphs, generated, faults):
    """Tests the check on callgraph/bad.cpp, then runs it on the firmware's graphs."""
    seeded = []
    with tempfile.TemporaryDirectory() as scratch:
        class Collected(list):
            def add(self, text):
                self.append(text)
        seeded = Collected()
        compile_each(["misra/callgraph/bad.cpp"], generated, scratch, seeded)
        check(CallGraph(scratch), [], [{"name": "deep", "entry": r"\bdeep\(", "bytes": 512}], seeded)
    for word in ("recursion: ", "an indirect call that callgraph.toml does not list (place.read)", "stack: deep may use"):
        if not any(word in text for text in seeded):
            faults.add(f"the check of the call graph does not report a fault of misra/callgraph/bad.cpp: "
                       f"`{word}` is not in {seeded}")
    listed = [one for path in records_of("callgraph.toml") for one in tomllib.loads(path.read_text()).get("indirect", [])]
    return check(CallGraph(graphs), listed, list(device_bounds()), faults)
