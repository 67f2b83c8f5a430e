# SPDX-License-Identifier: Apache-2.0
"""Checks the text of single files for faults that no tool finds. These are code in comments (5.7.2), unused types
(0.2.3), a wrong structure of switch statements (9.4.2), and includes below code (19.0.3). Expects code that clang-format
has formatted."""
import re

from .definitions import closing
from .rules import TOKENS, Finding, without_comments_and_literals

PLACE = r"[\w.:<>\[\]*&]+(?:->[\w.\[\]]+)*"  # left side of an assignment
TYPE = (r"(?:(?:const|constexpr|static|inline|virtual|explicit|mutable|volatile|extern)\s+)*"
        r"(?:(?:auto|bool|char|double|float|int|long|short|unsigned|void|\w+_t|(?:\w+::)+\w+)\b(?:<[^;]*>)?)[&*]*")
DISABLED = [re.compile(pattern) for pattern in (
    r"return\b[^;]*;$",
    r"(?:break|continue|goto \w+|throw\b[^;]*|delete\b[^;]*);$",
    rf"{PLACE} ?(?:[-+*/%&|^]|<<|>>)?=(?!=)[^;]*;$",         # an assignment
    rf"(?:\+\+|--){PLACE};$", rf"{PLACE}(?:\+\+|--);$",
    r"(?:[\w.:]|->|<[\w:, ]*>)+\([^;]*\)(?:\.\w+\([^;]*\))*;$",  # a call
    r"(?:[\w.:]|->|<[\w:, ]*>)+\([^;)]*[,(]$",                     # first line of a call that continues in the next line
    rf"{PLACE} ?(?:[-+*/%&|^]|<<|>>)?=$", rf"{TYPE}\s+\w+ =$",
    rf"{TYPE}\s+\w+(?:\s*=[^;]*|\{{[^;]*\}}|\([^;]*\)[^;]*|\[[^;]*\])?;$",  # a declaration
    r"(?:const|constexpr|static) [^;]*[\w)}\]];$",
    r"(?:using|typedef|friend|template)\b[^;]*[\w>)];$",
    r"(?:\} ?)?(?:else )?(?:if|for|while|switch)(?: constexpr)? \(.*(?:\{\}?|;)$",
    r"(?:\} ?)?(?:else )?(?:if|for|while|switch)(?: constexpr)? \(.*(?:[=!<>]=|[<>!]|&&|\|\||::|;).*\)$",
    r"(?:\} ?)?else \{$", r"do \{$", r"\} while \(.*\);$", r"[{}]+[;,]?$",
    r"case [\w:'.]+:(?: .*;)?$", r"default:(?: .*;)?$", r"(?:public|protected|private):$",
    r"# *(?:include *[<\"]|define +\w|if\b|ifdef\b|ifndef\b|elif\b|else$|endif$|pragma\b|undef\b)",
    r"(?:explicit |virtual |static |constexpr |inline )*[\w:<>,&* ~]*\w\([^;]*\)[\w\s:(){},>-]*\{.*$",  # the head of a function
    r"(?:class|struct|union|enum|namespace)\b[^.;]*\{.*$", r"template ?<.*>$",
)]
LABEL = re.compile(r"(?:case\b(?:[^:?;{}]|::)*|default\s*):(?!:)")
TERMINATOR = re.compile(r"(?:^|[;{}:\s])(?:break|continue|\[\[fallthrough\]\]|return\b[^;]*|goto\s+\w+|throw\b[^;]*);$", re.DOTALL)
DECLARED = re.compile(r"\b(?:(?:struct|class|union|enum(?:\s+(?:class|struct))?)\s+(?:alignas\([^()]*\)\s*)?(?P<type>\w+)(?=[^;()<>=,&*]*\{)"
                      r"|using\s+(?P<alias>\w+)\s*=|typedef\b[^;{}]*?\b(?P<old>\w+)\s*(?:\[[^;]*\])?;)")


def line_of(text, at):
    return text.count("\n", 0, at) + 1


def is_disabled_code(line):
    return any(pattern.match(line) for pattern in DISABLED)


