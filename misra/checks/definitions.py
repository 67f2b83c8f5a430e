"""What the compiler sees only one translation unit at a time: 6.2.1 and 6.2.3 (one definition, one place) and 6.9.1 (one alias).

A scanner of declarations by their braces, for code as clang-format leaves it."""
import re
from typing import NamedTuple

from .rules import Finding, without_comments_and_literals

TYPE = re.compile(r"\b(?:class|struct|union|enum(?:\s+class|\s+struct)?)\s+(?P<name>\w+)\s*(?:final\b\s*)?(?::[^:].*)?$", re.DOTALL)
ALIGNED = re.compile(r"\balignas\([^()]*\)\s*")
NAMESPACE = re.compile(r"\bnamespace\b\s*(?P<name>[\w:]*)\s*$")
CALLABLE = re.compile(r"(?P<result>.*?)\b(?P<name>(?:\w+::)*(?:operator\s*[^\s\w(]+|operator\s*\(\s*\)|~?\w+))\s*\(", re.DOTALL)
VARIABLE = re.compile(r"\b(?P<name>\w+)\s*(?:=.*)?$", re.DOTALL)


class Item(NamedTuple):
    """A declaration or definition with linkage."""
    name: str
    parameters: tuple  # spelled types; None for what is no function
    result: str
    defined: bool
    path: str
    line: int
    text: str


def closing(code, at):
    depth = 0
    for position in range(at, len(code)):
        depth += {"{": 1, "}": -1}.get(code[position], 0)
        if depth == 0:
            return position
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
    """The type as it is written: without the name, a default, const of the copy, and enclosing scopes."""
    text = re.sub(r"\s*=.*$", "", parameter, flags=re.DOTALL)
    if re.search(r"[\w>&*]\s+\w+$|[&*]\w+$", text) and not re.fullmatch(r"(?:const\s+)?[\w:]+", text):
        text = re.sub(r"\w+$", "", text)
    if "&" not in text and "*" not in text:
        text = re.sub(r"\bconst\b", "", text)
    text = re.sub(r"\b(?!std::)(?:\w+::)+(?=\w)", lambda m: "std::" if m.group().startswith("std::") else "", text)
    return re.sub(r"\s+", " ", re.sub(r"\s*([&*<>,])\s*", r"\1", text)).strip()


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
        qualifier = " const" if re.match(r"\)\s*const\b", clean[stop:]) else ""
        result = re.sub(r"\b(?:constexpr|inline|static|virtual|explicit|friend|noexcept)\b|\[\[[^\]]*\]\]", "", match["result"])
        name = scope + re.sub(r"\s+", "", match["name"]) + qualifier
        self.items.append(Item(name, parameters, spelled_type(result), defined, self.path, self.line(at), self.code[at:end]))

    def scan(self, start=0, stop=None, scope="", in_class=False):
        stop = len(self.code) if stop is None else stop
        at = begin = start
        while at < stop:
            sign = self.code[at]
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
        """Whether the brace at `at` ended a declaration; an initialiser's does not."""
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
            return False  # up to its semicolon, which declares nothing more
        if "(" in head.split("=")[0] or "operator" in head:
            listed = re.search(r"\)\s*(?:noexcept\s*)?:(?!:)", head)
            if listed and re.search(r"[\w>]\s*$", head) and not re.search(r"\b(?:noexcept|const|override)\s*$", head):
                return False
            self.function(head, begin, scope, True, end + 1)
            return True
        return False


def declarations(texts):
    for path, text in sorted(texts.items()):
        yield from Scanner(path, text).scan()


def one_definition(texts):
    """Every place but the first where something is defined again: 6.2.3, and 6.2.1 too where the definitions differ."""
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
    """Definitions whose types no declaration of theirs spells the same way: 6.9.1. Overloads pair off by their spelling."""
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
