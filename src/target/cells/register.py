# SPDX-License-Identifier: Apache-2.0
"""The requirements register as src/target/cells reads it: objects and decision tables of spec/, as spec/README.md
describes them.
This code shares nothing with speccompiler, which generates the tables."""
import itertools
import math
import pathlib
import struct
import tomllib

NUMBERS = {"BOOLEAN": (0x01, 1), "INTEGER8": (0x02, 1), "INTEGER16": (0x03, 2), "INTEGER32": (0x04, 4), "UNSIGNED8": (0x05, 1),
           "UNSIGNED16": (0x06, 2), "UNSIGNED32": (0x07, 4), "REAL32": (0x08, 4), "REAL64": (0x11, 8), "INTEGER64": (0x15, 8),
           "UNSIGNED64": (0x1B, 8)}  # the number of a type in CiA 301, and its size in bytes
TEXTS = {"VISIBLE_STRING": 0x09, "OCTET_STRING": 0x0A, "DOMAIN": 0x0F}
TYPES = {name: number for name, (number, _) in NUMBERS.items()} | TEXTS
VAR, ARRAY, RECORD = 7, 8, 9  # object codes of CiA 301
READ, WRITE, RPDO, TPDO, STORED, NODE_ID, CONSTANT = (1 << bit for bit in range(7))
RIGHTS = ("readable", "writable", "RPDO mapping", "TPDO mapping", "stored", "node-ID added")
SERVICES = ["none", "sync", "emcy", "heartbeat", "guarding", "pdo", "store", "nmt", "error_behaviour", "program", "lss", "device"]
# firmware/canopen/error_table.hpp: the errors that every node has; those of a device follow them.
NODE_ERRORS = {"can_overrun": 0, "error_passive": 1, "guard_or_heartbeat": 2, "bus_off_recovered": 3, "sync_length": 4,
               "stored_set_checksum": 5, "internal_software": 6, "rpdo_length": 7, "rpdo_timeout": 8, "life_guarding": 9,
               "heartbeat": 10, "rpdo_value": 14}
FIRST_OF_DEVICE = 15


def bytes_of(value, kind, size):
    """Returns a value as it lies in memory, least significant byte first."""
    if isinstance(value, str):
        return value.encode().ljust(size, b"\0")
    if kind in ("REAL32", "REAL64"):
        return struct.pack("<f" if kind == "REAL32" else "<d", value)
    return (int(value) & ((1 << (8 * size)) - 1)).to_bytes(size, "little")


