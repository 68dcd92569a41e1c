"""Debian's kernel and the modules that the test needs, unpacked in a folder without being installed."""
import os
import re
import shutil
import tempfile

import apt
from verdict import check, find, run, skip

MODULES = ("dummy_hcd", "libcomposite", "usb_f_acm", "cdc_acm", "ftdi_sio", "xhci_pci", "usbmon")


def package():
    """The package to which linux-image-amd64 refers at present; empty if apt knows none."""
    _, output = run(find("apt-cache", "apt"), "depends", "linux-image-amd64", good=False)
    found = re.search(r"Depends: (linux-image-\d\S+)", output)
    return found[1] if found else ""


def with_needs(tree, version):
    """Paths of the modules and of all their dependencies below lib/modules/VERSION."""
    needs = {}
    with open(f"{tree}/lib/modules/{version}/modules.dep", encoding="utf-8") as file:
        for line in file:
            path, rest = line.split(":", maxsplit=1)
            needs[re.sub(r"\.ko(\.\w+)?$", "", os.path.basename(path)).replace("-", "_")] = [path, *rest.split()]
    missing = [module for module in MODULES if module not in needs]
    check(not missing, f"the kernel {version} has no module {', '.join(missing)}; name others in tests/usb/kernel.py")
    return sorted({path for module in MODULES for path in needs[module]})


def unpack(deb, folder):
    """Makes `folder` with vmlinuz and lib/modules, completely or not at all."""
    depmod = find("depmod", "kmod")
    with tempfile.TemporaryDirectory(dir=os.path.dirname(folder)) as at:
        tree, kept = at + "/tree", at + "/kept"
        run("dpkg-deb", "-x", deb, tree)
        version = os.listdir(tree + "/lib/modules")[0]
        run(depmod, "-b", tree, version)
        for path in with_needs(tree, version):
            to = f"{kept}/lib/modules/{version}/{path}"
            os.makedirs(os.path.dirname(to), exist_ok=True)
            shutil.copy(f"{tree}/lib/modules/{version}/{path}", to)
        for name in ("modules.order", "modules.builtin", "modules.builtin.modinfo"):
            shutil.copy(f"{tree}/lib/modules/{version}/{name}", f"{kept}/lib/modules/{version}")
        run(depmod, "-b", kept, version)
        shutil.copy(f"{tree}/boot/vmlinuz-{version}", kept + "/vmlinuz")
        os.rename(kept, folder)


def fetch(cache):
    """The folder with Debian's kernel in `cache`, or with an older one if apt does not know the current one."""
    os.makedirs(cache, exist_ok=True)
    old = sorted(name for name in os.listdir(cache) if name.startswith("linux-image-"))
    wanted = package()
    if not wanted and not old:
        skip("apt knows no linux-image-amd64; on a Debian, run apt-get update")
    folder = os.path.join(cache, wanted or old[-1])
    if os.path.isdir(folder):
        return folder
    with tempfile.TemporaryDirectory(dir=cache) as at:
        unpack(apt.download([wanted], at)[0], folder)
    return folder
