"""What a tool said of files before, for as long as nothing that it reads has changed.

Kept is the tool's output and no judgement: findings, proofs of the checkers and records are worked out anew in each run. The key
of an output is a hash of the tool's version, its command line, its script, and the contents of the files with all of ours that
they include; headers of the system count by the versions of their packages. In ~/.cache/canproof/misra, or where
CANPROOF_MISRA_CACHE says; `CANPROOF_MISRA_CACHE=off` runs every tool."""
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
KEPT_SECONDS = 30 * 24 * 3600  # since an entry was last used
PACKAGES = ["libc6-dev", "libstdc++-*-dev", "gcc-*", "g++-*", "libclang-common-19-dev", "clang-tidy-19", "clang-tools-19", "cppcheck"]


def folder():
    """Where outputs are kept, or None."""
    named = os.environ.get("CANPROOF_MISRA_CACHE", "")
    if named == "off":
        return None
    home = os.environ.get("XDG_CACHE_HOME") or os.path.expanduser("~/.cache")
    return pathlib.Path(named or os.path.join(home, "canproof", "misra"))


@functools.lru_cache(maxsize=None)
def version(tool):
    """The tool itself, and what brings the headers of the system."""
    path = os.path.realpath(shutil.which(tool))
    _, said = run_tool([tool, "--version"])
    packages = ""
    if shutil.which("dpkg-query"):
        listed = subprocess.run(["dpkg-query", "-W", *PACKAGES], capture_output=True, text=True, check=False).stdout
        packages = "\n".join(sorted(listed.splitlines()))
    return f"{path} {os.stat(path).st_size}\n{said}\n{packages}"


@functools.lru_cache(maxsize=None)
def content(path):
    """A file's text and what it includes, as it is spelled; None where there is no such file."""
    try:
        text = pathlib.Path(path).read_text()
    except (OSError, UnicodeDecodeError):
        return None
    return text, tuple(INCLUDE.findall(text))


def read_with_includes(files, folders):
    """By path, the text of the files and of all that they include from their own folders or from `folders`. None when an include
    does not name its file: what it means, only the preprocessor knows."""
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
    """Folders whose place does not matter, by a name for each: a checkout elsewhere finds the same outputs."""

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
    """(exit status, output) of `command`, which reads `files` and nothing else of ours. A `@script@` in it becomes a file that holds
    `script`; `leaves` is a file that it writes, kept with its output; `scratch` is a folder of this run only."""
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
            pass  # not there, or not whole: the tool says it again
    with tempfile.NamedTemporaryFile("w", suffix=".script") as file:
        file.write(script)
        file.flush()
        status, output = run_tool([file.name if word == "@script@" else word for word in command])
    # Another status is no judgement: a tool that was killed, or that found no memory, may do better next time.
    if entry is None or status not in (0, 1) or (leaves and not os.path.exists(leaves)):
        return status, output
    known = {"status": status, "output": places.without(output)}
    if leaves:
        known["left"] = places.without(pathlib.Path(leaves).read_text())
    try:
        keep(entry, known)
    except OSError:
        pass  # a cache that cannot be written costs time, and nothing else
    return status, output


def keep(entry, known):
    entry.parent.mkdir(parents=True, exist_ok=True)
    with tempfile.NamedTemporaryFile("w", dir=entry.parent, suffix=".new", delete=False) as file:
        json.dump(known, file)
    os.replace(file.name, entry)


def drop_unused():
    """Removes what no run has asked for in a month."""
    store = folder()
    if store is None or not store.is_dir():
        return
    for entry in store.iterdir():
        try:
            if entry.stat().st_mtime < time.time() - KEPT_SECONDS:
                entry.unlink()
        except OSError:
            pass  # another run removed it
