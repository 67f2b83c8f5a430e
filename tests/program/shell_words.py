#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""tests/program/shell_words.py PROGRAM: checks that shell completion and manual pages of PROGRAM (canproof) contain every command and
option of --help."""
import pathlib
import re
import shlex
import shutil
import subprocess
import sys
import tempfile

PROGRAM = pathlib.Path(sys.argv[1]).resolve()


def said(*words, **how):
    done = subprocess.run([str(word) for word in words], capture_output=True, text=True, **how)
    if done.returncode != 0:
        sys.exit(f"{' '.join(map(str, words))} ended with {done.returncode}:\n{done.stdout}{done.stderr}")
    return done.stdout


def commands_of(path):
    """Returns the names of the subcommands of a command, as its --help lists them."""
    text = said(PROGRAM, *path, "--help")
    listed = re.search(r"^Subcommands:\n((?:  .*\n)+)", text, re.M)
    return re.findall(r"^  (\S+)", listed.group(1), re.M) if listed else []


def options_of(path):
    return sorted(set(re.findall(r"^  (?:-\w,)?(--[a-z-]+)", said(PROGRAM, *path, "--help"), re.M)))


def tree(path=()):
    yield path
    for name in commands_of(path):
        yield from tree((*path, name))


def completed(script, words):
    """Returns the completions that bash offers for these words, of which the last is incomplete."""
    line = f'source {script}; COMP_WORDS=(canproof {shlex.join(words)}); COMP_CWORD={len(words)}; _canproof; printf "%s\\n" "${{COMPREPLY[@]}}"'
    return said("bash", "-c", line).split()


# Each shell must offer the second list behind the words of the first, of which the last is incomplete.
OFFERED = (
    (["eds", "ch"], ["check"]),
    (["run", "--bus-f"], ["--bus-faults"]),
    (["eds", "ax060805", "--format", ""], ["eds", "eds-lely", "xdd", "json", "md", "dbc"]),
    (["audit", "--status", ""], ["failed", "open", "suspect", "shown", "explained"]),
    (["audit", "--kind", "st"], ["storage", "statement"]),
    (["spec", "review", "--role", ""], ["author", "independent"]),
    (["evidence", "ver"], ["verify"]),
    (["run", "cbx"], ["cbx-ao412"]),
    (["replay", "AX0608"], ["AX060835", "AX060840", "AX060841"]),
    (["nosuch", "aud"], ["audit"]),
)
# Only bash passes `=` as a word of its own; the other shells offer files where no word is fixed.
OFFERED_BY_BASH = (
    (["eds", "--format", "=", "x"], ["xdd"]),
    (["eds", "--format", "="], ["eds", "eds-lely", "xdd", "json", "md", "dbc"]),
    (["completion", ""], ["--help", "bash", "zsh", "fish"]),
    (["run", "--log", ""], []),
)


def fish_completed(script, words):
    """Returns the completions that fish offers, in a folder whose files begin with other words."""
    line = f"{shlex.join(['canproof', *words[:-1]])} {words[-1]}"
    asked = subprocess.run(["fish", "--no-config", "-c", f"source {script}; complete -C {shlex.quote(line)}"],
                           cwd=script.parent / "man", capture_output=True, text=True, check=False)
    if asked.returncode != 0 or asked.stderr:
        sys.exit(f"fish reports behind {line}: {asked.stderr}")
    return [row.split("\t")[0] for row in asked.stdout.splitlines()]


def zsh_completed(script, words):
    """Returns the words that the function of zsh offers, of those that begin with the last word."""
    line = (f"compdef() {{ }}; _describe() {{ print -l -- ${{(@)offered%%:*}} }}; source {script}; "
            f"words=(canproof {shlex.join(words)}); CURRENT={len(words) + 1}; _canproof")
    return [word for word in said("zsh", "-f", "-c", line).split() if word.startswith(words[-1])]


def check_offered(shell, script, completed, rows=OFFERED):
    """Checks what a shell offers for the words of each row. fish sorts what it offers."""
    for words, offered in rows:
        found = completed(script, words)
        if found != (sorted(offered) if shell == "fish" else offered):
            sys.exit(f"{shell} offers {found} behind canproof {' '.join(words)}, not {offered}")


def check_shell(shell, script, completed):
    """Checks what a shell offers for the words of OFFERED, and behind each command."""
    check_offered(shell, script, completed)
    for path in tree():
        for begin, wanted in (("", commands_of(path)), ("--", options_of(path))):
            missing = set(wanted) - set(completed(script, [*path, begin]))
            if missing:
                sys.exit(f"{shell} does not offer {missing} behind canproof {' '.join(path)}")


def main():
    page = said(PROGRAM, "manual").replace("\\-", "-")
    with tempfile.TemporaryDirectory() as folder:
        script = pathlib.Path(folder) / "bash"
        script.write_text(said(PROGRAM, "completion", "bash"))
        checked = 0
        shells = ["bash"]
        for path in tree():
            behind = completed(script, [*path, ""])
            for word in [*commands_of(path), *options_of(path)]:
                if word not in behind:
                    sys.exit(f"bash does not offer {word} behind canproof {' '.join(path)}: {behind}")
                checked += 1
            if path and f'.SS "canproof {" ".join(path)} ' not in page:
                sys.exit(f"the manual page does not have canproof {' '.join(path)}")
            own_page = said(PROGRAM, "manual", *path).replace("\\-", "-")
            if f'.TH {"-".join(["canproof", *path]).upper()} 1 ' not in own_page:
                sys.exit(f"canproof manual {' '.join(path)} has another title")
            for option in options_of(path) if path else []:
                if f".B {option}" not in page or f".B {option}" not in own_page:
                    sys.exit(f"a manual page does not have {option} of canproof {' '.join(path)}")
        written = pathlib.Path(folder) / "man"
        written.mkdir()
        said(PROGRAM, "manual", "--out", written)
        pages = {f"canproof-{name}.1": [name] for name in commands_of(())} | {"canproof.1": []}
        if {file.name for file in written.iterdir()} != set(pages):
            sys.exit(f"canproof manual --out writes {sorted(file.name for file in written.iterdir())}")
        for name, path in pages.items():
            if (written / name).read_text() != said(PROGRAM, "manual", *path):
                sys.exit(f"{name} differs from canproof manual {' '.join(path)}")
            if path and f".BR {name[:-2]} (1)" not in page:
                sys.exit(f"the page of the program does not refer to {name}")
        for line in ("canproof signals DEVICE [OPTION…]", "canproof run [DEVICE] [OPTION…]", "canproof plot CSV SVG [OPTION…]"):
            if f'.SS "{line}"' not in page:
                sys.exit(f"the manual page does not have the synopsis `{line}`")
        unknown = subprocess.run([PROGRAM, "manual", "nosuch"], capture_output=True, text=True, check=False)
        if unknown.returncode != 2 or "there is no command `nosuch`" not in unknown.stderr:
            sys.exit(f"canproof manual nosuch ends with {unknown.returncode}: {unknown.stderr}")
        if "canproof run " in said(PROGRAM, "manual", "eds"):
            sys.exit("the page of canproof eds has another command")
        check_offered("bash", script, completed, OFFERED + OFFERED_BY_BASH)
        if "nosuch" in completed(script, ["nosuch"]):
            sys.exit("bash offers what is no command")
        for shell in ("zsh", "fish"):
            text = said(PROGRAM, "completion", shell)
            (pathlib.Path(folder) / shell).write_text(text)
            if "conform" not in text or "allow-outputs" not in text:
                sys.exit(f"the completion of {shell} lacks a command or an option")
            if "eds-lely xdd" not in text or "C.3040.02" not in text:
                sys.exit(f"the completion of {shell} lacks the values of an option or the devices")
            if shutil.which(shell):
                said(shell, "-n", pathlib.Path(folder) / shell)
                check_shell(shell, pathlib.Path(folder) / shell, fish_completed if shell == "fish" else zsh_completed)
                shells.append(shell)
    if checked < 100:
        sys.exit(f"only {checked} words were looked at: --help has another form")
    print(f"{checked} commands and options complete and stand on the manual page; shells: {', '.join(shells)}")


main()
