# SPDX-License-Identifier: Apache-2.0
"""Computes the most instructions that an entry function can run. Solves a linear program with glpsol; its
unknowns are how often each edge between blocks runs (implicit path enumeration, IPET). Its optimum over real numbers
is never below the one over whole numbers, and so is an upper bound."""
import collections
import fnmatch
import math
import pathlib
import re
import subprocess
import tempfile

from graph import Edge
from program import most_back


class LinearProgram:
    def __init__(self):
        self.costs, self.rows, self.count = {}, [], 0

    def variable(self, cost=0):
        self.count += 1
        if cost:
            self.costs[self.count] = cost
        return self.count

    def row(self, terms, relation, right=0):
        """Adds a constraint: the sum of factor * variable over `terms` is = or <= (`relation`) the number `right`."""
        self.rows.append((terms, relation, right))

    @staticmethod
    def _sum(terms):
        total = {}
        for factor, variable in terms:
            total[variable] = total.get(variable, 0) + factor
        return "\n ".join(f"{factor:+} x{variable}" for variable, factor in total.items())

    def maximise(self):
        """Returns the optimum and the value of each variable; raises ValueError without an optimum."""
        # The objective names every variable, so that their order in the answer is known.
        text = ["Maximize", " all: " + self._sum([(self.costs.get(one, 0), one) for one in range(1, self.count + 1)]), "Subject To"]
        text += [f" r{number}: {self._sum(terms)} {relation} {right}" for number, (terms, relation, right) in enumerate(self.rows)]
        with tempfile.TemporaryDirectory() as folder:
            file, result = pathlib.Path(folder) / "program.lp", pathlib.Path(folder) / "result"
            file.write_text("\n".join(text + ["End"]) + "\n")
            done = subprocess.run(["glpsol", "--lp", file, "-w", result], text=True, capture_output=True)
            if done.returncode != 0 or not result.exists():
                raise ValueError(f"glpsol: {done.stdout[-500:]}")
            answer = result.read_text()
        if (status := re.search(r"^s bas \d+ \d+ (\w) (\w) (\S+)", answer, re.M)) is None or status.group(1, 2) != ("f", "f"):
            raise ValueError("the linear program has no optimum")
        columns = [float(found) for found in re.findall(r"^j \d+ \w (\S+) ", answer, re.M)]
        return float(status.group(3)), dict(enumerate(columns, 1))


