# SPDX-License-Identifier: Apache-2.0
"""Common parts of the checks in the guest: verdicts on its console, a listener on the bus, a run of canproof."""
import os
import re
import select
import socket
import struct
import subprocess
import sys
import termios
import time
import traceback

# PATIENCE is in seconds; only a broken program makes a check wait that long.
with open("/proc/cmdline") as words:
    PATIENCE = 300 if "program.arm=" in words.read() else 60
CAN_FRAME = struct.Struct("=IB3x8s")
EXTENDED, REMOTE, ERROR = 0x80000000, 0x40000000, 0x20000000  # linux/can.h
SO_RCVBUFFORCE, SO_TIMESTAMPNS_OLD = 33, 35

verdicts = []


class check:
    """`with check("what holds"): …` prints one line with the verdict. After a failed check, the next check still runs."""

    def __init__(self, name):
        self.name = name

    def __enter__(self):
        self.begun = time.monotonic()

    def __exit__(self, kind, what, trace):
        verdicts.append(kind is None)
        if kind is not None:
            where = traceback.extract_tb(trace)[0]
            print(f"{os.path.basename(where.filename)}:{where.lineno}: {kind.__name__}: {what}")
        print(f"{'ok    ' if kind is None else 'FAILED'}  {self.name}  ({time.monotonic() - self.begun:.1f} s)", flush=True)
        return kind is not None and issubclass(kind, Exception)


def sh(*words):
    """Returns the output of a command that must succeed."""
    done = subprocess.run(words, capture_output=True, text=True)
    assert done.returncode == 0, f"{' '.join(words)}: {done.stdout}{done.stderr}"
    return done.stdout


def until(what, holds, pause=0.01):
    """Waits until `holds()` is true. Calls it every `pause` seconds, because nothing reports the change of such a condition."""
    end = time.monotonic() + PATIENCE
    while not holds():
        assert time.monotonic() < end, f"not seen: {what}"
        time.sleep(pause)


def parse(text):
    """Returns the can_id and the data of a frame in the text form of candump, such as `603#40…` or `703#R`."""
    identifier, _, data = text.partition("#")
    if data.startswith("R"):
        return int(identifier, 16) | REMOTE, b""
    return int(identifier, 16), bytes.fromhex(data)


def show(can_id, data):
    return f"{can_id & 0x7FF:03X}#{'R' if can_id & REMOTE else data.hex().upper()}"


class Ear:
    """Sends and receives frames: a raw CAN socket on an interface, with time stamps of the kernel."""

    def __init__(self, interface):
        self.socket = socket.socket(socket.PF_CAN, socket.SOCK_RAW, socket.CAN_RAW)
        self.socket.setsockopt(socket.SOL_SOCKET, SO_RCVBUFFORCE, 1 << 26)
        self.socket.setsockopt(socket.SOL_SOCKET, SO_TIMESTAMPNS_OLD, 1)
        self.socket.bind((interface,))
        self.heard = []

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.socket.close()

    def send(self, text):
        can_id, data = parse(text)
        self.socket.send(CAN_FRAME.pack(can_id, len(data), data.ljust(8, b"\0")))

    def next(self, patience=PATIENCE):
        """Returns (text, time) of the next frame, or None after a time-out."""
        if not select.select([self.socket], [], [], patience)[0]:
            return None
        packed, control, _, _ = self.socket.recvmsg(CAN_FRAME.size, 64)
        can_id, length, data = CAN_FRAME.unpack(packed)
        seconds, nanoseconds = struct.unpack("qq", control[0][2]) if control else (0, 0)
        text = show(can_id, data[:length])
        self.heard.append(text)
        return text, seconds + nanoseconds / 1e9

    def wait(self, pattern):
        """Returns (text, time) of the next frame that matches, and skips the frames before it."""
        passed = []
        while True:
            got = self.next()
            assert got is not None, f"{pattern} did not come; heard {passed[-20:]}"
            if re.fullmatch(pattern, got[0]):
                return got
            passed.append(got[0])

    def ask(self, request, answer):
        self.send(request)
        return self.wait(answer)

    def rest(self, silence=0.3):
        """Returns all frames until no frame has come for `silence` seconds."""
        frames = []
        while (got := self.next(silence)) is not None:
            frames.append(got[0])
        return frames


def boot_up(ear, nodes):
    """Waits for the boot-up messages. Their order does not matter, because the devices share a process."""
    missing = {f"70{node}#00" for node in nodes}
    while missing:
        missing.discard(ear.wait(r"70\d#00")[0])


class Run:
    """A process `canproof run …`, whose notices a check can read while it runs. `log` is the file with its frames in the format of candump.
    Two runs at the same time need different names."""

    def __init__(self, program, *words, prefix=(), name="run"):
        self.log = f"/tmp/{name}.{os.getpid()}.log"
        if os.path.exists(self.log):
            os.unlink(self.log)
        open(self.log, "wb").close()
        os.chmod(self.log, 0o666)  # the program may run without root rights
        self.process = subprocess.Popen([*prefix, program, "run", *words, "--log", self.log, "--log-marks"], stdin=subprocess.DEVNULL,
                                        stdout=subprocess.DEVNULL, stderr=subprocess.PIPE)
        self.said = ""

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.process.kill()
        self.process.wait()
        self.process.stderr.close()

    def wait_notice(self, pattern):
        """Waits for a notice that matches `pattern` and returns it. The next call does not return the same notice."""
        end = time.monotonic() + PATIENCE
        while True:
            for line in self.said.splitlines(keepends=True):
                if line.endswith("\n") and re.search(pattern, line):
                    self.said = self.said[self.said.index(line) + len(line):]
                    return line.strip()
            ready = select.select([self.process.stderr], [], [], max(0, end - time.monotonic()))[0]
            piece = os.read(self.process.stderr.fileno(), 65536).decode() if ready else ""
            assert piece, f"no notice like {pattern}; said {self.said!r}"
            self.said += piece

    def frames(self):
        """Returns (seconds, ID#DATA, T (sent) or R (received)) of each complete line of the log so far."""
        with open(self.log) as log:
            lines = [line.split() for line in log.read().split("\n")[:-1]]
        return [(float(line[0].strip("()")), line[2], line[3]) for line in lines]

    def stop(self):
        """Ends the run as a user does. Returns all notices since the last one read, without the names of its devices and without the
        notices that only a slow machine causes."""
        self.seconds = self.processor_seconds()
        self.process.terminate()
        self.said = re.sub(r"(?m)^the simulation .*\n", "", self.said + self.process.stderr.read().decode())
        status = self.process.wait(PATIENCE)
        assert status == 0, f"ended with {status}: {self.said[-3000:]}"
        return re.sub(r"^\S+: (node-ID \d+|no node-ID)\n", "", self.said, flags=re.MULTILINE)

    def processor_seconds(self):
        with open(f"/proc/{self.process.pid}/stat") as stat:
            fields = stat.read().rpartition(")")[2].split()
        return (int(fields[11]) + int(fields[12])) / os.sysconf("SC_CLK_TCK")


def finish():
    failed = verdicts.count(False)
    print(f"verdict: {len(verdicts)} checks, {failed} failed", flush=True)
    termios.tcdrain(sys.stdout.fileno())  # waits for the slow console before the write to the exit port ends the guest
    with open("/dev/port", "r+b", buffering=0) as port:
        port.seek(0xF4)
        port.write(b"\x01" if failed == 0 and verdicts else b"\x02")
    sys.exit(1)
