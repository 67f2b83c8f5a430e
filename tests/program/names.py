#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""names.py PROGRAM: checks how PROGRAM (canproof) reads its command line: node-IDs, part numbers, factory data and images of devices,
options with one value, and --version."""
import os
import pathlib
import re
import subprocess
import sys
import tempfile

program = sys.argv[1]


def call(*words):
    done = subprocess.run([program, *words], stdin=subprocess.DEVNULL, capture_output=True, text=True, timeout=120)
    return done.returncode, done.stdout, done.stderr


def refused():
    """Checks that a wrong device name gives one line on stderr and status 2, and that nothing runs."""
    with tempfile.TemporaryDirectory() as folder:
        eds = os.path.join(folder, "box.eds")
        with open(eds, "w") as out:
            out.write(call("eds", "ax188001")[1])
        for node in ("0", "128", "200", "254", "256", "-1"):
            for words in (("run", f"ax188001@{node}", "--seconds", "0.05"), ("panel", f"ax188001@{node}", "--port", "0"),
                          ("replay", f"ax188001@{node}", "-"), ("replay", "ax188001", f"--node={node}", "-"),
                          ("run", "--eds", f"{eds}@{node}", "--seconds", "0.05"), ("replay", "--eds", f"{eds}@{node}", "-"),
                          ("replay", "--eds", eds, f"--node={node}", "-")):
                status, out, err = call(*words)
                assert status == 2, f"{words} ended with {status}"
                assert out == "" and "no node-ID; write 1…127, or 255" in err, f"{words}: {out}{err}"


def named():
    """Checks that `canproof run` names each device on standard error, and that standard output contains only frames."""
    status, out, err = call("run", "cbx-ao412@3", "ax188001@5", "ax060805@255", "--seconds", "0.05")
    assert status == 0, status
    assert err.splitlines() == ["cbx-ao412@3: node-ID 3", "ax188001@5: node-ID 5", "ax060805@255: no node-ID"], err
    frames = {line.split()[2] for line in out.splitlines()}
    assert frames == {"703#00", "705#00"}, out


def shared():
    """Checks that `canproof run` warns when two devices have the same node-ID."""
    status, _, err = call("run", "cbx-ao412@5", "ax188001@5", "--seconds", "0.05")
    assert status == 0, status
    assert "warning: node-ID 5 is used by 2 devices: cbx-ao412@5, ax188001@5" in err.splitlines(), err


def switches():
    """Checks that the application does not run with the coding switches at C8h (200, no node-ID): CAN-CBX-AO412, 3.2.6."""
    said = "the coding switches are at C8h, which is no node-ID"
    for words in (("run", "cbx-ao412@200", "--seconds", "0.05"), ("replay", "cbx-ao412@200", "-"),
                  ("replay", "cbx-ao412", "--node", "200", "-")):
        status, out, err = call(*words)
        assert status == 0 and out == "" and said in err, f"{words}: {status} {out}{err}"


def factory():
    """Checks that --factory sets 1018h:4 (serial number), that `canproof signals` lists its keys, and that wrong keys and values are
    refused."""
    request = "(0.1) can0 605#4018100400000000\n"
    done = subprocess.run([program, "replay", "ax188001@5", "--factory", "serial_number=7", "-"], input=request,
                          capture_output=True, text=True, timeout=120)
    assert done.returncode == 0 and "585#4318100407000000" in done.stdout, done
    _, _, err = call("run", "ax188001@5", "cbx-ao412@3", "--factory", "cbx-ao412.serial_number=7", "--seconds", "0.05")
    assert "no device" not in err, err
    assert "serial_number " in call("signals", "ax188001")[1]
    for given in ("serial=7", "serial_number=-1", "serial_number", "ax130751.serial_number=7"):
        for words in (("run", "ax188001@5", "--seconds", "0.05"), ("replay", "ax188001@5", "-"),
                      ("panel", "ax188001@5", "--port", "0")):
            status, out, err = call(*words, "--factory", given)
            assert status == 2 and out == "" and f"--factory {given}" in err, f"{words} {given}: {status} {out}{err}"


def part_numbers():
    """Checks that each part number is accepted as a device name, and that `canproof devices` says how the part numbers differ."""
    listed = call("devices")[1]
    for number in ("AX060835", "AX060840", "AX060841", "AX130771"):
        assert f"{number}: " in listed, listed
        status, _, err = call("run", f"{number.lower()}@5", "--seconds", "0.05")
        assert status == 0 and err.splitlines()[0] == f"{number.lower()}@5: node-ID 5", err


def workload_of_a_part_number():
    """Checks that `canproof inject` finds the workload of a device also by its part number, even if this contains a dot."""
    root = pathlib.Path(__file__).resolve().parents[2]
    results = [call("inject", name, "--faults", "1", "--root", str(root)) for name in ("cbx-ao412", "C.3040.02")]
    assert [one[0] for one in results] == [0, 0], results
    assert results[0][1].replace("cbx-ao412", "C.3040.02") == results[1][1], results


def unknown_commands():
    """Checks the error for an unknown or missing command: it must name the `--help` that lists the commands."""
    for words, told in ((["nosuch"], "there is no command `canproof nosuch`; `canproof --help` lists the commands"),
                        (["spec", "nosuch"], "there is no command `canproof spec nosuch`; `canproof spec --help` lists the commands"),
                        (["spec"], "`canproof spec` needs a command; `canproof spec --help` lists the commands"),
                        ([], "`canproof` needs a command; `canproof --help` lists the commands")):
        assert call(*words) == (2, "", f"canproof: {told}\n"), call(*words)


def one_word_each():
    """Checks that an option takes only one word. The word after that is a device, a file or another argument of the command."""
    with tempfile.TemporaryDirectory() as folder:
        eds = os.path.join(folder, "box.eds")
        with open(eds, "w") as out:
            out.write(call("eds", "ax188001")[1])
        status, _, err = call("run", "--eds", f"{eds}@7", "cbx-ao412@3", "--seconds", "0.05")
        assert status == 0 and sorted(err.splitlines())[-2:] == ["box@7: node-ID 7", "cbx-ao412@3: node-ID 3"], err
        listed = call("conform", "cbx-ao412", "--only=sync,emcy", "--skip=sync-producer-off", "--json")
        assert listed[0] == 0 and listed == call("conform", "--skip", "sync-producer-off", "--only", "sync", "--only", "emcy", "cbx-ao412", "--json"), listed
        status, out, err = call("conform", "--case", "nmt-power-on", "cbx-ao412")
        assert status == 0 and "nmt-power-on" in out, out + err
        outputs, drawing = os.path.join(folder, "out.csv"), os.path.join(folder, "out.svg")
        with open(outputs, "w") as out:
            out.write("seconds,signal,value\n0,aout1,0\n1,aout1,5\n")
        status, out, err = call("plot", "--signals", "aout1", outputs, drawing)
        assert status == 0 and os.path.exists(drawing), out + err
        status, out, err = call("fuzz", "--targets", "eds", "no-such-word")
        assert status == 2 and "no-such-word" in err, out + err


def folders_with_at():
    """Checks that an `@` in the name of a folder is not read as the beginning of a node-ID."""
    with tempfile.TemporaryDirectory() as folder:
        place = os.path.join(folder, "a@b")
        os.mkdir(place)
        eds = os.path.join(place, "box.eds")
        with open(eds, "w") as out:
            out.write(call("eds", "ax188001")[1])
        status, _, err = call("run", "--eds", f"{eds}@7", "--seconds", "0.05")
        assert status == 0 and "box@7: node-ID 7" in err.splitlines(), err
        status, out, err = call("run", "--eds", eds, "--seconds", "0.05")
        assert status == 0 and "cannot read" not in err, out + err
        assert call("replay", "--eds", eds, "-")[0] == 0
        assert call("conform", "--eds", eds, "--case", "nmt-power-on")[0] == 0
        for node in ("", "@7"):
            status, out, err = call("run", "--arm", f"{place}/no.elf{node}", "--seconds", "0")
            assert status == 2 and f"there is no image {place}/no.elf;" in err, out + err


def keywords():
    """Checks that `canproof new` refuses a device name that would become a keyword in C++."""
    with tempfile.TemporaryDirectory() as folder:
        for name in ("static-cast", "reinterpret-cast", "static-assert", "char16-t", "and-eq", "co-await", "requires", "int", "canopen"):
            done = subprocess.run([os.path.abspath(program), "new", name], stdin=subprocess.DEVNULL, capture_output=True,
                                  text=True, timeout=120, cwd=folder)
            assert done.returncode == 2 and f"`{name}` is a word of C++ or of canproof; choose another" in done.stderr, done
        assert os.listdir(folder) == [], os.listdir(folder)


def images():
    """Checks that a missing ARM image, and --arm together with another slave or a bus, are refused."""
    for words, why in ((("run", "--arm", "no.elf"), "there is no image no.elf"), (("conform", "--arm", "no.elf"), "there is no image no.elf"),
                       (("conform", "--arm", "no.elf", "--bus", "socketcan:can0"), "--arm runs the slave in virtual time"),
                       (("run", "--arm", "no.elf", "no-device"), "there is no device `no-device`"),
                       (("conform", "ax188001", "--arm", "no.elf"), "name the slave either by a device or by files")):
        status, out, err = call(*words)
        assert status == 2 and out == "" and why in err, f"{words}: {status} {out}{err}"


def version():
    """Checks that `canproof --version` prints the version that project() in CMakeLists.txt defines."""
    cmake = pathlib.Path(__file__).resolve().parents[2] / "CMakeLists.txt"
    wanted = re.search(r"project\(canproof VERSION (\S+)", cmake.read_text())[1]
    assert call("--version") == (0, f"canproof {wanted}\n", ""), call("--version")


version()
refused()
part_numbers()
workload_of_a_part_number()
factory()
named()
shared()
switches()
images()
keywords()
folders_with_at()
unknown_commands()
one_word_each()
print("version; node-IDs: refused, named, shared, switches; part numbers, factory data, images, commands, one word an option")
