# SPDX-License-Identifier: Apache-2.0
"""Checks the section "Use a device on your bus" of src/host/app/README.md: types its commands into a shell, one after the other."""
import os
import re
import subprocess

import warm_python
from bench import PATIENCE, Ear, check, sh, until

FOLDER = "/tmp/readme"


def blocks():
    with open("/repo/src/host/app/README.md") as readme:
        section = readme.read().partition("## Use a device on your bus\n")[2].partition("\n## ")[0]
    return [block.splitlines() for block in re.findall(r"```\n(.*?)```", section, re.S)]


class Shell:
    """A shell in a folder in which build/release/canproof is a link to `program`. In this shell `sudo COMMAND` just runs COMMAND, and
    python3 is the fast one of warm_python.py."""

    program = None

    def __init__(self):
        os.makedirs(f"{FOLDER}/bin", exist_ok=True)
        if not os.path.exists(f"{FOLDER}/build"):
            os.makedirs(f"{FOLDER}/build/release")
            os.symlink(self.program, f"{FOLDER}/build/release/canproof")
            for name, script in (("sudo", '#!/bin/sh\nexec "$@"\n'), ("python3", warm_python.COMMAND)):
                with open(f"{FOLDER}/bin/{name}", "w") as command:
                    command.write(script)
                os.chmod(f"{FOLDER}/bin/{name}", 0o755)
        environment = dict(os.environ, PATH=f"{FOLDER}/bin:{os.environ['PATH']}")
        self.output = open(f"{FOLDER}/output", "w+b")
        self.shell = subprocess.Popen(["bash", "--norc"], cwd=FOLDER, env=environment, stdin=subprocess.PIPE,
                                      stdout=self.output, stderr=subprocess.STDOUT, text=True)

    def said(self):
        with open(f"{FOLDER}/output", errors="replace") as output:
            return output.read()

    def type(self, line, *expected):
        """Types a line. Returns when the shell has printed all expected output and is ready for the next line."""
        done = f"{FOLDER}/done"
        if os.path.exists(done):
            os.unlink(done)
        self.shell.stdin.write(f"{line}\necho $? >{done}\n")
        self.shell.stdin.flush()
        until(line, lambda: os.path.exists(done) and open(done).read())
        status = open(done).read().strip()
        assert status == "0", f"{line}: status {status}: {self.said()[-2000:]}"
        for pattern in expected:
            until(f"{pattern} after {line}", lambda: re.search(pattern, self.said()))

    def close(self):
        self.shell.stdin.write("kill $(jobs -p); wait\n")
        self.shell.stdin.close()
        self.shell.wait(PATIENCE)


def on_vcan(lines):
    """Checks the output of each command line. Its first words select the expected output; a line without expected output fails."""
    expected = {
        "sudo ip link add dev vcan0": [],
        "sudo ip link set vcan0 up": [],
        "build/release/canproof run": [r"vcan0 703#00"],
        "candump vcan0": [],
        "cansend vcan0": [r"vcan0  583   \[8\]  43 00 10 00 91 01 08 00"],
        "python3 -c": [r"ID: 0583 .*43 18 10 01 17 00 00 00"],  # 1018h:01 vendor-ID of esd: 17h
        "build/release/canproof replay": [r"can0 703#00|vcan0 703#00(.|\n)*583#4300100091010800\n.*583#4318100117000000\n"],
    }
    follow(lines, expected, "vcan0")


def listeners(interface):
    """Returns the number of sockets that receive every frame of the interface."""
    with open("/proc/net/can/rcvlist_all") as sockets:
        return sum(line.split()[:1] == [interface] for line in sockets)


def follow(lines, expected, interface):
    shell = Shell()
    try:
        for line in lines:
            start = [words for words in expected if line.startswith(words)]
            assert len(start) == 1, f"no expectation for: {line}"
            shell.type(line, *expected[start[0]])
            if line.startswith("candump"):
                until("candump listens beside the program", lambda: listeners(interface) == 2)
    finally:
        shell.close()


def on_an_interface(lines):
    sh("ip", "link", "set", "can0", "down")
    sh("ip", "link", "set", "can1", "up", "type", "can", "bitrate", "125000")
    with Ear("can1") as ear:
        follow(lines, {"sudo ip link set can0 up": [], "sudo build/release/canproof run": [r"can0 705#00"]}, "can0")
        ear.wait("705#00")
    sh("ip", "link", "set", "can1", "down")


def over_socketcand(lines):
    # python-can must start after all four boot-up messages: it refuses a server that sends a frame beside the answer to `open`.
    follow(lines, {"build/release/canproof run": [r"socketcand listens at port 29536", r"(7..#00\b[^#]*){4}"],
                   "python3 -c": [r"ID: 0*583 .*43 18 10 01 17 00 00 00"]}, "lo")


def check_all(program):
    Shell.program = program
    vcan, interface, socketcand = blocks()
    with check("README: the commands on vcan0, as written"):
        on_vcan(vcan)
    with check("README: the commands on a real interface, as written"):
        on_an_interface(interface)
    with check("README: the commands over socketcand, as written"):
        over_socketcand(socketcand)
