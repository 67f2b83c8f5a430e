# SPDX-License-Identifier: Apache-2.0
"""Mutants of statements, variables, indices and literals: typical omissions and mix-ups of an author.

A call, a `break` or an assignment that is a statement of its own is omitted. Calls that follow each other are swapped where this
can make a difference (independence.py). A variable becomes another one of its type (a parameter, a local variable, or a member of the same
class). An index becomes 0; a literal is increased and decreased by one."""
import re

from clang.cindex import CursorKind as K
from independence import are_independent

LITERAL = re.compile(r"(?:0[xX][0-9a-fA-F']+|0[bB][01']+|[0-9][0-9']*)[uUlL]*")
NULL = re.compile(r"(?:0[xXbB])?0+[uUlL]*")
INTEGERS = {"UCHAR", "USHORT", "UINT", "ULONG", "ULONGLONG", "SCHAR", "SHORT", "INT", "LONG", "LONGLONG", "CHAR_S"}
SCALARS = INTEGERS | {"BOOL", "ENUM", "FLOAT", "DOUBLE"}
POINTS_IN_TIME = {"Instant", "Duration"}
SCOPES = {K.COMPOUND_STMT, K.FOR_STMT, K.CXX_FOR_RANGE_STMT, K.IF_STMT, K.WHILE_STMT, K.SWITCH_STMT, K.CASE_STMT}
SPACE = "::canproof::mutants::"


def plain_type(cursor):
    kind = cursor.type.get_canonical()
    if kind.kind.name in ("LVALUEREFERENCE", "RVALUEREFERENCE"):
        kind = kind.get_pointee()
    return re.sub(r"\b(?:const|volatile) ", "", kind.get_canonical().spelling)


def is_scalar(cursor):
    return cursor.type.get_canonical().kind.name in SCALARS


