# SPDX-License-Identifier: Apache-2.0
"""The files of the project, for the checks beside this file."""
import subprocess


def tracked(root):
    """Returns the paths of all files below `root` that git tracks or would add, without those that are gone."""
    done = subprocess.run(["git", "-C", root, "ls-files", "--cached", "--others", "--exclude-standard"],
                          capture_output=True, text=True, check=True)
    return [name for name in done.stdout.splitlines() if (root / name).exists()]
