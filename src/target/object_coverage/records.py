# SPDX-License-Identifier: Apache-2.0
"""Reads reasons/*.toml: the reasons why the suites do not reach a part of the object code."""
import fnmatch
import pathlib
import tomllib

KEYS = {"function", "code", "what", "reason"}


class Record:
    """A reason of reasons/*.toml. `function`, `code` (the text of the source line) and `what` are patterns with * and ?."""

    def __init__(self, table):
        if set(table) - KEYS or not table.get("function") or not table.get("reason"):
            raise ValueError(f"a record needs function and reason, and may have code and what: {table}")
        self.function, self.reason = table["function"], table["reason"]
        self.code, self.what = table.get("code", "*"), table.get("what", "*")
        self.uses = 0

    def fits(self, function, what, text):
        patterns = ((function, self.function), (what, self.what), (text, self.code))
        return all(fnmatch.fnmatchcase(value, pattern) for value, pattern in patterns)


class Records:
    def __init__(self, path):
        """Reads a file, or all files of a folder in the order of their names."""
        path = pathlib.Path(path)
        files = sorted(path.glob("*.toml")) if path.is_dir() else [path]
        self.all = [Record(one) for file in files for one in tomllib.loads(file.read_text(encoding="utf-8")).get("record", [])]

    def reason(self, function, what, text):
        """Returns the reason of the first record that fits; None when no record fits."""
        for one in self.all:
            if one.fits(function, what, text.strip()):
                one.uses += 1
                return one.reason
        return None

    def stale(self, functions):
        """Returns the records whose pattern fits none of these functions of the images."""
        return [one for one in self.all if not fnmatch.filter(functions, one.function)]

    def unused(self):
        """Returns the records from which no row got its reason."""
        return [one for one in self.all if one.uses == 0]


def text_at(place, lines={}):
    """Returns the source line at (file, line); an empty text when there is none."""
    if not place:
        return ""
    file, number = place
    if file not in lines:
        path = pathlib.Path(file)
        lines[file] = path.read_text(encoding="utf-8").splitlines() if path.is_file() else []
    return lines[file][number - 1] if 0 < number <= len(lines[file]) else ""
