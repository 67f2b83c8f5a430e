# SPDX-License-Identifier: Apache-2.0
"""Checks the LSS session of the manuals on interfaces that have a bit rate: two emulated SJA1000 controllers on one bus.

The session is that of frames 95 to 102 of the screen shot in AX188001 3.1.1.2 (node 80, from 125 to 250 kbit/s). Only the switch delay is
100 ms (bytes 6400) instead of 5 s (bytes 8813). AX130751 3.1.1 and AX060805 4.1.1 show the same session.
"""
import re

from bench import Ear, Run, check, sh, until


def set_rate(interface, rate):
    sh("ip", "link", "set", interface, "down")
    sh("ip", "link", "set", interface, "type", "can", "bitrate", str(rate))
    sh("ip", "link", "set", interface, "up")


def rate_of(interface):
    return int(re.search(r"bitrate (\d+)", sh("ip", "-d", "link", "show", interface)).group(1))


def ask_for_250(ear):
    ear.wait("750#00")
    ear.send("7E5#0401")
    ear.ask("7E5#130003", "7E4#130000.*")
    ear.send("7E5#156400")


def both_at_125():
    set_rate("can0", 125000)
    set_rate("can1", 125000)


def granted(program, device):
    both_at_125()
    with Run(program, f"{device}@80", "--bus", "socketcan:can0", "--control-interface") as run:
        with Ear("can1") as ear:
            ask_for_250(ear)
            run.wait_notice(f"{device}@80: LSS sets 250000 bit/s; can0 has this bit rate now")
        assert rate_of("can0") == 250000, rate_of("can0")
        set_rate("can1", 250000)
        with Ear("can1") as ear:
            until("the second switch delay is over", lambda: stored(ear))
            ear.ask("7E5#0400", "750#00")
        run.stop()


def stored(ear):
    """Sends the LSS request `store` (7E5#17). Returns whether the node confirms it; during its switch delay, a node does not answer."""
    ear.send("7E5#17")
    return "7E4#170000" in [text[:10] for text in ear.rest(0.05)]


def not_granted(program):
    both_at_125()
    with Run(program, "ax188001@80", "--bus", "socketcan:can0") as run, Ear("can1") as ear:
        ask_for_250(ear)
        said = run.wait_notice("LSS sets 250000 bit/s; can0 is unchanged without --control-interface")
        assert rate_of("can0") == 125000
        commands = said.partition("the commands for this are: ")[2]
        sh("sh", "-c", commands)
        assert rate_of("can0") == 250000, f"{commands} gave {rate_of('can0')}"


def without_the_right(program):
    both_at_125()
    with Run(program, "ax188001@80", "--bus", "socketcan:can0", "--control-interface",
             prefix=["setpriv", "--reuid", "65534", "--clear-groups"]) as run, Ear("can1") as ear:
        ask_for_250(ear)
        run.wait_notice("LSS sets 250000 bit/s; can0 could not be switched off; this needs CAP_NET_ADMIN")
        assert rate_of("can0") == 125000


def check_granted(kind, program):
    with check(f"{kind}LSS session of ax188001 changes can0 from 125 to 250 kbit/s"):
        granted(program, "ax188001")


def check_refused(program):
    with check("without --control-interface, can0 keeps its bit rate, and the commands of the notice change it"):
        not_granted(program)
    with check("without the right to change can0, the notice says so, and can0 keeps its bit rate"):
        without_the_right(program)
