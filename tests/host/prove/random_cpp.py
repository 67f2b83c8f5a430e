# SPDX-License-Identifier: Apache-2.0
"""Writes small random C++ functions of three inputs of at most 8 bits: arithmetic, shifts, compares, branches, switch, loops, arrays,
structs, references, addresses and virtual calls. Some of them are undefined for some inputs: a quotient by zero, an index behind its
array, a shift that is too far, a sum that overflows. The file that includes them defines INDEX(index, size), whose value is the index."""

PARTS = """
struct Item { std::uint8_t low; bool flag; std::uint16_t wide; std::int8_t row[3]; };
struct Inputs { std::uint8_t a; bool c; std::int8_t b; };
struct Big { std::uint32_t words[3]; std::uint8_t bytes[5]; bool on; std::uint64_t last; };
class Rule { public: virtual int of(int x) const = 0; };
class Twice final : public Rule { public: int of(int x) const override { return 2 * x; } };
class Plus final : public Rule { public: explicit Plus(int by) : by_{by} {} int of(int x) const override { return x + by_; } private: int by_; };
inline void bump(std::uint8_t& x, int by) { x = static_cast<std::uint8_t>(x + by); }
inline int sum(const std::uint8_t* from, const std::uint8_t* to) { int s = 0; for (; from != to; ++from) { s += *from; } return s; }
inline Item made(std::uint8_t low, bool flag, int wide) { return Item{low, flag, static_cast<std::uint16_t>(wide), {1, -2, 3}}; }
inline int weight(const Big big) { return static_cast<int>(big.words[1] & 0xFFU) + big.bytes[4] + (big.on ? 7 : 0) + static_cast<int>(big.last & 0x7FU); }
"""
SIGNED = ("int", "std::int8_t", "std::int16_t")
UNSIGNED = ("std::uint8_t", "std::uint16_t", "std::uint32_t", "std::uint64_t")
MOST_STATEMENTS = 4


