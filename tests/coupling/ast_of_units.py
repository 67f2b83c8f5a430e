# SPDX-License-Identifier: Apache-2.0
"""Reads the couplings between units (a header with its .cpp) from the code, with libclang.

A call in a template that depends on the template's arguments is read from each instance of the template. libclang does not list
instances among the declarations. But a call refers to the function of the instance, and libclang gives the code of this function: the
reader follows each call to an instance, also from one instance to the next."""
import collections
import pathlib

import clang.cindex
from clang.cindex import CursorKind as K

from layers import is_generated, layer_of

clang.cindex.Config.set_library_file("/usr/lib/llvm-19/lib/libclang-19.so.1")

FUNCTIONS = {K.CXX_METHOD, K.FUNCTION_DECL, K.CONSTRUCTOR, K.DESTRUCTOR, K.FUNCTION_TEMPLATE, K.CONVERSION_FUNCTION}
CLASSES = {K.CLASS_DECL, K.STRUCT_DECL, K.CLASS_TEMPLATE}
ASSIGNING = {K.COMPOUND_ASSIGNMENT_OPERATOR}
REFERENCES = {"LVALUEREFERENCE", "POINTER"}
pattern_of = clang.cindex.conf.lib.clang_getSpecializedCursorTemplate  # the template of an instance; None for any other cursor


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
        self.unknown = set()                             # places of calls of unknown functions outside of instances
        self.lost = set()                                # the same in instances
        self.known = set()                               # places of code in instances, and in begin() and end() of a range


def holder(cursor):
    """Returns the class that a member belongs to."""
    return cursor.semantic_parent


def qualified(cursor):
    parent = holder(cursor)
    return f"{parent.spelling}::{cursor.spelling}" if parent is not None and parent.kind in CLASSES else cursor.spelling


