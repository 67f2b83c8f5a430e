# SPDX-License-Identifier: Apache-2.0
"""Finds neighbouring calls whose order makes no difference. No mutant swaps such calls.

The order of two neighbouring calls makes no difference in two cases, which the source and its types show:
- The calls store into different fields of the object dictionary (`set`, `set_given`).
- The calls are method calls of two different objects that consist of values only, without a reference, pointer or view to the other
  object. The firmware has no variables outside of objects.
In both cases the arguments consist of values too. Their computation changes nothing and does not read the other object."""
import re

from clang.cindex import CursorKind as K

STORES = {"set", "set_given"}
REFERENCES = {"LVALUEREFERENCE", "RVALUEREFERENCE", "POINTER"}
SCALARS = {"BOOL", "ENUM", "FLOAT", "DOUBLE", "UCHAR", "USHORT", "UINT", "ULONG", "ULONGLONG", "SCHAR", "SHORT", "INT", "LONG",
           "LONGLONG", "CHAR_S"}
VARIABLES = {K.VAR_DECL, K.PARM_DECL, K.FIELD_DECL}
CHANGING = re.compile(r"\+\+|--|(?:<<|>>|[-+*/%&|^])?=|new|this")


def is_value(kind):
    """Returns whether an object of this type consists of values only."""
    kind = kind.get_canonical()
    name = kind.spelling.replace("const ", "")
    if kind.kind.name == "CONSTANTARRAY":
        return is_value(kind.get_array_element_type())
    if re.match(r"std::(array|optional)<", name):
        return is_value(kind.get_template_argument_type(0))
    if kind.kind.name != "RECORD" or name.startswith("std::") or kind.get_num_template_arguments() > 0:
        return kind.kind.name in SCALARS
    parts = list(kind.get_declaration().get_children())
    return all(part.kind != K.CXX_BASE_SPECIFIER for part in parts) and all(is_value(field.type) for field in kind.get_fields())


def is_read_only(parameter):
    """Returns whether a function changes nothing through a parameter, which is a value, or a constant reference or pointer to a value."""
    kind = parameter.type.get_canonical()
    if kind.kind.name not in REFERENCES:
        return is_value(kind)
    return kind.get_pointee().is_const_qualified() and is_value(kind.get_pointee())


def place(cursor):
    """Returns the names in an expression such as `a.b` for an object that is stored by value, the outermost first; else nothing."""
    declared = cursor.referenced
    if declared is None or declared.kind not in VARIABLES or declared.type.get_canonical().kind.name in REFERENCES:
        return None
    if cursor.kind == K.DECL_REF_EXPR:
        return (declared.spelling,)
    inner = [child for child in cursor.get_children() if child.extent.end.offset <= cursor.location.offset]
    outer = place(inner[0]) if inner else ("this",)
    return outer + (declared.spelling,) if outer else None


def asks_only_values(cursor, but):
    """Returns whether the computation of an expression changes nothing, reads only values, and reads no name in `but`."""
    if any(CHANGING.fullmatch(token.spelling) for token in cursor.get_tokens()):
        return False
    for part in cursor.walk_preorder():
        declared = part.referenced
        if part.kind in (K.DECL_REF_EXPR, K.MEMBER_REF_EXPR) and declared is not None and declared.kind in VARIABLES:
            kind = declared.type.get_canonical()
            held = kind.get_pointee() if kind.kind.name in REFERENCES else kind
            if declared.spelling in but or not is_value(held):
                return False
        elif part.kind == K.LAMBDA_EXPR:
            return False
        elif part.kind == K.CALL_EXPR:
            of_std = declared is not None and declared.semantic_parent.type.get_canonical().spelling.startswith("std::")
            if declared is None or (declared.kind == K.CXX_METHOD and not of_std):
                return False
            if declared.kind in (K.FUNCTION_DECL, K.FUNCTION_TEMPLATE) and not all(is_read_only(p) for p in declared.get_arguments()):
                return False
    return True


def method(call):
    """Returns (method, object, arguments) of a method call of a named object; nothing for any other call."""
    parts = list(call.get_children())
    declared = call.referenced
    if declared is None or declared.kind != K.CXX_METHOD or not parts or parts[0].kind != K.MEMBER_REF_EXPR:
        return None
    objects = [child for child in parts[0].get_children() if child.extent.end.offset <= parts[0].location.offset]
    return (declared, objects[0], parts[1:]) if objects else None


def field(argument):
    """Returns (name, index) of a dictionary field. The index is the text of a literal, or nothing if it is missing or no literal."""
    parts = list(argument.walk_preorder())
    named = [part.referenced for part in parts if part.kind in (K.DECL_REF_EXPR, K.MEMBER_REF_EXPR)
             and part.referenced is not None and part.referenced.kind in VARIABLES]
    numbers = [part for part in parts if part.kind == K.INTEGER_LITERAL]
    if not named or named[0].semantic_parent.kind != K.NAMESPACE or "Field<" not in named[0].type.spelling:
        return None
    is_fixed = len(named) == 1 and len(numbers) == 1
    return named[0].spelling, (next(numbers[0].get_tokens()).spelling if is_fixed else None)


def store(call):
    """Returns (field, value) of a call that stores into the object dictionary; nothing for any other call."""
    found = method(call)
    if not found or found[0].spelling not in STORES or found[0].semantic_parent.spelling != "ObjectDictionary" or len(found[2]) != 2:
        return None
    where = field(found[2][0])
    return (where, found[2][1]) if where and asks_only_values(found[2][1], ()) else None


def are_different(one, other):
    """Returns whether two dictionary fields certainly have different addresses."""
    return one[0] != other[0] or (None not in (one[1], other[1]) and one[1] != other[1])


def are_independent(first, second):
    """Returns whether two calls have the same result in either order."""
    stores = store(first), store(second)
    if all(stores):
        return are_different(stores[0][0], stores[1][0])
    calls = method(first), method(second)
    places = [place(call[1]) if call and is_value(call[1].type) else None for call in calls]
    if None in places or all(one == other for one, other in zip(*places)):
        return False  # the order may matter: an unknown object, the same object, or one object is a part of the other
    return all(is_read_only(parameter) for declared, _, _ in calls for parameter in declared.get_arguments()) and \
        all(asks_only_values(argument, other[-1:]) for (_, _, arguments), other in zip(calls, reversed(places)) for argument in arguments)
