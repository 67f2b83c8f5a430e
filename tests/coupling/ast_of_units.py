# SPDX-License-Identifier: Apache-2.0
"""Reads the couplings between units (a header with its .cpp) from the code, with libclang."""
import collections
import pathlib

import clang.cindex
from clang.cindex import CursorKind as K

from layers import layer_of

clang.cindex.Config.set_library_file("/usr/lib/llvm-19/lib/libclang-19.so.1")

FUNCTIONS = {K.CXX_METHOD, K.FUNCTION_DECL, K.CONSTRUCTOR, K.DESTRUCTOR, K.FUNCTION_TEMPLATE, K.CONVERSION_FUNCTION}
CLASSES = {K.CLASS_DECL, K.STRUCT_DECL, K.CLASS_TEMPLATE}
ASSIGNING = {K.COMPOUND_ASSIGNMENT_OPERATOR}
REFERENCES = {"LVALUEREFERENCE", "POINTER"}


class Coupling:
    """The couplings of units: their calls, with the function and the place of each call, and which units write and read
    data of another unit. Data are a public member (`Frame::id`), or the state of a class (`TransmitQueue`), which a member
    function that is not const writes."""

    def __init__(self):
        self.calls = collections.defaultdict(set)        # (caller, callee): {(function, file:line)}
        self.written = collections.defaultdict(set)      # (data, unit): {unit}
        self.read = collections.defaultdict(set)
        self.implemented = collections.defaultdict(set)  # (interface, unit): {unit}
        self.variables = set()                           # (name, file:line)


def holder(cursor):
    """Returns the class that a member belongs to."""
    return cursor.semantic_parent


def qualified(cursor):
    parent = holder(cursor)
    return f"{parent.spelling}::{cursor.spelling}" if parent is not None and parent.kind in CLASSES else cursor.spelling