class Reader:
    """Reads the units below `root`/src, and the data that generated headers below `generated`/generated declare."""

    def __init__(self, root, generated):
        self.roots = [generated.resolve(), root.resolve()]
        self.index = clang.cindex.Index.create()
        self.coupling = Coupling()
        self.seen = set()
        self.paths = {}
        self.instances = []  # functions of instances whose code is still to be read
        self.in_instance = False

    def read(self, path, arguments):
        tree = self.index.parse(str(path), args=[*arguments, "-w"])
        errors = [one.format() for one in tree.diagnostics if one.severity >= clang.cindex.Diagnostic.Error]
        if errors:
            raise SystemExit(f"{path}: {errors[0]}")
        self.walk_declarations(tree.cursor)
        self.in_instance = True
        while self.instances:
            self.enter_function(self.instances.pop())
        self.in_instance = False

    def unit(self, cursor):
        """Returns the unit that declares `cursor`; None outside of the firmware."""
        return self.unit_of_file(cursor.canonical)

    def unit_of_file(self, cursor):
        """Returns the unit of the file that contains `cursor`; None outside of the firmware."""
        file = cursor.location.file
        return self.path_and_unit(file.name)[1] if file is not None else None

    def path_and_unit(self, name):
        """Returns the path of a file from its root, and its unit; None for each of them that it does not have."""
        if name not in self.paths:
            path = clang_path(name)
            found = next((path.relative_to(root) for root in self.roots if path.is_relative_to(root)), None)
            unit = str(found.with_suffix("")) if found else None
            self.paths[name] = found, unit if unit and layer_of(unit) else None
        return self.paths[name]

    def place(self, cursor):
        return f"{self.path_and_unit(cursor.location.file.name)[0]}:{cursor.location.line}"

    def exact_place(self, cursor):
        start = cursor.extent.start
        return start.file.name, start.line, start.column

    def unknown_calls(self):
        """Returns file:line of each call whose function no instance of a template tells."""
        unknown = (self.coupling.unknown - self.coupling.known) | self.coupling.lost
        return sorted({f"{self.path_and_unit(name)[0]}:{line}" for name, line, _ in unknown})

    def walk_declarations(self, cursor):
        for child in cursor.get_children():
            unit = self.unit_of_file(child)
            if unit is None:
                continue
            if child.kind in FUNCTIONS and child.is_definition():
                if not is_generated(unit):
                    self.enter_function(child)
            elif child.kind in CLASSES:
                self.note_bases(child)
                self.walk_declarations(child)
            elif child.kind in (K.VAR_DECL, K.FIELD_DECL):
                self.enter_initial_value(child)
            elif child.kind in (K.NAMESPACE, K.LINKAGE_SPEC, K.UNEXPOSED_DECL):
                self.walk_declarations(child)

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

    def enter_initial_value(self, cursor):
        """Notes a variable or a member, and the couplings of its initial value."""
        if cursor.kind == K.VAR_DECL:
            self.note_variable(cursor)
        unit = self.unit(cursor)
        if unit:
            for child in cursor.get_children():
                self.walk_code(child, unit, False)

    def note_instance(self, function):
        """Plans to read a function of an instance of a template. Of a constructor, reads the initial values of the members too."""
        if self.unit(function) is None:
            return
        definition = function.get_definition()
        if pattern_of(function) is not None and definition is not None:
            self.instances.append(definition)
        parent = holder(function)
        if function.kind == K.CONSTRUCTOR and pattern_of(parent) is not None and parent.get_usr() not in self.seen:
            self.seen.add(parent.get_usr())
            before, self.in_instance = self.in_instance, True
            for member in parent.type.get_fields():
                self.enter_initial_value(member)
            self.in_instance = before

    def note_range(self, cursor, unit):
        """Notes the begin() and end() that a range-based for calls. libclang does not give these calls, and no instance of a
        class template's begin() and end(): they are those of the template."""
        kind = list(cursor.get_children())[1].type.get_canonical()
        kind = kind.get_pointee() if kind.kind.name == "LVALUEREFERENCE" else kind
        declared = kind.get_declaration()
        if declared.kind not in CLASSES or self.unit(declared) is None:
            return
        for method in (pattern_of(declared) or declared).get_children():
            if method.spelling in ("begin", "end"):
                self.note_function(cursor, method, unit, not method.is_const_method())
                self.coupling.known.update(self.exact_place(one) for one in method.walk_preorder())

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
        if self.in_instance:
            self.coupling.known.add(self.exact_place(cursor))
        if cursor.kind == K.MEMBER_REF_EXPR and cursor.referenced is not None and cursor.referenced.kind == K.FIELD_DECL:
            self.note_member(cursor.referenced, unit, written)
        elif cursor.kind == K.DECL_REF_EXPR and cursor.referenced is not None and cursor.referenced.kind == K.FUNCTION_DECL:
            self.note_instance(cursor.referenced)  # whoever gets the address of a function can call it
            self.note_function(cursor, cursor.referenced, unit, False)
        elif cursor.kind == K.CXX_FOR_RANGE_STMT:
            self.note_range(cursor, unit)
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
        if function is None or function.kind not in FUNCTIONS:
            (self.coupling.lost if self.in_instance else self.coupling.unknown).add(self.exact_place(cursor))
        else:
            if self.in_instance:
                self.coupling.known.add(self.exact_place(cursor))
            self.note_instance(function)
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
        if self.in_instance and is_copy(function):
            return
        self.coupling.calls[unit, owner].add((qualified(function), self.place(cursor)))
        if function.kind == K.CXX_METHOD and not function.is_static_method():
            (self.coupling.written if changes_object else self.coupling.read)[holder(function).spelling, owner].add(unit)


def is_copy(function):
    """Returns whether a function is a copy or move constructor that the compiler writes: a template that copies a value of its
    argument's type with it calls no code of the value's unit."""
    return (function.is_copy_constructor() or function.is_move_constructor()) and function.location == holder(function).location


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
