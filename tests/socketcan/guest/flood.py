# SPDX-License-Identifier: Apache-2.0
"""Checks the program on a bus where both sides send as fast as the kernel transfers frames, and checks what happens to frames for which a
buffer has no space."""
import re
import signal
import subprocess
import time

from bench import Ear, Run, check, sh, until

COUNT = 20000
REQUEST, ANSWER = "603#4000100000000000", "583#4300100091010800"  # CBX-AO412 7.9.2


def flood(count):
    """Sends frames with cangen without a gap, as fast as the kernel accepts them. Returns the frames per second."""
    begun = time.monotonic()
    sh("cangen", "vcan0", "-g", "0", "-n", str(count), "-I", "603", "-L", "8", "-D", REQUEST.partition("#")[2])
    return count / (time.monotonic() - begun)


def occurrences(path, text):
    with open(path, "rb") as log:
        return log.read().count(text.encode())


def full_rate(program):
    """Checks that each request of a flood is answered and is in the log, and that candump, which has a large buffer, gets each answer."""
    path = "/tmp/flood.log"
    with Ear("vcan0") as ear, Run(program, "cbx-ao412@3", "--bus", "socketcan:vcan0") as run:
        ear.wait("703#00")
        dump = subprocess.Popen(["candump", "-L", "-r", str(1 << 27), "vcan0,583:7FF"], stdout=open(path, "wb"))
        until("candump listens", lambda: "583" in open("/proc/net/can/rcvlist_fil").read())
        ear.socket.close()
        rate = flood(COUNT)
        until("as many answers", lambda: occurrences(path, ANSWER) == COUNT, 0.2)
        until("as many in the log", lambda: occurrences(run.log, ANSWER + " T") == COUNT, 0.2)
        dump.terminate()
        dump.wait()
        assert occurrences(run.log, REQUEST + " R") == COUNT
        said = run.stop()
        assert said == "", said
        print(f"        {rate:.0f} requests a second, processor {run.seconds:.2f} s for {COUNT} and their answers")


def losses_are_told(program):
    """Checks that a run reports how many frames are missing after it was stopped for too long. Without root rights, a run
    has a receive buffer of some hundred frames."""
    count = 2000
    with Ear("vcan0") as ear, Run(program, "cbx-ao412@3", "--bus", "socketcan:vcan0",
                                  prefix=["setpriv", "--reuid", "65534", "--clear-groups"]) as run:
        ear.wait("703#00")
        run.process.send_signal(signal.SIGSTOP)
        flood(count)
        run.process.send_signal(signal.SIGCONT)
        ear.wait(re.escape(ANSWER))
        ear.send("603#4001100000000000")  # CBX-AO412 7.9.4: 8110h (CAN overrun), with the error list and the error register
        ear.wait("083#1081110100000000")
        ear.rest()
        answered = ear.heard.count(ANSWER)
        said = run.stop()
        told = re.search(r"in total (\d+) frames were lost for the log, and (\d+) for the devices", said)
        assert told, said
        logged = occurrences(run.log, REQUEST + " R")
        assert int(told.group(1)) >= count - logged > 0, f"{logged} of {count} logged, but: {said}"
        assert int(told.group(2)) == count - answered > 0, f"{answered} of {count} answered, but: {said}"
        assert "sysctl -w net.core.rmem_max" in said, said


def check_all(program):
    with check(f"each of {COUNT} requests at full rate is logged and answered"):
        full_rate(program)
    with check("frames lost in a full buffer are counted and reported, and the device reports an overrun"):
        losses_are_told(program)
