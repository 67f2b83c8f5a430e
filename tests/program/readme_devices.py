#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""tests/program/readme_devices.py PROGRAM [--write]: compares the tables of devices of the pages with what the devices say.

- README.md: every row equals the register of the device (device.toml), in the order of `canproof devices`. --write writes the rows.
- src/target/README.md: each table whose first column is headed "device" has one row for every device and no other. Its figures are
  measured: src/target/footprint and src/target/run_suites compare them, and write them with --write-readme."""
import pathlib
import re
import subprocess
import sys
import tomllib

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.dont_write_bytecode = True
sys.path.append(str(ROOT / "src" / "target"))
from readme_table import differences, row  # noqa: E402

HEADING = "| device | maker | what it is | part numbers |"
MEASURED = ROOT / "src" / "target" / "README.md"
LEAST_MEASURED = 2  # the tables of memory and of work of the images


def devices(program):
    """Returns the names of the devices. A line of `canproof devices` without a leading space begins with a name."""
    lines = subprocess.run([program, "devices"], check=True, text=True, capture_output=True).stdout.splitlines()[1:]
    return [line.split()[0] for line in lines if not line.startswith(" ")]


def row_of(name):
    register = tomllib.loads((ROOT / "spec" / "devices" / name / "device.toml").read_text())
    return row(f"`{name}`", register["vendor"], register["title"], ", ".join(register["part_numbers"]))


def first_columns(text):
    """Returns, for each table of devices, the number of its first line and its first column."""
    for table in re.finditer(r"^\| *device *\|.*\n\|[-| ]+\|\n((?:\|.*\n)+)", text, re.M):
        yield text.count("\n", 0, table.start()) + 1, [one.split("|")[1].strip() for one in table.group(1).splitlines()]


def main():
    names = devices(sys.argv[1])
    faults = differences(ROOT / "README.md", HEADING, [row_of(name) for name in names], "--write" in sys.argv[2:])
    tables = list(first_columns(MEASURED.read_text()))
    if len(tables) < LEAST_MEASURED:
        faults.append(f"src/target/README.md: {len(tables)} tables of devices, there should be {LEAST_MEASURED}")
    for line, rows in tables:
        if sorted(rows) != sorted(f"`{name}`" for name in names):
            faults.append(f"src/target/README.md:{line}: the rows are {', '.join(rows)}; they should be {', '.join(names)}")
    for fault in faults:
        print(fault)
    print(f"{len(tables) + 1} tables, {len(names)} devices, {len(faults)} fault(s)")
    return 1 if faults or not names else 0


sys.exit(main())
