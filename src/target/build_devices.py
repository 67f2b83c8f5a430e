# SPDX-License-Identifier: Apache-2.0
"""The devices of a build, from the list that its configure step writes (src/devices/canproof_add_device.cmake)."""
import pathlib
import tomllib


class Device:
    """A device of a build: `name` (cbx-ao412), `word` (its C++ name, cbx_ao412), and `folder` (src/devices/cbx-ao412)
    below `root`."""

    def __init__(self, line):
        self.name, self.word, folder = line.split("\t")
        self.folder = pathlib.Path(folder)
        self.root = self.folder.parents[2]

    def budgets(self):
        """Returns target/budgets.toml: flash, ram, stack and host_stack in bytes, and tick, the constant with the period of a cycle."""
        return tomllib.loads((self.folder / "target" / "budgets.toml").read_text())


def devices_of(build):
    return [Device(line) for line in (build / "devices.txt").read_text().splitlines()]
