"""The root file system of the small machine: busybox, modules, the programs of a build with their libraries."""
import os
import re
import shutil

from host import ROOT, find, run

HERE = os.path.dirname(os.path.abspath(__file__))


def add(tree, program, to):
    """A program with the libraries that it is linked with, without what only a debugger reads."""
    shutil.copy(program, tree + to)
    if shutil.which("strip"):
        run("strip", "--strip-debug", tree + to)
    _, said = run("ldd", program, good=False)
    for library in re.findall(r"(/\S+) \(0x", said):
        if not os.path.exists(tree + library):
            os.makedirs(os.path.dirname(tree + library), exist_ok=True)
            shutil.copy(os.path.realpath(library), tree + library)


def build(kernel, programs, tree):
    """Makes `tree` and beside it tree.cpio, which is returned. `programs`: the build's folder of programs."""
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
    run("sh", "-c", 'find . | "$0" --quiet -R +0:+0 -H newc -o > ../tree.cpio', find("cpio", "cpio"), cwd=tree)
    return os.path.join(os.path.dirname(tree), "tree.cpio")