class Function:
    """One function `std::uint8_t fN(std::uint8_t a, std::int8_t b, bool c)`, as text."""

    def __init__(self, rng, name):
        self.rng = rng
        self.numbers = ["a", "b"]  # variables of at most 16 bits
        self.assignable = []  # with their types
        self.conditions = ["c"]
        self.lines = [f"inline std::uint8_t {name}(const std::uint8_t a, const std::int8_t b, const bool c) {{"]
        self.count = 0
        self.in_loop = False
        self.has_arrays = False
        self.begin()
        for _ in range(rng.randint(2, MOST_STATEMENTS)):
            self.statement(rng.choice((0, 1, 1, 2)))
        self.line(f"return static_cast<std::uint8_t>({self.number(2)});")
        self.lines.append("}")

    def text(self):
        return "\n".join(self.lines)

    def line(self, text):
        self.lines.append("    " + text)

    def new(self, stem):
        self.count += 1
        return f"{stem}{self.count}"

    def begin(self):
        """Declares the variables of the statements: numbers, an array, and others by chance."""
        for _ in range(2):
            kind, name = self.rng.choice(("std::uint8_t", "std::int8_t", "int", "std::uint16_t")), self.new("x")
            self.line(f"{kind} {name} = static_cast<{kind}>({self.number(1)});")
            self.numbers.append(name)
            self.assignable.append((name, kind))
        first = ", ".join(f"static_cast<std::uint8_t>({self.number(1)})" for _ in range(2))
        self.line(f"std::uint8_t list[4] = {{{first}}};")
        self.line(f"Item items[3] = {{made(a, c, b), made(3, {self.condition(1)}, 513), made(static_cast<std::uint8_t>(b), true, a)}};")
        self.line("Item one = items[0];")
        self.line(f"Big big[2] = {{{{{{a, 2U, 3U}}, {{1, 2, 3, 4, a}}, c, 5U}}, {{{{7U, a, 9U}}, {{6, 7, 8, 9, 10}}, {self.condition(1)}, 11U}}}};")
        self.line(f"const Twice twice{{}}; const Plus plus{{static_cast<int>({self.number(0)})}};")
        self.line("Inputs in{a, c, b};")
        self.has_arrays = True
        self.numbers += ["list[1]", "one.low", "one.wide", "in.a", "in.b"]
        self.assignable += [("list[2]", "std::uint8_t"), ("one.low", "std::uint8_t"), ("one.wide", "std::uint16_t"), ("in.b", "std::int8_t"), ("one.row[1]", "std::int8_t")]
        self.conditions += ["one.flag", "in.c"]

    def index(self, size):
        """Returns an index of an array of `size` elements. In 3 % of the cases the index may be one too large. INDEX
        also checks an index where the compiler does not: for a reference."""
        over = 1 if self.rng.random() < 0.03 else 0
        return f"INDEX(static_cast<std::uint8_t>({self.number(0)}) % {size + over}U, {size}U)"

    def number(self, depth):
        """Returns an expression of any arithmetic type. Except with 64 bits, its values are mostly far from the limits
        of the type."""
        rng = self.rng
        if depth == 0 or rng.random() < 0.2:
            return rng.choice(self.numbers) if rng.random() < 0.75 else f"({rng.choice((-128, -3, -1, 0, 1, 2, 7, 8, 127, 128, 255, 256))})"
        x, y = self.number(depth - 1), self.number(depth - 1)
        narrow = f"static_cast<std::uint8_t>({x})"
        plain = (
            lambda: f"({x} + {y})", lambda: f"({x} - {y})", lambda: f"({x} & {y})", lambda: f"({x} | {y})", lambda: f"({x} ^ {y})",
            lambda: f"({rng.choice(self.numbers)} * {rng.choice((3, 5, 17, 'a', 'b'))})",
            lambda: f"({narrow} / {rng.choice((1, 2, 3, 7, 10, 255))})", lambda: f"({x} % {rng.choice((2, 3, 10, 16))})",
            lambda: f"({narrow} {rng.choice('/%')} {rng.choice(('(a | 1)', '(b | 4)', '(b | 8)', '(a | 64)', 'b'))})",
            lambda: f"({narrow} << {rng.choice((1, 3, 7))})", lambda: f"({narrow} << (static_cast<std::uint8_t>({y}) & 7))",
            lambda: f"(static_cast<{rng.choice(SIGNED)}>({x}) >> {rng.choice((1, 4, '(a & 7)', '(a & 31)', '(b & 15)', '(a & 33)'))})",
            lambda: f"(static_cast<{rng.choice(UNSIGNED)}>({x}) >> (a & 7))",
            lambda: f"((static_cast<std::uint64_t>({x}) << 40U) >> {rng.choice((33, 40, 44))}U)",
            lambda: f"static_cast<{rng.choice(SIGNED + UNSIGNED[:2])}>({x})", lambda: f"(-static_cast<int>({narrow}))", lambda: f"(~{narrow})",
            lambda: f"({self.condition(depth - 1)} ? {x} : {y})")
        from_memory = (
            lambda: f"list[{self.index(4)}]", lambda: f"items[{self.index(3)}].low", lambda: f"items[{self.index(3)}].wide",
            lambda: f"items[{self.index(3)}].row[{self.index(3)}]", lambda: f"one.row[{self.index(3)}]",
            lambda: f"sum(list, list + {self.index(5)})", lambda: f"weight(big[{self.index(2)}])",
            lambda: f"(big[{self.index(2)}].words[{self.index(3)}] & 0xFFFFU)",
            lambda: f"(({self.condition(1)}) ? static_cast<const Rule&>(twice) : plus).of({narrow})")
        return rng.choice(plain + from_memory if self.has_arrays else plain)()

    def condition(self, depth):
        rng = self.rng
        if depth == 0 or rng.random() < 0.2:
            return rng.choice(self.conditions)
        x, y = self.number(depth - 1), self.number(depth - 1)
        return rng.choice((
            lambda: f"({x} {rng.choice(('<', '<=', '==', '!=', '>', '>='))} {y})",
            lambda: f"(({x} & {rng.choice((1, 2, 64, 128))}) != 0)", lambda: f"(!{self.condition(depth - 1)})",
            lambda: f"({self.condition(depth - 1)} {rng.choice(('&&', '||', '!='))} {self.condition(depth - 1)})"))()

    def block(self, depth):
        for _ in range(self.rng.randint(1, 2)):
            self.statement(depth - 1)

    def statement(self, depth):
        simple = (self.assign, self.assign, self.element, self.copy, self.item, self.reference, self.big, self.bump)
        nested = (self.branch, self.branch, self.choice, self.loop, self.halving, self.leave)
        self.rng.choice(simple if depth == 0 else simple + nested + nested)(*([] if depth == 0 else [depth]))

    def assign(self, _depth=0):
        name, kind = self.rng.choice(self.assignable)
        self.line(f"{name} = static_cast<{kind}>({self.number(2)});")

    def element(self, _depth=0):
        self.line(f"list[{self.index(4)}] = static_cast<std::uint8_t>({self.number(1)});")

    def copy(self, _depth=0):
        self.line(self.rng.choice((
            f"items[{self.index(3)}] = items[{self.index(3)}];", f"items[{self.index(3)}] = one;", f"one = items[{self.index(3)}];",
            f"big[{self.index(2)}] = big[{self.index(2)}];")))

    def item(self, _depth=0):
        self.line(self.rng.choice((
            f"items[{self.index(3)}].wide = static_cast<std::uint16_t>({self.number(1)});", f"items[{self.index(3)}].flag = {self.condition(1)};",
            f"one.flag = items[{self.index(3)}].flag;", f"items[{self.index(3)}].row[{self.index(3)}] = static_cast<std::int8_t>({self.number(1)});")))

    def big(self, _depth=0):
        self.line(self.rng.choice((
            f"big[{self.index(2)}].words[{self.index(3)}] = static_cast<std::uint32_t>({self.number(1)});", f"big[{self.index(2)}].on = {self.condition(1)};",
            f"big[{self.index(2)}].last += static_cast<std::uint8_t>({self.number(1)});", f"one.flag = big[{self.index(2)}].on;",
            f"big[{self.index(2)}].bytes[{self.index(5)}] = static_cast<std::uint8_t>({self.number(1)});")))

    def reference(self, _depth=0):
        to = self.new("r")
        self.line(f"std::uint8_t& {to} = {self.condition(1)} ? list[{self.index(4)}] : {self.rng.choice(('one.low', 'in.a', 'items[1].low'))};")
        self.line(f"{to} = static_cast<std::uint8_t>({to} {self.rng.choice('+-^')} {self.number(1)});")

    def bump(self, _depth=0):
        self.line(f"bump({self.rng.choice(('one.low', 'list[3]', f'list[{self.index(4)}]', f'items[{self.index(3)}].low'))}, static_cast<std::int16_t>({self.number(1)}));")

    def branch(self, depth):
        self.line(f"if ({self.condition(2)}) {{")
        self.block(depth)
        if self.rng.random() < 0.6:
            self.line("} else {")
            self.block(depth)
        self.line("}")

    def choice(self, depth):
        self.line(f"switch (static_cast<std::uint8_t>({self.number(1)}) % 5U) {{")
        for label in self.rng.sample(("case 0:", "case 1:", "case 3:", "case 4:", "default:"), 3):
            self.line(f"{label} {{")
            self.block(depth)
            self.line("}" if self.rng.random() < 0.3 else "break; }")
        self.line("}")

    def loop(self, depth):
        name, before, outside = self.new("i"), list(self.numbers), self.in_loop
        self.line(f"for (unsigned {name} = 0U; {name} < {self.rng.randint(2, 4)}U; ++{name}) {{")
        self.numbers += [name, f"list[{name} & 3U]"]
        self.in_loop = True
        self.block(depth)
        if self.rng.random() < 0.3:
            self.line(f"if ({self.condition(1)}) {{ {self.rng.choice(('break', 'continue'))}; }}")
            self.assign()
        self.line("}")
        self.numbers, self.in_loop = before, outside

    def halving(self, depth):
        """Writes a loop whose number of passes depends on the inputs: at most eight."""
        if self.in_loop:
            self.assign()
            return
        name = self.new("n")
        self.line(f"for (std::uint8_t {name} = static_cast<std::uint8_t>({self.number(1)}); {name} != 0U; {name} = static_cast<std::uint8_t>({name} >> 1U)) {{")
        self.in_loop = True
        self.statement(0)
        self.in_loop = False
        self.line("}")

    def leave(self, _depth):
        self.line(f"if ({self.condition(1)}) {{ return static_cast<std::uint8_t>({self.number(1)}); }}")


def functions(rng, count):
    """Returns the texts of f0 to f(count - 1), each with its name."""
    return [(f"f{i}", Function(rng, f"f{i}").text()) for i in range(count)]
