# SPDX-License-Identifier: Apache-2.0
"""The figures of the object coverage of each device, and their exhibit (piece of evidence) in the evidence pack."""
import dataclasses

HEADING = ["device", "instructions", "instructions that ran", "conditional branches", "branches that went both ways", "branches that went one way",
           "branches that did not run", "functions", "functions without a run", "functions in no test image", "rows without a reason"]


@dataclasses.dataclass
class Figures:
    """The figures of one device."""
    device: str
    instructions: int = 0
    ran: int = 0
    branches: int = 0
    one_way: int = 0
    not_reached: int = 0  # branches
    functions: int = 0
    never: int = 0        # functions without a run
    in_no_image: int = 0  # functions that no test image contains; they have no run
    without_reason: int = 0

    def add(self, body, offsets, edges):
        """Adds a function: its instructions, the offsets of those that ran, and the edges (offset, following offset) that were taken."""
        self.functions += 1
        self.never += not offsets
        for one in body:
            offset = one.address - body[0].address
            self.instructions += one.name != "nop"
            self.ran += one.name != "nop" and offset in offsets
            if one.kind == "branch":
                ways = {(offset, one.target - body[0].address), (offset, one.after - body[0].address)}
                self.branches += 1
                self.not_reached += offset not in offsets
                self.one_way += offset in offsets and not ways <= edges

    @property
    def both_ways(self):
        return self.branches - self.one_way - self.not_reached

    def row(self):
        return [self.device, self.instructions, self.ran, self.branches, self.both_ways, self.one_way, self.not_reached, self.functions, self.never,
                self.in_no_image, self.without_reason]

    def words(self):
        return (f"{self.device:10} {self.ran} of {self.instructions} instructions reached ({100 * self.ran / self.instructions:.1f} %); "
                f"{self.both_ways} of {self.branches} conditional branches both ways, {self.one_way} one way, {self.not_reached} not reached; "
                f"{self.never} of {self.functions} functions without a run; {self.in_no_image} functions in no test image")


def says_of(figures, faults):
    """Returns the sentence of the exhibit."""
    if faults:
        return f"{sum(one.without_reason for one in figures)} instructions or branches of the object code did not run and have no reason; {len(faults)} open points."
    both, branches = sum(one.both_ways for one in figures), sum(one.branches for one in figures)
    ran, instructions = sum(one.ran for one in figures), sum(one.instructions for one in figures)
    return (f"{ran:,} of {instructions:,} instructions of the devices' object code ran in test images on QEMU, and {both:,} of {branches:,} conditional "
            "branches went both ways. Each other instruction and branch has a reason.")
