# SPDX-License-Identifier: Apache-2.0
"""Finds the packages that ./run, ./test and the scripts of the tests install, and compares them with reports/packages.toml."""
import json
import re

LISTS = re.compile(r"(?:^ *|\|\| )(?:packages\+?|missing\+)=\(([^)]*)\)", re.MULTILINE)
# apt-get install … --no-install-recommends NAMES, in a shell script or in the argument list of a Python script
APT = re.compile(r"\"?--no-install-recommends\"?,?\s+\"?([a-z0-9][a-z0-9+. -]*)")
KERNEL = re.compile(r"\"(linux-image-[a-z0-9-]+)\"")  # tests/socketcan unpacks the package of a kernel
NPM = re.compile(r"npm install\b[^\n]*\"(@?[a-z][a-z0-9/-]*)@")
WORD = re.compile(r"[a-z0-9][a-z0-9+.-]+")


def installed_by(script):
    """Returns the names of the packages that a script installs; those of npm begin with `npm:`."""
    names = set()
    for listed in LISTS.findall(script) + APT.findall(script) + KERNEL.findall(script):
        names |= {word for word in listed.split() if WORD.fullmatch(word)}
    return names | {f"npm:{name}" for name in NPM.findall(script)}


def locked_in(lock):
    """Returns the licence of each npm package that a lock file names at its top; also the locked packages without a licence."""
    packages = json.loads(lock)["packages"]
    top = packages[""]
    direct = {**top.get("dependencies", {}), **top.get("devDependencies", {})}
    licences = {f"npm:{name}": packages[f"node_modules/{name}"].get("license", "") for name in direct}
    return licences, sorted(name for name, one in packages.items() if name and not one.get("license"))


def faults_of_packages(scripts, locks, records):
    """Yields where scripts and lock files (texts by path) differ from the records of reports/packages.toml."""
    licences = {one["name"]: one.get("licence", "") for one in records.get("package", [])}
    installed = {name: path for path, text in scripts.items() for name in sorted(installed_by(text))}
    for path, text in locks.items():
        direct, without = locked_in(text)
        for name, licence in sorted(direct.items()):
            installed[name] = path
            if name in licences and licences[name] != licence:
                yield f"reports/packages.toml: has the licence `{licences[name]}` for {name}, and {path} has `{licence}`"
        for name in without:
            yield f"{path}: has no licence of {name}"
    for name in sorted(set(installed) - set(licences)):
        yield f"reports/packages.toml: has no record of {name}, which {installed[name]} installs; add its scope and licence"
    for name in sorted(set(licences) - set(installed)):
        yield f"reports/packages.toml: has a record of {name}, which nothing installs; remove it"


def blind_spots():
    """Yields what the comparison does not see in small examples."""
    lock = json.dumps({"packages": {"": {"devDependencies": {"x": "1"}}, "node_modules/x": {"license": "MIT"}, "node_modules/y": {}}})
    script = 'packages=(aa bb\n  c++)\n  packages+=(dd)  # ee\ncommand -v ff || missing+=(gg)\nnone || missing+=("$package")\n'
    if installed_by(script) != {"aa", "bb", "c++", "dd", "gg"}:
        yield f"licence_check: found {sorted(installed_by(script))} in a list of packages"
    for text, name in (("apt-get install -y --no-install-recommends nodejs >/dev/null", "nodejs"),
                       ('"apt-get", "install",\n  "--no-install-recommends", "tshark"]', "tshark"),
                       ('package_of("linux-image-amd64")', "linux-image-amd64"), ('npm install --prefix . "canopen@$version"', "npm:canopen")):
        if installed_by(text) != {name}:
            yield f"licence_check: found {sorted(installed_by(text))} in `{text}`, expected {name}"
    found = list(faults_of_packages({"run": "packages=(aa)"}, {"lock": lock}, {"package": [{"name": "npm:x", "licence": "ISC"}, {"name": "zz"}]}))
    if [fault.split()[-1] for fault in found] != ["`MIT`", "node_modules/y", "licence", "it"]:
        yield f"licence_check: a difference is not found: {found}"
