# SPDX-License-Identifier: Apache-2.0
"""Checks one bus across two machines. Each machine is a network namespace, and a pair of virtual Ethernet devices connects the two.

In the other network, a `canproof run` serves its bus by socketcand. A second `canproof run` and a plain socket join the bus from here."""
import ctypes
import os
import re
import signal
import socket

from bench import PATIENCE, Run, check, sh, until

CLONE_NEWNET = 0x40000000  # linux/sched.h
HERE, THERE = "192.0.2.1", "192.0.2.2"  # addresses for documentation, RFC 5737


class OtherNetwork:
    """A second network namespace with the address THERE. `prefix` are the words before a command that make it run in this namespace."""

    def __enter__(self):
        ready, tell = os.pipe()
        self.holder = os.fork()
        if self.holder == 0:
            assert ctypes.CDLL(None).unshare(CLONE_NEWNET) == 0
            os.write(tell, b"!")
            signal.pause()
        os.close(tell)
        with os.fdopen(ready, "rb") as pipe:
            assert pipe.read(1) == b"!", "no second network"
        self.prefix = ("nsenter", f"--net=/proc/{self.holder}/ns/net")
        sh("ip", "link", "add", "here", "type", "veth", "peer", "name", "there", "netns", str(self.holder))
        for prefix, name, address in ((), "here", HERE), (self.prefix, "there", THERE):
            sh(*prefix, "ip", "address", "add", f"{address}/24", "dev", name)
            sh(*prefix, "ip", "link", "set", name, "up")
        return self

    def __exit__(self, *_):
        sh("ip", "link", "del", "here")  # the other device of the pair goes with it
        os.kill(self.holder, signal.SIGKILL)
        os.waitpid(self.holder, 0)


class Client:
    """A client of socketcand in this network, which sends and receives the text of the protocol."""

    def __init__(self, port):
        self.text = b""
        self.socket = socket.create_connection((THERE, port), PATIENCE)
        self.wait(rb"< hi >")
        for command in b"< open can0 >", b"< rawmode >":
            self.socket.sendall(command)
            self.wait(rb"< ok >")

    def wait(self, pattern):
        while (found := re.search(pattern, self.text)) is None:
            piece = self.socket.recv(65536)
            assert piece, f"{pattern} did not come; got {self.text}"
            self.text += piece
        self.text = self.text[found.end():]

    def ask(self, identifier, request, answer_identifier, answer):
        data = " ".join(f"{byte:02X}" for byte in bytes.fromhex(request))
        self.socket.sendall(f"< send {identifier:X} 8 {data} >".encode())
        self.wait(rf"(?i)< frame 0*{answer_identifier:X} \S+ {answer} >".encode())


def converse(program, other):
    """Checks that the devices of both networks answer a client in this network. Device types: CBX-AO412 7.9.2, AX188001 3.2.1."""
    with Run(program, "cbx-ao412@3", "--bus", f"socketcand:{THERE}:0", prefix=other.prefix) as server:
        port = int(re.search(r"port (\d+)", server.wait_notice("listens at port"))[1])
        with Run(program, "ax188001@5", "--bus", f"socketcand-client:{THERE}:{port}/can0", name="joined") as joined:
            until("boot-up of node 5 at the server", lambda: any(text == "705#00" for _, text, _ in server.frames()))
            client = Client(port)
            client.ask(0x603, "4000100000000000", 0x583, "4300100091010800")
            client.ask(0x605, "4000100000000000", 0x585, "4300100094010200")
            client.socket.close()
            said = joined.stop()
            assert said == "", f"the joined program said {said!r}"
        server.stop()


def check_all(program):
    with check("two networks: socketcand connects their devices"), OtherNetwork() as other:
        converse(program, other)
