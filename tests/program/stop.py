#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""stop.py PROGRAM: checks that PROGRAM (canproof) obeys Ctrl-C and serves its other clients even when it is overloaded or has slow clients.
The time from the signal to the end is measured in processor time, so that the load of the machine does not matter.
"""
import collections
import os
import re
import signal
import socket
import subprocess
import sys
import threading

MOST_SECONDS = 0.5  # processor time from the signal to the end


def processor_seconds(pid):
    with open(f"/proc/{pid}/stat") as stat:
        fields = stat.read().rpartition(")")[2].split()
    return (int(fields[11]) + int(fields[12])) / os.sysconf("SC_CLK_TCK")


def end(process, by):
    """Ends the process by a signal. Returns its stderr from then on."""
    before = processor_seconds(process.pid)
    process.send_signal(by)
    said = process.stderr.read()
    _, status, used = os.wait4(process.pid, 0)
    assert os.waitstatus_to_exitcode(status) == 0, f"ended with {status}: {said}"
    took = used.ru_utime + used.ru_stime - before
    assert took < MOST_SECONDS, f"the end took {took} s of processor time"
    return said


def start(*words):
    return subprocess.Popen([sys.argv[1], *words], stdin=subprocess.PIPE, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)


def overload():
    """Checks that a run which is slower than its bus reports this delay and still obeys Ctrl-C. Twenty devices send a SYNC every
    microsecond: 1006h (communication cycle period) is 1, 1005h (COB-ID SYNC) has bit 30 set (producer)."""
    nodes = range(1, 21)
    run = start("run", "--plain", *(f"cbx-ao412@{node}" for node in nodes))
    threading.Thread(target=collections.deque, args=(run.stdout, 0), daemon=True).start()
    try:
        for node in nodes:
            run.stdin.write(f"6{node:02X}#2306100001000000\n6{node:02X}#2305100080000040\n")
        run.stdin.flush()
        said = ""
        while "behind the bus" not in said:  # this line follows the lines that name the devices
            said = run.stderr.readline()
            assert said, "the program ended without a word on its lag"
        said = end(run, signal.SIGINT)
        assert "was up to" in said, f"said at the end {said!r}"
    finally:
        run.kill()


def fetch(port, headers=""):
    """Returns the body of the answer to a request for the page of the panel."""
    with socket.create_connection(("127.0.0.1", port)) as client:
        client.sendall(f"GET / HTTP/1.1\r\nHost: localhost\r\n{headers}\r\n".encode())
        answer = b""
        while piece := client.recv(65536):
            answer += piece
    return answer.partition(b"\r\n\r\n")[2]


def slow_clients():
    """Checks that sixteen clients which send only half a request delay neither another client nor the end of the program."""
    panel = start("panel", "cbx-ao412@3", "--port", "0")
    slow = []
    try:
        port = int(re.search(r":(\d+)/", panel.stdout.readline()).group(1))
        for _ in range(16):
            slow.append(socket.create_connection(("127.0.0.1", port)))
            slow[-1].sendall(b"GET / HTTP/1.1\r\nHost: local")
        page = fetch(port)
        assert page.startswith(b"<!doctype html>"), page[:100]
        ranges = "Range: bytes=" + ",".join(["0-"] * 2600) + "\r\n"
        assert fetch(port, ranges) == page, "ranges change what comes"
        end(panel, signal.SIGTERM)
    finally:
        panel.kill()
        for client in slow:
            client.close()


overload()
slow_clients()
print("who is behind or slow keeps nobody waiting")
