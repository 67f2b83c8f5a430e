# SPDX-License-Identifier: Apache-2.0
"""Checks rules of MISRA C++:2023 over several translation units: 6.2.1 and 6.2.3 (one definition, one place), 6.9.1 (one alias),
6.4.2 (hidden functions) and the part of 13.3.3 for overrides.

The scanner finds declarations by their braces, in code that clang-format has formatted."""
import functools
import re
from typing import NamedTuple

from .rules import Finding, without_comments_and_literals

TYPE = re.compile(r"\b(?:class|struct|union|enum(?:\s+class|\s+struct)?)\s+(?P<name>\w+)\s*(?:final\b\s*)?(?::[^:].*)?$", re.DOTALL)
ALIGNED = re.compile(r"\balignas\([^()]*\)\s*")
NAMESPACE = re.compile(r"\bnamespace\b\s*(?P<name>[\w:]*)\s*$")
CALLABLE = re.compile(r"(?P<result>.*?)\b(?P<name>(?:\w+::)*(?:operator\s*[^\s\w(]+|operator\s*\(\s*\)|~?\w+))\s*\(", re.DOTALL)
BRACE = re.compile(r"[{}]")
SIGN = re.compile(r"[;{:]")
VARIABLE = re.compile(r"\b(?P<name>\w+)\s*(?:=.*)?$", re.DOTALL)


class Item(NamedTuple):
    """A declaration or definition with linkage."""
    name: str
    parameters: tuple  # types as spelled; None for an item that is no function
    result: str
    defined: bool
    path: str
    line: int
    text: str
    names: tuple = ()  # names of the parameters; None for an unnamed one


def closing(code, at):
    """Returns the place of the brace that closes the one at `at`."""
    depth = 0
    for brace in BRACE.finditer(code, at):
        depth += 1 if brace.group() == "{" else -1
        if depth == 0:
            return brace.start()
    return len(code) - 1


def split_at_commas(text):
    parts, depth, start = [], 0, 0
    for at, sign in enumerate(text):
        depth += {"<": 1, "(": 1, "{": 1, "[": 1, ">": -1, ")": -1, "}": -1, "]": -1}.get(sign, 0)
        if sign == "," and depth == 0:
            parts.append(text[start:at])
            start = at + 1
    return [part.strip() for part in [*parts, text[start:]] if part.strip()]


def spelled_type(parameter):
    """Returns the type of a parameter as spelled. Leaves out its name, a default, the const of a parameter passed by value, and
    scopes except std::."""
    text = re.sub(r"\s*=.*$", "", parameter, flags=re.DOTALL)
    if re.search(r"[\w>&*]\s+\w+$|[&*]\w+$", text) and not re.fullmatch(r"(?:const\s+)?[\w:]+", text):
        text = re.sub(r"\w+$", "", text)
    if "&" not in text and "*" not in text:
        text = re.sub(r"\bconst\b", "", text)
    text = re.sub(r"\b(?!std::)(?:\w+::)+(?=\w)", lambda m: "std::" if m.group().startswith("std::") else "", text)
    return re.sub(r"\s+", " ", re.sub(r"\s*([&*<>,])\s*", r"\1", text)).strip()


def name_of(parameter):
    """Returns the parameter's name, or None."""
    text = re.sub(r"\s*=.*$|\[\[\w+\]\]", "", parameter, flags=re.DOTALL).strip()
    match = re.search(r"(?:[\w>&*]\s+|[&*])(\w+)$", text)
    return match[1] if match and not re.fullmatch(r"(?:const\s+)?[\w:]+", text) else None


