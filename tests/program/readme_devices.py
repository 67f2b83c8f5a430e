#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""tests/program/readme_devices.py PROGRAM: checks the tables of README and src/target/README.md whose first column is headed "device" or
"image". Each has one row for every device of `canproof devices`, by its name, or by the title or first part number in its register, and no
other row."""
import pathlib
import re
import subprocess
import sys
import tomllib

ROOT = pathlib.Path(__file__).resolve().parents[2]
PAGES = ("README.md", "src/target/README.md")
LEAST_TABLES = 3  # the list of devices, the memory of their images, and their work


def devices(program):
    """Returns the terms by which a row may name each device, by device name. A line of `canproof devices` without a leading space begins
    with a name."""
    lines = subprocess.run([program, "devices"], check=True, text=True, capture_output=True).stdout.splitlines()[1:]
    known = {}
    for name in (line.split()[0] for line in lines if not line.startswith(" ")):
        register = tomllib.loads((ROOT / "spec" / "devices" / name / "device.toml").read_text())
        known[name] = {name, register["title"], register["part_numbers"][0]}
    return known


def device_tables(text):
    """Returns, for each table of devices, the number of its first line and its first column."""
    for table in re.finditer(r"^\| *(?:device|image) *\|.*\n\|[-| ]+\|\n((?:\|.*\n)+)", text, re.M):
        rows = [row.split("|")[1].strip().strip("`") for row in table.group(1).splitlines()]
        yield text.count("\n", 0, table.start()) + 1, rows


def main():
    known = devices(sys.argv[1])
    tables = [(page, *table) for page in PAGES for table in device_tables((ROOT / page).read_text())]
    faults = [] if len(tables) >= LEAST_TABLES else [f"{' and '.join(PAGES)}: {len(tables)} tables of devices, there should be {LEAST_TABLES}"]
    for page, line, rows in tables:
        for name, words in known.items():
            count = sum(row in words for row in rows)
            faults += [f"{page}:{line}: {count} rows for {name}, there should be one"] if count != 1 else []
        every_word = set().union(*known.values())
        faults += [f"{page}:{line}: no device is called {row}" for row in rows if row not in every_word]
    for fault in faults:
        print(fault)
    print(f"{len(tables)} tables, {len(known)} devices, {len(faults)} fault(s)")
    return 1 if faults or not known else 0


sys.exit(main())
