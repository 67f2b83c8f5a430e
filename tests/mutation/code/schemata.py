#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""Rewrites the code so that it contains every mutant of its operators and conditions. A mutant is chosen at run time.

A comparison has three mutants: true, false, and the comparison changed in equality (`<=` for `<`). This last mutant is omitted where equal
operands give equal results, as in `a < b ? a : b`. Any other condition becomes true and false. && becomes || and vice versa. Each of these
operators, alone and before =, becomes another of them: + - * / % << >> & | ^. statements.py describes the mutants of statements, names,
indices and literals. Constant expressions stay unchanged, because a mutant there would not be one of the running program.

    schemata.py SOURCE_FOLDER OUTPUT_FOLDER COMPILER_ARGUMENT...

Reads src/firmware, src/devices/NAME/firmware of each device NAME, src/target/CHIP of each microcontroller CHIP, src/host/sim/bus and
src/host/sim/replay below SOURCE_FOLDER. libclang parses them with each COMPILER_ARGUMENT. Writes the rewritten files below OUTPUT_FOLDER,
and OUTPUT_FOLDER/mutants.cpp, the list of all mutants for tests/mutation/main.cpp."""
import collections
import os
import re
import sys
from concurrent.futures import ProcessPoolExecutor

import clang.cindex
from clang.cindex import CursorKind as K

sys.dont_write_bytecode = True
from mutant_list import LIST, driver_files, firmware_files, host_files, lines_of, number_text, write_changed  # noqa: E402
from statements import SCOPES, Statements, plain_type  # noqa: E402

COMPARISONS = {"<": ("less", "<="), "<=": ("less_equal", "<"), ">": ("greater", ">="), ">=": ("greater_equal", ">")}
EQUALITIES = {"==", "!="}
ARITHMETIC = {"+": ("plus", "-"), "-": ("minus", "+"), "*": ("times", "/"), "/": ("over", "*"), "%": ("modulo", "*"),
              "<<": ("left", ">>"), ">>": ("right", "<<"), "&": ("bit_and", "|"), "|": ("bit_or", "&"), "^": ("bit_xor", "|")}
FUNCTIONS = {K.FUNCTION_DECL, K.CXX_METHOD, K.CONSTRUCTOR, K.DESTRUCTOR, K.FUNCTION_TEMPLATE, K.CONVERSION_FUNCTION}
FLOATS = {"FLOAT", "DOUBLE"}
ZERO = re.compile(r"(?:[\w:]+\{)?0[Uu]?\}?")
WRAPPERS = {K.PAREN_EXPR, K.UNEXPOSED_EXPR}
SPACE = "::canproof::mutants::"


class Rewriter(Statements):
    """The edits of one file. Mutants are numbered from 0; `NUMBER[n]` in the text is replaced by the final number."""

    def __init__(self, path, name):
        self.path = path
        self.name = name  # path relative to the repository
        self.text = open(path, "rb").read()
        self.opens = collections.defaultdict(list)   # offset: the insertions that begin there, the outermost first
        self.closes = collections.defaultdict(list)  # offset: the insertions that end there, the innermost first
        self.removed = {}                            # offset of an operator: (its length, the text in its place)
        self.mutants = []                            # (line, function, original, mutated)
        self.function = ""
        self.scope = []    # (name, type) of the parameters and local variables that are visible here

    def source(self, cursor):
        return self.text[cursor.extent.start.offset:cursor.extent.end.offset].decode()

    def mutant(self, cursor, mutated):
        self.mutants.append((cursor.extent.start.line, self.function, " ".join(self.source(cursor).split()), mutated))
        return len(self.mutants) - 1

    def wrap(self, cursor, before, after):
        self.opens[cursor.extent.start.offset].append(before)
        return cursor.extent.end.offset, after

    def close(self, at, text):
        self.closes[at].append(text)

    # Operators and operands of an expression.

    def operator_of(self, cursor):
        """Returns (operator, its offset, left, right) of a binary operator, built-in or of a class; nothing for other cursors."""
        children = list(cursor.get_children())
        if cursor.kind in (K.BINARY_OPERATOR, K.COMPOUND_ASSIGNMENT_OPERATOR) and len(children) == 2:
            first, last = children
        elif cursor.kind == K.CALL_EXPR and cursor.spelling.startswith("operator") and len(children) == 3:
            first, _, last = children
        else:
            return None
        start, end = first.extent.end.offset, last.extent.start.offset
        between = self.text[start:end].decode()
        sign = between.strip().rstrip("(").strip()
        if not sign or any(c.isalnum() or c in "(),;{}" for c in sign):
            return None
        return sign, start + between.index(sign), first, last

    @staticmethod
    def core(cursor):
        """Returns the expression without parentheses and conversions around it."""
        while cursor.kind in WRAPPERS:
            children = list(cursor.get_children())
            if len(children) != 1:
                return cursor
            cursor = children[0]
        return cursor

    # Rewriting.

    def call(self, cursor, function, numbers, operator, at, first, last):
        """Rewrites `a OP b` to `function(number, (a), (b))`."""
        end, after = self.wrap(cursor, f"{SPACE}{function}(NUMBER[{numbers}], (", "))")
        self.removed[at] = (len(operator), "), (")
        self.visit(first)
        self.visit(last)
        self.close(end, after)

    def forced(self, cursor, inside):
        number = self.mutant(cursor, "true")
        self.mutant(cursor, "false")
        end, after = self.wrap(cursor, f"{SPACE}forced(NUMBER[{number}], (", "))")
        inside()
        self.close(end, after)

    def condition(self, cursor):
        """Rewrites an expression that decides between two paths."""
        core = self.core(cursor)
        operation = self.operator_of(core)
        if operation and operation[0] in ("&&", "||") and core.kind == K.BINARY_OPERATOR:
            self.logical(core, operation)
        elif operation and (operation[0] in COMPARISONS or operation[0] in EQUALITIES):
            self.comparison(core, operation)
        elif core.kind == K.UNARY_OPERATOR and self.source(core).startswith("!") and \
                (self.operator_of(self.core(next(core.get_children()))) or ("",))[0] in ("&&", "||"):
            self.condition(next(core.get_children()))
        elif core.kind == K.CXX_BOOL_LITERAL_EXPR:
            pass
        else:
            self.forced(cursor, lambda: self.variable(core, core) or self.children(core))

    def logical(self, cursor, operation):
        sign, _, first, last = operation
        number = self.mutant(cursor, f"{'||' if sign == '&&' else '&&'}")
        flag = f"{SPACE}turned(NUMBER[{number}])"
        # turned() is evaluated for the whole expression and for each part. Each evaluation records the same mutant.
        end, after = self.wrap(cursor, f"static_cast<bool>({flag} != (", "))")
        for part in (first, last):
            stop, finish = self.wrap(part, f"({flag} != static_cast<bool>(", "))")
            self.condition(part)
            self.close(stop, finish)
        self.close(end, after)

    def comparison(self, cursor, operation):
        sign, at, first, last = operation
        same = first.type.get_canonical().spelling.replace("const ", "") == last.type.get_canonical().spelling.replace("const ", "")
        if sign in COMPARISONS and (cursor.kind == K.BINARY_OPERATOR or same) and "dependent" not in first.type.spelling:
            function, boundary = COMPARISONS[sign]
            if cursor.kind == K.BINARY_OPERATOR:
                number = self.mutant(cursor, "true")
                self.mutant(cursor, "false")
                self.mutant(cursor, boundary)
                self.call(cursor, function, number, sign, at, first, last)
                return
        self.forced(cursor, lambda: (self.visit(first), self.visit(last)))

    def arithmetic(self, cursor, operation):
        sign, at, first, last = operation
        function, other = ARITHMETIC[sign]
        self.call(cursor, function, self.mutant(cursor, other), sign, at, first, last)

    def assignment(self, cursor, operation):
        sign, at, first, last = operation
        function, other = ARITHMETIC[sign[:-1]]
        target = self.source(first)
        if any(c in target for c in "(+-") or first.type.get_canonical().kind.name not in (
                "UCHAR", "USHORT", "UINT", "ULONG", "ULONGLONG", "SCHAR", "SHORT", "INT", "LONG", "LONGLONG", "FLOAT", "DOUBLE"):
            self.children(cursor)  # two evaluations of the target could have two side effects
            return
        number = self.mutant(cursor, other + "=")
        end, after = self.wrap(cursor, f"{SPACE}assigned({target}, {SPACE}{function}(NUMBER[{number}], (", ")))")
        self.removed[at] = (len(sign), "), (")
        self.visit(last)
        self.close(end, after)

    # Walking.

    def children(self, cursor, first=0):
        for child in cursor.get_children():
            if child.extent.start.offset >= first:
                self.visit(child)

    def visit(self, cursor):
        outer = len(self.scope)
        if cursor.kind == K.LAMBDA_EXPR:
            self.scope, outside = [], self.scope  # a lambda can only name the variables that it captures
            self.children(cursor)
            self.scope = outside
            return
        self.visit_here(cursor)
        if cursor.kind in SCOPES:
            del self.scope[outer:]

    def visit_here(self, cursor):
        kind = cursor.kind
        if kind in (K.STATIC_ASSERT, K.CXX_UNARY_EXPR, K.TYPEDEF_DECL, K.TYPE_ALIAS_DECL, K.ENUM_DECL):
            return
        if kind in (K.VAR_DECL,) and self.source(cursor).startswith(("constexpr ", "static constexpr ")):
            return
        if kind == K.DECL_REF_EXPR:
            return  # its children are only template arguments, which are constants
        if kind == K.VAR_DECL:
            self.children(cursor, cursor.location.offset)  # the source before the name is the type, which gets no mutants
            self.scope.append((cursor.spelling, plain_type(cursor)))
            return
        operation = self.operator_of(cursor)
        if operation:
            sign = operation[0]
            if sign in ("&&", "||") and kind == K.BINARY_OPERATOR:
                self.logical(cursor, operation)
                return
            if sign in COMPARISONS or sign in EQUALITIES:
                self.comparison(cursor, operation)
                return
            if kind == K.BINARY_OPERATOR and sign in ARITHMETIC:
                self.arithmetic(cursor, operation)
                return
            if kind == K.COMPOUND_ASSIGNMENT_OPERATOR and sign[:-1] in ARITHMETIC:
                self.assignment(cursor, operation)
                return
        if self.named(cursor):
            return
        visitor = {K.IF_STMT: self.if_statement, K.WHILE_STMT: self.loop, K.DO_STMT: self.loop, K.FOR_STMT: self.for_statement,
                   K.CONDITIONAL_OPERATOR: self.choice, K.RETURN_STMT: self.result, K.CASE_STMT: self.case,
                   K.DEFAULT_STMT: lambda default: self.statement(list(default.get_children())[-1])}.get(kind)
        if visitor:
            visitor(cursor)
        else:
            self.children(cursor)

    def split(self, cursor, decides):
        for child in cursor.get_children():
            if decides(child):
                self.condition(child)
            else:
                self.visit(child)

    def if_statement(self, cursor):
        if self.source(cursor).startswith("if constexpr"):
            for child in cursor.get_children():
                if child.kind.is_statement():
                    self.visit(child)
            return
        expressions = [c for c in cursor.get_children() if c.kind.is_expression()]
        declared = [c for c in cursor.get_children() if not c.kind.is_expression() and expressions and
                    c.extent.start.offset <= expressions[0].extent.start.offset < c.extent.end.offset]
        if declared:  # `if (int n = f())`: the condition is the name in the declaration, which must stay as it is
            for child in cursor.get_children():
                if child != expressions[0]:
                    self.visit(child)
            return
        self.split(cursor, lambda child: expressions and child == expressions[0])

    def loop(self, cursor):
        self.split(cursor, lambda child: child.kind.is_expression())

    def for_statement(self, cursor):
        """Rewrites a `for` statement, whose condition is between the two semicolons of its head."""
        depth, signs = 0, []
        for token in cursor.get_tokens():
            depth += {"(": 1, ")": -1, "{": 1, "}": -1}.get(token.spelling, 0)
            if token.spelling == ";" and depth == 1:
                signs.append(token.extent.start.offset)
            if len(signs) == 2:
                break
        self.split(cursor, lambda child: child.kind.is_expression() and len(signs) == 2
                   and signs[0] < child.extent.start.offset < signs[1])

    def when_equal(self, cursor, operands):
        """Returns the value that an expression has when both operands of the comparison are equal: `operand`, `0`, or None (unknown)."""
        core = self.core(cursor)
        if self.source(core) in operands:
            return "operand"
        operation = self.operator_of(core)
        if operation and operation[0] == "-" and {self.source(self.core(part)) for part in operation[2:]} == operands:
            return "0"
        return "0" if ZERO.fullmatch(self.source(core)) else None

    def moves_nothing(self, condition, values):
        """Returns whether a comparison chooses between values that are equal when its operands are equal: `a < b ? a : b`."""
        core = self.core(condition)
        operation = self.operator_of(core)
        if not operation or operation[0] not in COMPARISONS:
            return False
        sides = operation[2:]
        if any(side.type.get_canonical().kind.name in FLOATS for side in sides):
            return False  # zeros of a floating-point type have a sign
        equal = {self.when_equal(value, {self.source(self.core(side)) for side in sides}) for value in values}
        return len(equal) == 1 and None not in equal

    def choice(self, cursor):
        if "?" not in self.source(cursor):  # a macro makes the choice: its text is not in this file
            return
        parts = list(cursor.get_children())
        if self.moves_nothing(parts[0], parts[1:]):
            comparison = self.core(parts[0])
            self.forced(comparison, lambda: self.children(comparison))
        else:
            self.condition(parts[0])
        for part in parts[1:]:
            self.visit(part)

    def result(self, cursor):
        for child in cursor.get_children():
            if child.type.get_canonical().kind.name == "BOOL":
                self.condition(child)
            else:
                self.visit(child)

    def case(self, cursor):
        for child in list(cursor.get_children())[1:]:
            self.statement(child)

    def declarations(self, cursor, scope=""):
        """Visits the bodies of functions; code outside of them gets no mutants."""
        for child in cursor.get_children():
            if child.location.file is None or child.location.file.name != self.path:
                continue
            if child.kind in FUNCTIONS:
                owner = child.semantic_parent.spelling if child.semantic_parent is not None else ""
                self.function = (owner + "::" if owner and child.semantic_parent.kind != K.NAMESPACE else "") + child.spelling
                self.scope = [(part.spelling, plain_type(part)) for part in child.get_children()
                              if part.kind == K.PARM_DECL and part.spelling]
                for part in child.get_children():
                    if part.kind == K.COMPOUND_STMT:
                        self.visit(part)
            elif child.kind in (K.NAMESPACE, K.CLASS_DECL, K.STRUCT_DECL, K.CLASS_TEMPLATE,
                                K.CLASS_TEMPLATE_PARTIAL_SPECIALIZATION, K.LINKAGE_SPEC, K.UNEXPOSED_DECL):
                self.declarations(child)

    def result_text(self):
        out, at = [], 0
        places = sorted(set(self.opens) | set(self.closes) | set(self.removed))
        for place in places:
            out.append(self.text[at:place].decode())
            at = max(at, place)
            out += self.closes.get(place, [])
            out += self.opens.get(place, [])
            if place in self.removed:
                length, instead = self.removed[place]
                out.append(instead)
                at = place + length
        out.append(self.text[at:].decode())
        return "".join(out)


def rewrite(job):
    path, name, arguments = job
    index = clang.cindex.Index.create()
    unit = index.parse(path, args=["-x", "c++", *arguments])
    errors = [d.format() for d in unit.diagnostics if d.severity >= clang.cindex.Diagnostic.Error]
    if errors:
        raise SystemExit("\n".join(errors[:5]))
    rewriter = Rewriter(path, name)
    rewriter.declarations(unit.cursor)
    return name, rewriter.result_text(), rewriter.mutants


def main():
    source, output, *arguments = sys.argv[1:]
    files = firmware_files(source) + driver_files(source) + host_files(source)
    jobs = [(path, os.path.relpath(path, source), arguments) for path in files]
    lines, first = [], 1
    with ProcessPoolExecutor(max_workers=2) as pool:
        for name, text, mutants in pool.map(rewrite, jobs, chunksize=4):
            write_changed(os.path.join(output, name), number_text(text, first))
            lines += lines_of(name, mutants, first)
            first += len(mutants)
    write_changed(os.path.join(output, "mutants.cpp"), LIST.format(lines="".join(lines)))
    print(f"{first - 1} mutants in {len(jobs)} files")


if __name__ == "__main__":
    clang.cindex.Config.set_library_file("/usr/lib/llvm-19/lib/libclang-19.so.1")
    main()
