# SPDX-License-Identifier: Apache-2.0
"""Builds test programs that contain a seeded fault, beside the build of the unaltered sources. Only the objects that use a changed file are
compiled again, and a program of one test contains no other test source. The generated tables stay those of the unaltered tree."""
import json
import os
import pathlib
import re
import shlex
import shutil
import subprocess

import faults

CHANGED = "tree"  # name of the folder, below the folder of the programs of a fault, with the changed source files


def output_of(words):
    return words[words.index("-o") + 1]


def symbols_of(test):
    """Returns the names that GoogleTest may have given to the class of a test such as `Each/Suite.Name/3`."""
    suite, name = test.rsplit(".", 1) if "/" not in test.split(".")[-1] else (test.split(".")[0], test.split(".")[1])
    name = name.split("/")[0]
    return [f"{part}_{name}_Test" for part in suite.split("/") if not part.isdigit()]


class Programs:
    """The test programs of a build folder."""

    def __init__(self, build, names):
        self.build = pathlib.Path(build)
        self.commands = {}  # object: words of the command that compiles it
        for one in json.loads((self.build / "compile_commands.json").read_text()):
            words = shlex.split(one["command"])
            self.commands[output_of(words)] = words
        self.links = {name: self.link_words(name) for name in names}
        self.users = self.read_users()
        self.tests = {word: self.tests_in(word) for words in self.links.values() for word in words if word.endswith(".o")}
        ccache = shutil.which("ccache")
        self.launcher = [str(faults.ROOT / "src" / "host" / "ccache_launcher"), ccache] if ccache else []

    def ninja(self, *words):
        return subprocess.run(["ninja", "-C", str(self.build), *words], capture_output=True, text=True, check=True).stdout

    def link_words(self, name):
        """Returns the words of the command that links a program."""
        line = self.ninja("--quiet", "-t", "commands", "-s", name).splitlines()[-1]
        return shlex.split(re.sub(r"^: && | && :$", "", line))

    def read_users(self):
        """Returns {file: objects that use it}, with the path of the file from the root and the paths of the objects in the build
        folder."""
        users, made = {}, None
        tree = str(self.build.parent.parent) + "/"
        for line in self.ninja("--quiet", "-t", "deps").splitlines():
            if line.startswith("    "):
                path = os.path.normpath(os.path.join(self.build, line.strip()))
                if path.startswith(tree):
                    users.setdefault(path[len(tree):], []).append(made)
            elif line:
                made = line.split(":")[0]
        return users

    def tests_in(self, made):
        """Returns the mangled names of the classes of an object's tests, such as ...12Suite_Name_Test."""
        content, names = (self.build / made).read_bytes(), set()
        for found in re.finditer(rb"_Test8TestBodyEv\0", content):
            names.add(content[content.rfind(b"\0", 0, found.start()) + 1:found.start() + len("_Test")].decode())
        return names

    def object_of(self, program, test):
        """Returns the object of a program that contains a test, or nothing."""
        wanted = symbols_of(test)
        for made in self.links[program]:
            if any(re.search(rf"\d{one}$", name) for name in self.tests.get(made, ()) for one in wanted):
                return made
        return None

    def linked(self, program, kept):
        """Returns the objects that the linker may put into the program: the objects `kept`, and those of the archives it links."""
        folders = [f"{os.path.dirname(word)}/CMakeFiles/{os.path.basename(word)[3:-2]}.dir/" for word in self.links[program]
                   if word.endswith(".a") and not word.startswith("/")]
        return kept | {made for made in self.commands if made.startswith(tuple(folders))}

    def make(self, fault, program, folder, test=None):
        """Builds `program` with a fault, in `folder`. With `test`, the program has the source of this test and no other test source.
        Returns the error as text, or nothing."""
        objects = {word for word in self.links[program] if word.endswith(".o")}
        only = self.object_of(program, test) if test else None
        kept = {made for made in objects if not only or made == only or not self.tests[made]}
        wrong, altered = self.compile(fault, self.linked(program, kept), folder)
        if wrong:
            return wrong
        words = [word for word in self.links[program] if not (word in objects and (word not in kept or word in altered))]
        first = next(at for at, word in enumerate(words) if word.endswith((".o", ".a")))
        words[first:first] = altered.values()  # before the archives: so the linker does not take the unaltered objects from them
        words[words.index("-o") + 1] = str(folder / program)
        return self.run(words)

    def compile(self, fault, candidates, folder):
        """Compiles the candidates that use a changed file. Returns the error as text, or nothing, and {old object: new object}."""
        tree = folder / CHANGED
        for name in fault.files:
            (tree / name).parent.mkdir(parents=True, exist_ok=True)
            shutil.copy(self.build.parent.parent / name, tree / name)
        fault.apply(tree)
        altered = {}
        for made in sorted({one for name in fault.files for one in self.users.get(name, [])} & candidates):
            words = list(self.commands[made])
            source = words[-1].removeprefix(str(self.build.parent.parent) + "/")
            if (tree / source).exists():
                words[-1] = str(tree / source)
            words[1:1] = ["-I", str(tree / "src")]
            altered[made] = str(folder / f"{len(altered)}.o")
            words[words.index("-o") + 1] = altered[made]
            if wrong := self.run([*self.launcher, *words, "-w"]):
                return wrong, {}
        if not altered:
            return f"no program contains {', '.join(fault.files)}", {}
        return "", altered

    def run(self, words):
        done = subprocess.run(["nice", *words], cwd=self.build, capture_output=True, text=True, errors="replace", check=False)
        return "" if done.returncode == 0 else "\n".join(done.stderr.splitlines()[-40:]) or f"status {done.returncode}"