class Scanner:
    def __init__(self, path, text):
        self.path = path
        code = without_comments_and_literals(text)
        self.code = re.sub(r"^[ \t]*#[^\n]*", lambda m: " " * len(m.group()), code, flags=re.MULTILINE)
        self.items = []

    def line(self, at):
        while at < len(self.code) and self.code[at].isspace():
            at += 1
        return self.code.count("\n", 0, at) + 1

    def function(self, head, at, scope, defined, end):
        clean = re.sub(r"^\s*template\s*<[^{;]*?>\s*(?=\w)", "", head)
        match = CALLABLE.match(clean)
        if match is None or re.match(r"\s*(?:static_assert|using|friend|return|typedef)\b", clean):
            return
        depth, stop = 0, match.end() - 1
        for stop in range(match.end() - 1, len(clean)):
            depth += {"(": 1, ")": -1}.get(clean[stop], 0)
            if depth == 0:
                break
        if "= default" in clean[stop:] or "= delete" in clean[stop:]:
            return
        inside = clean[match.end() : stop]
        parameters = tuple(spelled_type(part) for part in split_at_commas(inside))
        names = tuple(name_of(part) for part in split_at_commas(inside))
        qualifier = " const" if re.match(r"\)\s*const\b", clean[stop:]) else ""
        result = re.sub(r"\b(?:constexpr|inline|static|virtual|explicit|friend|noexcept)\b|\[\[[^\]]*\]\]", "", match["result"])
        name = scope + re.sub(r"\s+", "", match["name"]) + qualifier
        self.items.append(Item(name, parameters, spelled_type(result), defined, self.path, self.line(at), self.code[at:end], names))

    def scan(self, start=0, stop=None, scope="", in_class=False):
        stop = len(self.code) if stop is None else stop
        at = begin = start
        while (found := SIGN.search(self.code, at, stop)) is not None:
            at, sign = found.start(), found.group()
            if sign == ";":
                head = self.code[begin:at]
                self.statement(head, begin, scope, in_class, at)
                begin = at + 1
            elif sign == "{":
                end = closing(self.code, at)
                if self.block(begin, at, end, scope, in_class):
                    begin = end + 1
                at = end
            elif sign == ":" and in_class and re.fullmatch(r"\s*(?:public|protected|private)\s*", self.code[begin:at]):
                begin = at + 1
            at += 1
        return self.items

    def statement(self, head, begin, scope, in_class, end):
        head = ALIGNED.sub("", head)
        if TYPE.search(head.split("{")[0]) or re.match(r"\s*(?:using|friend|extern|template|namespace)\b", head):
            return
        if "(" in head.split("=")[0].split("{")[0]:
            self.function(head, begin, scope, False, end)
        elif not in_class and re.search(r"[={]", head):
            match = VARIABLE.search(re.sub(r"\{.*", "", head, flags=re.DOTALL))
            if match:
                self.items.append(Item(scope + match["name"], None, "", True, self.path, self.line(begin), head))

    def block(self, begin, at, end, scope, in_class):
        """Scans the block at `at`. Returns whether it ends a declaration; the braces of an initialiser do not."""
        head = ALIGNED.sub("", self.code[begin:at])
        namespace = NAMESPACE.search(head)
        if namespace:
            name = namespace["name"] or f"(in {self.path})"
            self.scan(at + 1, end, f"{scope}{name}::", False)
            return True
        declared = TYPE.search(head)
        if declared and "(" not in head:
            text = self.code[begin : end + 1]
            self.items.append(Item(scope + declared["name"], None, "", True, self.path, self.line(begin), text))
            if "enum" not in head:
                self.scan(at + 1, end, f"{scope}{declared['name']}::", True)
            return False  # the declaration ends at its semicolon
        if "(" in head.split("=")[0] or "operator" in head:
            listed = re.search(r"\)\s*(?:noexcept\s*)?:(?!:)", head)
            if listed and re.search(r"[\w>]\s*$", head) and not re.search(r"\b(?:noexcept|const|override)\s*$", head):
                return False
            self.function(head, begin, scope, True, end + 1)
            return True
        return False


@functools.lru_cache(maxsize=None)
def scanned(path, text):
    """Returns the scanner of a file after its scan; several checks need the same scan."""
    scanner = Scanner(path, text)
    scanner.scan()
    return scanner


def declarations(texts):
    for path, text in sorted(texts.items()):
        yield from scanned(path, text).items


