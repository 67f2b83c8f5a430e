# SPDX-License-Identifier: Apache-2.0
"""Checks properties of the whole firmware: the includes between layers, and the symbols that its libraries need."""
import os
import pathlib
import re
import tempfile

from .rules import HERE, HOME, ROOT, firmware_files, run_tool


LAYERS = {
    "base": ("firmware/base/",),
    "canopen": ("firmware/base/", "firmware/canopen/", "generated/"),
    "blocks": ("firmware/base/", "firmware/blocks/", "generated/"),
}


def may_include(path, name):
    """Returns whether a firmware file may include a header; both paths are relative to the folder of sources.

    `canopen` and `blocks` may include `base`; devices may include all three. Drivers may include `base`, `canopen` and the drivers
    of the first port (stm32f405). Drivers of the second port (zynqmp) may also include each other. A device includes no other
    device and nothing outside the firmware. The wiring of a device may include the device and the drivers. Blocks include no object dictionary and no device. In a device's folder, the files
    with the device's name are the device, and every other file is a block of it."""
    parts = path.split("/")
    dictionary = name.startswith("generated/canopen/") or name.endswith("/objects.hpp")
    if parts[0] == "firmware":
        return name.startswith(LAYERS.get(parts[1], ())) and not (parts[1] == "blocks" and dictionary)
    if parts[0] == "target":
        return name.startswith(("firmware/base/", "firmware/canopen/", "generated/canopen/", "target/stm32f405/", f"target/{parts[1]}/"))
    if parts[2] == "target":  # the wiring of a device
        return name.startswith((f"devices/{parts[1]}/firmware/", "firmware/base/", "generated/canopen/", "target/stm32f405/"))
    device = parts[1].replace("-", "_")
    own = f"devices/{parts[1]}/firmware/"
    if parts[-1].startswith(device):
        return name.startswith(("firmware/", own, f"generated/{device}/", "generated/canopen/"))
    return (name.startswith(("firmware/base/", "firmware/blocks/", own, f"generated/{device}/"))
            and not dictionary and not name.startswith(own + device))


def against_the_layers(folder):
    """Yields the includes that violate the layers in folder/firmware, folder/devices/*/firmware and the drivers' folders."""
    for path in firmware_files(folder, "*.?pp"):
        for at, text in enumerate(path.read_text().splitlines(), 1):
            include = re.match(r'\s*#\s*include\s*"([^"]+)"', text)
            if include is not None and not may_include(path.relative_to(folder).as_posix(), include.group(1)):
                yield str(path), at


def check_layers(faults):
    bad = HERE / "layers" / "bad"
    expected = {
        (str(path), at)
        for path in bad.rglob("*.?pp")
        for at, text in enumerate(path.read_text().splitlines(), 1)
        if "// flagged" in text
    }
    if not expected or set(against_the_layers(bad)) != expected:
        faults.add("the check of includes does not flag exactly the marked lines of misra/layers/bad")
    for path, at in against_the_layers(ROOT / "src"):
        faults.add(f"{os.path.relpath(path, ROOT)}:{at}: this include violates the layers (may_include() in misra/checks/structure.py)")


# Symbols that the firmware must not need: allocation, exceptions, run-time type information, termination of the
# program, and the floating-point environment, because the firmware enables no floating-point trap and changes no
# rounding mode.
FORBIDDEN = re.compile(
    r"^(?:malloc|calloc|realloc|free|aligned_alloc|_Zn[wa]\w*|_Zd[la]\w*|__cxa_(?!pure_virtual|guard_)\w*|__gxx_personality\w*|"
    r"_Unwind_\w*|__dynamic_cast|_ZSt\d+__throw_\w*|_ZSt9terminatev|abort|exit|printf|puts|fe[a-z]\w*)$")


def archives(build):
    """Returns the libraries of the firmware: those of the shared layers, one per device, and those of the drivers."""
    devices = sorted(folder.parent.name for folder in (ROOT / "src").glob("devices/*/firmware"))
    source = pathlib.Path(build) / ("src" if ROOT == HOME else "package/src")  # another project: canproof is in package
    ports = ("stm32f405", "zynqmp") if ROOT == HOME else ()
    drivers = [source / "target" / port / f"libcanproof_{port}.a" for port in ports]
    shared = [source / "firmware" / f"libcanproof_firmware_{layer}.a" for layer in ("base", "canopen")]
    return [*shared, *drivers,
            *(source / "devices" / name / f"libcanproof_{name.replace('-', '_')}_firmware.a" for name in devices)]


def forbidden_symbols(archive):
    _, output = run_tool(["nm", "--undefined-only", "--format=just-symbols", str(archive)])
    return sorted({name for name in output.split() if FORBIDDEN.match(name)})


def check_symbols(build, faults):
    with tempfile.TemporaryDirectory() as scratch:
        seeded = pathlib.Path(scratch) / "bad.o"
        status, output = run_tool(["g++", "-std=c++17", "-c", str(HERE / "symbols" / "bad.cpp"), "-o", str(seeded)])
        names = forbidden_symbols(seeded) if status == 0 else []
        if not {"_Znwm", "__cxa_throw", "__dynamic_cast", "feenableexcept"} <= set(names):
            faults.add(f"the check of symbols does not report all forbidden symbols of misra/symbols/bad.cpp, only {names} {output}")
    for archive in archives(build):
        if not archive.exists():
            faults.add(f"{archive} is not built, so its symbols are unchecked; build it with `./run build`")
            continue
        for name in forbidden_symbols(archive):
            faults.add(f"the firmware library {archive.name} needs the forbidden symbol {name}")