class Statements:
    """The part of Rewriter (schemata.py) for statements and names. Rewriter stores the edits."""

    # Statements.

    def call_of(self, statement):
        """Returns the call if a statement is only a call, perhaps below conversions and static_cast<void>; else returns nothing."""
        core = self.core(statement)
        if core.kind == K.CXX_STATIC_CAST_EXPR and self.source(core).startswith("static_cast<void>("):
            core = self.core(list(core.get_children())[-1])
        return core if core.kind == K.CALL_EXPR and not core.spelling.startswith("operator") else None

    def is_assignment(self, statement):
        core = self.core(statement)
        if core.kind in (K.COMPOUND_ASSIGNMENT_OPERATOR, K.UNARY_OPERATOR):
            return True
        operation = self.operator_of(core)
        return bool(operation) and operation[0].endswith("=") and operation[0] not in ("==", "!=", "<=", ">=")

    def after(self, statement):
        """Returns the offset after the semicolon of a statement."""
        return self.text.index(b";", statement.extent.end.offset) + 1

    def statement(self, statement):
        """Visits a statement. A call, a `break` or an assignment gets a mutant that omits it."""
        if self.call_of(statement) is not None or statement.kind == K.BREAK_STMT:
            mutated = "deleted"
        elif self.is_assignment(statement):
            mutated = "dropped"
        else:
            self.visit(statement)
            return
        number = self.mutant(statement, mutated)
        self.opens[statement.extent.start.offset].append(f"if ({SPACE}kept(NUMBER[{number}])) ")
        self.visit(statement)

    def swapped(self, calls):
        """Makes mutants of calls that follow each other: each mutant swaps two neighbours."""
        numbers = [self.mutant(first, f"swapped with {' '.join(self.source(second).split())}") for first, second in zip(calls, calls[1:])]
        step = f"step_NUMBER[{numbers[0]}]"
        self.opens[calls[0].extent.start.offset].append(
            f"for (unsigned {step} = 0U; {step} != {len(calls)}U; ++{step}) {{ "
            f"switch ({SPACE}ordered(NUMBER[{numbers[0]}], {step}, {len(calls)}U)) {{ ")
        for at, call in enumerate(calls):
            self.opens[call.extent.start.offset].append(f"case {at}U: ")
            self.statement(call)
            self.close(self.after(call), " break;")
        self.close(self.after(calls[-1]), " default: break; } }")

    def block(self, cursor):
        calls = []
        for child in [*cursor.get_children(), None]:
            call = self.call_of(child) if child is not None else None
            if call is not None and calls and not are_independent(self.call_of(calls[-1]), call):
                calls.append(child)
                continue
            if len(calls) > 1:
                self.swapped(calls)
            elif calls:
                self.statement(calls[0])
            calls = [child] if call is not None else []
            if child is not None and call is None:
                self.statement(child)

    # Names.

    @staticmethod
    def next_one(name, others):
        """Returns the name that is declared after `name`; after the last name, the first one."""
        names = [other for other, _ in others]
        if name not in names:
            return names[0] if names else None
        after = names[names.index(name) + 1:] + names[:names.index(name)]
        return after[0] if after else None

    def other_variable(self, core):
        """Returns the text of another variable of the same type; nothing if there is none."""
        declared, kind = core.referenced, plain_type(core)
        if declared is None or not kind:
            return None
        if core.kind == K.DECL_REF_EXPR and declared.kind in (K.PARM_DECL, K.VAR_DECL):
            if declared.spelling not in [name for name, _ in self.scope]:
                return None  # a constant, or a variable of an outer function
            return self.next_one(declared.spelling, [entry for entry in self.scope if entry[1] == kind])
        if core.kind == K.MEMBER_REF_EXPR and declared.kind == K.FIELD_DECL:
            fields = [(field.spelling, plain_type(field)) for field in declared.semantic_parent.get_children()
                      if field.kind == K.FIELD_DECL and field.access_specifier == declared.access_specifier]
            other = self.next_one(declared.spelling, [field for field in fields if field[1] == kind])
            base = self.source(core)[:-len(declared.spelling)]
            return base + other if other and "(" not in base and self.source(core).endswith(declared.spelling) else None
        return None

    def variable(self, cursor, core):
        """Rewrites the value of a variable. Returns whether it became a mutant."""
        other = self.other_variable(core)
        if other is None or "depend" in core.type.spelling:
            return False
        number = self.mutant(core, f"variable {other}")
        end, after = self.wrap(cursor, f"{SPACE}other(NUMBER[{number}], (", f"), ({other}))")
        self.members(core)
        self.close(end, after)
        return True

    def value(self, cursor):
        """Rewrites an expression if it reads a variable. Returns whether it was rewritten."""
        children = list(cursor.get_children())
        if len(children) != 1 or children[0].extent != cursor.extent or children[0].kind not in (K.DECL_REF_EXPR, K.MEMBER_REF_EXPR):
            return False
        if cursor.kind == K.CALL_EXPR and cursor.spelling not in POINTS_IN_TIME:
            return False
        if cursor.kind == K.UNEXPOSED_EXPR and not is_scalar(cursor):
            return False
        return self.variable(cursor, children[0])

    def members(self, cursor):
        """Visits the part before the name of a member; the part after the name has only template arguments."""
        if cursor.kind == K.MEMBER_REF_EXPR:
            for child in cursor.get_children():
                if child.extent.end.offset <= cursor.location.offset:
                    self.visit(child)

    # Indices and literals.

    def subscript(self, cursor):
        parts = list(cursor.get_children())
        index = parts[-1]
        self.visit(parts[0])
        if self.core(index).kind == K.INTEGER_LITERAL or self.core(index).type.get_canonical().kind.name not in INTEGERS:
            self.visit(index)
            return
        number = self.mutant(cursor, "[0]")
        end, after = self.wrap(index, f"{SPACE}index(NUMBER[{number}], (", "))")
        self.visit(index)
        self.close(end, after)

    def literal(self, cursor):
        before = self.text[:cursor.extent.start.offset].decode()
        follows = self.text[cursor.extent.end.offset:cursor.extent.end.offset + 1]
        text = self.source(cursor)
        if not LITERAL.fullmatch(text) or re.search(r"<(?:[\w:][\w:, ]*)?$", before[-80:]) or follows == b">":
            return  # a template argument
        number = self.mutant(cursor, "+1")
        function = "literal"
        if NULL.fullmatch(text):
            function = "zero"
        else:
            self.mutant(cursor, "-1")
        end, after = self.wrap(cursor, f"{SPACE}{function}(NUMBER[{number}], ", ")")
        self.close(end, after)

    def named(self, cursor):
        """Rewrites a cursor if one of the functions above can rewrite it. Returns whether it was rewritten."""
        kind = cursor.kind
        if kind == K.COMPOUND_STMT:
            self.block(cursor)
        elif kind == K.INTEGER_LITERAL:
            self.literal(cursor)
        elif kind == K.MEMBER_REF_EXPR:
            self.members(cursor)
        elif kind == K.ARRAY_SUBSCRIPT_EXPR or (kind == K.CALL_EXPR and cursor.spelling == "operator[]"):
            self.subscript(cursor)
        elif kind in (K.UNEXPOSED_EXPR, K.CALL_EXPR):
            return self.value(cursor)
        else:
            return False
        return True
