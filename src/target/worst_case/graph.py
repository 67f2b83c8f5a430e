# SPDX-License-Identifier: Apache-2.0
"""The control-flow graph of one function: blocks, edges, calls and loops, from the instructions of an image."""
import dataclasses

EXIT = "exit"


class Unknown(Exception):
    """Reports an instruction of the image after which it is not known where the program continues."""


@dataclasses.dataclass
class Edge:
    source: int
    target: object    # the address of a block, or EXIT
    calls: tuple = () # addresses of the functions that run between source and target, or "indirect"


@dataclasses.dataclass
class Block:
    start: int
    instructions: list
    calls: list = dataclasses.field(default_factory=list)
    edges: list = dataclasses.field(default_factory=list)


@dataclasses.dataclass
class Loop:
    header: int
    blocks: set
    back: list        # edges from the loop's blocks back to its header
    inner: set = dataclasses.field(default_factory=set)  # blocks that belong to loops within this loop

    def entries(self, graph):
        return [edge for edge in graph.edges() if edge.target == self.header and edge.source not in self.blocks]


def targets_of_table(image, code, jump):
    """Returns the targets of a switch: its table follows the instruction and ends where code begins or a byte of padding lies."""
    size, at = {"tbb": 1, "tbh": 2}.get(jump.name, 4), jump.address + 4
    base, targets = at, set()
    if size == 4 and at in code and code[at].name == "nop":
        at += 2  # aligns the table
    while at not in code:
        value = int.from_bytes(image.read(at, size), "little")
        target = value & ~1 if size == 4 else base + 2 * value
        if target not in code:
            break
        targets.add(target)
        at += size
    if not targets:
        raise Unknown(f"{jump.address:X}h: a switch without a table")
    return sorted(targets)


class Graph:
    """The blocks of a function, by address. Follows the code from `entry`, so that a function may continue in the code of another symbol."""

    def __init__(self, code, names, image, entry):
        self.code, self.names, self.image, self.entry = code, names, image, entry
        self.successors, self.calls = {}, {}
        self._follow()
        self.blocks = self._blocks()
        self.all_edges = [edge for block in self.blocks.values() for edge in block.edges]
        self.loops = self._loops()

    def _leaves(self, target):
        """Returns whether a jump to this address is a call of another function."""
        return target in self.names and target != self.entry

    def _passes(self, one):
        """Returns (targets, calls) for each way to continue after an instruction."""
        kind, onward = one.kind, [(one.after, ())]
        if kind == "next":
            if one.after == 0:
                raise Unknown(f"{one.address:X}h: {one.name} runs into data")
            return onward
        if kind == "call":
            callee = one.target if one.target is not None else "indirect"
            # There may be no code behind the call of a function that does not return.
            called = [(one.after if one.after else EXIT, (callee,))]
            return called + onward if one.maybe else called
        if kind in ("branch", "jump"):
            there = (EXIT, (one.target,)) if self._leaves(one.target) else (one.target, ())
            return [there] + (onward if kind == "branch" or one.maybe else [])
        if kind == "table":
            return [(target, ()) for target in targets_of_table(self.image, self.code, one)]
        away = [(EXIT, ("indirect",) if kind == "indirect" else ())]
        return away + onward if one.maybe else away

    def _follow(self):
        waiting = [self.entry]
        while waiting:
            at = waiting.pop()
            if at in self.successors:
                continue
            if at not in self.code:
                raise Unknown(f"{at:X}h: no instruction here")
            self.successors[at] = self._passes(self.code[at])
            waiting += [target for target, _ in self.successors[at] if target != EXIT]

    def _blocks(self):
        entered = {}
        for ways in self.successors.values():
            for target, _ in ways:
                entered[target] = entered.get(target, 0) + 1
        starts = {self.entry}
        for at, ways in self.successors.items():
            for target, calls in ways:
                if target != EXIT and (len(ways) > 1 or entered[target] > 1):
                    starts.add(target)
        return {start: self._block(start, starts) for start in sorted(starts)}

    def _block(self, start, starts):
        block, at = Block(start, []), start
        while True:
            block.instructions.append(self.code[at])
            ways = self.successors[at]
            if len(ways) > 1 or ways[0][0] == EXIT or ways[0][0] in starts:
                block.edges = [Edge(start, target, calls) for target, calls in ways]
                return block
            block.calls += ways[0][1]
            at = ways[0][0]

    def edges(self):
        return self.all_edges

    def _order(self):
        """Returns the blocks in reverse postorder."""
        seen, order, stack = {self.entry}, [], [(self.entry, iter(self.blocks[self.entry].edges))]
        while stack:
            at, edges = stack[-1]
            for edge in edges:
                if edge.target != EXIT and edge.target not in seen:
                    seen.add(edge.target)
                    stack.append((edge.target, iter(self.blocks[edge.target].edges)))
                    break
            else:
                order.append(at)
                stack.pop()
        return order[::-1]

    def _dominators(self, order):
        before = {at: [] for at in order}
        for edge in self.edges():
            if edge.target != EXIT:
                before[edge.target].append(edge.source)
        all_blocks = set(order)
        dominators = {at: all_blocks for at in order}
        dominators[self.entry] = {self.entry}
        changed = True
        while changed:
            changed = False
            for at in order[1:]:
                found = set.intersection(*(dominators[one] for one in before[at])) | {at}
                if found != dominators[at]:
                    dominators[at], changed = found, True
        return dominators, before

    def _loops(self):
        order = self._order()
        rank = {at: number for number, at in enumerate(order)}
        backward = [edge for edge in self.edges() if edge.target != EXIT and rank[edge.target] <= rank[edge.source]]
        if not backward:
            return []
        dominators, before = self._dominators(order)
        loops = {}
        for edge in backward:
            if edge.target not in dominators[edge.source]:
                raise Unknown(f"{edge.target:X}h: a loop with two entries")
            loop = loops.setdefault(edge.target, Loop(edge.target, {edge.target}, []))
            loop.back.append(edge)
            waiting = [edge.source]
            while waiting:
                at = waiting.pop()
                if at not in loop.blocks:
                    loop.blocks.add(at)
                    waiting += before[at]
        for loop in loops.values():
            for other in loops.values():
                if other is not loop and other.header in loop.blocks:
                    loop.inner |= other.blocks if other.blocks < loop.blocks else set()
        return list(loops.values())
