#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""in_toto.py PROGRAM: lets in-toto-verify (Debian's in-toto) check evidence packs that PROGRAM (canproof) has signed. It must accept a
signed pack with the public key alone. It must refuse a pack with a file that is altered, missing or added, a pack signed by another key,
and an altered layout. The keys are made here and thrown away."""
import json
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile

sys.dont_write_bytecode = True
sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "program"))
from small_project import GREEN, Project

KINDS = {"ed25519": ("-algorithm", "ed25519"), "ecdsa": ("-algorithm", "EC", "-pkeyopt", "ec_paramgen_curve:P-256")}
SCHEMES = {"ed25519": "ed25519", "ecdsa": "ecdsa-sha2-nistp256"}


def openssl(*words):
    return subprocess.run(["openssl", *words], check=True, capture_output=True).stdout


def make_key(folder, kind, name):
    """Makes a key pair without canproof. Writes the private key to NAME.key (PEM) and the public key to NAME.json, as in-toto reads it."""
    private, public = folder / f"{name}.key", folder / f"{name}.pub"
    openssl("genpkey", *KINDS[kind], "-out", private)
    openssl("pkey", "-in", private, "-pubout", "-out", public)
    text = openssl("pkey", "-in", private, "-pubout", "-outform", "DER")[-32:].hex() if kind == "ed25519" else public.read_text().strip()
    (folder / f"{name}.json").write_text(json.dumps({
        "keytype": kind, "scheme": SCHEMES[kind], "keyval": {"public": text}}))
    return private


def is_accepted(pack, kind, key):
    words = ["in-toto-verify", "--layout", "in-toto/root.layout", "--layout-keys", key, "--key-types", kind, "--link-dir", "in-toto"]
    done = subprocess.run(words, cwd=pack, capture_output=True, text=True)
    (pack / "pack.link").unlink(missing_ok=True)  # removes a file that in-toto leaves in the pack after an inspection
    return done.returncode == 0, done.stdout + done.stderr


def altered(folder, pack, change):
    """Returns a copy of the evidence pack in which `change` has altered something."""
    copy = folder / "copy"
    shutil.rmtree(copy, ignore_errors=True)
    shutil.copytree(pack, copy)
    change(copy)
    return copy


def edit(name, old, new):
    def change(pack):
        file = pack / name
        text = file.read_text()
        assert old in text, f"{name} has no `{old}`"
        file.write_text(text.replace(old, new, 1))
    return change


def link_of(pack):
    return json.loads(next((pack / "in-toto").glob("evidence.*.link")).read_text())["signed"]


def check(project, kind):
    folder = project.root
    private = make_key(folder, kind, kind)
    pack = folder / f"pack-{kind}"
    status, out, err = project.call("evidence", "--verdicts", "verdicts", "--out", str(pack), "--sign", str(private))
    assert status == 0, out + err
    good, told = is_accepted(pack, kind, folder / f"{kind}.json")
    assert good, told
    assert project.call("evidence", "verify", str(pack), "--key", str(folder / f"{kind}.pub"))[0] == 0
    link = link_of(pack)
    assert "spec/devices/box/items.toml" in link["materials"] and "verdicts/tests.xml" in link["materials"], sorted(link["materials"])
    assert json.loads((pack / "in-toto/root.layout").read_text())["signed"]["expires"] == "2033-12-31T23:59:59Z"  # 2023 + 10
    return pack


def refused(folder, pack, kind):
    """Checks that each change of a signed pack is refused."""
    changes = {"an altered file": edit("index.html", "canproof", "canprof"), "a missing file": lambda one: (one / "tests.html").unlink(),
               "one more file": lambda one: (one / "more.html").write_text("more"),
               "a later expiry of the layout": edit("in-toto/root.layout", "2033-12-31", "2043-12-31")}
    for what, change in changes.items():
        assert not is_accepted(altered(folder, pack, change), kind, folder / f"{kind}.json")[0], f"in-toto accepts {what}"
    make_key(folder, kind, "other")
    assert not is_accepted(pack, kind, folder / "other.json")[0], "in-toto accepts another key"


os.environ["SOURCE_DATE_EPOCH"] = "1700000000"  # 2023-11-14
with tempfile.TemporaryDirectory() as scratch:
    small = Project(sys.argv[1], scratch)
    small.statements(GREEN)
    small.write("reports/argument.toml", '[[claim]]\nid = "C"\ntext = "Tests pass."\nevidence = ["tests"]\n')
    git = ["git", "-C", scratch, "-c", "user.name=t", "-c", "user.email=t@example.org", "-c", "commit.gpgsign=false"]
    for words in (["init", "-q"], ["add", "."], ["commit", "-q", "-m", "first"]):
        subprocess.run([*git, *words], check=True)
    for kind in KINDS:
        made = check(small, kind)
    refused(small.root, made, kind)
print("in-toto accepts packs signed with Ed25519 and P-256, and refuses what was changed")
