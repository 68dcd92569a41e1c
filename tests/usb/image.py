"""The root file system of the small machine: busybox, modules, the programs of a build with their libraries."""
import os
import re
import shutil

from verdict import ROOT, find, run
from systemd import LIBRARIES, PROGRAMS

HERE = os.path.dirname(os.path.abspath(__file__))


def add(tree, program, to):
    """Adds a program with the libraries that it is linked with, without debug information."""
    shutil.copy(program, tree + to)
    if shutil.which("strip"):
        run("strip", "--strip-debug", tree + to)
    _, output = run("ldd", program, good=False)
    add_libraries(tree, re.findall(r"(/\S+) \(0x", output))


def add_libraries(tree, libraries):
    for library in libraries:
        if not os.path.exists(tree + library):
            os.makedirs(os.path.dirname(tree + library), exist_ok=True)
            shutil.copy(os.path.realpath(library), tree + library)


def add_service(tree, systemd):
    """Adds what is needed to run tp100d as a service, and the package's files for it. `systemd`: the folder of
    systemd.fetch."""
    shutil.copytree(systemd, tree, symlinks=True, dirs_exist_ok=True)
    where = dict(os.environ, LD_LIBRARY_PATH=systemd + LIBRARIES)
    for program in PROGRAMS:
        _, output = run("ldd", f"{systemd}/{program}", good=False, env=where)
        add_libraries(tree, [path for path in re.findall(r"(/\S+) \(0x", output) if not path.startswith(systemd)])
    _, output = run(tree + "/bin/busybox", "--list")
    for applet in output.split():
        if not os.path.lexists(f"{tree}/bin/{applet}"):
            os.symlink("busybox", f"{tree}/bin/{applet}")
    for folder in ("sbin", "run", "root", "var/tmp", "var/lib", "usr/bin", "usr/lib/sysusers.d", "etc/tp100"):
        os.makedirs(f"{tree}/{folder}", exist_ok=True)
    os.symlink("/bin/busybox", tree + "/sbin/modprobe")
    os.symlink("/bin/tp100d", tree + "/usr/bin/tp100d")
    shutil.copy(ROOT + "/config/systemd/tp100d@.service", tree + "/lib/systemd/system")
    shutil.copy(ROOT + "/config/systemd/tp100.conf", tree + "/usr/lib/sysusers.d")
    for rules in ("64-tp100-bridges", "65-tp100"):
        shutil.copy(f"{ROOT}/config/udev/{rules}.rules", tree + "/guest")
    os.makedirs(tree + "/etc/udev/rules.d", exist_ok=True)
    shutil.copy(ROOT + "/scripts/debian/postinst", tree + "/guest")
    shutil.copy(HERE + "/guest/check.service", tree + "/lib/systemd/system")
    # No driver for the bridge is loaded before a check requests it.
    os.makedirs(tree + "/etc/modprobe.d")
    with open(tree + "/etc/modprobe.d/later.conf", "w", encoding="utf-8") as file:
        file.write("blacklist ftdi_sio\n")
    with open(tree + "/etc/passwd", "w", encoding="utf-8") as file:
        file.write("root:x:0:0::/root:/bin/sh\nnobody:x:65534:65534::/tmp:/bin/sh\n")
    with open(tree + "/etc/group", "w", encoding="utf-8") as file:
        file.write("root:x:0:\ntty:x:5:\ndialout:x:20:\nnogroup:x:65534:\n")


def build(kernel, programs, tree, systemd=""):
    """Makes `tree` and, beside it, tree.cpio, which is returned. `programs`: the build's folder of programs. `systemd`:
    empty, or the folder of systemd.fetch; then the machine can run tp100d as a service."""
    for folder in ("bin", "dev", "proc", "sys", "tmp", "etc", "share"):
        os.makedirs(f"{tree}/{folder}")
    shutil.copytree(kernel + "/lib", tree + "/lib")
    shutil.copy(find("busybox", "busybox-static"), tree + "/bin/busybox")
    os.symlink("busybox", tree + "/bin/sh")
    add(tree, find("socat", "socat"), "/bin/socat")
    for program in ("tp100d", "tp100-sim"):
        add(tree, os.path.join(programs, program), "/bin/" + program)
    shutil.copytree(ROOT + "/config", tree + "/share/tp100")
    shutil.copytree(HERE + "/guest", tree + "/guest")
    os.symlink("guest/init.sh", tree + "/init")
    os.chmod(tree + "/guest/init.sh", 0o755)
    if systemd:
        add_service(tree, systemd)
    run("sh", "-c", 'find . | "$0" --quiet -R +0:+0 -H newc -o > ../tree.cpio', find("cpio", "cpio"), cwd=tree)
    return os.path.join(os.path.dirname(tree), "tree.cpio")
