# SPDX-License-Identifier: Apache-2.0
"""Hashes the inputs of a check: its command, its environment, the tools of this machine, and the contents of files and programs."""
import functools
import hashlib
import os
import pathlib
import re
import struct
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "tests"))
from tracked import tracked  # noqa: E402

HERE = b"@project@"  # stands for the folder of the project, so that all clones share their verdicts
# Variables that change what a check does. Those that only say where something is, or how verdicts are kept, are left out.
MATTERS = re.compile(r"(CANPROOF|RC|GTEST|ASAN|UBSAN|TSAN|CXX|CMAKE|PYTHON|NODE|LC|GIT)[A-Z_]*|LANG|TZ|PATH|SEED|SOURCE_DATE_EPOCH|FUZZ_SECONDS")
LEFT_OUT = {"CANPROOF_VERDICTS", "CANPROOF_KEPT", "CANPROOF_MISRA_CACHE"}
NOTE, LOADED = 4, 1  # types of segments of an ELF file
TIMES = re.compile(rb' (?:time|timestamp)="[^"]*"')  # attributes of JUnit: how long and when a test ran


def without_folder(data):
    return data.replace(os.fsencode(ROOT), HERE)


def within_folder(data):
    return data.replace(HERE, os.fsencode(ROOT))


def segments(data):
    """Yields (type, offset, address, bytes in the file, bytes in memory, flags) of each segment of an ELF file."""
    wide = data[4] == 2
    table, = struct.unpack_from("<Q" if wide else "<I", data, 32 if wide else 28)
    size, count = struct.unpack_from("<HH", data, 54 if wide else 42)
    for at in range(table, table + size * count, size):
        if wide:
            kind, flags, offset, address, _, in_file, in_memory, _ = struct.unpack_from("<IIQQQQQQ", data, at)
        else:
            kind, offset, address, _, in_file, in_memory, flags, _ = struct.unpack_from("<IIIIIIII", data, at)
        yield kind, offset, address, in_file, in_memory, flags


def loaded(content):
    """Returns what a processor sees of a program: neither its debug information, which names the folder of the build, nor the notes and
    the parts of the header that depend on the debug information."""
    data = bytearray(content)
    parts = list(segments(data))
    for kind, offset, _, in_file, *_ in parts:
        if kind == NOTE:
            data[offset : offset + in_file] = bytes(in_file)
    wide = data[4] == 2
    for begin, end in [(40, 48), (58, 64)] if wide else [(32, 36), (46, 52)]:  # place, size and count of the sections
        data[begin:end] = bytes(end - begin)
    return b"".join(struct.pack("<QQQI", address, in_file, in_memory, flags) + bytes(data[offset : offset + in_file])
                    for kind, offset, address, in_file, in_memory, flags in parts if kind == LOADED)


def content(path):
    """Returns the bytes of a file that matter to a check. A link matters by its text and by the file to which it leads."""
    if path.is_symlink():
        return without_folder(os.fsencode(os.readlink(path))) + (content(path.resolve()) if path.is_file() else b"")
    data = path.read_bytes()
    if data[:4] == b"\x7fELF" and data[16] in (2, 3):  # a program or shared library, not an object
        return loaded(data)
    if path.suffix == ".xml":
        data = TIMES.sub(b"", data)
    return without_folder(data)


@functools.lru_cache(maxsize=None)
def of_git():
    return tracked(ROOT)


def files_of(name):
    """Returns the files that a name means, by the names that they have in the hash. A name is a file, a folder or a pattern. In the
    project, a folder means the files that git tracks or would add; in build/ and outside of the project it means all files."""
    path = ROOT / name
    if path.is_relative_to(ROOT) and not path.is_relative_to(ROOT / "build"):
        below = path.relative_to(ROOT).as_posix()
        found = [ROOT / one for one in of_git() if below in (".", one) or one.startswith(below + "/")]
    elif path.is_dir():
        found = [one for one in path.rglob("*") if one.is_file() or one.is_symlink()]
    else:
        found = [one for one in path.parent.glob(path.name) if one.is_file()]
    if not found:
        sys.exit(f"kept: no input is {name}")
    if not path.is_relative_to(ROOT):
        return {f"outside/{one.relative_to(path if path.is_dir() else path.parent)}": one for one in found}
    return {one.relative_to(ROOT).as_posix(): one for one in found}


@functools.lru_cache(maxsize=None)
def machine():
    """Returns the tools and the processor of this machine. All tools come from Debian packages, but Python and Node may not."""
    packages = subprocess.run(["dpkg-query", "-W"], capture_output=True, text=True, check=True).stdout
    node = subprocess.run(["sh", "-c", "command -v node && node --version"], capture_output=True, text=True, check=False).stdout
    cpu = re.search(r"^model name.*$", pathlib.Path("/proc/cpuinfo").read_text(), re.MULTILINE)
    return "\n".join([packages, sys.executable, sys.version, node, cpu.group() if cpu else "", str(os.cpu_count()), os.uname().release])


def key_of(command, names, but, words):
    """Returns the hash of all inputs of a check: `names` are its files, without those that a pattern of `but` matches."""
    of_git.cache_clear()  # a check may have added files since the last call
    known = sorted(f"{name}={value}" for name, value in os.environ.items() if MATTERS.fullmatch(name) and name not in LEFT_OUT)
    sum_of = hashlib.sha256()

    def add(data):
        sum_of.update(f"{len(data)}:".encode() + data)

    for text in ["1", machine(), *known, *command, "--", *words]:
        add(without_folder(os.fsencode(text)))
    files = {}
    for name in names:
        files.update(files_of(name))
    for name, path in sorted(files.items()):
        if any(pathlib.PurePath(name).match(pattern) for pattern in but):
            continue
        add(name.encode())
        add(b"x" if os.access(path, os.X_OK) else b"-")
        add(content(path))
    return sum_of.hexdigest()
