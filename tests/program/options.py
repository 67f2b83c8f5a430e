#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""tests/program/options.py PROGRAM: checks that PROGRAM (canproof) ignores no option silently: each option and argument of each command
refuses an empty value, and options of which one would have no effect are refused together."""
import pathlib
import re
import sys
import tempfile

sys.dont_write_bytecode = True
from expectations import canproof, expect, finish, refused

EMPTY_ALLOWED = {("fuzz", "--land")}  # '': do not copy findings


def tree(path=()):
    """Yields each command with the text of its --help."""
    text = canproof(*path, "--help").stdout
    yield path, text
    listed = re.search(r"^Subcommands:\n((?:  .*\n)+)", text, re.M)
    for name in re.findall(r"^  (\S+)", listed.group(1), re.M) if listed else []:
        yield from tree((*path, name))


def empty_values():
    """Checks that each option that takes a value, and each argument, refuses ''. Returns how many were tried."""
    tried = 0
    for path, text in tree():
        for name, kind in re.findall(r"^  (?:-\w,)?(--[a-z-]+)(?: ([A-Z]{3}\S*))?", text, re.M):
            if kind and (path[:1] + (name,)) not in EMPTY_ALLOWED:
                # an option with a check of its own, such as TEXT:{eds,xdd}, refuses '' by this check
                refused(name if ":" in kind else "the value is empty", *path, name, "")
                tried += 1
        arguments = re.search(r"^Positionals:\n((?:  .*\n)+)", text, re.M)
        if arguments and re.match(r"  [A-Z]", arguments.group(1)):
            refused("SHELL" if path == ("completion",) else "the value is empty", *path, "")
            tried += 1
    return tried


def without_effect(folder):
    eds = folder / "a.eds"
    eds.write_text(canproof("eds", "ax188001").stdout)
    for words in ((eds,), ("--fix", folder / "b.eds"), ("--strict",)):
        refused("excludes", "eds", "check", "--rules", *words)
    refused("excludes", "eds", "--format", "xdd", "check", eds)
    refused("--log", "run", "cbx-ao412", "--log-marks", "--seconds", "0")
    refused("applies only to a candump log", "run", "cbx-ao412", "--log", folder / "x.pcap", "--log-marks", "--seconds", "0")
    refused("applies only to --bus socketcan", "run", "cbx-ao412", "--control-interface", "--seconds", "0")
    for words in (("ax188001",), ("--only", "sdo"), ("--skip", "lss"), ("--case", "1"), ("--eds", eds), ("--report", folder / "out")):
        refused("excludes", "conform", "--list", *words)
    for words in (("--kind", "timing"), ("--status", "open"), ("--section", "AX188001:1"), ("--untested",)):
        refused("is no device", "audit", "CO-SDO-001", *words)
    refused("excludes", "audit", "--untested", "--status", "shown")
    refused("conditions of use have no", "audit", "--kind", "condition-of-use", "--status", "open")
    refused("excludes", "coverage", "--records", "--cobertura", folder / "c.xml")
    refused("excludes", "coverage", "--records", "build/coverage/coverage.json")
    refused("excludes", "evidence", "--full", "verify", folder)
    refused("excludes", "misra", "--json", "review", "FILE", "0.1.1", "--by", "x", "--judgement", "y")
    for words in (("--minutes", "1"), ("--hours", "1"), ("--seed", "7"), ("--restart",), ("--shard", "1/2")):
        refused("excludes", "fuzz", "--merge", folder, *words)
    refused("excludes", "inject", "cbx-ao412", "--shard", "1/2", "--json")
    refused("requires", "mutate", "--seed", "7")
    for words in (("AO4-AOUT-002",), ("--code",), ("--sample", "3"), ("--shard", "1/2"), ("--merge", folder)):
        refused("excludes", "mutate", "--kills", *words)
    refused("excludes", "mutate", "--code", "--table", "node.cpp")
    expect(sorted(file.name for file in folder.iterdir()) == ["a.eds"], "a refused command has written a file")


def wrong_values():
    for number in ("nan", "inf", "95.1", "-1"):
        refused("is not a number from 0 to 95", "conform", "ax188001", "--traffic", number)
    refused("is not a number from 0.01", "fuzz", "--minutes", "nan")
    refused("is not a number from 0.01", "fuzz", "--hours", "nan")
    for command in (("fuzz",), ("inject", "cbx-ao412"), ("mutate", "--sample", "1")):
        for number in ("-1", "18446744073709551616", "1.5", "0x", "+1"):
            refused("is no whole number from 0 to 18446744073709551615", *command, "--seed", number)
    refused("is not UTF-8", "spec", "review", "AO4-AOUT-002", "--by", b"Ren\xe9", "--role", "author")
    refused("is not UTF-8", "misra", "review", "FILE", "0.1.1", "--by", b"Ren\xe9", "--judgement", "y")
    refused("is not UTF-8", "new", "my-box", "--manual", b"Ger\xe4t")
    refused("is no date", "spec", "review", "AO4-AOUT-002", "--by", "x", "--role", "author", "--date", "2026-13-45")
    refused("has quotes or backslashes", "new", "my-box", "--manual", 'The "box"')
    refused("name the slave to test", "conform")
    refused("not by both", "conform", "ax188001", "--eds", "x.eds")


def wrong_use():
    """Checks that wrong use gives status 2 and one line on standard error, which names the --help of the command."""
    for words, command in ((("run", "--nope"), "canproof run"), (("eds", "check"), "canproof eds check"),
                           (("mutate", "--jobs", "0"), "canproof mutate"), ((), "canproof"), (("nope",), "canproof"), (("spec",), "canproof spec"),
                           (("replay", "a", "b\nc", "d"), "canproof replay")):
        result = canproof(*words)
        lines = result.stderr.splitlines()
        one = len(lines) == 1 and lines[0].startswith("canproof: ") and f"`{command} --help` lists" in lines[0]
        expect(result.returncode == 2 and result.stdout == "" and one, f"wrong use: {words}: {result}")


with tempfile.TemporaryDirectory() as name:
    count = empty_values()
    expect(count > 100, f"only {count} options and arguments were found: --help has another form")
    without_effect(pathlib.Path(name))
    wrong_values()
    wrong_use()
finish(f"{count} options and arguments refuse an empty value; none is ignored")
