# SPDX-License-Identifier: Apache-2.0
"""Checks the four devices, in one process, on vcan0: cansend and python-can send requests, candump records all frames, and `canproof
replay` replays the log."""
import os
import signal
import subprocess
import time

import warm_python
from bench import Ear, Run, boot_up, check, sh, until

FOUR = {3: "cbx-ao412", 4: "ax130751", 5: "ax188001", 6: "ax060805"}
NAMES = [f"{name}@{node}" for node, name in FOUR.items()]


# The devices that also run as ARM code. The AX130751 has a cycle of 1 ms: an emulator inside the emulated guest is too slow for it, and
# delays the heartbeats of the other devices of the process.
ARM = {"cbx-ao412", "ax188001", "ax060805"}


def words_of(name, node, images):
    """Returns the words of `canproof run` for a device; with the folder of the images, it runs as ARM code."""
    return ["--arm", f"{images}/bridged_{name.replace('-', '_')}.elf@{node}"] if images else [f"{name}@{node}"]


def with_images(folder):
    """Returns the words of `canproof run` for the four devices, three of them as ARM code."""
    return [word for node, name in FOUR.items() for word in words_of(name, node, folder if name in ARM else None)]


# 1000h device type: CBX-AO412 7.9.2; AX130751 3.2.1; AX188001 3.2.1; AX060805 4.2.1. A frame contains the lowest byte first.
DEVICE_TYPES = {3: "91010800", 4: "94011CE0", 5: "94010200", 6: "9A010310"}
DUMP = "/tmp/candump.log"


def ask_with_cansend(ear):
    for node, device_type in DEVICE_TYPES.items():
        sh("cansend", "vcan0", f"60{node}#4000100000000000")
        ear.wait(f"58{node}#43001000{device_type}")
    sh("cansend", "vcan0", "703#R")  # node guarding: pre-operational is 127, toggle bit 0 (CiA 301, 7.2.8.2.2.1)
    ear.wait("703#7F")
    sh("cansend", "vcan0", "000#0103")
    sh("cansend", "vcan0", "703#R")
    ear.wait("703#85")  # operational is 5, with the toggle bit 85h


def ask_with_python_can():
    with open(os.path.join(os.path.dirname(__file__), "python_can.py")) as script:
        status, said = warm_python.ask(script.read())
    assert status == 0, said


def stamps_are_the_kernels(ear, run):
    """Checks that a frame that arrives while the process is stopped is logged with its time of arrival."""
    run.process.send_signal(signal.SIGSTOP)
    with Ear("vcan0") as other:
        stamps = []
        for number in range(3):
            ear.send(f"7A5#0{number}")
            stamps.append(other.wait(f"7A5#0{number}")[1])
            time.sleep(0.04)  # far more than the difference allowed below
    run.process.send_signal(signal.SIGCONT)
    until("the last frame in the log", lambda: any(text == "7A5#02" for _, text, _ in run.frames()))
    logged = [at for at, text, _ in run.frames() if text.startswith("7A5#")]
    for first, second in ((0, 1), (1, 2)):
        apart = logged[second] - logged[first]
        assert abs(apart - (stamps[second] - stamps[first])) < 0.001, f"{apart} s apart in the log, not {stamps}"


def dumped():
    """Returns (seconds, ID#DATA) of each complete line in the log of candump."""
    with open(DUMP) as dump:
        lines = [line.split() for line in dump.read().split("\n")[:-1]]
    return [(float(line[0].strip("()")), line[2]) for line in lines]


def log_is_candumps(run):
    """Compares the frames that the log has now with those of candump. Heartbeats continue, so candump may soon have more.

    candump writes the frames of one socket as the kernel delivers them. Each device has a socket of its own, and the log is in
    the order of the kernel's time stamps. With two processors, the kernel may deliver two frames in another order than that of
    their stamps. Both sides are compared in the order of the stamps."""
    ours = [(at, text) for at, text, _ in run.frames()]
    until("candump has as many frames", lambda: len(dumped()) >= len(ours))
    theirs = sorted(dumped(), key=lambda frame: frame[0])[:len(ours)]
    for number, (mine, other) in enumerate(zip(ours, theirs)):
        assert mine[1] == other[1], f"frame {number}: the log has {ours[number:number + 3]}, candump {theirs[number:number + 3]}"
    offsets = [mine - other for (mine, _), (other, _) in zip(ours, theirs)]
    assert max(offsets) - min(offsets) < 0.001, f"stamps differ by {max(offsets) - min(offsets)} s"


def log_replays(program, run):
    frames = run.frames()
    end = str(frames[-1][0])
    replays = {node: subprocess.Popen([program, "replay", name, "--node", str(node), "--until", end, run.log],
                                      stdout=subprocess.PIPE, text=True) for node, name in FOUR.items()}
    for node, replay in replays.items():
        again = [line.split()[2] for line in replay.communicate()[0].splitlines()]
        own = [text for _, text, who in frames if who == "T" and int(text[:3], 16) & 0x7F == node]
        assert own == again, f"node {node}: {len(own)} frames in the run, {len(again)} in its replay"
        assert len(own) > 2, f"node {node}: {own}"


def check_short(kind, program):
    """Runs a short check with a build with sanitizers. For a defect, a sanitizer prints an error and changes the exit status."""
    with Ear("vcan0") as ear, Run(program, *NAMES, "--bus", "socketcan:vcan0") as run:
        with check(f"{kind}four devices of one process boot up and answer"):
            boot_up(ear, FOUR)
            ask_with_cansend(ear)
        with check(f"{kind}SIGTERM ends the run without a further notice"):
            said = run.stop()
            assert said == "", said


def check_all(program, devices=NAMES):
    dump = subprocess.Popen(["candump", "-L", "vcan0"], stdout=open(DUMP, "wb"))
    with Ear("vcan0") as ear:
        until("candump listens", lambda: "vcan0" in open("/proc/net/can/rcvlist_all").read())
        with Run(program, *devices, "--bus", "socketcan:vcan0") as run:
            with check("four devices of one process boot up"):
                boot_up(ear, FOUR)
            with check("cansend reads the type of each device, and guards and starts one of them"):
                ask_with_cansend(ear)
            with check("python-can reads and writes objects and receives a heartbeat every 10 ms"):
                ask_with_python_can()
            with check("frames in the log have the receive times of the kernel"):
                stamps_are_the_kernels(ear, run)
            with check("the log has the frames of candump, in the order of their stamps and with the same intervals"):
                log_is_candumps(run)
            with check("SIGTERM ends the run without a further notice"):
                said = run.stop()
                assert said == "", said
            with check("a replay of the log gives the frames that each device sent"):
                log_replays(program, run)
    dump.terminate()
    dump.wait()
