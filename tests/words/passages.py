# SPDX-License-Identifier: Apache-2.0
"""Finds the texts of a file that a reader reads: comments, prose, sentences of TOML values, names of tests."""
import ast
import collections
import io
import pathlib
import re
import tokenize

# kind: "comment", "prose", "text" (a TOML value), "layout" (a line of a table or list of options) or "test name". line:
# the number of the first line. text: with the line breaks of the file.
Passage = collections.namedtuple("Passage", "kind line text")
# A line of a comment or page; `begins` says that it does not continue the line above.
Line = collections.namedtuple("Line", "number column text begins")

# Values of TOML files that are sentences; all others are names or numbers.
SENTENCES = ("text|says|reason|question|chosen|because|shows|risk|hides|note|judgement|disposition|rest|noticed|safe_state|"
             "why|differs")
TOML_VALUE = re.compile(rf'(?:^|[{{,\s])(?:{SENTENCES})\s*=\s*("""(?:[^\\]|\\.)*?"""|"(?:[^"\\\n]|\\.)*")', re.M | re.S)
CPP_TOKEN = re.compile(r'R"(\w*)\((?:.|\n)*?\)\1"|"(?:[^"\\\n]|\\.)*"|(?<![0-9a-fA-F])\'(?:[^\'\\\n]|\\.)+\''
                       r"|(?P<line>//[^\n]*)|(?P<block>/\*(?:.|\n)*?\*/)")
HASH_COMMENT = re.compile(r"""^((?:[^"'#\n\\]|\\.|"(?:[^"\\\n]|\\.)*"|'[^'\n]*'|(?<=\S)#)*?)(?<!\S)#(?!!)(.*)$""")
TEST_NAME = re.compile(r"^\s*(?:TEST|TEST_F|TEST_P|TYPED_TEST|RC_GTEST_PROP|RC_GTEST_FIXTURE_PROP)\(\s*(\w+),\s*(\w+)", re.M)
CAMEL = re.compile(r"[A-Z]?[a-z]+|[A-Z]+(?![a-z])|\d+")
LIST_ITEM = re.compile(r"^\s*(?:[-*+]|\d+[.)])\s+")
LAYOUT = re.compile(r"^   |\S {2,}\S|^\s*[-=*/#]{3,}|^\s*[|+]")


def joined(lines, kind):
    """Yields a passage for each run of lines without a blank, a list item or a change of column between them."""
    group = []
    for line in lines:
        if line.text.strip().startswith("SPDX-"):
            line = line._replace(text="")
        layout = LAYOUT.search(line.text) and not LIST_ITEM.match(line.text)
        follows = group and line.number == group[-1].number + 1 and line.column == group[-1].column and not line.begins
        if group and (not follows or layout or not line.text.strip() or LIST_ITEM.match(line.text)):
            yield Passage(kind, group[0].number, "\n".join(one.text for one in group))
            group = []
        if layout:
            yield Passage("layout", line.number, line.text.strip())
        elif line.text.strip():
            group.append(line._replace(text=LIST_ITEM.sub("", line.text).strip()))
    if group:
        yield Passage(kind, group[0].number, "\n".join(one.text for one in group))


def cpp_passages(text):
    lines = []
    for match in CPP_TOKEN.finditer(text):
        if not match["line"] and not match["block"]:
            continue
        begin = text.rfind("\n", 0, match.start()) + 1
        number, column = text.count("\n", 0, begin) + 1, match.start() - begin
        behind_code = bool(text[begin:match.start()].strip())
        if match["line"]:
            lines.append(Line(number, column, re.sub(r"^///?!?<?", "", match["line"]), behind_code))
        else:
            body = match["block"].removeprefix("/*").removesuffix("*/").splitlines()
            lines += [Line(number + at, column, re.sub(r"^\s*\*(?!\*)", "", one), at == 0) for at, one in enumerate(body)]
    yield from joined(lines, "comment")
    for match in TEST_NAME.finditer(text):
        yield Passage("test name", text.count("\n", 0, match.start(1)) + 1, " ".join(CAMEL.findall(match[1]) + CAMEL.findall(match[2])))


def python_passages(text):
    lines = []
    for token in tokenize.generate_tokens(io.StringIO(text).readline):
        if token.type == tokenize.COMMENT and not token.string.startswith("#!"):
            lines.append(Line(*token.start, token.string.lstrip("#"), bool(token.line[:token.start[1]].strip())))
    yield from joined(lines, "comment")
    for node in ast.walk(ast.parse(text)):
        if isinstance(node, (ast.Module, ast.ClassDef, ast.FunctionDef)) and ast.get_docstring(node):
            body = ast.get_docstring(node).splitlines()
            yield from joined([Line(node.body[0].lineno + at, 0, one, False) for at, one in enumerate(body)], "comment")


def hash_passages(text):
    found = [(number, HASH_COMMENT.match(line)) for number, line in enumerate(text.splitlines(), 1)]
    yield from joined([Line(number, len(match[1]), match[2], bool(match[1].strip())) for number, match in found if match], "comment")


def toml_passages(text):
    yield from hash_passages(text)
    for match in TOML_VALUE.finditer(text):
        yield Passage("text", text.count("\n", 0, match.start(1)) + 1, match[1].strip('"').replace("\\\n", "\n").strip())


def markdown_passages(text):
    lines, fenced = [], False
    for number, line in enumerate(text.splitlines(), 1):
        fence = line.lstrip().startswith("```")
        fenced ^= fence
        code = fence or fenced or (line.startswith("    ") and not (lines and lines[-1].text))
        text_of_line = "" if code else line.lstrip("#> ") if line.startswith(("#", ">")) else line
        item = LIST_ITEM.match(text_of_line)
        lines.append(Line(number, 0, text_of_line if item else text_of_line.strip(), line.startswith("#")))
        if line.startswith("#"):
            lines.append(Line(number, 0, "", True))
    yield from joined(lines, "prose")


READERS = {".cpp": cpp_passages, ".hpp": cpp_passages, ".js": cpp_passages, ".ld": cpp_passages, ".py": python_passages,
           ".md": markdown_passages, ".toml": toml_passages, ".cmake": hash_passages, ".sh": hash_passages,
           ".yml": hash_passages, ".yaml": hash_passages}


def reader_of(name, text):
    path = pathlib.PurePosixPath(name.removesuffix(".in"))
    if path.name in ("CMakeLists.txt", "Dockerfile", ".editorconfig", ".clangd"):
        return hash_passages
    if not path.suffix and text.startswith("#!"):
        return python_passages if "python" in text.split("\n", 1)[0] else hash_passages
    return READERS.get(path.suffix)


def passages(name, text):
    """Returns the passages of a file: none of a file that no reader knows."""
    reader = reader_of(name, text)
    return list(reader(text)) if reader else []


def wide_lines(text, width):
    """Yields (number, characters) of each line of Markdown prose above the width; links, tables and code may be wider."""
    fenced = False
    for number, line in enumerate(text.splitlines(), 1):
        fence = line.lstrip().startswith("```")
        fenced ^= fence
        prose = re.sub(r"\]\([^)]*\)", "]", line)
        if not fence and not fenced and not line.startswith(("|", "    ")) and len(prose) > width:
            yield number, len(prose)
