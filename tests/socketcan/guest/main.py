# SPDX-License-Identifier: Apache-2.0
"""Runs every check in order. tests/socketcan/run names the programs on the kernel command line. The builds with sanitizers are checked at
the same time in a network namespace of their own, which has other interfaces with the names vcan0, can0 and can1."""
import ctypes
import os
import re

import bench
import conform
import conversation
import flood
import interface
import lss
import panel
import readme
import two_networks
import warm_python

CLONE_NEWNET = 0x40000000  # linux/sched.h


def programs():
    with open("/proc/cmdline") as line:
        return {kind: f"/repo/{path}" for kind, path in re.findall(r"program\.(\w+)=(\S+)", line.read())}


def make_vcan():
    bench.sh("ip", "link", "add", "dev", "vcan0", "type", "vcan")
    bench.sh("ip", "link", "set", "vcan0", "up")


def check_program(program):
    readme.check_all(program)  # this check creates vcan0
    conversation.check_all(program)
    flood.check_all(program)
    interface.check_kernel(program)
    interface.check_faults("", program)
    lss.check_granted("", program)
    lss.check_refused(program)
    panel.check_panel(program)
    two_networks.check_all(program)


def check_sanitized(kind, program):
    prefix = f"{kind}: "
    conversation.check_short(prefix, program)
    interface.check_faults(prefix, program)
    lss.check_granted(prefix, program)


def take_interfaces():
    """Waits until the second pair of controllers, can2 and can3, is in this network namespace, and renames the two to can0 and can1."""
    for old, new in (("can2", "can0"), ("can3", "can1")):
        bench.until(f"{old} here", lambda old=old: f"{old}:" in bench.sh("ip", "link", "show"))
        bench.sh("ip", "link", "set", old, "name", new)


def sanitized_beside(kinds):
    """Starts the checks of the builds `kinds` in a second process. Returns the end of a pipe that delivers their verdicts, one byte
    each."""
    verdicts, told = os.pipe()
    child = os.fork()
    if child == 0:
        assert ctypes.CDLL(None).unshare(CLONE_NEWNET) == 0
        os.write(told, b"!")
        take_interfaces()
        make_vcan()
        for kind, program in kinds.items():
            check_sanitized(kind, program)
        os.write(told, bytes(bench.verdicts))
        os._exit(0)
    os.close(told)
    assert os.read(verdicts, 1) == b"!"  # the network namespace of the second process exists now
    for name in ("can2", "can3"):
        bench.sh("ip", "link", "set", name, "netns", str(child))
    return verdicts


def check_everything(kinds):
    program = kinds.pop("program")
    warm_python.start()
    others = sanitized_beside(kinds) if kinds else None
    check_program(program)
    if others is None:
        return
    with os.fdopen(others, "rb") as pipe:
        told = pipe.read()
    with bench.check("the builds with sanitizers were checked to the end"):
        assert told, "no verdicts from them"
    bench.verdicts += [bool(verdict) for verdict in told]


given = programs()
if "arm" in given:
    make_vcan()
    warm_python.start()
    conversation.check_all(given["arm"], conversation.with_images(given["images"]))
elif "conform" in given:
    conform.check_all(given["conform"], given.get("images"))
else:
    check_everything(given)
bench.finish()
