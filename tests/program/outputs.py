#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""tests/program/outputs.py PROGRAM: runs PROGRAM (canproof) with files and streams that cannot be read or written.

Runs each command that prints with /dev/full as its standard output. The command must end with status 2 and one line of error. A folder is
refused as a log, a pipe is refused as a file of the register, and no file is emptied before everything else was checked."""
import fcntl
import os
import pathlib
import signal
import socket
import subprocess
import sys
import tempfile

sys.dont_write_bytecode = True
from expectations import PATIENCE, PROGRAM, canproof, expect, finish


def refused(result, what, *says):
    """Checks for status 2, for an error in the last line on standard error, and for the words `says` on standard error."""
    lines = result.stderr.splitlines()
    expect(result.returncode == 2, f"{what}: status {result.returncode}, not 2")
    expect(len(lines) >= 1 and lines[-1].startswith("canproof: "), f"{what}: standard error says {lines[-3:]}")
    for words in says:
        expect(words in result.stderr, f"{what}: `{words}` is not in {result.stderr!r}")


def full_disk(folder):
    """Checks that each command ends with status 2 and one line with the reason when standard output, --log or --outputs is on a full
    disk."""
    log = folder / "bus.log"
    log.write_text("(0.100000) can0 603#4000100000000000\n")
    verdicts = folder / "verdicts"
    verdicts.mkdir()
    (verdicts / "tests.xml").write_text('<testsuites><testsuite><testcase classname="A" name="B"/></testsuite></testsuites>')
    commands = [["--help"], ["devices"], ["signals", "cbx-ao412"], ["eds", "cbx-ao412"],
                ["eds", "ax188001", "--format", "xdd"], ["eds", "ax060805", "--format", "json"],
                ["eds", "ax130751", "--format", "md"], ["eds", "cbx-ao412", "--format", "dbc"], ["eds", "check", "--rules"],
                ["spec", "check"], ["audit", "--json", "--verdicts", verdicts], ["demo"],
                ["replay", "cbx-ao412", "--node", "3", log], ["run", "cbx-ao412@3", "--seconds", "0.01"],
                ["panel", "cbx-ao412@3", "--port", "0"], ["audit", "CO-SDO-001", "--verdicts", verdicts],
                ["coverage", "--records"]]
    with open("/dev/full", "w", encoding="ascii") as full:
        for command in commands:
            result = canproof(*command, stdout=full)
            refused(result, f"{' '.join(map(str, command))} > /dev/full", "standard output cannot be written")
            errors = [line for line in result.stderr.splitlines() if line.startswith("canproof: ")]
            expect(len(errors) == 1, f"{command}: not one line of error: {result.stderr!r}")
    for command in (["run", "cbx-ao412@3", "--seconds", "0.01", "--log"],
                    ["run", "cbx-ao412@3", "--seconds", "0.01", "--outputs"],
                    ["replay", "cbx-ao412", "--node", "3", log, "--outputs"]):
        refused(canproof(*command, "/dev/full"), f"{command} /dev/full", "/dev/full could not be written completely")


def closed_output(folder):
    """Checks that with a closed standard output no output goes into a file that the program opens, such as the log."""
    log = folder / "closed.log"
    result = subprocess.run(["sh", "-c", 'exec "$0" "$@" >&-', PROGRAM, "run", "cbx-ao412@3", "--seconds", "0.01",
                             "--log", str(log)], stderr=subprocess.PIPE, text=True, timeout=PATIENCE,
                            stdin=subprocess.DEVNULL)
    refused(result, "run >&-", "standard output cannot be written")
    lines = log.read_text().splitlines()
    expect(len(lines) == 1 and "703#00" in lines[0], f"the log of run >&- holds {lines}")


def reader_that_goes():
    """Checks that `canproof run | head -1` ends when head ends, without an attempt to print a further line."""
    with subprocess.Popen([PROGRAM, "run", "cbx-ao412@3"], stdin=subprocess.DEVNULL, stdout=subprocess.PIPE,
                          stderr=subprocess.PIPE, text=True) as run:
        first = run.stdout.readline()
        expect("703#00" in first, f"the first line is {first!r}")
        run.stdout.close()
        try:
            status = run.wait(PATIENCE)
            expect(status == 2, f"run | head -1 ends with {status}")
        except subprocess.TimeoutExpired:
            run.send_signal(signal.SIGKILL)
            expect(False, "run | head -1 does not end")


def unreadable_inputs(folder):
    log = folder / "one.log"
    log.write_text("(0.100000) can0 603#4000100000000000\n")
    held = folder / "folder"
    held.mkdir()
    refused(canproof("replay", "cbx-ao412", held), "a folder as log", "is a folder")
    refused(canproof("replay", "cbx-ao412", log, "--stimulus", held), "a folder as stimulus", "is a folder")
    refused(canproof("run", "cbx-ao412", "--stimulus", held, "--seconds", "0"), "a folder as stimulus of run",
            "is a folder")
    refused(canproof("plot", held, folder / "x.svg"), "a folder as CSV", "is a folder")
    directory = os.open(held, os.O_RDONLY)
    refused(canproof("replay", "cbx-ao412", "-", stdin=directory), "a folder as standard input",
            "standard input cannot be read to its end")
    refused(canproof("run", "cbx-ao412", "--seconds", "0.01", stdin=directory),
            "a folder as standard input of run", "standard input is a folder")
    os.close(directory)
    refused(canproof("replay", "cbx-ao412", "/dev/zero"), "/dev/zero as log", "/dev/zero:1: a line has more than")
    refused(canproof("replay", "cbx-ao412", log, "--stimulus", "/dev/zero"), "/dev/zero as stimulus",
            "/dev/zero:1: a line has more than")


def no_register(folder):
    spec = folder / "spec"
    spec.mkdir()
    refused(canproof("spec", "check", "--spec", spec), "an empty register", "contains no .toml file")
    (spec / "empty.toml").write_text("")
    result = canproof("spec", "check", "--spec", spec)
    expect(result.returncode != 0, "a register without an item is sound")
    os.mkfifo(spec / "pipe.toml")
    refused(canproof("spec", "check", "--spec", spec), "a pipe in a register", "pipe.toml: it is a pipe without a writer")
    refused(canproof("spec", "check", "--spec", spec / "pipe.toml"), "a pipe as register", "is no folder")


def no_folder(folder):
    """Checks that a file in the place of a folder, or a missing folder, gives one clear message, and that the file stays as it is."""
    empty, full = folder / "empty", folder / "full"
    for file, text in ((empty, ""), (full, "x")):
        file.write_text(text)
        for name in (file, file / "x"):
            says = f"canproof: {file} is no folder; name a folder, or remove this file\n"
            for command in (["conform", "cbx-ao412", "--only", "nmt", "--report"], ["run", "cbx-ao412", "--seconds", "0", "--nvm"],
                            ["evidence", "--out"]):
                result = canproof(*command, name)
                expect((result.returncode, result.stdout, result.stderr) == (2, "", says), f"{command} {name}: {result}")
        expect(file.read_text() == text, f"{file} was changed")
    for command in (["conform", "--list", "--cases"], ["inject", "cbx-ao412", "--merge"]):
        for name, why in ((folder / "none", "No such file or directory"), (full, "Not a directory")):
            refused(canproof(*command, name), f"{command} {name}",
                    f"canproof: cannot read the folder {name}: {why}; name a folder that exists and can be read")


def file_that_cannot_be_emptied(folder):
    """Checks that an output file which can be opened but not emptied is refused. A sealed file in memory is such a file."""
    log = folder / "one.log"
    log.write_text("(0.100000) can0 603#4000100000000000\n")
    sealed = os.memfd_create("sealed", os.MFD_ALLOW_SEALING)
    os.write(sealed, b"kept\n")
    fcntl.fcntl(sealed, fcntl.F_ADD_SEALS, fcntl.F_SEAL_SHRINK)
    path = f"/proc/{os.getpid()}/fd/{sealed}"
    for command in (["replay", "cbx-ao412", "--node", "3", log, "--outputs"],
                    ["run", "cbx-ao412@3", "--seconds", "0.01", "--outputs"],
                    ["run", "cbx-ao412@3", "--seconds", "0.01", "--log"]):
        refused(canproof(*command, path), f"{command} of a sealed file",
                f"cannot write {path} (Operation not permitted); name another file")
    expect(os.pread(sealed, 100, 0) == b"kept\n", "the sealed file was changed")
    os.close(sealed)


def nothing_is_emptied(folder):
    """Checks that a command which is refused at its start leaves the existing files of its --log and --outputs unchanged."""
    log, outputs = folder / "old.log", folder / "old.csv"
    kept = "(0.000000) can0 703#00\n"

    def keeps(what, *words, **how):
        log.write_text(kept)
        outputs.write_text(kept)
        result = canproof(*words, "--outputs", outputs, **how)
        expect(result.returncode == 2, f"{what}: status {result.returncode}")
        expect(log.read_text() == kept and outputs.read_text() == kept, f"{what}: a file was emptied")

    keeps("an unknown device", "run", "nosuch", "--log", log)
    keeps("an unknown bus", "run", "cbx-ao412", "--bus", "nosuch", "--log", log)
    keeps("an interface that is not there", "run", "cbx-ao412", "--bus", "socketcan:", "--log", log)
    keeps("a stimulus that does not exist", "run", "cbx-ao412", "--stimulus", folder / "none", "--log", log)
    keeps("a log in a folder that is not there", "run", "cbx-ao412", "--log", folder / "no" / "log")
    keeps("the outputs are the log", "run", "cbx-ao412", "--log", outputs)
    keeps("the outputs are the log that is read", "replay", "cbx-ao412", outputs)
    keeps("an unknown device in replay", "replay", "nosuch", log)
    with socket.socket() as taken:
        taken.bind(("127.0.0.1", 0))
        taken.listen()
        port = taken.getsockname()[1]
        keeps("a busy port", "run", "cbx-ao412", "--bus", f"socketcand:127.0.0.1:{port}", "--log", log)
        keeps("a busy port of the panel", "panel", "cbx-ao412", "--port", port, "--log", log)


with tempfile.TemporaryDirectory() as name:
    for number, check in enumerate((full_disk, closed_output, unreadable_inputs, no_register, no_folder,
                                    file_that_cannot_be_emptied, nothing_is_emptied)):
        place = pathlib.Path(name) / str(number)
        place.mkdir()
        check(place)
    reader_that_goes()
finish("every stream and file is checked")
