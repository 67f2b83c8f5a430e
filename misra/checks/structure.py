"""What no single file shows: the arrows between the layers, and the symbols that the firmware library needs."""
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
    """Whether a firmware file may include a header; both are named from the folder of sources.

    The arrows: base <- canopen, blocks <- the devices; base, canopen <- the drivers. A device knows no other device and
    nothing outside the firmware. Blocks know no object dictionary and no device. In a device's folder the files that carry the device's name
    are the device; every other file there is a block of it."""
    parts = path.split("/")
    dictionary = name.startswith("generated/canopen/") or name.endswith("/objects.hpp")
    if parts[0] == "firmware":
        return name.startswith(LAYERS.get(parts[1], ())) and not (parts[1] == "blocks" and dictionary)
    if parts[0] == "target":
        return name.startswith(("firmware/base/", "firmware/canopen/", "generated/canopen/", "target/stm32f405/"))
    device = parts[1].replace("-", "_")
    own = f"devices/{parts[1]}/firmware/"
    if parts[-1].startswith(device):
        return name.startswith(("firmware/", own, f"generated/{device}/", "generated/canopen/"))
    return (name.startswith(("firmware/base/", "firmware/blocks/", own, f"generated/{device}/"))
            and not dictionary and not name.startswith(own + device))


def against_the_layers(folder):
    """Includes against the arrows in folder/firmware, folder/devices/*/firmware and folder/target/stm32f405."""
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
        faults.add("the include check does not flag just the marked lines of misra/layers/bad")
    for path, at in against_the_layers(ROOT / "src"):
        faults.add(f"{os.path.relpath(path, ROOT)}:{at}: an include against the layers")


# Allocation, exceptions, run-time type information, ending the program, and the floating-point environment (no trap is
# enabled, no rounding mode changed): what the firmware must not pull in.
FORBIDDEN = re.compile(
    r"^(?:malloc|calloc|realloc|free|aligned_alloc|_Zn[wa]\w*|_Zd[la]\w*|__cxa_(?!pure_virtual|guard_)\w*|__gxx_personality\w*|"
    r"_Unwind_\w*|__dynamic_cast|_ZSt\d+__throw_\w*|_ZSt9terminatev|abort|exit|printf|puts|fe[a-z]\w*)$")


def archives(build):
    """The libraries of the firmware: that of all devices, one a device, and that of the drivers."""
    devices = sorted(folder.parent.name for folder in (ROOT / "src").glob("devices/*/firmware"))
    source = pathlib.Path(build) / ("src" if ROOT == HOME else "package/src")  # as canproof_project() has it
    drivers = [source / "target" / "stm32f405" / "libcanproof_stm32f405.a"] if ROOT == HOME else []
    return [source / "firmware" / "libcanproof_firmware.a", *drivers,
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
            faults.add(f"the symbol check misses what misra/symbols/bad.cpp holds: {names} {output}")
    for archive in archives(build):
        if not archive.exists():
            faults.add(f"{archive} is not built: its symbols are unchecked")
            continue
        for name in forbidden_symbols(archive):
            faults.add(f"the firmware library {archive.name} needs {name}")
