# SPDX-License-Identifier: Apache-2.0
"""Reads the bytes of an image for the microcontroller by symbol, as the linker put them into flash."""
import struct
import subprocess

LOADED = 1  # PT_LOAD


class Image:
    """An image. `flash` has (address, bytes) of each segment; `symbols` has (address, size) by C++ name."""

    def __init__(self, file):
        whole = file.read_bytes()
        if whole[:6] != b"\x7fELF\x01\x01":
            raise ValueError(f"{file} is no ELF file of 32 bits, least significant byte first")
        at, step, count = struct.unpack_from("<I", whole, 28)[0], *struct.unpack_from("<HH", whole, 42)
        self.flash = []
        for header in range(at, at + step * count, step):
            kind, offset, _, address, size = struct.unpack_from("<IIIII", whole, header)
            if kind == LOADED and size:
                self.flash.append((address, bytearray(whole[offset:offset + size])))
        names = subprocess.run(["arm-none-eabi-nm", "-S", "-C", file], text=True, check=True, capture_output=True).stdout
        fields = (line.split(maxsplit=3) for line in names.splitlines())
        self.symbols = {one[3]: (int(one[0], 16), int(one[1], 16)) for one in fields if len(one) == 4}

    def _place(self, address, size):
        for start, content in self.flash:
            if start <= address and address + size <= start + len(content):
                return content, address - start
        raise ValueError(f"nothing is loaded at {address:08X}h")

    def read(self, address, size):
        content, at = self._place(address, size)
        return bytes(content[at:at + size])

    def flip(self, address, mask):
        """Inverts the bits of `mask` in one byte."""
        content, at = self._place(address, 1)
        content[at] ^= mask
