# SPDX-License-Identifier: Apache-2.0
"""Writes one exhibit (piece of evidence) of the evidence pack. src/host/assess/evidence/exhibit.hpp describes its files."""
import csv
import json


def write_exhibit(folder, title, says, open_points, tables):
    """Replaces the exhibit in the folder. `tables`: rows by file name, with the heading as the first row. The state of the exhibit
    is `open` when there is an open point, otherwise `holds`. At most 100 open points are written."""
    folder.mkdir(parents=True, exist_ok=True)
    description = folder / "exhibit.json"
    description.unlink(missing_ok=True)  # a folder without it is no exhibit, if this program ends too early
    for old in folder.glob("*.csv"):
        old.unlink()
    for name, rows in tables.items():
        with open(folder / name, "w", newline="", encoding="utf-8") as out:
            csv.writer(out, lineterminator="\n").writerows(rows)
    exhibit = {"title": title, "state": "open" if open_points else "holds", "says": says, "open": open_points[:100], "data": list(tables)}
    new = description.with_suffix(".new")
    new.write_text(json.dumps(exhibit, indent=1) + "\n", encoding="utf-8")
    new.replace(description)
