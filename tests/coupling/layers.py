# SPDX-License-Identifier: Apache-2.0
"""The layers of the firmware. A unit is named by the path of its header and .cpp from the project's folder, without an
ending."""
import pathlib
import re

ROOT = pathlib.Path(__file__).resolve().parents[2]


def layer_of(unit):
    """Returns the layer of a unit: `base`, `canopen`, `blocks`, `ax188001`, `blocks of ax188001` or `drivers`; None for
    a unit outside the firmware."""
    shared = re.match(r"src/firmware/(\w+)/", unit)
    if shared:
        return shared.group(1)
    own = re.match(r"src/devices/([^/]+)/firmware/(.*)", unit)
    if own:
        name = own.group(1)
        return name if own.group(2).startswith(name.replace("-", "_")) else f"blocks of {name}"
    return "drivers" if unit.startswith(("src/target/stm32f405/", "src/target/zynqmp/")) else None


def is_downward(upper, lower):
    """Returns whether `upper` may call `lower`. A device may call everything except another device. A driver may call the
    shared firmware. Every layer may call base."""
    if upper == lower or lower == "base":
        return True
    if upper in ("base", "blocks", "canopen"):
        return False
    if upper == "drivers":
        return lower == "canopen"
    if upper.startswith("blocks of "):
        return lower == "blocks"
    return lower in ("canopen", "blocks", f"blocks of {upper}")