def disabled_code(text):
    """Returns the lines of comments that are code."""
    for token in TOKENS.finditer(text):
        if token.lastgroup != "comment":
            continue
        whole = token.group()
        inside = whole[2:] if whole.startswith("//") else whole[2:-2]
        for offset, line in enumerate(inside.split("\n")):
            line = re.sub(r"\s*// flagged$", "", line.strip().removeprefix("*").lstrip("/!<").strip())
            if is_disabled_code(line):
                yield line_of(text, token.start()) + offset


def unused_types(code):
    """Returns the line of each type whose name occurs only in its own definition."""
    for match in DECLARED.finditer(code):
        name = match["type"] or match["alias"] or match["old"]
        end = match.end()
        if match["type"]:
            end = closing(code, code.index("{", match.end()))
        outside = code[: match.start()] + code[end:]
        if not re.search(rf"\b{name}\b", outside):
            yield line_of(code, match.start())


def labels_of(code, start, stop):
    """Returns the start and end of each label of the switch whose body is [start, stop). Labels in inner braces do not count."""
    depth, at, begin = 0, start, True
    while at < stop:
        sign = code[at]
        label = LABEL.match(code, at, stop) if begin and depth == 0 else None
        if label:
            yield label.start(), label.end()
            at = label.end()
            continue
        if not sign.isspace():
            begin = sign in ";}" or (sign == "{" and depth == 0)
        depth += {"{": 1, "(": 1, "[": 1, "}": -1, ")": -1, "]": -1}.get(sign, 0)
        at += 1


def ends_with_jump(statements):
    """Returns whether the statements below a label end with a jump, or are a block that does."""
    text = statements.strip()
    while text.startswith("{") and closing(text, 0) == len(text) - 1:
        text = text[1:-1].strip()
    return bool(TERMINATOR.search(text))


def switch_faults(code):
    """Returns the line of each fault of a switch. A switch without a label, with statements above the first label, or with fewer
    than two branches is a fault. So is a default that is neither the first nor the last branch, and a last branch that does not end
    with a jump."""
    for match in re.finditer(r"\bswitch\s*\(", code):
        depth, at = 1, match.end()
        while at < len(code) and depth:
            depth += {"(": 1, ")": -1}.get(code[at], 0)
            at += 1
        rest = re.compile(r"\s*\{").match(code, at)
        if rest is None:
            continue  # the clang-query matchers report a switch body without braces
        start = rest.end()
        stop = closing(code, start - 1)
        labels = list(labels_of(code, start, stop))
        if not labels:
            yield line_of(code, match.start())
            continue
        if code[start : labels[0][0]].strip():
            yield line_of(code, match.start())
        ends = [begin for begin, _ in labels[1:]] + [stop]
        branches = [[]]  # labels of each branch; the statements of a branch follow its last label
        for (begin, end), next_begin in zip(labels, ends):
            branches[-1].append((begin, end, next_begin))
            if code[end:next_begin].strip():
                branches.append([])
        branches = [branch for branch in branches if branch]
        if len(branches) < 2:
            yield line_of(code, match.start())
        for branch in branches[1:-1]:
            yield from (line_of(code, begin) for begin, _, _ in branch if code.startswith("default", begin))
        begin, end, last = branches[-1][-1]
        if not ends_with_jump(code[end:last]):
            yield line_of(code, begin)


def late_includes(code):
    """Returns the line of each include below the first line that is no directive."""
    after = False
    continued = False
    for at, line in enumerate(code.split("\n"), 1):
        directive = continued or line.lstrip().startswith("#")
        if after and re.match(r"\s*#\s*include\b", line):
            yield at
        after = after or (not directive and bool(line.strip()))
        continued = directive and line.endswith("\\")


def scan(path, text):
    """Returns the findings of all scans in one file."""
    code = without_comments_and_literals(text)
    yield from (Finding("5.7.2", path, line) for line in disabled_code(text))
    yield from (Finding("19.0.3", path, line) for line in late_includes(code))
    yield from (Finding("9.4.2", path, line) for line in switch_faults(code))
    if path.endswith(".cpp"):
        yield from (Finding("0.2.3", path, line) for line in unused_types(code))
