# SPDX-License-Identifier: Apache-2.0
"""Builds plugins of QEMU."""
import pathlib
import subprocess

SRC = pathlib.Path(__file__).resolve().parents[2]


def build_plugin(source, folder):
    """Compiles a plugin into the folder. Returns the path of the plugin."""
    plugin = folder / f"{source.stem}.so"
    subprocess.run(["g++", "-std=c++17", "-O2", "-shared", "-fPIC", "-I", SRC, source, "-o", plugin], check=True)
    return plugin
