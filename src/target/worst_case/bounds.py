# SPDX-License-Identifier: Apache-2.0
"""The bounds of loops and the limits of calls in an image, from bounds.toml and ways.toml."""
import ast
import functools
import operator
import pathlib
import re
import tomllib

LOOP = re.compile(r"(?:\} ?)?(?:for|while|do)\b")
OPERATORS = {ast.Add: operator.add, ast.Sub: operator.sub, ast.Mult: operator.mul, ast.FloorDiv: operator.floordiv}


@functools.cache
def source_lines(file):
    path = pathlib.Path(file)
    return path.read_text().splitlines() if path.exists() else []  # the source of the C library is not on this machine


def text_at(place):
    lines = source_lines(place[0])
    return lines[place[1] - 1].strip() if place[1] <= len(lines) else ""


def short(name):
    """Returns a C++ name without namespace canproof, parameters and return type."""
    plain = re.sub(r"\(anonymous namespace\)", "anonymous", name)
    return re.sub(r"^(?:.* )?(?:canproof::)", "", re.sub(r"\(.*", "", plain))


def evaluate(expression, names):
    """Returns the value of an expression of whole numbers, names, `+`, `-`, `*`, `//`, `min()` and `max()`."""
    def value(node):
        if isinstance(node, ast.Constant) and isinstance(node.value, int):
            return node.value
        if isinstance(node, ast.Name) and node.id in names:
            return names[node.id]
        if isinstance(node, ast.BinOp):
            return OPERATORS[type(node.op)](value(node.left), value(node.right))
        if isinstance(node, ast.Call) and node.func.id in ("min", "max"):
            return {"min": min, "max": max}[node.func.id](*map(value, node.args))
        raise ValueError(f"bounds.toml or ways.toml: `{expression}` is no arithmetic with known names")
    return value(ast.parse(str(expression), mode="eval").body)


def constants(root, generated, table):
    """Returns the constants of the firmware that bounds.toml names: each is read from the file that defines it. `generated`: the folder of
    the generated files."""
    found = {}
    for name, file in table.items():
        path = generated.parent / file if file.startswith("generated/") else root / file
        match = re.search(rf"\b{name}\s*(?:=|\{{)\s*(0x[0-9A-Fa-f]+|\d+)", path.read_text())
        if match is None:
            raise ValueError(f"bounds.toml or ways.toml: {file} has no number {name}; correct the file in [constants]")
        found[name] = int(match.group(1), 0)
    return found


def rows_of_table(place):
    """Returns the number of rows of the generated table that a loop steps through; None for another loop."""
    if not re.fullmatch(r"for \(const (?:auto|\w+)& \w+ : (?:\w+::)*rows\) \{", text_at(place)) or "/generated/" not in place[0]:
        return None
    above = "\n".join(source_lines(place[0])[:place[1]])
    return int(re.findall(r"std::array<Row, (\d+)U> rows", above)[-1])


class Names:
    """Names each loop of a function: `file: text` of its source, or `function, loop N` without a source line."""

    def __init__(self, graph, function):
        self.of, self.place = {}, {}
        inner_first = sorted(graph.loops, key=lambda loop: len(loop.blocks))
        for number, loop in enumerate(sorted(graph.loops, key=lambda loop: loop.header), 1):
            self.of[loop.header] = f"{function}, loop {number}"
        for loop in inner_first:
            taken = {self.place[one.header] for one in graph.loops if one.header in loop.blocks and one.header in self.place}
            found = {one.place for at in loop.blocks - loop.inner for one in graph.blocks[at].instructions
                     if one.place and one.place not in taken and LOOP.match(text_at(one.place))}
            if len(found) == 1:
                self.place[loop.header] = place = found.pop()
                self.of[loop.header] = f"{pathlib.Path(place[0]).name}: {text_at(place)}"


class Bounds:
    """The bounds of loops and the limits of calls, from several files. A loop gets the bound of the first file that names it."""

    def __init__(self, root, generated, files, values):
        tables = [tomllib.loads(file.read_text()) for file in files if file.exists()]
        for file, table in zip([file for file in files if file.exists()], tables):
            for one in [one for key in ("loop", "limit", "size", "way") for one in table.get(key, [])]:
                one["file"] = file.relative_to(root) if file.is_relative_to(root) else file
        self.values = dict(values)
        for table in tables:
            self.values.update(constants(root, generated, table.get("constants", {})))
        self.loops, self.limits, self.sizes, self.ways = ([one for table in tables for one in table.get(key, [])]
                                                          for key in ("loop", "limit", "size", "way"))
        for one in self.loops + self.limits + self.sizes + self.ways:
            if not one.get("reason"):
                raise ValueError(f"bounds.toml or ways.toml: {one} has no reason; add one")
        for one in self.limits:
            if isinstance(one.get("per"), dict):
                one["per"], one["each"] = self._repeated(one["per"]), 1
            if isinstance(one.get("plus"), dict):
                one["plus"] = self._repeated(one["plus"])
        self.used = set()

    def of_loop(self, names, header, function, extra):
        """Returns (most iterations for each entry into the loop, most for each call of its function); None replaces a number that
        is not given. Returns None for a loop without a bound."""
        name = names.of[header]
        for one in self.loops:
            if name.startswith(one["at"]) and one.get("in", "") in function:
                self.used.add(id(one))
                known = {**self.values, **extra}
                each = [evaluate(one[key], known) if key in one else None for key in ("bound", "each_call")]
                return tuple(each)
        rows = rows_of_table(names.place[header]) if header in names.place else None
        return None if rows is None else (rows, None)

    def bytes_of(self, caller, function):
        """Returns the most bytes that a call of memcpy, memmove or memset passes when the caller computes their number."""
        for one in self.sizes:
            if one["in"] == caller and one.get("function", function) == function:
                self.used.add(id(one))
                return evaluate(one["bytes"], self.values)
        raise ValueError(f"{caller} calls {function} with a computed number of bytes: bounds.toml needs a [[size]]")

    def limits_of(self, work):
        """Yields each [[limit]] that applies to this work: its entry, and the values of `at_most` and `each`."""
        for one in self.limits:
            if work in one.get("work", [work]):
                yield one, *(evaluate(one.get(key, 0), self.values) for key in ("at_most", "each"))

    def _repeated(self, factors):
        """Returns the names of a table as often as their factors."""
        return [name for name, factor in factors.items() for _ in range(evaluate(factor, self.values))]

    def ways_of(self, work):
        """Returns the [[way]] entries of this work."""
        return [one for one in self.ways if work in one["work"]]

    def names(self, only_used=False):
        """Returns the names of all entries, or of those that a loop, call or limit needed. A name is the file and a part of the entry."""
        return {f"{one['file']}: {one.get('at') or one.get('in') or one.get('functions') or one.get('calls') or one.get('loops') or one.get('entries') or one.get('blocks')}"
                for one in self.loops + self.sizes + self.limits if not only_used or id(one) in self.used}
