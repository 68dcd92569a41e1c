"""Debian's systemd and udev, unpacked in a folder and reduced to what starts a service and names a device."""
import glob
import os
import shutil
import tempfile

import apt
from verdict import run

PACKAGES = ("systemd", "libsystemd-shared", "udev")
PROGRAMS = ("bin/systemctl", "bin/journalctl", "bin/udevadm", "bin/systemd-sysusers", "lib/systemd/systemd",
            "lib/systemd/systemd-journald")
AT_BOOT = ("systemd-journald.service", "systemd-udevd.service", "systemd-udev-trigger.service")
LIBRARIES = "/usr/lib/x86_64-linux-gnu/systemd"


def cut_down(tree, kept):
    shutil.copytree(tree + "/lib/systemd/system", kept + "/lib/systemd/system", symlinks=True)
    shutil.copytree(tree + "/lib/udev/rules.d", kept + "/lib/udev/rules.d")
    shutil.copytree(tree + LIBRARIES, kept + LIBRARIES)
    for program in PROGRAMS:
        os.makedirs(os.path.dirname(f"{kept}/{program}"), exist_ok=True)
        shutil.copy(f"{tree}/{program}", f"{kept}/{program}")
    os.symlink("/bin/udevadm", kept + "/lib/systemd/systemd-udevd")
    for link in glob.glob(kept + "/lib/systemd/system/*.target.wants/*"):
        if os.path.basename(link) not in AT_BOOT:
            os.remove(link)


def fetch(cache):
    """The folder of systemd in `cache`."""
    os.makedirs(cache, exist_ok=True)
    folder = os.path.join(cache, "systemd")
    if not os.path.isdir(folder):
        with tempfile.TemporaryDirectory(dir=cache) as at:
            tree, kept, debs = at + "/tree", at + "/kept", at + "/debs"
            os.makedirs(debs)
            for deb in apt.download(PACKAGES, debs):
                run("dpkg-deb", "-x", deb, tree)
            cut_down(tree, kept)
            os.rename(kept, folder)
    return folder