class Reader:
    def __init__(self, root):
        self.root = root.resolve()
        self.index = clang.cindex.Index.create()
        self.coupling = Coupling()
        self.seen = set()
        self.units = {}

    def read(self, path, arguments):
        tree = self.index.parse(str(path), args=[*arguments, "-w"])
        errors = [one.format() for one in tree.diagnostics if one.severity >= clang.cindex.Diagnostic.Error]
        if errors:
            raise SystemExit(f"{path}: {errors[0]}")
        self.walk_declarations(tree.cursor)

    def unit(self, cursor):
        """Returns the unit that declares `cursor`; None outside of the firmware."""
        place = cursor.canonical.location.file
        if place is None:
            return None
        if place.name not in self.units:
            found = None
            path = clang_path(place.name)
            if path.is_relative_to(self.root):
                name = str(path.relative_to(self.root).with_suffix(""))
                found = name if layer_of(name) else None
            self.units[place.name] = found
        return self.units[place.name]

    def place(self, cursor):
        return f"{clang_path(cursor.location.file.name).relative_to(self.root)}:{cursor.location.line}"

    def walk_declarations(self, cursor):
        for child in cursor.get_children():
            if child.location.file is None or self.unit_of_file(child) is None:
                continue
            if child.kind in FUNCTIONS and child.is_definition():
                self.enter_function(child)
            elif child.kind in CLASSES:
                self.note_bases(child)
                self.walk_declarations(child)
            elif child.kind == K.VAR_DECL:
                self.note_variable(child)
            elif child.kind in (K.NAMESPACE, K.LINKAGE_SPEC, K.UNEXPOSED_DECL):
                self.walk_declarations(child)

    def unit_of_file(self, cursor):
        path = clang_path(cursor.location.file.name)
        return path if path.is_relative_to(self.root) and layer_of(str(path.relative_to(self.root).with_suffix(""))) else None

    def note_bases(self, cursor):
        for child in cursor.get_children():
            if child.kind == K.CXX_BASE_SPECIFIER:
                base = child.referenced
                unit, own = self.unit(base), self.unit(cursor)
                if unit and own:
                    self.coupling.implemented[base.spelling, unit].add(own)

    def note_variable(self, cursor):
        """Notes a variable of a namespace or a class, or a static variable of a function, unless it is constant."""
        kind = cursor.type.get_canonical()
        if kind.kind.name == "LVALUEREFERENCE":  # a reference always refers to the same object
            kind = kind.get_pointee()
        element = kind
        while element.kind.name in ("CONSTANTARRAY", "INCOMPLETEARRAY"):
            element = element.get_array_element_type()
        if not (kind.is_const_qualified() or element.is_const_qualified()) and cursor.is_definition():
            self.coupling.variables.add((cursor.spelling, self.place(cursor)))

    def enter_function(self, cursor):
        key = (cursor.get_usr(), self.place(cursor))
        if key in self.seen:
            return
        self.seen.add(key)
        unit = self.unit(cursor)
        if unit:
            for child in cursor.get_children():
                self.walk_code(child, unit, False)

    def walk_code(self, cursor, unit, written):
        """Notes the couplings of an expression. `written` is true when the expression around it changes the named data."""
        if cursor.kind == K.CALL_EXPR:
            self.note_call(cursor, unit)
            return
        if cursor.kind == K.MEMBER_REF_EXPR and cursor.referenced is not None and cursor.referenced.kind == K.FIELD_DECL:
            self.note_member(cursor.referenced, unit, written)
        elif cursor.kind == K.VAR_DECL and cursor.storage_class == clang.cindex.StorageClass.STATIC:
            self.note_variable(cursor)
        children = list(cursor.get_children())
        for number, child in enumerate(children):
            self.walk_code(child, unit, self.changes(cursor, number) or (written and passes_on(cursor, number)))

    @staticmethod
    def changes(cursor, number):
        """Returns whether an expression changes its child `number`."""
        if cursor.kind in ASSIGNING:
            return number == 0
        if cursor.kind == K.BINARY_OPERATOR:
            return number == 0 and cursor.binary_operator.name == "Assign"
        if cursor.kind == K.UNARY_OPERATOR:
            tokens = [token.spelling for token in cursor.get_tokens()]
            return bool(tokens) and ("++" in (tokens[0], tokens[-1]) or "--" in (tokens[0], tokens[-1]))
        return False

    def note_member(self, field, unit, written):
        owner = self.unit(field)
        if owner and owner != unit:
            (self.coupling.written if written else self.coupling.read)[qualified(field), owner].add(unit)

    def note_call(self, cursor, unit):
        function = cursor.referenced
        children = list(cursor.get_children())
        changes_object = False
        if function is not None and function.kind in FUNCTIONS:
            changes_object = function.kind == K.CXX_METHOD and not function.is_const_method() and not function.is_static_method()
            self.note_function(cursor, function, unit, changes_object)
        arguments = list(cursor.get_arguments())
        callee = [child for child in children if child not in arguments]
        for child in callee:
            self.walk_code(child, unit, changes_object)
        parameters = list(function.get_arguments()) if function is not None else []
        is_operator = changes_object and function.spelling.startswith("operator") and len(arguments) == len(parameters) + 1
        for number, argument in enumerate(arguments):
            if is_operator and number == 0:
                self.walk_code(argument, unit, True)
                continue
            at = number - 1 if is_operator else number
            self.walk_code(argument, unit, at < len(parameters) and is_output(parameters[at].type))

    def note_function(self, cursor, function, unit, changes_object):
        owner = self.unit(function)
        if owner is None or owner == unit or holder(function).spelling.startswith("(lambda"):
            return
        self.coupling.calls[unit, owner].add((qualified(function), self.place(cursor)))
        if function.kind == K.CXX_METHOD and not function.is_static_method():
            (self.coupling.written if changes_object else self.coupling.read)[holder(function).spelling, owner].add(unit)


def passes_on(cursor, number):
    """Returns whether a change of an expression also changes its child `number`. It does for the object of a member, the
    array of an element and the content of brackets."""
    return number == 0 and cursor.kind in (K.MEMBER_REF_EXPR, K.ARRAY_SUBSCRIPT_EXPR, K.PAREN_EXPR, K.UNEXPOSED_EXPR)


def is_output(kind):
    """Returns whether a function may change its argument through a parameter of this type."""
    kind = kind.get_canonical()
    return kind.kind.name in REFERENCES and not kind.get_pointee().is_const_qualified()


def clang_path(name):
    return pathlib.Path(name).resolve()
