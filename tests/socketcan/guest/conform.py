# SPDX-License-Identifier: Apache-2.0
"""Runs `canproof conform` on the four devices on interfaces of the kernel. The verdicts must be those in virtual time.

Three devices have a virtual interface each. The fourth is on an emulated SJA1000 controller with 125 kbit/s, and the program that tests it
on a second controller of the same bus. This test sends no remote frames: after a remote frame with a length above 0, QEMU's SJA1000 loses
its place in the receive buffer (it stores the length, and releases 3 bytes). All four devices are tested at the same time, because each
test waits most of its time."""
import json
import subprocess

from bench import Ear, check, sh
from conversation import words_of

# device, node-ID, interface of the device, interface of the test
SLAVES = [("ax188001", 5, "vcan0", "vcan0"), ("cbx-ao412", 3, "vcan1", "vcan1"), ("ax060805", 6, "vcan2", "vcan2"),
          ("ax130751", 7, "can0", "can1")]
# The devices that are tested as ARM code. With more, an emulator inside the emulated guest misses the times of some cases.
ARM = {"cbx-ao412", "ax188001"}
ALLOWED = ["--allow-outputs", "--allow-store", "--allow-lss"]
SECONDS = 1100  # limit for one run, for a slow machine
# The only reasons why the verdict of a case in real time may differ from its verdict in virtual time.
ONLY_VIRTUAL = {"in this run, nobody can switch the slave off and on (on a bus, --by-hand lets you do it)", "in this run, no program can switch the slave off to the millisecond"}


def frames_of(interface):
    """Returns `--no-remote-frames` for an emulated controller (can…), else no option."""
    return ["--no-remote-frames"] if interface.startswith("can") else []


def verdicts(report):
    return {case["id"]: (case["verdict"], case["why"], case["step"]) for case in json.loads(report)["cases"]}


def in_virtual_time(program, device, interface):
    done = subprocess.run([program, "conform", device, "--json", *frames_of(interface)], capture_output=True, text=True)
    assert done.returncode == 0, f"{device} in virtual time: {done.stderr[-2000:]}"
    return verdicts(done.stdout)


def run_slave(program, device, node, interface, images):
    words = words_of(device, node, images if device in ARM else None)
    with open(f"/tmp/{device}.said", "w") as said, Ear(interface) as ear:
        slave = subprocess.Popen([program, "run", *words, "--bus", f"socketcan:{interface}"], stdin=subprocess.DEVNULL,
                                 stdout=subprocess.DEVNULL, stderr=said)
        if not interface.startswith("can"):  # a controller does not receive its own frames, so the ear would wait in vain
            ear.wait(f"70{node}#00")
        return slave


def begin(program, device, node, interface):
    with open(f"/tmp/{device}.eds", "w") as sheet:
        sheet.write(sh(program, "eds", device))
    with open(f"/tmp/{device}.json", "w") as report:
        return subprocess.Popen([program, "conform", "--eds", f"/tmp/{device}.eds", "--node", str(node), "--bus",
                                 f"socketcan:{interface}", *ALLOWED, *frames_of(interface), "--json"], stdout=report, stderr=subprocess.PIPE, text=True)


def compare(program, device, interface, process):
    _, said = process.communicate(timeout=SECONDS)
    with open(f"/tmp/{device}.json") as report:
        text = report.read()
    assert text, f"no report, status {process.returncode}: {said[-2000:]}"
    bus, virtual = verdicts(text), in_virtual_time(program, device, interface)
    count = {word: sum(verdict == word for verdict, _, _ in bus.values()) for word in ("passed", "skipped", "unstable")}
    print(f"{device}: {len(bus)} cases, {count}, {json.loads(text)['us'] / 1e6:.0f} s", flush=True)
    others = [f"{name}: {bus[name]}, in virtual time {virtual[name]}" for name in virtual
              if bus[name][0] != virtual[name][0] and bus[name][1] not in ONLY_VIRTUAL]
    assert not others and process.returncode == 0, "\n  ".join([f"status {process.returncode}", said[-500:], *others])


def check_all(program, images=None):
    """Tests the four slaves at the same time. `images` is the folder of the ARM images: the slaves in ARM then run as ARM code."""
    for name in ("vcan0", "vcan1", "vcan2"):
        sh("ip", "link", "add", "dev", name, "type", "vcan")
        sh("ip", "link", "set", name, "up")
    for name in ("can0", "can1"):
        sh("ip", "link", "set", name, "type", "can", "bitrate", "125000")
        sh("ip", "link", "set", name, "up")
    started = []
    try:
        started += [run_slave(program, device, node, own, images) for device, node, own, _ in SLAVES]
        tests = [begin(program, device, node, other) for device, node, _, other in SLAVES]
        started += tests
        for (device, _, own, other), test in zip(SLAVES, tests):
            with check(f"{device} on {own}: the verdicts of `canproof conform` through {other} are those of virtual time"):
                compare(program, device, other, test)
    finally:
        for one in started:
            one.kill()
