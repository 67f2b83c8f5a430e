# SPDX-License-Identifier: Apache-2.0
"""Tests the checkers on seeds: violations in the style of the firmware, inserted into copies of firmware files.

misra/seeds/*.toml contains the seeds. A seed is a marked line of a piece of code; the other lines of the piece comply with its
rule. All pieces for one firmware file are in one copy of it, each in its own namespace. `bare` pieces have no namespace, `header`
pieces are in a header that the copy includes, and `text` pieces, which no compiler accepts, are in a file that only patterns
check."""
import pathlib
import re
import tempfile
import tomllib
from typing import NamedTuple

from .rules import HERE, HOME, NO_GCC
from .tools import find

MARK = "// flagged"
UNSEEN = "// unseen"  # marks a violation that no checker detects, a known gap
OTHER = "// its other line"  # marks another line at which a tool may report the flagged violation
KEYS = {"rule", "code", "bare", "header", "text"}


class Piece(NamedTuple):
    """Code for one rule. The numbers of its marked lines count from 0."""
    rule: str
    lines: list
    marked: list
    unseen: list
    others: list
    bare: bool
    header: bool
    text: bool


def read_pieces(faults):
    """Reads misra/seeds/*.toml. Returns, for each copy of a firmware file, the lines for its start and its pieces of code. The key
    is the firmware file and the suffix of the copy."""
    hosts = {}
    for path in sorted((HERE / "seeds").glob("*.toml")):
        table = tomllib.loads(path.read_text())
        starts, pieces = hosts.setdefault((table["file"], "" if table.get("gcc", True) else NO_GCC), ([], []))
        starts += [f"#include <{name}>" for name in table.get("includes", []) if f"#include <{name}>" not in starts]
        for entry in table["code"]:
            if not {"rule", "code"} <= entry.keys() <= KEYS:
                faults.add(f"{path.name}: code for rule {entry.get('rule')} has keys {sorted(entry)}")
                continue
            lines = entry["code"].strip("\n").split("\n")
            marks = [[at for at, line in enumerate(lines) if mark in line] for mark in (MARK, UNSEEN, OTHER)]
            pieces.append(Piece(entry["rule"], lines, *marks, *(entry.get(key, False) for key in ("bare", "header", "text"))))
    return hosts


def namespace_of(piece, number):
    return f"canproof::seed_{number}_for_{re.sub(r'[^0-9]', '_', piece.rule)}"


def write_copies(hosts, folder):
    """Writes copies of the firmware files with their pieces, and a header beside each for the pieces that need one.
    Returns the units, the headers and, for each piece, its file and the line before its first line."""
    units, headers, places = [], [], []
    for (file, ending), (starts, pieces) in sorted(hosts.items()):
        unit = folder / file.replace("/", "_").replace(".cpp", f"{ending}.cpp")
        header, text_only = unit.with_suffix(".hpp"), unit.with_suffix(".text.hpp")
        texts = {text_only: [], header: ["#pragma once", "", "#include <array>", "#include <cstdint>"],
                 unit: [*starts, *(HOME / file).read_text().splitlines(), f'#include "{header.name}"']}
        for number, piece in sorted(enumerate(pieces), key=lambda one: one[1].bare):
            path = text_only if piece.text else header if piece.header else unit
            text = texts[path]
            if not piece.bare:
                text.append(f"namespace {namespace_of(piece, number)} {{")
            places.append((piece, str(path), len(text)))
            text += [re.sub(rf"\s*(?:{MARK}|{UNSEEN}|{OTHER})$", "", line) for line in piece.lines]
            if not piece.bare:
                text.append("}")
        for path, text in texts.items():
            path.write_text("\n".join(text) + "\n")
        units.append(str(unit))
        headers += [str(header), str(text_only)]
    return units, headers, places


def judge(places, found, faults):
    """Checks that exactly the marked lines are flagged under their rule. Returns the number of seeds and the number of
    undetected seeds."""
    lines_of = {}
    for finding in found:
        lines_of.setdefault((finding.rule, finding.path), set()).add(finding.line)
    for piece, path, before in places:
        flagged = {line - before - 1 for line in lines_of.get((piece.rule, path), ())}
        inside = {at for at in flagged if 0 <= at < len(piece.lines)}
        for at in sorted(set(piece.marked) - inside):
            faults.add(f"a seeded violation of rule {piece.rule} is not detected: {piece.lines[at].strip()}")
        for at in sorted(inside - {*piece.marked, *piece.others}):
            what = "is detected now: mark the line with `// flagged`" if at in piece.unseen else "is flagged, but complies"
            faults.add(f"a seeded line for rule {piece.rule} {what} (line {at + 1}): {piece.lines[at].strip()}")
    return sum(len(piece.marked) for piece, *_ in places), sum(len(piece.unseen) for piece, *_ in places)


def prove_on_firmware(rules, generated, faults):
    """Runs all checkers over copies of firmware files with seeds. Returns the number of seeds and that of undetected seeds."""
    hosts = read_pieces(faults)
    with tempfile.TemporaryDirectory() as scratch:
        units, headers, places = write_copies(hosts, pathlib.Path(scratch).resolve())
        found = find(rules, units, headers, generated, scratch, faults, together=True)
    seeds, unseen = judge(places, found, faults)
    if unseen * 50 > seeds + unseen:
        faults.add(f"{unseen} of {seeds + unseen} seeds are not detected; at most 2 % are allowed")
    return seeds, unseen
