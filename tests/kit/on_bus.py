#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""on_bus.py PROGRAM: runs the device RC-22 with PROGRAM, the canproof of the outside project, on a bus in real time. Sends frames to the
device as a client of socketcand. Then opens the panel, which must have a card for the device. The kernel chooses the ports. The frames are
written by hand after sections 1, 3 and 5 of tests/kit/datasheet.txt."""
import json
import re
import signal
import socket
import subprocess
import sys
import tempfile
import urllib.request

PATIENCE = 60  # seconds; reached only by a broken program
CONVERSATION = (  # a frame to the device, and its answer: None where the data sheet names no answer
    ("601", "4000100000000000", ("581", "4300100000000000")),  # 1000h: 0
    ("601", "2F00200101000000", ("581", "6000200100000000")),  # relay 1 closes ...
    ("000", "0101", None),                                     # ... in operational
    ("601", "4000200100000000", ("581", "4F00200101000000")),
    ("000", "0201", None),                                     # stopped: both contacts are open
)


class Client:
    def __init__(self, port):
        self.socket = socket.create_connection(("127.0.0.1", port), timeout=PATIENCE)
        self.text = ""
        self.wait_for(r"< hi >")
        self.ask("< open can0 >", r"< ok >")
        self.ask("< rawmode >", r"< ok >")

    def wait_for(self, pattern):
        while not (found := re.search(pattern, self.text)):
            piece = self.socket.recv(4096)
            assert piece, f"the server ended; it did not say {pattern}: {self.text}"
            self.text += piece.decode()
        self.text = self.text[found.end():]

    def ask(self, words, pattern):
        self.socket.sendall(words.encode())
        self.wait_for(pattern)

    def send(self, identifier, data):
        octets = re.findall("..", data)
        self.socket.sendall(f"< send {identifier} {len(octets)} {' '.join(octets)} >".encode())


def port_of(run):
    for line in run.stderr:
        if found := re.search(r"listens at port (\d+)", line):
            return int(found.group(1))
    raise AssertionError("the program ended before it named its port")


def show_on_panel(program):
    panel = subprocess.Popen([program, "panel", "relay-counter@1", "--port", "0"], stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True)
    try:
        address = re.search(r"http://\S+/", panel.stdout.readline()).group(0)
        with urllib.request.urlopen(f"{address}api/panel", timeout=PATIENCE) as answer:
            shown = json.load(answer)["devices"]
        names = [(one["name"], one["view"]["unit"], [lamp["signal"] for lamp in one["view"]["lamps"]]) for one in shown]
        assert names == [("relay-counter@1", "RC-22", ["lamp", "relay1", "relay2"])], names
        panel.send_signal(signal.SIGTERM)
        panel.wait(PATIENCE)
    finally:
        panel.kill()


def main():
    with tempfile.TemporaryDirectory() as folder:
        outputs = f"{folder}/outputs.csv"
        command = [sys.argv[1], "run", "relay-counter@1", "--bus", "socketcand:127.0.0.1:0", "--outputs", outputs]
        run = subprocess.Popen(command, stdin=subprocess.PIPE, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True)
        try:
            client = Client(port_of(run))
            for identifier, data, answer in CONVERSATION:
                client.send(identifier, data)
                if answer:
                    client.wait_for(rf"< frame {answer[0]} [0-9.]+ {answer[1]} >")
            client.send("000", "8101")
            client.wait_for(r"< frame 701 [0-9.]+ 00 >")  # the boot-up message comes after the effects of all frames before it
            run.send_signal(signal.SIGINT)
            assert run.wait(PATIENCE) == 0, run.stderr.read()
        finally:
            run.kill()
        with open(outputs, encoding="utf-8") as changes:
            relay = [line.strip().split(",")[2] for line in changes if ",relay1," in line]
    assert relay[-2:] == ["1", "0"], f"relay 1 was {relay}"
    print("on a bus: asked, started, switched")
    show_on_panel(sys.argv[1])
    print("on the panel: its card")


main()
