# SPDX-License-Identifier: Apache-2.0
"""Translates the limits of a device's bounds into addresses of a test image, for the plugin counts.cpp.

A test image has the same object code as the device's image at other addresses. An address is translated by the function
that it lies in, and by its distance from the beginning of this function."""
import collections

KINDS = ("power_on", "frame", "tick", "command", "due_frame")  # a due_frame, which comes at the time of a deadline, has no limits
DUE, BEGIN = "_ZN8canproof6target27counting_begins_at_deadlineEv", "_ZN8canproof6target15counting_beginsEv"
END = "_ZN8canproof6target10work_stopsEv"
# A frame that calls one of these resets the node or stores its parameters: a command.
COMMANDS = ("Node::reset_node", "Node::reset_communication", "ParameterStore::execute", "Lss::store")


class Places:
    """Where the instructions of the device's image lie in a test image. `missing` has the functions that the test image does not have."""

    def __init__(self, program, code, names):
        self.program, self.missing = program, set()
        self.starts = sorted(program.names)
        self.bodies = self._bodies(program.code, program.names)
        bodies = self._bodies(code, names)
        self.found = collections.defaultdict(list)
        for at, name in names.items():
            self.found[name, bodies.get(at)].append(at)

    @staticmethod
    def _bodies(code, names):
        """Returns the names of the instructions of each function, by its address."""
        bodies, at = collections.defaultdict(list), None
        for address in sorted(code):
            at = address if address in names else at
            bodies[at].append(code[address].name)
        return {at: tuple(body) for at, body in bodies.items()}

    def of(self, address):
        """Returns the addresses in the test image; none when it does not have the function."""
        start = max(at for at in self.starts if at <= address)
        found = self.found[self.program.names[start], self.bodies.get(start)]
        if not found:
            self.missing.add(self.program.name(start))
        return [at + address - start for at in found]


class Watch:
    """The counters and limits of a device in a test image, as lines for the plugin. `limits` has (kind of work, limit) in the order of
    the lines; `functions` has the name of the function that each counter of calls counts."""

    def __init__(self, places, names):
        self.places, self.counters, self.lines = places, {}, []
        self.limits, self.limit_lines, self.functions = [], [], {}
        for word, symbol in (("due", DUE), ("begin", BEGIN), ("end", END)):
            self.lines += [f"{word} {at:x}" for at, name in names.items() if name == symbol]

    def counter(self, place):
        """Returns the number of the counter of a place (see Flow.counted), or None when the test image does not have it."""
        if place in self.counters:
            return self.counters[place]
        number = len(self.functions)
        if isinstance(place, tuple):
            pairs = [(source, target) for source in self.places.of(place[0]) for target in self.places.of(place[1])]
            made, name = [f"jump {number} {source:x} {target:x}" for source, target in pairs], None
        else:
            made, name = [f"at {number} {at:x}" for at in self.places.of(place)], self.places.program.name(place)
        self.counters[place] = number if made else None
        if made:
            self.lines += made
            self.functions[number] = name
        return self.counters[place]

    def add_work(self, kind, entry, flow, limits, ways):
        """Adds a kind of work: its entry function, its functions, its limits (limit, most, each) and its ways ([[way]] entries)."""
        number = KINDS.index(kind)
        if kind != "command":  # a command begins with the function of a frame
            due = KINDS.index("due_frame") if kind == "frame" else number
            self.lines += [f"kind {number} {due} {at:x}" for at in self.places.of(entry)]
        for key in flow.functions:
            self.counter(key[0])
            if kind == "frame" and self.places.program.name(key[0]) in COMMANDS:
                self.lines += [f"changes {number} {KINDS.index('command')} {at:x}" for at in self.places.of(key[0])]
        for limit, most, each in limits:
            terms, per = ([self.counter(place) for place in dict.fromkeys(place for _, place in some)] for some in flow.counted(limit))
            plus = [self.counter(place) for _, place in flow.plus(limit)]
            if not terms or None in terms + plus + per:
                continue
            for chosen, others in self._choices(limit, flow, ways):
                self.limits.append((kind, limit))
                lists = " ".join(f"{len(some)} {' '.join(map(str, some))}".strip() for some in (terms + plus, self._per(limit, flow), chosen, others))
                self.limit_lines.append(f"limit {number} {most} {each} {lists}")

    def _choices(self, limit, flow, ways):
        """Yields for each way of a limit the counters of its calls, and those of the other ways. One of the former, or without them none of
        the latter, has counted when a work took this way. Yields two empty lists for a limit of all ways."""
        counters = {one["name"]: [self.counter(place) for _, place in flow.counted(one)[0]] for one in ways}
        if "way" not in limit:
            yield [], []
        elif all(None not in some for some in counters.values()):
            yield from ((counters[name], [] if counters[name] else sum(counters.values(), [])) for name in limit["way"])

    def _per(self, limit, flow):
        """Returns the counters of `per`. A function that `per` names twice counts twice."""
        return [self.counter(place) for _, place in flow.counted(limit)[1]]

    def text(self):
        return "\n".join(self.lines + self.limit_lines) + "\n"
