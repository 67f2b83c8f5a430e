# SPDX-License-Identifier: Apache-2.0
"""A script that conversation.py runs: python-can sends requests to the four devices and checks the answers."""
import can

FOUR = {3: "17000000", 4: "55000000", 5: "55000000", 6: "55000000"}  # 1018h:01 vendor-ID: esd 17h, Axiomatic 55h


def transfer(bus, node, data):
    bus.send(can.Message(arbitration_id=0x600 + node, data=bytes.fromhex(data), is_extended_id=False))
    while (got := bus.recv(60)) is not None:
        if got.arbitration_id == 0x580 + node:
            return got.data.hex().upper()
    raise AssertionError(f"node {node} did not answer {data}")


def converse(bus):
    for node, vendor in FOUR.items():
        got = transfer(bus, node, "4018100100000000")
        assert got == "43181001" + vendor, f"node {node}: {got}"
    assert transfer(bus, 3, "2B1710000A000000") == "6017100000000000"  # 1017h producer heartbeat time: 10 ms
    beats = []
    while len(beats) < 41:
        got = bus.recv(60)
        assert got is not None, "no heartbeat"
        if got.arbitration_id == 0x703:
            assert got.data.hex() == "05", got
            beats.append(got.timestamp)
    assert transfer(bus, 3, "2B17100000000000") == "6017100000000000"
    # Each heartbeat has its own due time, so delays do not add up. But a busy machine may delay the first or the last heartbeat.
    mean = (beats[-1] - beats[0]) / 40
    assert 0.0075 < mean < 0.0125, f"heartbeat every {mean * 1000:.2f} ms, not every 10 ms"


with can.Bus(interface="socketcan", channel="vcan0") as interface:
    converse(interface)
