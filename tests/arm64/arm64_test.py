#!/usr/bin/env python3
"""arm64_test.py STEP BUILD: one test of the build for 64-bit ARM, compared with this machine's build."""
import glob
import json
import os
import shutil
import subprocess
import sys
import tempfile
import time

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path.append(os.path.join(os.path.dirname(HERE), "package"))
import container_test  # noqa: E402
from host import ROOT, check, need, package, run, skip  # noqa: E402
from install_test import APT, CONFIG, newer, upgrade_and_purge  # noqa: E402
from machine import Machine  # noqa: E402

ARM64 = ROOT + "/build/arm64"
# Programs that qemu-user runs (scripts/cmake/Package.cmake).
EMULATED = ARM64 + "/emulated/"
FLAT = ("1-straight", "1-curve", "1-sharp", "2", "3")
# ODE's own build fuses on ARM, so that the emulated robot differs from the first step on.
LARGEST_DIFFERENCE = 1e-9
# qemu-user does not have the socket options of multicast: Cyclone DDS announces itself to the ports of 127.0.0.1.
WITHOUT_MULTICAST = (
    '<CycloneDDS><Domain id="any"><General><Interfaces><NetworkInterface name="lo" multicast="false"/></Interfaces>'
    '<AllowMulticast>false</AllowMulticast></General><Discovery><ParticipantIndex>auto</ParticipantIndex>'
    '<Peers><Peer address="127.0.0.1"/></Peers></Discovery></Domain></CycloneDDS>')
BINFMT = "/proc/sys/fs/binfmt_misc"


def make(_build):
    need(("apt-get", "apt"))
    print(run(ROOT + "/scripts/package", "--arch", "arm64")[-2000:])
    deb, camera = package(ARM64), package(ARM64, "tp100-camera")
    for each in (deb, camera):
        check(run("dpkg-deb", "-f", each, "Architecture").strip() == "arm64", f"{each}: of another architecture")
    depends = run("dpkg-deb", "-f", camera, "Depends")
    check("libopencv-imgproc406" in depends, f"tp100-camera does not depend on OpenCV: {depends}")
    depends = run("dpkg-deb", "-f", deb, "Depends")
    for library in ("libc6 (>= ", "libddsc0debian", "libode8", "libserialport0", "libsimavr2", "libstdc++6", "libzstd1"):
        check(library in depends, f"the package does not depend on {library}: {depends}")
    there = run("dpkg-deb", "-c", deb)
    for path in ("bin/tp100d", "bin/tp100-sim", "share/tp100/tp100.hex", "share/man/man1/tp100d.1.gz",
                 "share/bash-completion/completions/tp100-sim"):
        check(f" ./usr/{path}\n" in there, f"the package has no /usr/{path}")


def unit(_build):
    print(run(ROOT + "/scripts/build", "arm64")[-500:])
    tested = run("ctest", "--preset", "arm64", "--label-regex", "^(unit|fuzz)$",
                 "--label-exclude", "^(all|nightly|realtime)$", "--parallel", str(os.cpu_count()), "--output-on-failure",
                 cwd=ROOT)
    print(tested[-1500:])
    ran = int(tested.rsplit(" tests failed out of ", 1)[1].split()[0])
    check(ran > 1000, f"only {ran} unit tests ran")


def results(program, course):
    """All results of a course by name, except those that depend on this machine's time."""
    def flat(value, name):
        if isinstance(value, dict):
            for key, inner in value.items():
                if "time" not in key and key != "loop":
                    yield from flat(inner, f"{name}.{key}")
        elif isinstance(value, list):
            for i, inner in enumerate(value):
                yield from flat(inner, f"{name}[{i}]")
        else:
            yield name.removeprefix("."), value
    return dict(flat(json.loads(run(program, "course", course, "--json")), ""))


