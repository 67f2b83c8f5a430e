#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""tests/program/readme_devices.py PROGRAM: compares the tables of devices in two README pages with the devices of PROGRAM (canproof).
tests/program/readme_devices.py --write-readme [BUILD HOST_BUILD] [--root FOLDER]: writes these tables, in the repository FOLDER.

- README.md: every row equals the register of the device (device.toml), in the order of `canproof devices`.
- src/target/README.md: each table whose first column is headed "device" has one row for every device and no other. Its figures are
  measured values. src/target/footprint, run_suites, run_self_tests and bounds_table compare them with what they measure, except the
  injected faults, which are records of single campaigns.

--write-readme writes the rows of README.md. In src/target/README.md it adds a row without figures for each device that has none, and
removes the rows of devices that are gone. It needs no build. With BUILD and HOST_BUILD, the build folders of the presets target and debug,
it also measures all figures and writes them."""
import argparse
import pathlib
import re
import subprocess
import sys
import tomllib

TARGET = pathlib.Path(__file__).resolve().parents[2] / "src" / "target"
sys.dont_write_bytecode = True
sys.path.append(str(TARGET))
from readme_table import differences, row  # noqa: E402

HEADING = "| device | maker | what it is | part numbers |"
MEASURED_TABLE = re.compile(r"^(\| *device *\|.*\n\|[-| ]+\|\n)((?:\|.*\n)*)", re.M)
LEAST_MEASURED = 5  # src/target/README.md has tables of memory, of work, of self-tests (two) and of bounds


def devices(program):
    """Returns the names of the devices. A line of `canproof devices` without a leading space begins with a name."""
    lines = subprocess.run([program, "devices"], check=True, text=True, capture_output=True).stdout.splitlines()[1:]
    return [line.split()[0] for line in lines if not line.startswith(" ")]


def described(root):
    """Returns the names of the devices that the register describes."""
    return sorted(file.parent.name for file in (root / "spec" / "devices").glob("*/device.toml"))


def row_of(root, name):
    register = tomllib.loads((root / "spec" / "devices" / name / "device.toml").read_text())
    return row(f"`{name}`", register["vendor"], register["title"], ", ".join(register["part_numbers"]))


def first_cell(line):
    return line.split("|")[1].strip()


def compare(root, names):
    """Returns the number of tables, and a fault for each difference between their rows and the devices."""
    faults = differences(root / "README.md", HEADING, [row_of(root, name) for name in names])
    text = (root / "src" / "target" / "README.md").read_text()
    tables = list(MEASURED_TABLE.finditer(text))
    if len(tables) < LEAST_MEASURED:
        faults.append(f"src/target/README.md: {len(tables)} tables of devices, there should be {LEAST_MEASURED}")
    for table in tables:
        rows = [first_cell(one) for one in table.group(2).splitlines()]
        if sorted(rows) != sorted(f"`{name}`" for name in names):
            line = text.count("\n", 0, table.start()) + 1
            faults.append(f"src/target/README.md:{line}: the rows are {', '.join(rows)}; they should be {', '.join(names)}")
    return len(tables) + 1, faults


def write(root, names):
    """Writes the rows of README.md, and the missing rows of src/target/README.md without figures. Returns the faults of README.md."""
    def rows(table):
        known = {first_cell(one): one for one in table.group(2).splitlines(keepends=True)}
        empty = [""] * (table.group(1).splitlines()[0].count("|") - 2)
        return table.group(1) + "".join(known.get(f"`{name}`", row(f"`{name}`", *empty)) for name in names)

    page = root / "src" / "target" / "README.md"
    page.write_text(MEASURED_TABLE.sub(rows, page.read_text()))
    return differences(root / "README.md", HEADING, [row_of(root, name) for name in names], True)


def measure(build, host):
    """Lets each script that measures a table write it. Returns a fault for each one that fails."""
    bounds = pathlib.Path(build).parent / "exhibits" / "worst_case"
    calls = [("footprint", build), ("run_suites", build, host), ("run_self_tests", build)]
    faults = [f"src/target/{name} fails" for name, *builds in calls
              if subprocess.run([TARGET / name, *builds, "--write-readme"], check=False).returncode != 0]
    bounded = subprocess.run([TARGET / "worst_case" / "check", build, "--exhibit", bounds], check=False).returncode == 0
    written = subprocess.run([TARGET / "bounds_table", build, bounds, "--write-readme"], check=False).returncode == 0
    return faults + ([] if bounded and written else ["the table of static bounds is not measured"])


def main():
    parser = argparse.ArgumentParser(usage=__doc__)
    parser.add_argument("words", nargs="*")
    parser.add_argument("--write-readme", action="store_true")
    parser.add_argument("--root", type=pathlib.Path, default=TARGET.parents[1])
    options = parser.parse_args()
    if len(options.words) not in ((0, 2) if options.write_readme else (1,)):
        parser.error("wrong number of arguments")
    names = described(options.root) if options.write_readme else devices(options.words[0])
    faults = write(options.root, names) if options.write_readme else []
    if options.write_readme and options.words:
        faults += measure(*options.words)
    tables, differing = compare(options.root, names)
    faults += differing
    for fault in faults:
        print(fault)
    print(f"{tables} tables, {len(names)} devices, {len(faults)} fault(s)")
    return 1 if faults or not names else 0


sys.exit(main())
