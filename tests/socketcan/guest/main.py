"""Every check, in order; `run` names the programs on the kernel's command line."""
import re

import bench
import conversation
import flood
import interface
import lss
import readme


def programs():
    with open("/proc/cmdline") as line:
        return {kind: f"/repo/{path}" for kind, path in re.findall(r"program\.(\w+)=(\S+)", line.read())}


def make_vcan():
    bench.sh("ip", "link", "add", "dev", "vcan0", "type", "vcan")
    bench.sh("ip", "link", "set", "vcan0", "up")


def check_release(program):
    readme.check_all()  # it makes vcan0
    conversation.check_all(program)
    flood.check_all(program)
    interface.check_kernel(program)
    interface.check_faults("", program)
    lss.check_granted("", program)
    lss.check_refused(program)


def check_sanitized(kind, program):
    prefix = f"{kind}: "
    conversation.check_short(prefix, program)
    interface.check_faults(prefix, program)
    lss.check_granted(prefix, program)


for kind, program in programs().items():
    if kind == "release":
        check_release(program)
    else:
        if kind == list(programs())[0]:
            make_vcan()
        check_sanitized(kind, program)
bench.finish()