def courses(build):
    for course in FLAT:
        ours = results(build + "/bin/tp100-sim", course)
        began = time.monotonic()
        theirs = results(EMULATED + "tp100-sim", course)
        took_s = time.monotonic() - began
        check(ours.keys() == theirs.keys(), f"{course}: other results: {ours.keys() ^ theirs.keys()}")
        check(ours["completed"] is True, f"{course}: not completed")
        largest, where, differ = 0.0, "", 0
        for name, value in ours.items():
            differ += value != theirs[name]
            if isinstance(value, (int, float)) and not isinstance(value, bool):
                apart = abs(value - theirs[name])
                if apart > largest:
                    largest, where = apart, name
            else:
                check(value == theirs[name], f"{course}: {name} is {theirs[name]}, here {value}")
        print(f"{course}: {differ} of {len(ours)} results differ, by {largest:.2g} at most ({where}); {took_s:.1f} s")
        check(largest <= LARGEST_DIFFERENCE, f"{course}: {where} differs by {largest}")


def replay(build):
    """Recordings of each processor must give the same bits on the other."""
    ours, theirs = build + "/bin/", EMULATED
    fma = " fma " in open("/proc/cpuinfo", encoding="utf-8").read()
    with tempfile.TemporaryDirectory() as folder:
        for name, recorder, player in (("theirs", theirs, ours), ("ours", ours, theirs), ("own", theirs, theirs)):
            run(recorder + "tp100-sim", "course", "3", "--camera", "--setup", "terrain", "--record", f"{folder}/{name}")
            recording = glob.glob(f"{folder}/{name}/*/run.mcap")[0]
            output = run(player + "tp100d", "replay", recording, "--out", folder + "/poses.csv")
            print(output)
            elsewhere = "recorded on " in output and ", replayed on " in output
            check(elsewhere == (name != "own"), f"{name}: another kind of processor is not named: {output}")
            # Without FMA the last bits differ, and replay reports by how much.
            verdict = "bit for bit" if fma or name == "own" else "the largest difference is "
            check(verdict in output, f"{name}: not {verdict}: {output}")


def ros2(build):
    """Another implementation of DDS, run by this machine, receives every message of the daemon. tp100-sim's own topics
    are always announced by multicast, which qemu-user does not have."""
    with tempfile.TemporaryDirectory() as folder:
        for program, where in (("tp100d", EMULATED), ("tp100-sim", build + "/bin/"), ("ros2_peer", build + "/bin/")):
            os.symlink(where + program, f"{folder}/{program}")
        output = run(ROOT + "/tests/ros2/in_network", "node",
                     "--test-name-pattern=another implementation receives every", ROOT + "/tests/npm/ros2_live_test.mjs",
                     env=dict(os.environ, TP100_BIN=folder, TP100_NPM=build + "/npm",
                              TP100_ROS2='interface = ""', CYCLONEDDS_URI=WITHOUT_MULTICAST))
    print(output)
    check("# pass 1\n" in output, "not run")


class Emulation:
    """The kernel runs ARM programs by qemu-user during the lifetime of this object."""

    def __init__(self):
        self.mounted = self.registered = False
        if os.path.exists(BINFMT + "/qemu-aarch64"):
            return
        need(("qemu-aarch64-static", "arm64"))
        if os.geteuid() != 0:
            skip("only root can have the kernel run programs of ARM; run it as root, or install binfmt-support")
        if not os.path.exists(BINFMT + "/register"):
            mounted = subprocess.run(["mount", "-t", "binfmt_misc", "binfmt_misc", BINFMT], stderr=subprocess.PIPE,
                                     text=True, check=False)
            if mounted.returncode != 0:
                skip(f"this kernel runs no programs by an interpreter (binfmt_misc): {mounted.stderr.strip()}")
            self.mounted = True
        with open("/usr/lib/binfmt.d/qemu-aarch64.conf", encoding="utf-8") as file:
            line = file.read().strip()
        with open(BINFMT + "/register", "w", encoding="utf-8") as file:
            file.write(line)
        self.registered = True

    def close(self):
        if self.registered:
            with open(BINFMT + "/qemu-aarch64", "w", encoding="utf-8") as file:
                file.write("-1")
        if self.mounted:
            subprocess.run(["umount", BINFMT], check=False)


