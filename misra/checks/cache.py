# SPDX-License-Identifier: Apache-2.0
"""Caches the outputs of the tools as long as none of their inputs changes.

The cache contains only outputs: each run evaluates findings, tests of the checkers and records again. The key of an
output is a hash of the tool's version, its command line, its script, and the contents of its files. The headers of this
project that a file includes, also through other headers, count as its files. System headers count by the versions of
their packages. The cache is in
~/.cache/canproof/misra, or in the folder CANPROOF_MISRA_CACHE; `CANPROOF_MISRA_CACHE=off` runs every tool."""
import functools
import hashlib
import json
import os
import pathlib
import re
import shutil
import subprocess
import tempfile
import time

from .rules import HOME, ROOT, run_tool

INCLUDE = re.compile(r'^[ \t]*#[ \t]*(?:include|include_next|import)\b[ \t]*(.*)$', re.MULTILINE)
NAME = re.compile(r'(?:"([^"]+)"|<([^>]+)>)')
KEPT_SECONDS = 30 * 24 * 3600  # an entry of the cache is removed this long after its last use
PACKAGES = ["libc6-dev", "libstdc++-*-dev", "gcc-*", "g++-*", "libclang-common-19-dev", "clang-tidy-19", "clang-tools-19", "cppcheck"]


def home():
    """Returns the folder in which canproof keeps what another run can use again."""
    return pathlib.Path(os.environ.get("XDG_CACHE_HOME") or os.path.expanduser("~/.cache")) / "canproof"


def folder():
    """Returns the folder of the cache; None when it is switched off."""
    named = os.environ.get("CANPROOF_MISRA_CACHE", "")
    if named == "off":
        return None
    return pathlib.Path(named or home() / "misra")


@functools.lru_cache(maxsize=None)
def version(tool):
    """Returns the version of a tool, and the versions of the packages with the system headers."""
    path = os.path.realpath(shutil.which(tool))
    _, said = run_tool([tool, "--version"])
    packages = ""
    if shutil.which("dpkg-query"):
        listed = subprocess.run(["dpkg-query", "-W", *PACKAGES], capture_output=True, text=True, check=False).stdout
        packages = "\n".join(sorted(listed.splitlines()))
    return f"{path} {os.stat(path).st_size}\n{said}\n{packages}"


@functools.lru_cache(maxsize=None)
def content(path):
    """Returns a file's text and its includes as spelled; None when the file cannot be read as text."""
    try:
        text = pathlib.Path(path).read_text()
    except (OSError, UnicodeDecodeError):
        return None
    return text, tuple(INCLUDE.findall(text))


def read_with_includes(files, folders):
    """Returns by path the text of the files and of all files that they include from their own folders or from `folders`. Returns
    None when an include does not name its file, so that only the preprocessor can resolve it."""
    texts, waiting = {}, [str(path) for path in files]
    while waiting:
        path = waiting.pop()
        if path in texts:
            continue
        found = content(path)
        if found is None:
            return None
        texts[path] = found[0]
        for spelled in found[1]:
            name = NAME.match(spelled)
            if name is None:
                return None
            quoted, angled = name.groups()
            for base in [*([os.path.dirname(path)] if quoted else []), *folders]:
                included = os.path.join(base, quoted or angled)
                if os.path.isfile(included):
                    waiting.append(os.path.normpath(included))
                    break
    return texts


class Places:
    """Replaces the paths of folders by names, so that a checkout in another folder finds the same cached outputs."""

    def __init__(self, **folders):
        self.named = sorted(((os.path.realpath(path), f"@{name}@") for name, path in folders.items()), key=lambda one: -len(one[0]))

    def without(self, text):
        for path, name in self.named:
            text = text.replace(path, name)
        return text

    def within(self, text):
        for path, name in self.named:
            text = text.replace(name, path)
        return text


def key_of(command, script, texts, places):
    sum_of = hashlib.sha256()
    for part in [version(command[0]), *command, script, *(part for item in sorted(texts.items()) for part in item)]:
        data = places.without(part).encode()
        sum_of.update(f"{len(data)}:".encode() + data)
    return sum_of.hexdigest()


def run_cached(command, files, generated, script="", scratch=None, leaves=None):
    """Returns (exit status, output) of `command`, which reads only `files` of this project and their includes. The word `@script@`
    of the command is replaced by the name of a file with the content `script`. `leaves` is a file that the command writes; it is
    cached with the output. `scratch` is a folder of this run, whose path has no influence on the key."""
    generated = os.path.realpath(generated)
    others = {"project": str(ROOT)} if ROOT != HOME else {}
    places = Places(root=str(HOME), generated=generated, **others, **({"scratch": scratch} if scratch else {}))
    store, entry = folder(), None
    texts = read_with_includes([HOME / path for path in files], [str(HOME / "src"), str(ROOT / "src"), generated]) if store else None
    if texts is not None:
        entry = store / (key_of(command, script, texts, places) + ".json")
        try:
            known = json.loads(entry.read_text())
            if leaves:
                pathlib.Path(leaves).write_text(places.within(known["left"]))
            os.utime(entry)
            return known["status"], places.within(known["output"])
        except (OSError, ValueError, KeyError, TypeError):
            pass  # entry missing or incomplete: the tool runs again
    with tempfile.NamedTemporaryFile("w", suffix=".script") as file:
        file.write(script)
        file.flush()
        status, output = run_tool([file.name if word == "@script@" else word for word in command])
    # A status other than 0 and 1 is no result: a tool that was killed or ran out of memory may succeed next time.
    if entry is None or status not in (0, 1) or (leaves and not os.path.exists(leaves)):
        return status, output
    known = {"status": status, "output": places.without(output)}
    if leaves:
        known["left"] = places.without(pathlib.Path(leaves).read_text())
    try:
        keep(entry, known)
    except OSError:
        pass  # without a writable cache the checks only take longer
    return status, output


def keep(entry, known):
    entry.parent.mkdir(parents=True, exist_ok=True)
    with tempfile.NamedTemporaryFile("w", dir=entry.parent, suffix=".new", delete=False) as file:
        json.dump(known, file)
    os.replace(file.name, entry)


def drop_unused(store):
    """Removes the entries of the folder `store` that no run has used for 30 days."""
    if store is None or not store.is_dir():
        return
    for entry in store.iterdir():
        try:
            if entry.stat().st_mtime < time.time() - KEPT_SECONDS:
                entry.unlink()
        except OSError:
            pass  # another run has removed the entry
