# SPDX-License-Identifier: Apache-2.0
"""Compares the cells of one image with those of the requirements register. A cell is one value in a generated table."""
import struct

from register import CONSTANT, NUMBERS, RIGHTS, Table, bytes_of

NO_LIMIT, NO_OBJECT = 0xFFFF, 0xFFFF
ENTRY, OBJECT, LIMITS = "<HHHBBBB", "<HHBB", "<BxxxIiBxxxIi"  # rows of firmware/canopen/object_types.hpp
ENTRY_CELLS = ("sub-index", "type", "length", "default", "minimum", "maximum", "allowed value", "zero allowed")
LIST = 3
ENDS = {0: None, 1: "value", 2: "entry", 4: "zero"}  # LimitKind


class Cells:
    """The cells of one image.

    `cells` has (name, address, bytes) of each cell, `differences` one line for each cell that differs. `absent` are the
    tables that are not in the image. `named` has each compared cell as (item, cell), named as in `canproof mutate`."""

    def __init__(self, word, part, image):
        self.word, self.image = word, image
        self.objects = part.objects
        self.cells, self.differences, self.absent, self.named, self.compared = [], [], [], set(), 0
        self._dictionary(part)
        for owner, content in ((word, part), ("canopen", part.shared)):
            for item in content.tables.values():
                self._table(owner, Table(content, item))

    def _symbol(self, name):
        return self.image.symbols[f"canproof::generated::{self.word}::{name}"]

    def _compare(self, name, address, size, found, expected):
        self.compared += 1
        self.cells.append((name, address, size))
        if found != expected:
            self.differences.append(f"{name}: {expected!r} in spec/, {found!r} in the image")

    def _rows(self, name, form):
        """Returns (address, members) of each row of a table."""
        address, size = self._symbol(name)
        step = struct.calcsize(form)
        return [(at, struct.unpack(form, self.image.read(at, step))) for at in range(address, address + size, step)]

    def _dictionary(self, part):
        objects, entries = self._rows("object_rows", OBJECT), self._rows("entry_rows", ENTRY)
        self.limits, self.allowed = self._rows("limit_rows", LIMITS), self._rows("allowed_values", "<I")
        self.pools = {name: self._symbol(name) for name in ("default_image", "constant_pool")}
        if len(objects) != len(part.objects) or len(entries) != sum(len(one["entries"]) for one in part.objects):
            self.differences.append(f"{len(objects)} objects with {len(entries)} entries in the image: not those of spec/")
            return
        slots, next_entry = self._slots(objects), 0
        for at, (expected, (address, (index, first, count, kind))) in enumerate(zip(part.objects, objects)):
            name = f"{expected['index']:04X}h"
            self._compare(f"{name} index", address, 2, index, expected["index"])
            self._compare(f"{name} first entry", address + 2, 2, first, next_entry)
            self._compare(f"{name} entries", address + 4, 1, count, len(expected["entries"]))
            self._compare(f"{name} kind", address + 5, 1, kind, expected["kind"])
            if at not in slots:
                self.differences.append(f"{name} is not found by its slot")
            item = f"{part.prefix}-OD-{expected['index']:04X}"
            self.named.add((item, "index"))
            for entry in expected["entries"]:
                self._entry(f"{name}:{entry['sub']}", entry, *entries[next_entry])
                self.named |= {(item, f"sub {entry['sub']} {word}") for word in (*RIGHTS, *ENTRY_CELLS)}
                next_entry += 1

    def _slots(self, objects):
        """Returns the positions of the objects that a search by index finds (ObjectDictionary::lookup)."""
        slots = self._rows("object_slots", "<H")
        tables, _ = self._symbol("tables")
        words = struct.unpack("<17I", self.image.read(tables, 68))
        factor, count = words[15], len(slots)
        self._compare("count of slots", tables + 56, 4, words[14], count)
        self.cells.append(("slot factor", tables + 60, 4))
        others = sum(entry["size"] for one in self.objects for entry in one["entries"]
                     if not entry["setting"] and not entry["rights"] & CONSTANT)
        self._compare("offset of the settings", tables + 64, 4, words[16], -(-others // 4) * 4)
        taken = set()
        for at, (_, (index, *_)) in enumerate(objects):
            slot = ((index * factor & 0xFFFFFFFF) >> 16) & (count - 1)
            while slots[slot][1][0] not in (at, NO_OBJECT):
                slot = (slot + 1) % count
            taken |= {at} if slots[slot][1][0] == at else set()
        for number, (address, (position,)) in enumerate(slots):
            self.cells.append((f"slot {number}", address, 2))
            if position != NO_OBJECT and position >= len(objects):
                self.differences.append(f"slot {number} names object {position}, which is not there")
        if sum(one[1][0] != NO_OBJECT for one in slots) != len(objects):
            self.differences.append("slots name an object twice, or not at all")
        return taken

    def _entry(self, name, expected, address, row):
        offset, size, limit, sub, kind, rights, service = row
        for word, at, bytes_, found, wanted in (("length", 2, 2, size, expected["size"]), ("sub-index", 6, 1, sub, expected["sub"]),
                                                ("type", 7, 1, kind, expected["type"]), ("rights", 8, 1, rights, expected["rights"]),
                                                ("service", 9, 1, service, expected["service"])):
            self._compare(f"{name} {word}", address + at, bytes_, found, wanted)
        pool, length = self.pools["constant_pool" if expected["rights"] & CONSTANT else "default_image"]
        if expected["size"]:
            inside = offset + expected["size"] <= length
            found = self.image.read(pool + offset, expected["size"]) if inside else None
            self._compare(f"{name} default", pool + offset if inside else address, expected["size"] if inside else 2, found,
                          expected["default"])
        self.cells.append((f"{name} limit", address + 4, 2))
        self._limit(name, limit, expected["limits"])

    def _limit(self, name, limit, expected):
        if limit >= len(self.limits) or expected is None:
            found = None if limit == NO_LIMIT else f"row {limit}"
            self._compare_limit(f"{name} limits", found, expected)
            return
        address, (low, low_bits, low_add, high, high_bits, high_add) = self.limits[limit]
        if low == LIST:
            first, count = low_bits >> 16, low_bits & 0xFFFF
            values = [value for _, (value,) in self.allowed[first:first + count]]
            self._compare(f"{name} allowed values", address, 12, ("list", values), expected)
            self.cells += [(f"{name} allowed value", place, 4) for place, _ in self.allowed[first:first + count]]
            return
        ends = []
        for kind, bits, add in ((low, low_bits, low_add), (high, high_bits, high_add)):
            word = ENDS.get(kind, kind)
            ends.append(None if word is None else (word, bits, add) if word == "entry" else (word, bits))
        for which, at, found, wanted in (("minimum", 0, ends[0], expected[1]), ("maximum", 12, ends[1], expected[2])):
            if expected[0] != "ends":
                wanted = expected
            self._compare(f"{name} {which}", address + at, 1, found, wanted)
            if found is not None:
                self.cells.append((f"{name} {which}", address + at + 4, 8 if found[0] == "entry" else 4))

    def _compare_limit(self, name, found, expected):
        self.compared += 1
        if found != expected:
            self.differences.append(f"{name}: {expected!r} in spec/, {found!r} in the image")

    def _table(self, owner, table):
        symbol = f"canproof::generated::{owner}::{table.namespace()}::rows"
        if symbol not in self.image.symbols:
            self.absent.append(table.item["id"])
            return
        address, size = self.image.symbols[symbol]
        fields, rows = list(table.fields()), list(table.rows())
        places, step, widest = [], 0, 1
        for _, kind, _ in fields:
            width = NUMBERS[kind][1]
            step = -(-step // width) * width
            places.append((step, width))
            step, widest = step + width, max(widest, width)
        step = -(-step // widest) * widest
        if step * len(rows) != size:
            self.differences.append(f"{table.item['id']}: {len(rows)} rows of {step} bytes in spec/, {size} bytes in the image")
            return
        for first, last in table.groups():
            # Several rows in memory can come from one row of the requirements register. At most one of them matches any input, so
            # their order does not matter.
            found = sorted((self.image.read(address + at * step, step), address + at * step) for at in range(first, last))
            groups = sorted(self._row_bytes(row, fields, places, step) for row in rows[first:last])
            for (content, place), expected in zip(found, groups):
                for (name, _, _), (at, width) in zip(fields, places):
                    cell = f"row {(place - address) // step + 1} {name}"
                    self._compare(f"{table.item['id']} {cell}", place + at, width, content[at:at + width], expected[at:at + width])
                    self.named.add((table.item["id"], cell))

    @staticmethod
    def _row_bytes(row, fields, places, step):
        content = bytearray(step)
        for (_, kind, words), (at, width), value in zip(fields, places, row):
            content[at:at + width] = bytes_of(words[value] if words is not None else value, kind, width)
        return bytes(content)
