#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""socketcand.py PROGRAM: starts a run of two devices with PROGRAM (canproof), whose bus is a socketcand server. Checks that python-can and
another `canproof run` can join this bus as clients.

The kernel chooses the port; the test reads it from the output of the program. Frames are written by hand, after
CBX-AO412 7.9.2 (device type 191h with 0008h) and CiA 301. python-can 4.1 treats every frame of this interface as an
extended frame. Therefore the test compares identifiers only.
"""
import collections
import re
import subprocess
import sys
import threading

import can

PATIENCE = 120  # seconds; reached only by a broken program


def frame(identifier, data):
    return can.Message(arbitration_id=identifier, data=bytes.fromhex(data), is_extended_id=False)


def wait_for(bus, identifier, data):
    """Checks that the next frame with this identifier has this data."""
    while True:
        got = bus.recv(PATIENCE)
        assert got is not None, f"nothing came where {identifier:03X}#{data} was due"
        if got.arbitration_id == identifier:
            assert got.data.hex().upper() == data, f"{identifier:03X}#{got.data.hex().upper()}, not {data}"
            return got


def converse(port):
    one = can.Bus(interface="socketcand", channel="can0", host="127.0.0.1", port=port)
    two = can.Bus(interface="socketcand", channel="can0", host="127.0.0.1", port=port)
    one.send(frame(0x603, "4000100000000000"))
    wait_for(one, 0x583, "4300100091010800")
    wait_for(two, 0x603, "4000100000000000")  # another client receives the request
    wait_for(two, 0x583, "4300100091010800")  # and the answer
    two.send(frame(0x603, "2B1710000A000000"))  # heartbeat every 10 ms
    wait_for(two, 0x583, "6017100000000000")
    two.send(frame(0x000, "0103"))
    wait_for(one, 0x000, "0103")
    first = wait_for(one, 0x703, "05")
    second = wait_for(one, 0x703, "05")
    period = second.timestamp - first.timestamp
    assert abs(period - 0.010) < 0.0015, f"heartbeat after {period} s"
    two.send(frame(0x606, "4000100000000000"))  # device type of the node in the other CANopen program: AX060805, 4.2.1
    wait_for(two, 0x586, "430010009A010310")
    two.send(frame(0x605, "4000100100000000"))  # 1000h has no sub-index 1
    wait_for(two, 0x585, "8000100111000906")
    one.shutdown()
    two.shutdown()


def wait_for_boot_up(run, nodes):
    """Returns when all nodes have sent their boot-up messages. python-can expects that each
    received piece of data is one answer. It would refuse the server if a frame came together with the answer to `open`."""
    missing = {f"70{node}#00" for node in nodes}
    while missing:
        line = run.stdout.readline()
        assert line, f"the program ended without {missing}"
        missing.discard(line.split()[2])
    threading.Thread(target=collections.deque, args=(run.stdout, 0), daemon=True).start()  # further text is read and dropped


def main():
    command = [sys.argv[1], "run", "cbx-ao412@3", "ax188001@5", "--bus", "socketcand:127.0.0.1:0", "--seconds", "600"]
    run = subprocess.Popen(command, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
    programs = [run]
    try:
        port = None
        while not port:  # other lines, such as the device names, come before the port
            said = run.stderr.readline()
            assert said, "the program ended before it named its port"
            port = re.search(r"listens at port (\d+)", said)
        port = int(port.group(1))
        command = [sys.argv[1], "run", "ax060805@6", "--bus", f"socketcand-client:127.0.0.1:{port}/can0", "--seconds", "600"]
        programs.append(subprocess.Popen(command, stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL))
        wait_for_boot_up(run, [3, 5, 6])
        converse(port)
    finally:
        for program in reversed(programs):
            program.terminate()
    assert [program.wait(PATIENCE) for program in programs] == [0, 0], "a program did not end as it should"
    print("python-can: joined, asked, heard")


main()
