# SPDX-License-Identifier: Apache-2.0
"""The instructions of an image for the microcontroller, and where each one passes control."""
import dataclasses
import re
import subprocess

CONDITIONS = "eq ne cs cc hs lo mi pl vs vc hi ls ge lt gt le".split()
BRANCHES = {f"b{one}" for one in CONDITIONS}
CALLS = {"bl", "blx", *(f"{call}{one}" for call in ("bl", "blx") for one in CONDITIONS)}
LABEL = re.compile(r"([0-9a-f]+) <(.+)>:$")
CODE = re.compile(r"\s*([0-9a-f]+):\t([^\t]+)(?:\t(.*))?$")
PLACE = re.compile(r"(/.*):(\d+)(?: \(discriminator \d+\))?$")


@dataclasses.dataclass
class Instruction:
    address: int
    name: str         # without the suffix of the width: `ldr` for `ldr.w`
    operands: str     # without objdump's comment
    place: tuple      # (source file, line), or None without debug information
    maybe: bool       # True in an IT block: the instruction may have no effect
    after: int = 0    # address of the next instruction; 0 if data follow

    @property
    def target(self):
        """Returns the address that a branch or call names, or None."""
        found = re.search(r"(?:^|, )([0-9a-f]+)(?: <|$)", self.operands)
        return int(found.group(1), 16) if found else None

    @property
    def kind(self):
        """Returns how the instruction passes control: next, branch, jump, call, return, indirect, table or stop."""
        base = self.name
        if base in BRANCHES or base in ("cbz", "cbnz"):
            return "branch"
        if base == "b":
            return "jump"
        if base in CALLS:
            return "call"
        if base in ("tbb", "tbh"):
            return "table"
        if re.fullmatch(r"bx(..)?", base):
            return "return" if self.operands == "lr" else "indirect"
        if base == "udf":
            return "stop"
        if re.search(r"\bpc\b", self.operands) and self._sets_pc():
            return self._jump_by_register()
        return "next"

    def _sets_pc(self):
        if self.name.startswith(("pop", "ldm")):
            return True
        return self.operands.startswith("pc,") and not self.name.startswith(("cmp", "str"))

    def _jump_by_register(self):
        if self.name.startswith(("pop", "ldm")) or self.operands.startswith("pc, [sp]"):
            return "return"
        if self.name.startswith("mov"):
            return "return" if self.operands == "pc, lr" else "indirect"
        return "table" if "lsl #2" in self.operands else "indirect"


def disassemble(image):
    """Returns two tables by address: the instructions, and the names of the functions that begin there."""
    text = subprocess.run(["arm-none-eabi-objdump", "-d", "-l", "--no-show-raw-insn", image], text=True, check=True, capture_output=True).stdout
    code, names, place, before, in_it = {}, {}, None, None, 0
    for line in text.splitlines():
        if found := CODE.match(line):
            name, operands = found.group(2).split(".")[0], re.sub(r"\s*[@;].*", "", found.group(3) or "")
            if found.group(2).startswith("."):
                before = None
                continue
            one = Instruction(int(found.group(1), 16), name, operands, place, in_it > 0)
            in_it = len(name) - 1 if re.fullmatch(r"it[te]{0,3}", name) else max(0, in_it - 1)
            code[one.address] = one
            if before is not None:
                before.after = one.address
            before = one
        elif found := LABEL.match(line):
            names.setdefault(int(found.group(1), 16), found.group(2))
            place = None
        elif found := PLACE.match(line):
            place = (found.group(1), int(found.group(2)))
    return code, names
