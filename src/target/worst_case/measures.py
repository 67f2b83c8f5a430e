# SPDX-License-Identifier: Apache-2.0
"""Numbers of a device that bound its loops, from its generated tables."""
import re

# error_table.hpp: the rows of an ErrorTable, and numbers of ErrorId.
MAX_ERRORS = 48
FIRST_OF_DEVICE = 15
FIRST_MANUFACTURER = 0x2000  # the index behind those of the communication group
# The errors of guarding, heartbeat, SYNC and receive PDOs. All other errors depend on the device's inputs (the CAN
# state included) or on a reset.
BUS_ERRORS = (2, 4, *range(7, 15))
# Those of them that begin when a time has passed: guarding, heartbeat and the time-out of a receive PDO.
TIMED_ERRORS = (2, 8, 9, *range(10, 14))
FIRST_HEARTBEAT = 10  # the error of the producer in 1016h:1 (consumer heartbeat time); those of three further producers follow
PRODUCERS = 4
BUS_OFF_RECOVERED = 3


# COB-ID and inhibit time of EMCY: the only objects that a node often looks up although the device may lack them.
OFTEN_ABSENT = (0x1014, 0x1015)
ERROR_LIST = 0x1003  # the defaults do not change it


def _rows(text, name):
    """Returns the fields of each row of a generated table."""
    body = re.search(rf"> {name}\{{\{{\n(.*?)\n\}}\}};", text, re.S)
    return [re.split(r",\s*", row) for row in re.findall(r"^    \{(.*)\},", body.group(1), re.M)]


def _number(field):
    return int(field.rstrip("U"), 0)