class Part:
    """One folder of the requirements register: canopen, or a device."""

    def __init__(self, folder, shared=None):
        self.shared, self.tables, self.enumerations, self.objects = shared, {}, {}, []
        self.prefix, found = "CO", []
        for file in sorted(pathlib.Path(folder).rglob("*.toml")):
            content = tomllib.loads(file.read_text())
            self.prefix = content.get("prefix", self.prefix)
            self.tables |= {one["id"]: one for one in content.get("table", [])}
            self.enumerations |= {one["id"]: one["values"] for one in content.get("enumeration", [])}
            found += content.get("object", [])
        for one in found:
            self.objects += self._members(one)
        self.objects.sort(key=lambda one: one["index"])

    def table(self, key):
        return self.tables.get(key) or self.shared.tables[key]

    def enumeration(self, key):
        """Returns {word: number} of an enumeration."""
        values = self.enumerations.get(key)
        if values is None:
            values = self.shared.enumerations[key]
        return values if isinstance(values, dict) else {word: number for number, word in enumerate(values)}

    def errors(self):
        """Returns the number of each error: first those of every node, then the device's in the order in which its
        tables name them."""
        own = []
        for table in self.tables.values():
            for at, column in enumerate(table["inputs"]):
                if table.get("errors") and Table.name(column) == table["errors"]:
                    own += [word for row in table["rows"] for word in Table.parts(row[at]) if word not in NODE_ERRORS]
        return NODE_ERRORS | {word: FIRST_OF_DEVICE + at for at, word in enumerate(dict.fromkeys(own))}

    def _members(self, item):
        """Yields the objects that one [[object]] stands for; a family has several."""
        family = item.get("repeat", {"first": 0, "last": 0, "step": 0})
        base = 16 if family.get("decimal") else 10  # with `decimal`, the decimal digits of the number are read as hexadecimal ones
        for n in range(family["first"], family["last"] + 1):
            entries = [self._entry(one, one["sub"], self._default(one, n)) for one in item.get("entry", [])]
            usual = RECORD
            if "array" in item:
                usual, values, ranges = ARRAY, self._default(item, n), item.get("range")
                for at in range(item["array"]):
                    one = dict(item, range=ranges[at]) if isinstance(ranges, list) else item
                    entries.append(self._entry(one, at + 1, values[at] if isinstance(values, list) else values))
            elif "type" in item:
                usual, entries = VAR, [self._entry(item, 0, self._default(item, n))]
            if usual != VAR and all(one["sub"] != 0 for one in entries):
                highest = {"type": "UNSIGNED8", "access": "const"}
                entries.append(self._entry(highest, 0, max(one["sub"] for one in entries)))
            yield {"index": item["index"] + (int(str(n), base) - int(str(family["first"]), base)) * family["step"],
                   "kind": {"array": ARRAY, "record": RECORD}.get(item.get("kind"), usual),
                   "entries": sorted(entries, key=lambda one: one["sub"])}

    @staticmethod
    def _default(item, n):
        default = item.get("default")
        return default[str(n)] if isinstance(default, dict) else default

    def _entry(self, item, sub, default):
        kind, access, mapping = item["type"], item["access"], item.get("mapping", "none")
        service, node_id = item.get("service", "none"), isinstance(default, str) and default.startswith("$NODEID+")
        if node_id:
            default = int(default.removeprefix("$NODEID+"), 0)
        own = not item.get("factory", False) and not node_id and mapping == "none"
        constant = own and (access == "const" or (access == "ro" and not item.get("live", False) and service == "none"))
        granted = [(READ, access != "wo"), (WRITE, access in ("rw", "wo")), (RPDO, mapping in ("rpdo", "both")),
                   (TPDO, mapping in ("tpdo", "both")), (STORED, item.get("stored", access == "rw")), (NODE_ID, node_id),
                   (CONSTANT, constant)]
        size = NUMBERS[kind][1] if kind in NUMBERS else item.get("length", len(default or ""))
        given = item.get("stored", access == "rw") or item.get("factory", False)
        setting = given and not item.get("live", False) and mapping == "none" and not constant
        return {"sub": sub, "type": TYPES[kind], "size": size, "setting": setting, "rights": sum(bit for bit, given in granted if given),
                "service": SERVICES.index(service), "default": bytes_of(default or 0 if kind in NUMBERS else default or "", kind, size),
                "limits": self._limits(item.get("range"), kind)}

    def _limits(self, allowed, kind):
        """Returns None, ("list", values) or ("ends", lowest, highest). An end is None (no limit) or ("value", bits). It is
        ("zero", bits) when 0 is allowed below it too, and ("entry", place, number to add) when it is the value of another entry."""
        if not allowed:
            return None
        if "table" in allowed:
            numbers = sorted(self._first_column(self.table(allowed["table"])))
            whole = numbers[-1] - numbers[0] + 1 == len(numbers)
            allowed = {"min": numbers[0], "max": numbers[-1]} if whole else {"values": numbers}
        bits = lambda value: int.from_bytes(bytes_of(value, kind, NUMBERS[kind][1]), "little")
        if "values" in allowed:
            return ("list", [bits(value) for value in allowed["values"]])

        def end(key, word):
            limit = allowed.get(key)
            if isinstance(limit, (str, dict)):
                place = limit if isinstance(limit, str) else limit["object"]
                index, _, sub = place.partition(":")
                return ("entry", int(index, 16) << 8 | (int(sub, 16) if sub else 0xFF), 0 if isinstance(limit, str) else limit.get("add", 0))
            return None if limit is None else (word, bits(limit))
        return ("ends", end("min", "zero" if allowed.get("zero") else "value"), end("max", "value"))

    def _first_column(self, table):
        column = table["inputs"][0]
        if isinstance(column, dict) and "enumeration" in column:
            return set(self.enumeration(column["enumeration"]).values())
        return {number for row in table["rows"] for first, last in Table(self, table).choices(0, row[0])
                for number in range(first, last + 1)}


