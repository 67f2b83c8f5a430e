# SPDX-License-Identifier: Apache-2.0
"""The layers of the firmware. A unit is named by the path of its header and .cpp from the project's folder, without an
ending."""
import pathlib
import re

ROOT = pathlib.Path(__file__).resolve().parents[2]

# The kinds of layers that each kind may call and whose data it may write, besides base and itself. A layer whose kind ends with "of"
# belongs to one device, as does a device.
BELOW_IMAGE = ("main loop", "wiring of", "device", "data of", "drivers", "canopen")
BELOW = {
    "base": (),
    "canopen": (),
    "blocks": (),
    "data of": ("canopen",),
    "blocks of": ("data of", "blocks"),
    "device": ("blocks of", "data of", "blocks", "canopen"),
    "drivers": ("canopen",),
    "wiring of": ("data of", "drivers"),
    "main loop": ("wiring of", "device", "data of", "drivers", "canopen"),
    "image": BELOW_IMAGE,
    "image of": ("image", *BELOW_IMAGE),
}
# Variables outside of objects, with the file that defines them and the reason.
OUTSIDE = {
    "image": ("src/devices/NAME/target/device.cpp", "the object that holds a device and its drivers as long as the power is on"),
    "kept": ("src/target/image/memory.cpp", "the record of a failed self-test: a reset by the watchdog keeps it"),
}


def is_generated(unit):
    return unit.startswith("generated/")


def reason_outside(name, place):
    """Returns why a variable may be outside of objects; None when it may not. `place`: file:line."""
    file, reason = OUTSIDE.get(name, ("", None))
    return reason if re.fullmatch(file.replace("NAME", "[^/]+") + r":\d+", place) else None


def layer_of(unit):
    """Returns the layer of a unit: `base`, `canopen`, `blocks`, `ax188001`, `blocks of ax188001`, `data of ax188001`, `drivers`,
    `wiring of ax188001`, `main loop`, `image` or `image of ax188001`; None for a unit outside of the firmware."""
    shared = re.match(r"src/firmware/(\w+)/", unit)
    if shared:
        return shared.group(1)
    generated = re.match(r"generated/(\w+)/(signals|profile)$", unit)
    if generated:
        return f"data of {generated.group(1).replace('_', '-')}"
    own = re.match(r"src/devices/([^/]+)/(firmware|target)/(.*)", unit)
    if own:
        return layer_in_device(*own.groups())
    if f"{unit}.hpp" == "src/target/stm32f405/device_loop.hpp":
        return "main loop"
    if unit.startswith("src/target/image/"):
        return "image"
    return "drivers" if unit.startswith(("src/target/stm32f405/", "src/target/zynqmp/")) else None


def layer_in_device(name, folder, unit):
    if folder == "firmware":
        return name if unit.startswith(name.replace("-", "_")) else f"blocks of {name}"
    if unit == "main":  # an image for measurements only
        return None
    return f"image of {name}" if unit == "device" else f"wiring of {name}"


def kind_of(layer):
    """Returns the kind of a layer and its device; the device is empty for a layer that all devices share."""
    if layer in BELOW:
        return layer, ""
    found = re.fullmatch(r"(\w+ of) (.*)", layer)
    return found.groups() if found else ("device", layer)


def is_downward(upper, lower):
    """Returns whether `upper` may call `lower` and write its data. A layer of one device never calls a layer of another device."""
    if upper == lower or lower == "base":
        return True
    (kind, device), (lower_kind, lower_device) = kind_of(upper), kind_of(lower)
    return lower_kind in BELOW[kind] and (not device or not lower_device or device == lower_device)
