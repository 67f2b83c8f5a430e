# SPDX-License-Identifier: Apache-2.0
"""Checks the panel on SocketCAN: a frame that its page sends is on the bus, and a frame of the bus is in the log of the page."""
import json
import subprocess
import urllib.request

from bench import PATIENCE, Ear, check, until


def ask(url, path, body=None):
    data = None if body is None else json.dumps(body).encode()
    with urllib.request.urlopen(urllib.request.Request(url + path, data, {"Content-Type": "application/json"}), timeout=PATIENCE) as answer:
        return json.loads(answer.read() or b"null")


def converse(url, ear):
    ask(url, "api/frame", {"frame": "603#4000100000000000"})
    ear.wait("603#4000100000000000")
    ear.wait("583#4300100091010800")  # CBX-AO412 7.9.2
    ear.ask("603#4001100000000000", "583#4F01100000000000")
    until("the answer in the page's log",
          lambda: "4F01100000000000" in json.dumps(ask(url, "api/state?changes=0&frames=0")))


def check_panel(program):
    with check("frames sent by the page of the panel are on the bus, and frames of the bus are in its log"), Ear("vcan0") as ear:
        panel = subprocess.Popen([program, "panel", "cbx-ao412@3", "--bus", "socketcan:vcan0", "--port", "0"],
                                 stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True)
        try:
            ear.wait("703#00")
            converse(panel.stdout.readline().split()[2], ear)
            panel.terminate()
            assert panel.wait(PATIENCE) == 0
        finally:
            panel.kill()
