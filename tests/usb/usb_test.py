#!/usr/bin/env python3
"""usb_test.py machine|service BUILD: the programs of a build on a real kernel's serial ports, in a small machine of its
own. machine: alone; service: as the package's unit, under Debian's systemd and udev."""
import os
import re
import sys
import tempfile
import time

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path.append(os.path.join(os.path.dirname(HERE), "support"))
import image  # noqa: E402
import kernel  # noqa: E402
import machine  # noqa: E402
import systemd  # noqa: E402
from verdict import check, find, skip  # noqa: E402

LIMIT_S = 800
# The script of each step, and the kernel options that it needs.
STEPS = {"machine": ("init.sh", ""),
         "service": ("service.sh", "rdinit=/lib/systemd/systemd systemd.unit=check.service systemd.show_status=off")}


def wanted(script):
    """The names of the checks that the guest runs."""
    with open(f"{HERE}/guest/{script}", encoding="utf-8") as file:
        return re.findall(r"^try (\S+)", file.read(), re.M)


def main(step, build):
    script, options = STEPS[step]
    for program, package in (("qemu-system-x86_64", "qemu-system-x86"), ("busybox", "busybox-static"),
                             ("cpio", "cpio"), ("socat", "socat"), ("depmod", "kmod")):
        find(program, package)
    if os.uname().machine != "x86_64":
        skip(f"the programs are for {os.uname().machine}, the machine is an x86_64")
    cache = os.path.join(build, "usb")
    folder = kernel.fetch(cache)
    service = systemd.fetch(cache) if step == "service" else ""
    with tempfile.TemporaryDirectory(prefix="tp100-usb-") as at:
        root = image.build(folder, os.path.join(build, "bin"), at + "/tree", service)
        began = time.monotonic()
        output = machine.boot(folder, root, at + "/log", LIMIT_S, options)
    print(output)
    print(f"{os.path.basename(folder)}: {time.monotonic() - began:.0f} s from boot to power-off")
    passed = re.findall(r"^ok (\S+)$", output, re.M)
    check(not (failed := re.findall(r"^FAILED (.*)", output, re.M)), "; ".join(failed))
    check(not (missing := [name for name in wanted(script) if name not in passed]), f"not made: {', '.join(missing)}")
    check(re.search(r"^guest: done$", output, re.M), "the machine ended before the last check")


if __name__ == "__main__":
    if len(sys.argv) != 3 or sys.argv[1] not in STEPS:
        sys.exit(f"usage: usb_test.py {'|'.join(STEPS)} BUILD")
    main(*sys.argv[1:])
