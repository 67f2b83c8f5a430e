# SPDX-License-Identifier: Apache-2.0
"""The names in C++ of the symbols of an image."""
import subprocess


def demangle(symbols, *options):
    """Returns the names by symbol. `options`: those of c++filt, such as -p for names without parameters."""
    symbols = list(symbols)
    done = subprocess.run(["arm-none-eabi-c++filt", *options], input="\n".join(symbols), text=True, check=True, capture_output=True)
    return dict(zip(symbols, done.stdout.splitlines()))
