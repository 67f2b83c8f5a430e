# SPDX-License-Identifier: Apache-2.0
"""Tables of a page that a script knows: compares their rows, or writes them."""
import re

TABLE = r"^({heading}\n\|[-| ]+\|\n)((?:\|.*\n)+)"


def row(*cells):
    return f"| {' | '.join(cells)} |\n"


def differences(page, heading, rows, write=False):
    """Compares the table below the line `heading` of a page with `rows`. Returns a fault for each row that is missing and for each one
    that the page has too much. With `write` it writes the rows into the page and returns none."""
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