def measures(folder):
    """Returns the numbers by name; `folder` is generated/NAME of a build. bounds.toml and ways.toml explain each name."""
    text = (folder / "objects.hpp").read_text()
    objects = [(_number(index), _number(first), _number(count)) for index, first, count, _ in _rows(text, "object_rows")]
    entries = _rows(text, "entry_rows")
    counts = {index: count for index, _, count in objects}
    first = {index: at for index, at, _ in objects}
    pdos = {base: max((index - base + 1 for index in counts if base <= index < base + 8), default=0) for base in (0x1400, 0x1800)}
    mapping = [index for index in counts if 0x1600 <= index < 0x1608 or 0x1A00 <= index < 0x1A08]
    size, subindex = [_number(row[1]) for row in entries], [_number(row[3]) for row in entries]
    stored = [at for at, row in enumerate(entries) if "stored" in row[5]]
    limits = re.findall(r"^    \{\{LimitKind::(.*)\}\},", text, re.M)
    between = {f"{number}U" for number, limit in enumerate(limits) if "LimitKind::entry" in f"LimitKind::{limit}"}
    in_ram = [at for at, row in enumerate(entries) if "constant" not in row[5]]
    error_list = range(first.get(ERROR_LIST, 0), first.get(ERROR_LIST, 0) + counts.get(ERROR_LIST, 0))
    loaded = [at for at in in_ram if at not in error_list]
    communication = set(range(sum(count for index, count in counts.items() if index < FIRST_MANUFACTURER)))  # the first rows
    slots = re.findall(r"\w+", re.search(r"> object_slots\{\{(.*?)\}\};", text, re.S).group(1))
    factor = _number(re.search(r"table_view\(object_slots\), (\w+)", text).group(1))
    steps = {index: _steps(index, slots, factor, [row[0] for row in objects]) for index in range(0x10000)}
    own_pdos = [base + offset + number for base in pdos for offset in (0, 0x200) for number in range(pdos[base])]
    usual = max([*(steps[index] for index in (*counts, *own_pdos)), (max(steps[index] for index in OFTEN_ABSENT) + 2) // 3])
    named = [_number(found) for found in re.findall(r" = (0x1[01]\w+)", (folder.parent / "canopen" / "index.hpp").read_text())]
    profile = (folder / "profile.hpp").read_text()
    tables = (folder / "tables.hpp").read_text()
    lists = [_number(found) & 0xFFFF for found in re.findall(r"LimitKind::list, (\w+)", text)]
    shared = (folder.parent / "canopen" / "tables.hpp").read_text()
    rows = re.findall(r"^namespace (\w+) \{$(?:(?!^namespace).)*?std::array<Row, (\d+)U> rows", shared + tables, re.M | re.S)
    return {
        **{f"rows_of_{name}": int(count) for name, count in rows},
        **{f"probes_of_{index:x}": steps[index] for index in (*counts, *named)}, "has_1014": int(0x1014 in counts),
        "objects": len(objects), "entries": len(entries), "most_entries": max(counts.values()),
        "rpdos": pdos[0x1400], "tpdos": pdos[0x1800], "pdo_lines": max((counts[index] - 1 for index in mapping), default=0),
        "error_fields": max(1, counts.get(0x1003, 1) - 1),
        "stored": len(stored), "stored_bytes": sum(size[at] for at in stored), "longest_stored": max(size[at] for at in stored),
        "loaded": len(loaded), "loaded_bytes": sum(size[at] for at in loaded),
        "node_id_bytes": sum(size[at] for at, row in enumerate(entries) if "node_id" in row[5]),
        "longest_in_ram": max(size[at] for at in in_ram),
        "longest": max(size), "longest_list": max(lists, default=0), "probes": _probes(slots),
        "usual_probes": usual, "service_probes": max(usual, *(steps[index] for index in named)), "synchronises": int(0x1006 in counts),
        "lss": int("LssProfile{}" not in profile),
        "block_sdo": int(re.search(r"0x\w+U,\s*\w+,\s*(true|false),\s*LssProfile", profile).group(1) == "true"),
        "communication_entries": len(communication),
        "communication_stored": len(communication & {*stored}), "communication_stored_bytes": sum(size[at] for at in communication & {*stored}),
        "communication_loaded": len(communication & {*loaded}), "communication_loaded_bytes": sum(size[at] for at in communication & {*loaded}),
        "node_id_entries": sum("node_id" in row[5] for row in entries),
        "producers": max(0, counts.get(0x1016, 0) - 1),
        "odd_numbers": sum(not re.search("string|domain", row[4]) and _number(row[1]) not in (1, 2, 4) for row in entries),
        "mappable": sum("rpdo" in row[5] for row in entries),
        "mappable_with_limits": sum("rpdo" in row[5] and row[2] != "no_limit" for row in entries),
        "mappable_between_entries": sum("rpdo" in row[5] and row[2] in between for row in entries),
        "mappable_in_bits": sum(("rpdo" in row[5] or "tpdo" in row[5]) and ("boolean" in row[4] or _number(row[1]) not in (1, 2, 4)) for row in entries),
        "transmittable": sum("tpdo" in row[5] for row in entries),
        "mappable_of_device": sum("rpdo" in row[5] and row[6] == "Service::device" for row in entries),
        "mappable_parameters": sum("rpdo" in row[5] and row[6].split("::")[-1] not in ("none", "device") for row in entries),
        "missing_rows": max(subindex[first[index] + at] - at for index in counts for at in range(counts[index])),
    }


def errors_of(image, producers):
    """Returns counts of a device's errors, and the highest error number. A device has an error if its row in the image's error table (error_table.hpp) has a code.
    The error of a heartbeat can occur only for one of `producers`: 1016h (consumer heartbeat time) has an entry for each."""
    address, size = next(place for name, place in image.symbols.items() if name.endswith("::error_table"))
    row = size // MAX_ERRORS
    absent = range(FIRST_HEARTBEAT + producers, FIRST_HEARTBEAT + PRODUCERS)
    reported = [at for at in range(MAX_ERRORS) if any(image.read(address + row * at, 2)) and at not in absent]
    return {
        "messages": 2 * len(reported) - (BUS_OFF_RECOVERED in reported), "errors": len(reported), "last_error": max(reported),
        "own_errors": sum(at >= FIRST_OF_DEVICE for at in reported), "bus_errors": sum(at in BUS_ERRORS for at in reported),
        "timed_errors": sum(at in TIMED_ERRORS for at in reported),
    }


def _probes(slots):
    """Returns the longest run of slots in use: the most steps of a search of the object dictionary."""
    longest = run = 0
    for slot in slots + slots:
        run = run + 1 if slot != "no_object" else 0
        longest = max(longest, run)
    return longest


def _steps(index, slots, factor, indices):
    """Returns the steps of a search of the object dictionary beyond its first slot, as ObjectDictionary::lookup() searches."""
    at, steps = (index * factor & 0xFFFFFFFF) >> 16 & len(slots) - 1, 0
    while slots[at] != "no_object" and indices[_number(slots[at])] != index:
        at, steps = at + 1 & len(slots) - 1, steps + 1
    return steps
