# SPDX-License-Identifier: Apache-2.0
"""Makes one unit of several files, because a tool spends most of its time on the headers, which one unit contains only once.

A joined unit contains the texts of the files, one after the other. It does not include them, because a tool then would not treat them
as main files. Some checks report only in a main file, such as misc-use-internal-linkage."""
import bisect
import hashlib
import os
import pathlib
import re

from .rules import HOME


class Separate:
    """Files that a tool reads one by one."""

    def __init__(self, files):
        self.files = self.sources = [str(path) for path in files]

    @staticmethod
    def own_places(output):
        return output


class Joined:
    """Files whose texts are one unit in the folder `scratch`."""

    def __init__(self, files, scratch):
        self.files, self.first_lines, texts, at = [str(path) for path in files], [], [], 1
        for path in self.files:
            text = (HOME / path).read_text()
            texts.append(text if text.endswith("\n") else text + "\n")
            self.first_lines.append(at)
            at += texts[-1].count("\n")
        name = hashlib.sha256(repr(self.files).encode()).hexdigest()[:16]
        unit = pathlib.Path(os.path.realpath(scratch)) / f"joined_{name}.cpp"
        unit.write_text("".join(texts))
        self.sources = [str(unit)]

    def own_places(self, output):
        """Returns the output of a tool with the places in the joined unit replaced by those in the files."""
        def own(match):
            line = int(match[1])
            at = bisect.bisect_right(self.first_lines, line) - 1
            return f"{self.files[at]}:{line - self.first_lines[at] + 1}"
        return re.sub(re.escape(self.sources[0]) + r":(\d+)", own, output)


def unit_of(files, scratch):
    return Joined(files, scratch) if len(files) > 1 else Separate(files)
