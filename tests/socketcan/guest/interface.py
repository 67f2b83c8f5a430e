# SPDX-License-Identifier: Apache-2.0
"""Checks how a CAN interface of the kernel affects the devices: by error frames, a full queue and filters, and when it goes down and up."""
import re
import subprocess
import time

from bench import Ear, Run, boot_up, check, sh, until

DEVICES = ["cbx-ao412@3", "ax188001@5", "ax060805@6"]


def wait_all(ear, patterns):
    """Waits until each pattern has matched a frame. The frames may come in any order."""
    open_ones = list(patterns)
    while open_ones:
        got = ear.wait("|".join(open_ones))[0]
        open_ones = [one for one in open_ones if not re.fullmatch(one, got)]


def error_frames(ear):
    """Sends error frames and checks the emergency messages of the devices.

    linux/can/error.h: class 004h controller, with 10h receive passive, 40h active, 01h receive overflow in byte 1;
    class 040h bus-off, class 100h restarted. Emergency codes: CBX-AO412 7.9.4; AX188001 Table 5; AX060805 4.2.4."""
    sh("cansend", "vcan0", "20000004#0010000000000000")
    ear.wait("083#2081110100000000")  # error passive, one entry in the error list
    sh("cansend", "vcan0", "20000004#0040000000000000")
    ear.wait("083#0000000100000000")
    sh("cansend", "vcan0", "20000004#0001000000000000")
    wait_all(ear, ["083#1081110200000000", "085#1081.{12}", "086#1081.{12}"])
    sh("cansend", "vcan0", "000#0100")  # a frame that all nodes receive ends the overrun
    wait_all(ear, ["083#0000000200000000", "085#0000.{12}", "086#0000.{12}"])
    sh("cansend", "vcan0", "20000040#0000000000000000")
    sh("cansend", "vcan0", "603#4000100000000000")  # bus-off: no answer
    sh("cansend", "vcan0", "20000100#0000000000000000")
    wait_all(ear, ["085#0084.{12}", "086#4081.{12}", "083#4081110400000000"])
    heard = [text for text in ear.heard if text.startswith("58")]
    assert not heard, f"{heard} sent while bus-off"
    ear.ask("603#4000100000000000", "583#4300100091010800")


def down_and_up(run):
    sh("ip", "link", "set", "vcan0", "down")
    run.wait_notice("^vcan0 is down; waiting for it$")
    sh("ip", "link", "set", "vcan0", "up")
    run.wait_notice("^vcan0 is up again$")
    with Ear("vcan0") as ear:
        ear.ask("603#4000100000000000", "583#4300100091010800")
    sh("ip", "link", "del", "vcan0")
    run.wait_notice("^vcan0 is gone; waiting for it$")
    sh("ip", "link", "add", "dev", "vcan0", "type", "vcan")
    sh("ip", "link", "set", "vcan0", "up")
    run.wait_notice("^vcan0 is up again$")
    with Ear("vcan0") as ear:
        ear.ask("605#4000100000000000", "585#4300100094010200")


def check_faults(kind, program):
    with Ear("vcan0") as ear, Run(program, *DEVICES, "--bus", "socketcan:vcan0") as run:
        boot_up(ear, [3, 5, 6])
        with check(f"{kind}error frames cause the errors of each device, and a restart ends bus-off"):
            error_frames(ear)
        with check(f"{kind}an interface that goes down or is deleted is reported, and the run goes on when it is back"):
            down_and_up(run)
        with check(f"{kind}SIGTERM ends the run without a further notice"):
            said = run.stop()
            assert said == "", said


def matches():
    """Returns the number of frames that each filter of a node has accepted: {identifier: [count of each socket]}."""
    counts = {}
    with open("/proc/net/can/rcvlist_fil") as filters:
        for line in filters:
            words = line.split()
            if words and words[0] == "vcan0":
                counts.setdefault(words[1], []).append(int(words[-2]))
    return counts


def filters(program):
    """Checks that the kernel wakes the socket of a node only for frames to which the node may react."""
    with Ear("vcan0") as ear, Run(program, "cbx-ao412@3", "ax188001@5", "--bus", "socketcan:vcan0"):
        boot_up(ear, [3, 5])
        # The kernel passes a frame to one socket after the other. So the ear may have a frame before the program has it.
        until("both boot-ups counted", lambda: matches().get("703") == [1] and matches().get("705") == [1])
        before = matches()
        assert "603" in before and "605" in before, before
        sh("cangen", "vcan0", "-g", "0", "-n", "500", "-I", "7A5", "-L", "8")
        sh("cangen", "vcan0", "-g", "0", "-n", "500", "-I", "607", "-L", "8")
        ear.ask("603#4000100000000000", "583#4300100091010800")
        after = matches()
        before["603"] = [before["603"][0] + 1]
        assert after == before, f"{before} then {after}"


def full_queue(program):
    """Checks a run on an interface with a queue of four frames, which sends 60 frames a second. The kernel refuses more frames with
    ENOBUFS."""
    count = 24
    sh("ip", "link", "add", "dev", "vxcan0", "type", "vxcan", "peer", "name", "vxcan1")
    for interface in ("vxcan0", "vxcan1"):
        sh("ip", "link", "set", interface, "up")
    with Ear("vxcan1") as ear, Run(program, "cbx-ao412@3", "--bus", "socketcan:vxcan0") as run:
        ear.wait("703#00")
        sh("tc", "qdisc", "add", "dev", "vxcan0", "root", "tbf", "rate", "8kbit", "burst", "80", "limit", "64")
        spent, begun = run.processor_seconds(), time.monotonic()
        for sub in range(count):
            ear.send(f"603#400030{sub:02X}00000000")
        for sub in range(count):  # 3000h does not exist: abort code 06020000h (CiA 301, 7.2.4.3.17)
            got = ear.wait("583#.*")[0]
            assert got == f"583#800030{sub:02X}00000206", f"answer {sub}: {got}"
        took, spent = time.monotonic() - begun, run.processor_seconds() - spent
        refused = re.search(r"dropped (\d+)", sh("tc", "-s", "qdisc", "show", "dev", "vxcan0"))
        assert refused and int(refused.group(1)) > 0, "nothing was refused: the check shows nothing"
        assert spent < took / 2, f"{spent} s of processor time in {took} s"
        said = run.stop()
        assert said == "", said
    sh("ip", "link", "del", "vxcan0")


def check_kernel(program):
    with check("the socket of each device has its own filters, which accept no frame for others"):
        filters(program)
    with check("a full queue (ENOBUFS) delays answers and loses none, and the wait takes little processor time"):
        full_queue(program)