class Table:
    """A decision table: the columns of its rows in memory, and their contents."""

    def __init__(self, part, item):
        self.part, self.item = part, item
        self.columns = item["inputs"] + item["outputs"]
        self.kinds = [self._kind(at) for at in range(len(self.columns))]

    @staticmethod
    def name(column):
        return column if isinstance(column, str) else column["name"]

    @staticmethod
    def parts(cell):
        return cell if isinstance(cell, list) else [cell]

    def namespace(self):
        title = self.item["title"]
        for mark in ",.:;()–—":
            title = title.split(mark)[0]
        return self.item.get("name") or "_".join(title.lower().replace("-", " ").split())

    def _cells(self, at):
        return [one for row in self.item["rows"] for one in self.parts(row[at]) if one != "*"]

    @staticmethod
    def _ends(cell):
        if isinstance(cell, str) and ".." in cell:
            first, last = cell.split("..")
            return int(first), int(last)
        return cell, cell

    def _kind(self, at):
        """Returns the type and values of a column: (type of CiA 301, {word: number} or None, lowest, highest)."""
        column = {"name": self.columns[at]} if isinstance(self.columns[at], str) else self.columns[at]
        cells = self._cells(at)
        words = [one for one in cells if isinstance(one, str) and ".." not in one]
        if column["name"] == self.item.get("errors"):
            return "UNSIGNED8", self.part.errors(), 0, 0
        if "enumeration" in column:
            values = self.part.enumeration(column["enumeration"])
            return self._narrowest(values.values()), values, 0, 0
        if words or "values" in column:
            return "UNSIGNED8", {word: number for number, word in enumerate(column.get("values") or dict.fromkeys(words))}, 0, 0
        if any(isinstance(one, bool) for one in cells):
            return "BOOLEAN", None, False, True
        if any(isinstance(one, float) for one in cells):
            return column.get("type", "REAL32"), None, 0, 0
        ends = [end for one in cells for end in self._ends(one)]
        low, high = column.get("min", min(ends)), column.get("max", max(ends))
        return column.get("type") or self._narrowest([low, high]), None, low, high

    @staticmethod
    def _narrowest(numbers):
        signed = min(numbers) < 0
        for size in (8, 16, 32, 64):
            low, high = (-(1 << (size - 1)), (1 << (size - 1)) - 1) if signed else (0, (1 << size) - 1)
            if low <= min(numbers) and max(numbers) <= high:
                return f"{'INTEGER' if signed else 'UNSIGNED'}{size}"
        raise ValueError(f"{max(numbers)} has more than 64 bits")

    def is_ranged(self, at):
        kind, words, _, _ = self.kinds[at]
        numbers = words is None and kind not in ("BOOLEAN", "REAL32", "REAL64") and at < len(self.item["inputs"])
        return numbers and any("*" == row[at] or any(self._ends(one)[0] != self._ends(one)[1] for one in self.parts(row[at]))
                               for row in self.item["rows"])

    def choices(self, at, cell):
        """Returns a (first, last) for each value or range that a cell of an input stands for."""
        kind, words, low, high = self.kinds[at]
        if cell == "*":
            if words is not None:
                return [(word, word) for word in words]
            return [(False, False), (True, True)] if kind == "BOOLEAN" else [(low, high)]
        return [self._ends(one) for one in self.parts(cell)]

    def fields(self):
        """Yields (name, type of CiA 301, words or None) of each member of a row, in their order."""
        for at, column in enumerate(self.columns):
            kind, words, _, _ = self.kinds[at]
            for end in ("_first", "_last") if self.is_ranged(at) else ("",):
                yield self.name(column) + end, kind, words

    def groups(self):
        """Yields, for each row of a table in spec/, the numbers of its first row in memory and of the row behind its last one."""
        first = 0
        for row in self.item["rows"]:
            last = first + math.prod(len(self.choices(at, row[at])) for at in range(len(self.item["inputs"])))
            yield first, last
            first = last

    def rows(self):
        """Yields, for each row of the generated table, the values of its members."""
        inputs = len(self.item["inputs"])
        for row in self.item["rows"]:
            for head in itertools.product(*(self.choices(at, row[at]) for at in range(inputs))):
                line = []
                for at, (first, last) in enumerate(head):
                    line += [first, last] if self.is_ranged(at) else [first]
                yield line + [self.parts(cell)[0] for cell in row[inputs:]]
