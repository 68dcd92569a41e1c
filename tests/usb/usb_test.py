#!/usr/bin/env python3
"""usb_test.py BUILD: the programs of a build on a real kernel's serial ports, in a small machine of its own."""
import os
import re
import sys
import tempfile
import time

import image
import kernel
import machine
from host import check, find, skip

HERE = os.path.dirname(os.path.abspath(__file__))
LIMIT_S = 600


def wanted():
    """The checks that guest/init.sh makes."""
    with open(HERE + "/guest/init.sh", encoding="utf-8") as file:
        return re.findall(r"^try (\S+)", file.read(), re.M)


def main(build):
    for program, package in (("qemu-system-x86_64", "qemu-system-x86"), ("busybox", "busybox-static"),
                             ("cpio", "cpio"), ("socat", "socat"), ("depmod", "kmod")):
        find(program, package)
    if os.uname().machine != "x86_64":
        skip(f"the programs are for {os.uname().machine}, the machine is an x86_64")
    folder = kernel.fetch(os.path.join(build, "usb"))
    with tempfile.TemporaryDirectory(prefix="tp100-usb-") as at:
        root = image.build(folder, os.path.join(build, "bin"), at + "/tree")
        began = time.monotonic()
        said = machine.boot(folder, root, at + "/log", LIMIT_S)
    print(said)
    print(f"{os.path.basename(folder)}: {time.monotonic() - began:.0f} s from boot to power-off")
    passed = re.findall(r"^ok (\S+)$", said, re.M)
    check(not (failed := re.findall(r"^FAILED (.*)", said, re.M)), "; ".join(failed))
    check(not (missing := [name for name in wanted() if name not in passed]), f"not made: {', '.join(missing)}")
    check(re.search(r"^guest: done$", said, re.M), "the machine ended before the last check")


if __name__ == "__main__":
    if len(sys.argv) != 2:
        sys.exit("usage: usb_test.py BUILD")
    main(sys.argv[1])
