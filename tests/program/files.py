#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""tests/program/files.py PROGRAM: checks how PROGRAM (canproof) treats the files that it writes.

An output never replaces an input or another output. A run that cannot start empties no file. One process at a time writes a log. No
emulator outlives the program."""
import os
import pathlib
import select
import signal
import socket
import struct
import subprocess
import sys
import tempfile

sys.dont_write_bytecode = True
from expectations import PATIENCE, PROGRAM, canproof, expect, finish, refused


def outputs_over_inputs(folder):
    log, eds, csv = folder / "in.log", folder / "in.eds", folder / "in.csv"
    texts = {log: "(0.100000) can0 603#4000100000000000\n", eds: canproof("eds", "ax188001").stdout,
             csv: "seconds,signal,value\n0,aout1,0\n1,aout1,5\n"}
    for file, text in texts.items():
        file.write_text(text)
    linked, other = folder / "linked", folder / "other.eds"
    os.link(eds, linked)
    other.symlink_to(eds)
    same = "is named twice, as an output and as another file"
    run = ("run", "--seconds", "0", "--eds", f"{eds}@5")
    for name in (eds, linked, other, folder / ".." / folder.name / "in.eds"):  # four names of one file
        refused(same, *run, "--log", name)
        refused(same, *run, "--outputs", name)
    refused(same, *run, "--log", folder / "new", "--outputs", folder / "new")
    refused(same, *run, "--nvm", folder, "--log", folder / "in@5.bin")
    refused(same, "replay", "--eds", eds, log, "--outputs", eds)
    refused(same, "replay", "cbx-ao412", log, "--outputs", log)
    refused(same, "replay", "cbx-ao412", log, "--nvm", log)
    refused(same, "replay", "cbx-ao412", log, "--nvm", folder / "new", "--outputs", folder / "new")
    with log.open(encoding="ascii") as stream:
        refused(same, "replay", "cbx-ao412", "-", "--outputs", log, stdin=stream)
    refused(same, "plot", csv, csv)
    for file, text in texts.items():
        expect(file.read_text() == text, f"{file.name} was changed")
    expect(not (folder / "new").exists() and not (folder / "in@5.bin").exists(), "a refused command has made a file")


def start_that_fails(folder):
    """Checks that a run which cannot join its bus leaves the old log and outputs."""
    log, outputs = folder / "old.log", folder / "old.csv"
    log.write_text("kept\n")
    outputs.write_text("kept\n")
    with socket.socket() as closed:
        closed.bind(("127.0.0.1", 0))  # nothing listens at this port
        refused("cannot join", "run", "cbx-ao412", "--bus", f"socketcand-client:127.0.0.1:{closed.getsockname()[1]}", "--log", log,
                "--outputs", outputs)
    expect((log.read_text(), outputs.read_text()) == ("kept\n", "kept\n"), "a run that cannot start has changed its files")


def report_folder():
    """Checks that a report which cannot be written is refused before the first case."""
    result = refused("cannot write /proc/report", "conform", "ax188001", "--only", "nmt", "--report", "/proc/report")
    expect(result.stdout == "", f"cases ran before the folder was checked: {result.stdout[:100]!r}")


def key_before_the_work(folder):
    """Checks that `evidence` refuses a key before it reads the register, which is missing in `folder`."""
    bad = folder / "bad.pem"
    bad.write_text("no key\n")
    refused("bad.pem contains no private key", "evidence", "--root", folder, "--sign", bad, "--out", folder / "out")
    refused("none.pem", "evidence", "--root", folder, "--sign", folder / "none.pem", "--out", folder / "out")


def kills_that_fail(folder):
    """Checks that `mutate --kills` leaves no results of a program that is missing or of which a test fails."""
    programs, verdicts = folder / "programs", folder / "programs" / "verdicts"
    programs.mkdir()
    spec = pathlib.Path(__file__).resolve().parents[2] / "spec"
    (folder / "spec").symlink_to(spec)
    (folder / "reports").mkdir()
    (folder / "reports" / "kills.csv").write_text("test,body,kills,without mutants,code\n")
    words = ("mutate", "--kills", "--root", folder, "--programs", programs)
    refused("canproof_tests", *words)
    expect(not verdicts.exists(), "mutate --kills without programs leaves a folder")
    for name in ("canproof_tests", "canproof_properties"):
        (programs / name).write_text("#!/bin/sh\nexit 1\n")
        (programs / name).chmod(0o755)
    refused("fails without any alteration", *words)
    expect(not verdicts.exists(), "mutate --kills with a failing test leaves a folder")
    (verdicts / "others").mkdir(parents=True)
    refused("fails without any alteration", *words)
    expect([file.name for file in verdicts.iterdir()] == ["others"], "mutate --kills removes the results of others, or leaves its own")


def two_runs_with_one_log(folder):
    log = folder / "shared.log"
    with subprocess.Popen([PROGRAM, "run", "cbx-ao412@3", "--log", str(log)], stdin=subprocess.DEVNULL, stdout=subprocess.PIPE,
                          stderr=subprocess.PIPE, text=True) as first:
        try:
            expect("703#00" in first.stdout.readline(), "the first run sends no boot-up frame")
            refused(f"{log} is in use by process {first.pid}", "run", "cbx-ao412@4", "--log", log, "--seconds", "0.01")
            refused(f"{log} is in use by process {first.pid}", "replay", "cbx-ao412", "/dev/null", "--outputs", log)
        finally:
            first.send_signal(signal.SIGTERM)
            first.communicate(timeout=PATIENCE)
    expect("703#00" in log.read_text() and "704#00" not in log.read_text(), "the log is not that of the first run")
    again = canproof("run", "cbx-ao412@4", "--log", log, "--seconds", "0.01")
    expect(again.returncode == 0 and "703#00" not in log.read_text(), f"the log stays locked: {again.stderr}")


def images(folder):
    no_image = folder / "notes.elf"
    for head in (b"", b"no image\n" * 10, b"\x7fELF\x02" + bytes(60), b"\x7fELF\x01" + bytes(60)):
        no_image.write_bytes(head)
        refused("is no image: it is no 32-bit ELF program for ARM", "run", "--arm", no_image, "--seconds", "0.1")


def is_running(process):
    try:
        return pathlib.Path(f"/proc/{process}/stat").read_text().rpartition(")")[2].split()[0] != "Z"
    except FileNotFoundError:
        return False


def emulator_ends_with_the_program(folder):
    """Checks that a signal which ends the program before the image has answered ends the emulator too. The emulator is a shell script."""
    image = folder / "silent.elf"
    image.write_bytes(b"\x7fELF\x01\x01\x01" + bytes(9) + struct.pack("<HHII", 2, 40, 1, 0x08000001) + bytes(24))
    emulator = folder / "qemu-system-arm"
    fifo = folder / "pid"
    os.mkfifo(fifo)
    emulator.write_text(f'#!/bin/sh\necho $$ >"{fifo}"\nexec tail -f /dev/null\n')
    emulator.chmod(0o755)
    for by in (signal.SIGTERM, signal.SIGKILL):
        with subprocess.Popen([PROGRAM, "run", "--arm", str(image)], stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL,
                              stderr=subprocess.DEVNULL, env={**os.environ, "PATH": f"{folder}:{os.environ['PATH']}"}) as run:
            process = int(fifo.read_text())
            watched = os.pidfd_open(process)
            run.send_signal(by)
            run.wait(PATIENCE)
        select.select([watched], [], [], 10)  # ready when the process has ended
        os.close(watched)
        if is_running(process):
            os.kill(process, signal.SIGKILL)
            expect(False, f"the emulator goes on after {by.name}")


with tempfile.TemporaryDirectory() as name:
    for number, check in enumerate((outputs_over_inputs, start_that_fails, two_runs_with_one_log, images,
                                    key_before_the_work, kills_that_fail, emulator_ends_with_the_program)):
        place = pathlib.Path(name) / str(number)
        place.mkdir()
        check(place)
    report_folder()
finish("no output replaces an input; a log has one writer; no emulator outlives the program")
