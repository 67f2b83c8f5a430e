#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""conform_report.py PROGRAM: checks where `canproof conform --report FOLDER` writes its report (PROGRAM is canproof). FOLDER may be a
relative path. A second run writes the same bytes. A FOLDER with other files is refused before the run and stays as it is. Also checks that
--no-remote-frames skips the case that needs a remote frame."""
import json
import pathlib
import subprocess
import sys
import tempfile

PROGRAM = pathlib.Path(sys.argv[1]).resolve()


def conform(folder, report):
    return subprocess.run([PROGRAM, "conform", "ax188001", "--case", "2.1", "--report", report], cwd=folder, capture_output=True,
                          text=True)


def contents(folder):
    return {str(file.relative_to(folder)): file.read_bytes() for file in folder.rglob("*") if file.is_file()}


def check_relative_name(folder):
    done = conform(folder, "out")
    assert done.returncode == 0, done.stderr
    first = contents(folder / "out")
    assert {"index.html", "sdo.html", "report.json", "report.txt", "junit.xml"} <= set(first), sorted(first)
    again = conform(folder, "./out/")
    assert again.returncode == 0, again.stderr
    assert contents(folder / "out") == first, "a second run leaves other bytes"


def check_adapter_without_remote_frames():
    def verdict(*words):
        done = subprocess.run([PROGRAM, "conform", "ax188001", "--case", "sdo-remote-request", "--json", *words], capture_output=True,
                              text=True)
        assert done.returncode == 0, done.stderr
        return [(one["verdict"], one["why"]) for one in json.loads(done.stdout)["cases"]]

    assert verdict() == [("passed", "")], verdict()
    assert verdict("--no-remote-frames") == [("skipped", "this bus carries no remote frames")], verdict("--no-remote-frames")


def check_refusal(folder):
    for names in (["notes.txt"], ["page.html"], ["report.json", "notes.txt"]):
        place = folder / names[0].replace(".", "-")
        place.mkdir()
        for name in names:
            (place / name).write_text("mine", encoding="utf-8")
        before = contents(folder)
        for report, cwd in ((place.name, folder), (".", place)):
            done = conform(cwd, report)
            assert done.returncode == 2 and "files that belong to no report" in done.stderr, done
            assert "passed" not in done.stdout, "the run came first"
            assert contents(folder) == before, "files of others are gone"


def main():
    check_adapter_without_remote_frames()
    with tempfile.TemporaryDirectory() as folder:
        check_relative_name(pathlib.Path(folder))
    with tempfile.TemporaryDirectory() as folder:
        check_refusal(pathlib.Path(folder))


main()
