# SPDX-License-Identifier: Apache-2.0
"""The host's side of an image's protocol (src/host/sim/image/message.hpp) for checks that need the answer to each single command."""
import struct
import subprocess

GREETING, STATE, READ, WRITE, COMMIT, BEGIN, POWER_ON, RECEIVE, SET_INPUTS, ADVANCE, LOOK, STORED = range(12)
MEMORY = 8192
MACHINE = ["qemu-system-aarch64", "-nodefaults", "-no-user-config", "-object", "can-bus,id=bus", "-machine",
           "xlnx-zcu102,virtualization=on,canbus0=bus,canbus1=bus", "-icount", "shift=0,sleep=off", "-display", "none", "-monitor", "none",
           "-serial", "none", "-audiodev", "none,id=silent", *["-nic", "user,restrict=on,model=cadence_gem"] * 4, "-semihosting-config", "enable=on,target=native"]


class State:
    """The state that an image reports after a command. `frames` are (identifier, data)."""

    def __init__(self, content):
        self.deadline, self.node, self.nmt, self.bit_rate, _, count = struct.unpack_from("<QBBIBB", content)
        self.frames = []
        for at in range(16, 16 + 14 * count, 14):
            identifier, _, length, data = struct.unpack_from("<IBB8s", content, at)
            self.frames.append((identifier, data[:length]))


class Image:
    """An image on the emulated Zynq UltraScale+. Virtual time passes only in its methods."""

    def __init__(self, path):
        self.memory, self.now, self.sent = bytearray(b"\xff" * MEMORY), 0, 0
        self.process = subprocess.Popen([*MACHINE, "-device", f"loader,cpu-num=0,file={path}"], stdin=subprocess.PIPE,
                                        stdout=subprocess.PIPE)
        kind, content = self._take()
        if kind != GREETING or content[:4] != b"CBC1":
            raise SystemExit(f"{path}: no greeting of an image with its own clock")
        self.inputs = content[4]
        self._put(BEGIN, struct.pack("<I", MEMORY))

    def _put(self, kind, content):
        self.process.stdin.write(struct.pack("<HB", len(content) + 1, kind) + content)
        self.process.stdin.flush()

    def _take(self):
        head = self.process.stdout.read(3)
        if len(head) < 3:
            raise SystemExit(f"the image has ended with status {self.process.wait()}")
        length, kind = struct.unpack("<HB", head)
        return kind, self.process.stdout.read(length - 1)

    def call(self, kind, content=b"", after_us=0):
        """Lets time pass, sends a command and returns the state of the image. The next command tells the image that the frames of this state were sent."""
        self.now += after_us
        time = b"" if kind == LOOK else struct.pack("<Q", self.now)
        self._put(kind, bytes([self.sent]) + time + content)
        while True:
            kind, content = self._take()
            if kind == STATE:
                state = State(content)
                self.sent = len(state.frames)
                return state
            self._put(STORED, self._access(kind, content))

    def _access(self, kind, content):
        if kind == COMMIT:
            return b"\1"
        at, count = struct.unpack_from("<IH", content)
        if kind == READ:
            return b"\1" + self.memory[at:at + count]
        self.memory[at:at + count] = content[6:]
        return b"\1"

    def power_on(self):
        return self.all_of(self.call(POWER_ON, struct.pack(f"<{self.inputs}d", *[0.0] * self.inputs)))

    def send(self, identifier, data, after_us=1000):
        """Sends a data frame to the device. Returns the last state, with every frame of the answer."""
        frame = struct.pack("<IBB8s", identifier, 0, len(data), bytes(data))
        return self.all_of(self.call(RECEIVE, frame, after_us))

    def advance(self, us):
        return self.all_of(self.call(ADVANCE, b"", us))

    def all_of(self, state):
        frames = state.frames
        while state.frames:
            state = self.call(LOOK)
            frames = frames + state.frames
        state.frames = frames
        return state

    def end(self):
        self.process.stdin.close()
        return self.process.wait(60)