class Flow:
    """The linear program of an entry function and all functions that it calls, directly or not."""

    def __init__(self, program, entry):
        self.program, self.lp = program, LinearProgram()
        self.functions = program.below(entry)
        self.calls = {key: self.lp.variable() for key in self.functions}
        self.sites = collections.defaultdict(list)  # for each called function: (caller, variable that counts its calls, instruction that calls)
        self.blocks, self.edges = {}, {}
        for key, calls in self.functions.items():
            self._add(key, calls)
        for key, variable in self.calls.items():
            sites = [(1, site) for _, site, _ in self.sites[key]]
            start = 1 if key == (entry, None) else 0
            self.lp.row([(1, variable), *((-factor, site) for factor, site in sites)], "=", start)
        for key in self.functions:
            self._bound(key)

    def _add(self, key, calls):
        graph = self.program.graph(key[0])
        for at, block in graph.blocks.items():
            self.blocks[key, at] = self.lp.variable(len(block.instructions))
            for edge in block.edges:
                self.edges[key, id(edge)] = self.lp.variable()
        into = collections.defaultdict(list)
        for edge in graph.edges():
            into[edge.target].append((-1, self.edges[key, id(edge)]))
        into[graph.entry].append((-1, self.calls[key]))
        for at, block in graph.blocks.items():
            self.lp.row([(1, self.blocks[key, at]), *into[at]], "=")
            self.lp.row([(1, self.blocks[key, at]), *((-1, self.edges[key, id(edge)]) for edge in block.edges)], "=")
        for place, callees, call in calls:
            site = self.edges[key, id(place)] if isinstance(place, Edge) else self.blocks[key, place.start]
            if len(callees) == 1:
                self.sites[callees[0]].append((key, site, call))
                continue
            answers = [self.lp.variable() for _ in callees]
            for callee, variable in zip(callees, answers):
                self.sites[callee].append((key, variable, call))
            self.lp.row([(1, site), *((-1, one) for one in answers)], "=")

    def _bound(self, key):
        graph = self.program.graph(key[0])
        for loop, (each_entry, each_call) in self.program.loop_bounds(key):
            back = [(1, self.edges[key, id(edge)]) for edge in loop.back]
            entries = [self.edges[key, id(edge)] for edge in loop.entries(graph)]
            entries += [self.calls[key]] if loop.header == graph.entry else []
            if each_entry is not None:
                most = most_back(graph, loop, each_entry)
                self.lp.row([*back, *((-most, one) for one in entries)], "<=")
            if each_call is not None:
                self.lp.row([*back, (-each_call, self.calls[key])], "<=")

    def limit(self, limit, most, each):
        """Adds a [[limit]]: its functions, calls, blocks, turns of loops and entries into loops together run at most `most` times, and
        `each` times more for each call of the functions `per`. Returns whether the image has any of them."""
        terms, per = self.counted(limit)
        if terms:
            self.lp.row([(1, one) for one, _ in terms + self.plus(limit)] + [(-each, one) for one, _ in per], "<=", most)
        return bool(terms)

    def counted(self, limit):
        """Returns what a [[limit]] counts, and the calls of its functions `per`: lists of (variable, place). A place is the address of a
        function or block, or (instruction that jumps, where it jumps to)."""
        terms = []
        for kind, find in (("functions", self._calls_of), ("calls", self._calls_between), ("blocks", self._runs_of)):
            terms += [one for name in limit.get(kind, []) for one in find(name)]
        for kind, find in (("loops", self._returns_of), ("entries", self._entries_of)):
            terms += [one for name in limit.get(kind, []) for loop in self._loops_named(name, limit.get("in", "*")) for one in find(*loop)]
        return terms, [one for name in limit.get("per", []) for one in self._calls_of(name)]

    def plus(self, limit):
        """Returns the calls of the functions `plus` of a [[limit]], each as often as its factor."""
        return [one for name in limit.get("plus", []) for one in self._calls_of(name)]

    def _calls_of(self, name):
        return [(variable, key[0]) for key, variable in self.calls.items() if fnmatch.fnmatchcase(self.program.name(key[0]), name)]

    def _calls_between(self, names):
        caller, callee = names.split(" > ")
        return [(variable, (call.address, key[0])) for key, sites in self.sites.items() for source, variable, call in sites
                if self.program.name(source[0]) == caller and fnmatch.fnmatchcase(self.program.name(key[0]), callee)]

    def _runs_of(self, place):
        """Returns the block that begins at "FUNCTION+OFFSET"."""
        function, offset = place.rsplit("+", 1)
        found = [(key, key[0] + int(offset)) for key in self.calls if self.program.name(key[0]) == function]
        return [(self.blocks[key, at], at) for key, at in found if (key, at) in self.blocks]

    def _loops_named(self, name, function):
        """Yields (key of the function, its graph, loop) for each loop with this name in the functions with this name."""
        for key in self.functions:
            if fnmatch.fnmatchcase(self.program.name(key[0]), function):
                graph, names = self.program.graph(key[0]), self.program.loop_names(key[0])
                yield from ((key, graph, loop) for loop in graph.loops if names.of[loop.header].startswith(name))

    def _returns_of(self, key, graph, loop):
        return [(self.edges[key, id(edge)], (graph.blocks[edge.source].instructions[-1].address, loop.header)) for edge in loop.back]

    def _entries_of(self, key, graph, loop):
        if loop.header == graph.entry:
            yield self.calls[key], key[0]
        for edge in loop.entries(graph):
            block = graph.blocks[edge.source]
            # A block that runs on into the loop may end without a jump.
            place = (block.instructions[-1].address, loop.header) if len(block.edges) > 1 else block.start
            yield self.edges[key, id(edge)], place

    def solve(self):
        """Returns the bound. Afterwards the functions below describe the worst path."""
        optimum, self.values = self.lp.maximise()
        return math.floor(optimum + 1e-6)

    def shares(self):
        """Returns the functions that take most of the bound: (instructions, calls, name)."""
        by_name = collections.defaultdict(lambda: [0.0, 0.0])
        for key, variable in self.calls.items():
            by_name[key[0]][0] += self.own_cost(key)
            by_name[key[0]][1] += self.values[variable]
        return sorted(((round(cost), round(calls), self.program.name(at)) for at, (cost, calls) in by_name.items()), reverse=True)

    def frequent_calls(self):
        """Returns the calls on the worst path: (number, caller, callee)."""
        name = self.program.name
        return sorted(((round(self.values[variable]), name(source[0]), name(key[0])) for key, calls in self.sites.items()
                       for source, variable, _ in calls), reverse=True)

    def own_cost(self, key):
        """Returns the instructions that a function runs on the worst path, without those of the functions that it calls."""
        return sum(self.values[self.blocks[key, at]] * len(block.instructions) for at, block in self.program.graph(key[0]).blocks.items())

    def in_order(self):
        """Returns the keys of the functions, each before the functions that it calls."""
        return list(self.functions)[::-1]

    def calls_from(self, key):
        """Yields (key of the callee, variable) for each call that a function makes."""
        for callee, sites in self.sites.items():
            yield from ((callee, variable) for source, variable, _ in sites if source == key)

    def loops_of(self, key):
        """Yields (name, times that it jumps back) for each loop of a function."""
        names = self.program.loop_names(key[0])
        for loop in self.program.graph(key[0]).loops:
            yield names.of[loop.header], sum(self.values[self.edges[key, id(edge)]] for edge in loop.back)
