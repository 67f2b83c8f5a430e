# SPDX-License-Identifier: Apache-2.0
"""Chooses the files that get mutants, and makes the list of all mutants as C++."""
import glob
import json
import os

LIST = """// Written by tests/mutation/code/schemata.py: the mutants.
#include <iterator>

#include "host/codegen/alteration.hpp"

namespace canproof::mutants {{
unsigned chosen = 0U;
unsigned char* told = nullptr;
}}  // namespace canproof::mutants

namespace canproof::host {{

namespace {{

// {{file, function and line, change, address, size, number}}
const Alteration all[] = {{
{lines}}};

}}  // namespace

Alterations generated_alterations() {{
    return {{all, std::size(all)}};
}}

}}  // namespace canproof::host
"""


def firmware_files(source):
    """Returns the sources and headers of the firmware: the part that all devices share, then that of each device."""
    src = os.path.join(source, "src")
    roots = [os.path.join(src, "firmware"), *sorted(glob.glob(os.path.join(src, "devices", "*", "firmware")))]
    return [os.path.join(folder, file) for root in roots for folder, _, files in sorted(os.walk(root)) for file in sorted(files)
            if file.endswith((".cpp", ".hpp"))]


def driver_files(source):
    """Returns the sources and headers of the microcontrollers' drivers, without the access to real registers, which models replace."""
    roots = [os.path.join(source, "src", "target", chip) for chip in ("stm32f405", "zynqmp")]
    return [os.path.join(folder, file) for root in roots for folder, _, files in sorted(os.walk(root)) for file in sorted(files)
            if file.endswith((".cpp", ".hpp")) and file != "register.cpp"]


def host_files(source):
    """Returns the sources and headers of the buses and replay of the host, without the system calls of SocketCAN, which need a kernel."""
    roots = [os.path.join(source, "src", "host", "sim", part) for part in ("bus", "replay")]
    return [path for root in roots for path in sorted(glob.glob(os.path.join(root, "*.[ch]pp")))
            if not os.path.basename(path).startswith("linux_can_system.")]


def number_text(text, first):
    """Replaces each NUMBER[n] in the text by `first` + n, the number of this mutant in the whole program."""
    parts = text.split("NUMBER[")
    out = [parts[0]]
    for part in parts[1:]:
        digits, rest = part.split("]", 1)
        out.append(f"{first + int(digits)}U{rest}")
    return "".join(out)


def write_changed(path, text):
    """Writes a file only if its content changes, so that nothing is compiled again without need."""
    if os.path.exists(path) and open(path, encoding="utf-8").read() == text:
        return
    os.makedirs(os.path.dirname(path), exist_ok=True)
    with open(path, "w", encoding="utf-8") as out:
        out.write(text)


def lines_of(name, mutants, first):
    """Returns the lines of the list for one file, whose first mutant has the number `first`."""
    lines = []
    for number, (line, function, original, mutated) in enumerate(mutants, first):
        cell = json.dumps(f"{function}, line {line}")
        change = json.dumps(f"{original} -> {mutated}", ensure_ascii=False)
        lines.append(f"    {{{json.dumps(name)}, {cell}, {change}, &mutants::chosen, sizeof(unsigned), {number}U}},\n")
    return lines
