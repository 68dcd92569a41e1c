"""A Debian in a folder, with or without systemd."""
import glob
import os
import re
import shutil
import subprocess
import tempfile

from host import need, run, skip


def mirror():
    """Address from which this machine's apt fetches Debian; empty if there is none."""
    for path in sorted(glob.glob("/etc/apt/sources.list.d/*.sources") + glob.glob("/etc/apt/sources.list.d/*.list")
                       + ["/etc/apt/sources.list"]):
        if not os.path.exists(path):
            continue
        with open(path, encoding="utf-8") as file:
            for line in file:
                found = re.match(r"(?:URIs:|deb(?:\s+\[[^]]*\])?)\s*(\S+/debian)/?(\s|$)", line)
                if found and "security" not in found[1]:
                    return found[1]
    return ""


def release():
    with open("/etc/os-release", encoding="utf-8") as file:
        return dict(re.findall(r'^(\w+)="?([^"\n]*)', file.read(), re.M)).get("VERSION_CODENAME", "")


class Machine:
    """A folder that contains a Debian; it is removed at the end. It may be of another architecture whose programs the
    kernel runs."""

    def __init__(self, architecture=None):
        need(("debootstrap", "debootstrap"), ("systemd-nspawn", "systemd-container"))
        if os.geteuid() != 0:
            skip("only root can make another Debian; run it as root")
        if not mirror() or not release():
            skip("no Debian mirror in /etc/apt; add one")
        self.folder = tempfile.mkdtemp(prefix="tp100-machine-")
        # Every user in the machine must be able to use its root folder.
        os.chmod(self.folder, 0o755)
        of = [f"--arch={architecture}"] if architecture else []
        made = subprocess.run(["debootstrap", "--variant=minbase", *of, release(), self.folder, mirror()], text=True,
                              stdout=subprocess.PIPE, stderr=subprocess.STDOUT, check=False)
        if made.returncode != 0:
            self.close()
            skip(f"debootstrap from {mirror()}: {' '.join(made.stdout.splitlines()[-1:])}")

    def close(self):
        shutil.rmtree(self.folder, ignore_errors=True)

    def path(self, inside):
        return self.folder + inside

    def write(self, inside, text):
        with open(self.path(inside), "w", encoding="utf-8") as file:
            file.write(text)

    def read(self, inside):
        with open(self.path(inside), encoding="utf-8") as file:
            return file.read()

    def nspawn(self, *rest, **more):
        output = run("systemd-nspawn", "--quiet", "--directory=" + self.folder, "--register=no", "--keep-unit", *rest,
                     **more)
        # This message comes from nspawn's clean-up where /run is no separate file system.
        return re.sub(r"^Attempted to remove disk file system .*\n", "", output, flags=re.M)

    def shell(self, script, good=True):
        return self.nspawn("--pipe", "--setenv=DEBIAN_FRONTEND=noninteractive", "sh", "-ec", script, good=good)

    def boot(self, script):
        """Starts systemd, runs `script` as a service and returns what it printed."""
        self.write("/run.sh", script)
        self.write("/etc/systemd/system/run.service",
                   "[Service]\nType=oneshot\nExecStart=/bin/sh -x /run.sh\nExecStopPost=systemctl poweroff\n"
                   "TimeoutStartSec=100\nStandardOutput=file:/run.log\nStandardError=file:/run.log\n")
        self.nspawn("--private-network", "--boot", "systemd.unit=run.service", good=False, timeout=150)
        return self.read("/run.log") if os.path.exists(self.path("/run.log")) else ""
