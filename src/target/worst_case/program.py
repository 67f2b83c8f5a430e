# SPDX-License-Identifier: Apache-2.0
"""The functions that run below an entry function, each with its graph, its callees and the bounds of its loops."""
import functools
import re

from bounds import Names, short, text_at
from graph import Graph, Unknown

# Functions of the C library whose loops depend on their third argument, a number of bytes. A Program treats such a
# function as several functions, one for each number of bytes.
SIZED = ("memcpy", "memmove", "memset")


# Instructions that always move a number into a register. A conditional one, such as movcc, does so only sometimes.
MOVES = ("mov", "movs", "mov.w", "movw")


def bytes_at(block, call):
    """Returns the number of bytes that a call passes as its third argument, or None when its block does not set it."""
    for one in reversed([one for one in block.instructions if one.address < call.address]):
        if found := re.fullmatch(r"r2, #(\d+)", one.operands if one.name in MOVES else ""):
            return int(found.group(1))
        if re.match(r"r2\b|\{", one.operands) and not one.name.startswith(("cmp", "str", "tst", "cmn")) or one.kind == "call":
            return None
    return None


class Program:
    """The functions of an image, each by a key (address, bytes). `bytes` is the number that a copy of a SIZED function gets,
    None for another function. `faults` has one line for each loop without a bound."""

    def __init__(self, image, code, names, demangled, bounds, answers):
        self.image, self.code, self.names, self.demangled = image, code, names, demangled
        self.bounds, self.answers = bounds, answers
        self.graphs, self.faults = {}, []

    @functools.cache
    def name(self, address):
        """Returns the name of the function that begins at an address, or NAME+OFFSET within a function: libgcc calls parts of its functions."""
        if address in self.names:
            return short(self.demangled[self.names[address]])
        before = max(at for at in self.names if at < address)
        return f"{self.names[before]}+{address - before}"

    def graph(self, address):
        if address not in self.graphs:
            self.graphs[address] = Graph(self.code, self.names, self.image, address)
        return self.graphs[address]

    def below(self, entry):
        """Returns, by key, the calls of `entry` and of each function below it, as calls_of() returns them."""
        found, path = {}, []

        def visit(key):
            if key in path:
                raise Unknown("recursion: " + " -> ".join(self.name(one[0]) for one in path + [key]))
            if key in found:
                return
            path.append(key)
            calls = self.calls_of(key[0])
            for _, callees, _ in calls:
                for callee in callees:
                    visit(callee)
            path.pop()
            found[key] = calls

        visit((entry, None))
        return found

    @functools.cache
    def calls_of(self, address):
        """Returns (block or edge, keys of what it may call, instruction that calls) for each call that a function makes."""
        return list(self._calls(address))

    def _calls(self, address):
        for block in self.graph(address).blocks.values():
            sites = [one for one in block.instructions[:-1] if one.kind == "call"]
            for callee, site in zip(block.calls, sites, strict=True):
                yield block, self._keys(address, block, callee, site), site
            for edge in block.edges:
                for callee in edge.calls:
                    yield edge, self._keys(address, block, callee, block.instructions[-1]), block.instructions[-1]

    def _keys(self, address, block, callee, site):
        if callee == "indirect":
            return [(one, None) for one in self.answers(address)]
        if self.names.get(callee) not in SIZED:
            return [(callee, None)]
        size = bytes_at(block, site)
        return [(callee, self.bounds.bytes_of(self.name(address), self.names[callee]) if size is None else size)]

    @functools.cache
    def loop_names(self, address):
        return Names(self.graph(address), self.name(address))

    def loop_bounds(self, key):
        """Yields each loop of a function with its bounds: most iterations for each entry into the loop, and for each call of the function."""
        graph, function = self.graph(key[0]), self.name(key[0])
        names = self.loop_names(key[0])
        extra = {} if key[1] is None else {"bytes": key[1]}
        for loop in graph.loops:
            bound = self.bounds.of_loop(names, loop.header, function, extra)
            if bound is None:
                self.faults.append(f"{function}: no bound for the loop at {loop.header:X}h ({names.of[loop.header]})")
            else:
                yield loop, bound


def most_back(graph, loop, iterations):
    """Returns the most times that the loop jumps back to its beginning.

    A loop whose test is behind its body jumps back one time less than its body runs. Such a loop is left only where it jumps back, or
    by an `if` or `return` in its body."""
    exits = {edge.source for at in loop.blocks for edge in graph.blocks[at].edges if edge.target not in loop.blocks}
    tests = {at for at in exits if not leaves_body(graph.blocks[at].instructions[-1].place)}
    tests_behind = tests <= {edge.source for edge in loop.back} and len(loop.back) == 1
    return max(0, iterations - 1) if tests_behind else iterations


def leaves_body(place):
    """Returns whether a branch that leaves a loop belongs to a statement of its body, not to the loop's own test."""
    return place is not None and re.match(r"(?:if|return)\b", text_at(place)) is not None
