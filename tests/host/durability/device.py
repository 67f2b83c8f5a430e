# SPDX-License-Identifier: Apache-2.0
"""The running program, and a model of the data that its device has stored."""
import dataclasses
import os
import random
import select
import signal
import subprocess
import tempfile
import time

LONGEST_WAIT = 120.0  # seconds; reached only by a program that hangs


class Broken(Exception):
    """A check that failed. `kind` names its counter: lost, unusable or other."""

    def __init__(self, kind, text):
        super().__init__(text)
        self.kind = kind


@dataclasses.dataclass(frozen=True)
class Device:
    name: str  # the name for `canproof run`
    node: int
    objects: tuple  # index, sub-index: numbers of 16 bit that a save (1010h:1) stores
    kinds: tuple  # kinds of stores
    shipped: int  # factory node-ID, which applies when the LSS store is damaged (CO-LSS-065)


CBX_AO412 = Device("cbx-ao412@3", 3, ((0x1017, 0), (0x2404, 1), (0x6411, 1)), ("save", "restore", "save"), 3)
AX188001 = Device("ax188001@5", 5, ((0x1017, 0), (0x1800, 5), (0x1801, 5)), ("save", "lss", "restore"), 127)


class Running:
    """`canproof run` with its frames. The end of the `with` block kills it if it still runs."""

    def __init__(self, program, device, folder, environment, preexec):
        self.device = device
        self.errors = tempfile.TemporaryFile()
        self.process = subprocess.Popen([program, "run", device.name, "--nvm", str(folder)], stdin=subprocess.PIPE, stdout=subprocess.PIPE,
                                        stderr=self.errors, env=environment, preexec_fn=preexec, bufsize=0)
        self.rest = b""
        self.lines = []
        self.deadline = None

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.process.kill()
        self.process.wait()
        self.process.stdin.close()
        self.process.stdout.close()
        self.errors.close()

    def put(self, frames):
        try:
            self.process.stdin.write("".join(frame + "\n" for frame in frames).encode())
        except BrokenPipeError:
            pass  # the program has ended: its remaining output is read

    def kill_after(self, seconds):
        self.deadline = time.monotonic() + seconds

    def frame(self, *beginnings):
        """Returns the next frame with one of these beginnings, or None when the program has ended."""
        until = time.monotonic() + LONGEST_WAIT
        while True:
            while self.lines:
                words = self.lines.pop(0).split()
                if len(words) >= 3 and words[2].startswith(beginnings):
                    return words[2]
            if not self.read(until):
                return None

    def read(self, until):
        now = time.monotonic()
        if now > until:
            raise Broken("other", "no answer, and the program runs")
        if self.deadline is not None and now >= self.deadline:
            self.process.kill()
            self.deadline = None
        wait = (until if self.deadline is None else min(until, self.deadline)) - now
        if not select.select([self.process.stdout], [], [], max(wait, 0.0))[0]:
            return True
        piece = os.read(self.process.stdout.fileno(), 65536)
        *whole, self.rest = (self.rest + piece).split(b"\n")
        self.lines += [line.decode() for line in whole]
        return bool(piece)

    def wait(self):
        while self.frame("nothing begins so") is not None:
            pass
        return self.process.wait(LONGEST_WAIT)

    def finish(self, number):
        self.process.send_signal(number)
        return self.wait()

    def complaint(self):
        self.errors.seek(0)
        return self.errors.read().decode()


class Model:
    """The states that the device may have stored. A state is (node-ID, values of the objects)."""

    def __init__(self, device, seed):
        self.device = device
        self.chance = random.Random(seed)
        self.number = 0
        self.defaults = None
        self.kept = None  # acknowledged
        self.asked = None
        self.maybe = set()  # requested since the last acknowledgement, and either not answered or refused: may be stored or not
        self.past = set()

    def kinds(self):
        return self.device.kinds

    def file(self, folder):
        return folder / (self.device.name + ".bin")

    def read_state(self, running, what):
        boot = running.frame("7")
        while boot is not None and not boot.endswith("#00"):
            boot = running.frame("7")
        if boot is None:
            return None
        self.node = int(boot[:3], 16) - 0x700
        running.put([f"{0x600 + self.node:03X}#40{low(index)}{sub:02X}00000000" for index, sub in self.device.objects])
        values = []
        for _ in self.device.objects:
            answer = running.frame(f"{0x580 + self.node:03X}#4B")
            if answer is None:
                return None
            values.append(int.from_bytes(bytes.fromhex(answer[12:16]), "little"))
        return self.node, tuple(values)

    def state_of(self, running, what, may_end):
        state = self.read_state(running, what)
        if state is None and not may_end:
            raise Broken("unusable", f"{what}: the program does not run: {running.complaint()}")
        return state

    def look(self, running, what, may_end=False):
        """Reads the state after a start. Returns False if the program ended before."""
        state = self.state_of(running, what, may_end)
        if state is None:
            return False
        if self.kept is None:
            self.kept, self.defaults = state, state[1]
        if state != self.kept and state not in self.maybe:
            raise Broken("lost", f"{what}: found {state}, acknowledged {self.kept}, asked for {self.maybe}")
        self.kept, self.maybe = state, set()
        self.past.add(state)
        return True

    def look_at_any(self, running, what):
        """Accepts any node-ID and any values that were ever stored or shipped. They are stored separately, so they need not belong
        together."""
        node, values = self.state_of(running, what, False)
        if values not in {one[1] for one in self.past} or node not in {one[0] for one in self.past} | {self.device.shipped}:
            raise Broken("lost", f"{what}: {(node, values)} was never stored")

    def only_kept(self):
        """Drops the refused requests, so that the next start must find the acknowledged state."""
        self.maybe = set()

    def ask(self, running, kind=None):
        self.number += 1
        kind = kind or self.chance.choice(self.device.kinds)
        node, _ = self.kept
        request = f"{0x600 + self.node:03X}#"
        if kind == "save":
            value = 10000 + self.number % 20000
            self.asked = node, (value,) * len(self.device.objects)
            bytes_of = value.to_bytes(2, "little").hex().upper()
            running.put([f"{request}2B{low(index)}{sub:02X}{bytes_of}0000" for index, sub in self.device.objects]
                        + [request + "2310100173617665"])
            self.good, self.bad = (f"{0x580 + self.node:03X}#{code}10100" for code in ("60", "80"))
        elif kind == "restore":
            self.asked = node, self.defaults
            running.put([request + "231110016C6F6164"])
            self.good, self.bad = (f"{0x580 + self.node:03X}#{code}11100" for code in ("60", "80"))
        else:
            wanted = 1 + self.number % 126
            self.asked = wanted, self.kept[1]
            running.put(["7E5#0401000000000000", f"7E5#11{wanted:02X}000000000000", "7E5#1700000000000000"])
            self.good, self.bad = "7E4#1700", "7E4#1702"
        self.maybe.add(self.asked)

    def answer(self, running):
        """Returns True if the store was acknowledged, and False if the memory refused it: then the old state stays, and the requested state
        is possible too. Returns None if the program ended."""
        answer = running.frame(self.good, self.bad)
        if answer is None:
            return None
        if answer.startswith(self.good):
            self.kept, self.maybe = self.asked, set()
            self.past.add(self.kept)
            return True
        return False


def low(index):
    return f"{index & 0xFF:02X}{index >> 8:02X}"
