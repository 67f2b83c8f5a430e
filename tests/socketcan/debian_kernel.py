# SPDX-License-Identifier: Apache-2.0
"""Prepares the Debian kernel of the guest (the emulated computer): downloads it once, unpacks it, and makes an initial file system with its
modules."""
import gzip
import lzma
import os
import pathlib
import re
import shutil
import struct
import subprocess

MODULES = ["virtio_pci", "9pnet_virtio", "9p", "can-raw", "vcan", "vxcan", "kvaser_pci", "sch_tbf", "veth"]
SETUP_SECTORS, PAYLOAD_OFFSET, PAYLOAD_LENGTH = 0x1F1, 0x248, 0x24C  # offsets in a bzImage, Documentation/x86/boot.rst


def package_of(metapackage):
    """Returns the package with the kernel itself, whose name contains the current ABI number, or None if apt knows no such package."""
    depends = subprocess.run(["apt-cache", "depends", metapackage], capture_output=True, text=True).stdout
    found = re.search(r"Depends: (linux-image-[0-9]\S+)", depends)
    return found.group(1) if found else None


def fetch(folder):
    """Returns the folder of the unpacked kernel package below `folder`. Downloads and unpacks the package if this folder is missing."""
    name = package_of("linux-image-amd64")
    if name is None:
        subprocess.run([*([] if os.getuid() == 0 else ["sudo"]), "apt-get", "update", "-qq"], check=True)
        name = package_of("linux-image-amd64")
    unpacked = folder / name
    if not unpacked.is_dir():
        folder.mkdir(parents=True, exist_ok=True)
        for old in folder.glob("linux-image-*"):
            shutil.rmtree(old) if old.is_dir() else old.unlink()
        print(f"fetching {name}", flush=True)
        subprocess.run(["apt-get", "download", "-qq", "-o", "APT::Sandbox::User=root", name], cwd=folder, check=True)
        package = next(folder.glob("linux-image-*.deb"))
        partial = folder / "partial"
        shutil.rmtree(partial, ignore_errors=True)
        subprocess.run(["dpkg", "-x", package, partial], check=True)
        package.unlink()
        partial.rename(unpacked)
    return unpacked


def unpack_image(image):
    """Returns the ELF image inside a bzImage, so that the guest spends no time unpacking."""
    offset, length = struct.unpack_from("<II", image, PAYLOAD_OFFSET)
    start = (image[SETUP_SECTORS] + 1) * 512 + offset
    return lzma.LZMADecompressor(format=lzma.FORMAT_XZ).decompress(image[start:start + length])


def in_order(unpacked):
    """Returns the files of MODULES and of the modules that these need, in the order of their dependencies."""
    files = {file.stem.replace("_", "-"): file for file in unpacked.glob("lib/modules/*/kernel/**/*.ko")}
    built_in = {pathlib.Path(line).stem.replace("_", "-")
                for line in next(unpacked.glob("lib/modules/*/modules.builtin")).read_text().splitlines()}
    order = []

    def add(name):
        name = name.replace("_", "-")
        if name in built_in or files[name] in order:
            return
        depends = re.search(rb"\0depends=([^\0]*)\0", files[name].read_bytes()).group(1).decode()
        for other in filter(None, depends.split(",")):
            add(other)
        order.append(files[name])

    for module in MODULES:
        add(module)
    return order


def write_initramfs(modules, init, target):
    root = target.with_suffix(".tree")
    shutil.rmtree(root, ignore_errors=True)
    for folder in ["proc", "sys", "dev", "tmp", "etc", "usr", "repo", "modules"]:
        (root / folder).mkdir(parents=True)
    for link in ["bin", "sbin", "lib", "lib64"]:
        (root / link).symlink_to(f"usr/{link}")
    shutil.copy("/bin/busybox", root / "busybox")
    for number, module in enumerate(modules):
        shutil.copy(module, root / "modules" / f"{number:02}-{module.name}")
    shutil.copy(init, root / "init")
    (root / "init").chmod(0o755)
    names = subprocess.run(["find", ".", "-print0"], cwd=root, check=True, capture_output=True).stdout
    archive = subprocess.run(["cpio", "--null", "-o", "-H", "newc", "--quiet"], cwd=root, check=True, input=names,
                             capture_output=True).stdout
    target.write_bytes(gzip.compress(archive, 1))
    shutil.rmtree(root)


def prepare(folder, init):
    """Returns the files (kernel, initial file system) below `folder`. Makes them if they are missing or older than their sources."""
    unpacked = fetch(folder)
    kernel = unpacked / "vmlinux"
    if not kernel.exists():
        kernel.write_bytes(unpack_image(next(unpacked.glob("boot/vmlinuz-*")).read_bytes()))
    initramfs = unpacked / "initramfs"
    newest = max(init.stat().st_mtime, pathlib.Path(__file__).stat().st_mtime)
    if not initramfs.exists() or initramfs.stat().st_mtime < newest:
        write_initramfs(in_order(unpacked), init, initramfs)
    return kernel, initramfs
