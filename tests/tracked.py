# SPDX-License-Identifier: Apache-2.0
"""Lists the files of the project, for the checks in this folder."""
import subprocess


def tracked(root):
    """Returns the paths of all existing files below `root` that git tracks or would add."""
    done = subprocess.run(["git", "-C", root, "ls-files", "--cached", "--others", "--exclude-standard"],
                          capture_output=True, text=True, check=True)
    return [name for name in done.stdout.splitlines() if (root / name).exists()]