def serve(machine):
    """Runs the unit's command as its user beside an emulated robot: connected, page served, ended by SIGTERM. systemd
    itself does not start it, and the real time of an emulated processor is not judged."""
    machine.write(CONFIG, '[link]\nport = "/tmp/robot"\n[server]\nlisten = "127.0.0.1:0"\n')
    output = machine.shell(r"""
      as='setpriv --reuid=tp100 --regid=tp100 --init-groups env -u NOTIFY_SOCKET XDG_STATE_HOME=/tmp'
      wait_for() { for _ in $(seq 600); do ! "$@" || return 0; sleep 0.1; done; cat /tmp/service.log; exit 1; }
      $as tp100-sim robot --link /tmp/robot & robot=$!
      trap 'kill $robot' EXIT
      wait_for test -e /tmp/robot
      $as $(sed -n 's/^ExecStart=//p' /lib/systemd/system/tp100d@.service | sed 's/%i/tp100/') >/tmp/service.log 2>&1 &
      service=$!
      wait_for grep -q -- '-> ready' /tmp/service.log
      port=$(sed -n 's|.*http://127.0.0.1:\([0-9]*\)/.*|\1|p' /tmp/service.log | head -1)
      bash -c "exec 3<>/dev/tcp/127.0.0.1/$port; printf 'GET / HTTP/1.0\r\nHost: localhost\r\n\r\n' >&3; cat <&3" |
        grep -ac '<title>'
      kill $service
      wait $service
      cat /tmp/service.log; rm -r /tmp/service.log /tmp/tp100""")
    print(output)


def install(_build):
    """Install, service, upgrade, remove and purge in a Debian of the architecture. Its programs, the maintainer scripts
    among them, are run by qemu-user."""
    deb = package(ARM64)
    emulation = Emulation()
    machine = None
    try:
        machine = Machine("arm64")
        check(machine.shell("dpkg --print-architecture; uname -m").split() == ["arm64", "aarch64"], "not an arm64 root")
        shutil.copy(deb, machine.path("/srv/tp100.deb"))
        newer(deb, machine.path("/srv"))
        machine.shell(f"apt-get -qq update; {APT} install --no-install-recommends /srv/tp100.deb udev")
        machine.shell("dpkg --verify tp100; systemd-analyze verify --man=no tp100d@tp100.service")
        output = machine.shell("""
          test "$(id -nG tp100)" = "tp100 dialout"
          ! udevadm test /sys/class/mem/null 2>&1 | grep tp100.rules:
          tp100d --version; tp100d check /etc/tp100/tp100.toml
          as='setpriv --reuid=tp100 --regid=tp100 --init-groups env XDG_STATE_HOME=/tmp'
          $as tp100-sim course 1-curve --board avr --record /tmp/runs
          $as tp100d replay /tmp/runs/* --out /tmp/poses.csv""")
        print(output)
        check("completed" in output and "bit for bit" in output, f"the course as tp100: {output}")
        serve(machine)
        machine.shell("rm -rf /tmp/runs")
        upgrade_and_purge(machine)
    finally:
        if machine:
            machine.close()
        emulation.close()


def container(build):
    """The container of the architecture: it is built, drives, and with a port passed in waits for Enter."""
    emulation = Emulation()
    try:
        container_test.container(ARM64, robot=build + "/bin/tp100-sim")
    finally:
        emulation.close()


STEPS = {step.__name__: step for step in (make, unit, courses, replay, ros2, install, container)}

if __name__ == "__main__":
    if len(sys.argv) != 3 or sys.argv[1] not in STEPS:
        sys.exit(f"usage: arm64_test.py {'|'.join(STEPS)} BUILD")
    STEPS[sys.argv[1]](os.path.abspath(sys.argv[2]))