def one_definition(texts):
    """Returns every repeated definition: a finding of 6.2.3, and also of 6.2.1 if the definitions differ."""
    places = {}
    for item in declarations(texts):
        if item.defined:
            places.setdefault((item.name, item.parameters), []).append(item)
    for items in places.values():
        for item in items[1:]:
            if (item.path, item.line) != (items[0].path, items[0].line):
                yield Finding("6.2.3", item.path, item.line)
                if "".join(item.text.split()) != "".join(items[0].text.split()):
                    yield Finding("6.2.1", item.path, item.line)


def same_aliases(texts):
    """Returns a finding of 6.9.1 for each definition whose parameter and result types no declaration spells in the same way.

    Compares functions with the same name and the same number of parameters together, because they may be overloads. If each
    declaration of this group has a definition with the same spelling, there are no findings: the other definitions are then
    overloads without a declaration."""
    declared, defined = {}, {}
    for item in declarations(texts):
        if item.parameters is not None:
            spelled = (item.parameters, item.result)
            (defined if item.defined else declared).setdefault((item.name, len(item.parameters)), {})[spelled] = item
    for name, definitions in defined.items():
        others = declared.get(name, {})
        if others.keys() - definitions.keys():
            for spelled, item in definitions.items():
                if spelled not in others:
                    yield Finding("6.9.1", item.path, item.line)


BASES = re.compile(r"\b(?:class|struct)\s+(?P<name>\w+)\s*(?:final\b\s*)?:(?!:)(?P<bases>[^{};]+)\{")


def bases_of(code):
    """Returns each class with the simple names of its bases and the names that its `using` declarations import from them."""
    for match in BASES.finditer(code):
        bases = [re.sub(r"<.*|\b(?:public|private|protected|virtual)\b|\s", "", part, flags=re.DOTALL).split("::")[-1]
                 for part in split_at_commas(match["bases"])]
        body = code[match.end() : closing(code, match.end() - 1)]
        yield match["name"], bases, set(re.findall(r"\busing\s+(?:\w+(?:<[^;]*>)?::)+(\w+)\s*;", body))


def overriding(item):
    return re.search(r"\b(?:override|final)\b", item.text) is not None


def hidden_and_renamed(texts):
    """Returns members that hide a function of a base (6.4.2), and overrides with another parameter name than the base (13.3.3)."""
    methods, bases, used = {}, {}, {}
    for path, text in sorted(texts.items()):
        scanner = scanned(path, text)
        for item in scanner.items:
            parts = item.name.split("::")
            if item.parameters is not None and len(parts) > 1 and not re.match(r"~|operator", parts[-1]) and parts[-1] != parts[-2]:
                name, _, qualifier = parts[-1].partition(" ")
                methods.setdefault("::".join(parts[:-1]), {}).setdefault(name, []).append((item, (item.parameters, qualifier)))
        for name, named, taken in bases_of(scanner.code):
            bases.setdefault((path, name), set()).update(named)
            used.setdefault((path, name), set()).update(taken)
    for (path, name), named in bases.items():
        for scope in [scope for scope in methods if scope.split("::")[-1] == name]:
            own = {method: [one for one in items if one[0].path == path] for method, items in methods[scope].items()}
            for method, others in inherited_by(scope, named, methods, bases):
                virtual = {spelled for item, spelled in others if re.search(r"\bvirtual\b", item.text) or overriding(item)}
                for item, spelled in own.get(method, []):
                    if spelled not in virtual and not overriding(item) and method not in used[path, name]:
                        yield Finding("6.4.2", item.path, item.line)
                    for other, same in others:
                        if same == spelled and any(one and two and one != two for one, two in zip(item.names, other.names)):
                            yield Finding("13.3.3", item.path, item.line)


def inherited_by(scope, named, methods, bases, seen=()):
    """Returns name and declarations of each function that the class `scope` inherits from the bases `named` and from their bases.
    If several classes have the name of a base, the one in the nearest scope counts."""
    for base in named - set(seen):
        around = scope.split("::")[:-1]
        places = [place for place in methods if place.split("::")[-1] == base]
        places.sort(key=lambda place: -len([1 for one, two in zip(place.split("::"), around) if one == two]))
        for place in places[:1]:
            yield from methods[place].items()
        for (_, name), further in bases.items():
            if name == base:
                yield from inherited_by(scope, further, methods, bases, (*seen, base))
