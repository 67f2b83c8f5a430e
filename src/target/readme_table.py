# SPDX-License-Identifier: Apache-2.0
"""Compares a table of a README.md with the rows that a script has computed, or writes these rows into the page."""
import re

TABLE = r"^({heading}\n\|[-| ]+\|\n)((?:\|.*\n)+)"


def row(*cells):
    return f"| {' | '.join(cells)} |\n"


def differences(page, heading, rows, write=False):
    """Compares the table below the line `heading` of a page with `rows`. Returns a fault for each missing row and for each row that
    only the page has. With `write` it writes the rows into the page and returns none."""
    text = page.read_text()
    found = re.search(TABLE.format(heading=re.escape(heading)), text, re.M)
    if found is None:
        return [f"{page.name}: no table begins with {heading}"]
    if write:
        page.write_text(text[: found.start(2)] + "".join(rows) + text[found.end(2):])
        return []
    written = found.group(2).splitlines(keepends=True)
    line = text.count("\n", 0, found.start(2)) + 1
    faults = [f"{page}:{line}: this row is missing: {one.strip()}" for one in rows if one not in written]
    faults += [f"{page}:{line}: this row is wrong: {one.strip()}" for one in written if one not in rows]
    return faults if faults or written == list(rows) else [f"{page}:{line}: the rows have another order: {''.join(rows)}"]
