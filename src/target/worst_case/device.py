# SPDX-License-Identifier: Apache-2.0
"""The bounds of one device of a build: its image, its loops and its limits."""
import pathlib
import sys
import tomllib

from bounds import Bounds
from demangle import demangle
from graph import Unknown
from image import Image
from instructions import disassemble
from ipet import Flow
from measures import errors_of, measures
from program import Program
from virtual_calls import answers_of

HERE = pathlib.Path(__file__).resolve().parent
ENTRIES = {"power_on": "power_on", "frame": "receive", "tick": "advance", "command": "receive"}
KINDS = tuple(ENTRIES)
# A frame or command at the time of a deadline: the device first does what a tick does. Then nothing is due any more.
SUMS = {"due_frame": ("tick", "frame"), "due_command": ("tick", "command")}
# The kinds of work.json that a bound covers. A tick in the first millisecond after a power-on, and a tick after more frames than a bus
# carries, have the bound of each tick.
OBSERVED = {"tick": ("tick", "first_tick", "crowded_tick")}


def generated_of(build):
    """Returns the folder with the generated tables of the build for the host."""
    cache = (build / "CMakeCache.txt").read_text()
    host = next(line.split("=", 1)[1] for line in cache.splitlines() if line.startswith("CANPROOF_HOST_BUILD:"))
    return pathlib.Path(host) / "generated" / "generated"


def program_of(file, image, bounds, table):
    code, names = disassemble(file)
    symbols = [name for at, name in names.items() if at in code]
    demangled = demangle(symbols)
    address = {name: at for at, name in names.items()}

    def answers(caller):
        return sorted(address[one] for one in answers_of(table, demangled[names[caller]], demangled))

    return Program(image, code, names, demangled, bounds, answers)


class Analysis:
    """The program of a device's image with its bounds, and the linear program of each kind of work."""

    def __init__(self, build, device):
        generated = generated_of(build)
        own = sorted((device.folder / "target").glob("bounds*.toml"))
        files = [*own, HERE / "bounds.toml", HERE / "ways.toml", HERE / "frames.toml",
                 HERE / "dictionary.toml", HERE / "start.toml"]
        file = build / f"{device.word}.elf"
        image = Image(file)
        self.device = device
        found = measures(generated / device.word)
        self.bounds = Bounds(device.root, generated, files, {**found, **errors_of(image, found["producers"])})
        self.program = program_of(file, image, self.bounds, tomllib.loads((HERE.parent / "virtual_calls.toml").read_text()))

    def entry(self, work):
        """Returns the address of the function that begins a kind of work."""
        wanted = f"{self.device.word}::Device::{ENTRIES[work]}"
        found = [at for at, name in self.program.names.items() if name in self.program.demangled and self.program.name(at) == wanted]
        if len(found) != 1:
            sys.exit(f"{self.device.word}: {len(found)} functions {wanted}")
        return found[0]

    def limits(self, work):
        """Returns the limits of a kind of work: (limit, value of `at_most`, value of `each`)."""
        return list(self.bounds.limits_of(work))

    def ways(self, work):
        """Returns the names of the ways of a kind of work, of which each call takes one; [None] for a work without ways."""
        return [one["name"] for one in self.bounds.ways_of(work)] or [None]

    def flow(self, work, way=None):
        """Returns the linear program of a kind of work, or of one of its ways, with its limits; adds those that it needs to the used ones."""
        flow = Flow(self.program, self.entry(work))
        for other in self.bounds.ways_of(work) if way else []:
            if other["name"] != way:
                flow.limit(other, 0, 0)
        for limit, most, each in self.limits(work):
            if way in limit.get("way", [way]) and flow.limit(limit, most, each):
                self.bounds.used.add(id(limit))
        return flow

    def worst(self, work):
        """Returns (bound, way, solved Flow) of the way with the greatest bound."""
        flows = [(way, self.flow(work, way)) for way in self.ways(work)]
        if self.program.faults:
            raise Unknown("\n".join(dict.fromkeys(self.program.faults)))
        return max(((flow.solve(), way, flow) for way, flow in flows), key=lambda one: one[0])
