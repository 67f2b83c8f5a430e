"""What no single file shows: the arrows between the layers, and the symbols that the firmware library needs."""
import os
import pathlib
import re
import tempfile

from .rules import HERE, ROOT, run_tool


def against_the_layers(folder):
    """Includes against the arrows base ← canopen, blocks ← devices, under folder/firmware; blocks know no object dictionary."""
    allowed = {
        "base": ("firmware/base/",),
        "canopen": ("firmware/base/", "firmware/canopen/", "generated/"),
        "blocks": ("firmware/base/", "firmware/blocks/", "generated/"),
        "devices": ("firmware/", "generated/"),
    }
    for path in sorted((folder / "firmware").rglob("*.?pp")):
        layer = path.relative_to(folder / "firmware").parts[0]
        for at, text in enumerate(path.read_text().splitlines(), 1):
            include = re.match(r'\s*#\s*include\s*"([^"]+)"', text)
            if include is None:
                continue
            name = include.group(1)
            dictionary = name.startswith("generated/canopen/") or name.endswith("/objects.hpp")
            if not name.startswith(allowed.get(layer, ())) or (layer == "blocks" and dictionary):
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
    archive = pathlib.Path(build) / "libcanproof_firmware.a"
    if not archive.exists():
        faults.add(f"{archive} is not built: the symbols are unchecked")
        return
    for name in forbidden_symbols(archive):
        faults.add(f"the firmware library needs {name}")
