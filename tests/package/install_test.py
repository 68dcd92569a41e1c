"""Installs, drives, upgrades, removes and purges the package in a separate Debian."""
import os
import re
import shutil
import subprocess
import sys

from host import ROOT, check, packages, run
from machine import Machine

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path.append(os.path.join(os.path.dirname(HERE), "docs"))
from run_page import blocks, script_of  # noqa: E402

CONFIG = "/etc/tp100/tp100.toml"
APT = "apt-get -qq -y -o Dpkg::Use-Pty=0 -o Dpkg::Options::=--force-confdef -o Dpkg::Options::=--force-confold "
# A short course.
COURSE = ('description = "short"\nspeed_mps = 0.1\n[[segment]]\ntype = "line"\nlength_m = 0.2\n'
          "[fence]\nmin_x_m = -0.5\nmax_x_m = 0.8\nmin_y_m = -0.5\nmax_y_m = 0.5\n")


def newer(deb, folder):
    """The same package with a higher version and a different configuration file."""
    tree = os.path.join(folder, "newer")
    run("dpkg-deb", "-R", deb, tree)
    with open(tree + "/DEBIAN/control", encoding="utf-8") as file:
        control = file.read()
    with open(tree + "/DEBIAN/control", "w", encoding="utf-8") as file:
        file.write(re.sub(r"^Version: .*", r"\g<0>+1", control, flags=re.M))
    with open(tree + CONFIG, "a", encoding="utf-8") as file:
        file.write("# of the newer version\n")
    run("dpkg-deb", "--root-owner-group", "-b", tree, folder + "/newer.deb")
    shutil.rmtree(tree)


def drive_as_user(machine):
    """Runs emulator and daemon as the service's user through a short course without systemd, and a campaign of two runs."""
    machine.write("/srv/short.toml", COURSE)
    output = machine.shell("""
      test "$(id -nG tp100)" = "tp100 dialout"
      as='setpriv --reuid=tp100 --regid=tp100 --init-groups'
      $as tp100-sim robot --link /tmp/robot & robot=$!
      trap 'kill $robot' EXIT
      for i in $(seq 50); do [ -e /tmp/robot ] && break; sleep 0.1; done
      # The container has a manager; this one is started by hand.
      $as env -u NOTIFY_SOCKET XDG_STATE_HOME=/tmp tp100d run --port /tmp/robot --course /srv/short.toml --duration 60
      $as tp100-sim course 1-curve --board avr | head -3
      printf 'runs = 2\\ncourse = "1-curve"\\n' >/srv/few.toml
      $as tp100-campaign /srv/few.toml --out /tmp/few --engine one
      test -s /tmp/few/index.html""")
    check("short: completed" in output, f"the course as tp100: {output}")
    print(output)


def drive_bare_board(machine):
    """Runs the block of FIRST_DRIVE.md for who has no board, with Enter where it is requested."""
    [block] = [body for _, _, body in blocks(ROOT + "/firmware/FIRST_DRIVE.md") if "tp100_fake.hex --port mega" in body]
    machine.write("/srv/bare.sh", script_of([("sh", "start", block)]) + "\nkill %1\n")
    output = machine.shell("cd \"$(mktemp -d)\"; XDG_STATE_HOME=. bash /srv/bare.sh 2>&1")
    print(output)
    check("simulated inside the board" in output and "1-curve: completed" in output, f"the bare board: {output}")


def ros2_drop_in():
    """The lines of the drop-in that ROS2.md gives for a service, as printf takes them."""
    [lines] = [body for language, _, body in blocks(ROOT + "/daemon/ros2/ROS2.md") if language == "ini"]
    check(lines.startswith("[Service]\n"), f"not a drop-in for a service: {lines}")
    return "\\n".join(lines.splitlines()[1:])


def serve(machine):
    """Checks the unit under systemd: ready, real-time, through a course, supervised, stopped."""
    may_raise = subprocess.run(["prlimit", "--rtprio=90:90", "true"], stderr=subprocess.DEVNULL, check=False)
    machine.write("/etc/tp100/tp100.toml", 'course = "/srv/short.toml"\n[link]\nport = "/srv/robot"\n')
    with open(HERE + "/service.sh", encoding="utf-8") as file:
        output = machine.boot(file.read().replace("@MAY_RAISE@", "yes" if may_raise.returncode == 0 else "")
                              .replace("@ROS2_DROP_IN@", ros2_drop_in()))
    print(output)
    check("service: done" in output, "the service under systemd (above)")


def left(machine):
    """All files that mention tp100 except the logs of apt and dpkg."""
    return machine.shell("""
      find / -xdev \\( -path /proc -o -path /sys -o -path /dev -o -path /srv \\) -prune -o -iname '*tp100*' -print
      grep -s tp100 /etc/passwd /etc/group /etc/shadow /etc/gshadow /var/lib/dpkg/status || true""")


def watch_marker(machine):
    """Installs the camera beside the bridge, draws the marker and reads it from an image, and removes it again."""
    output = machine.shell(f"""
      ! dpkg -l 'libopencv*' | grep ^ii
      {APT} install --no-install-recommends /srv/tp100-camera.deb
      tp100-camera --print-marker /srv/marker.svg; grep -c '<svg' /srv/marker.svg
      tp100-camera --print-marker /srv/marker.svg --view /usr/share/tp100/view.toml
      {APT} purge tp100-camera; {APT} autoremove --purge; tp100d --version""")
    print(output)


def upgrade_and_purge(machine):
    """The user's configuration stays until the package is purged, and then nothing is left."""
    machine.write(CONFIG, "# of its user\n")
    machine.shell(f"{APT} install --no-install-recommends /srv/newer.deb; tp100d check {CONFIG}")
    check(machine.read(CONFIG) == "# of its user\n", f"the upgrade changed {CONFIG}")
    machine.shell(f"{APT} remove tp100; test -e {CONFIG}; test ! -e /usr/bin/tp100d; {APT} purge tp100")
    check(not (still := left(machine).strip()), f"after the purge there is still:\n{still}")
    print("installed, driven, served, upgraded, removed, purged")


def install(build):
    debs = packages(build)
    machine = Machine()
    try:
        for name, deb in debs.items():
            shutil.copy(deb, machine.path(f"/srv/{name}.deb"))
        newer(debs["tp100"], machine.path("/srv"))
        machine.shell(f"apt-get -qq update; {APT} install --no-install-recommends /srv/tp100.deb arduino-core-avr avrdude udev")
        if "tp100-camera" in debs:
            watch_marker(machine)
        machine.shell("systemd-analyze verify --man=no tp100d@tp100.service")
        # The message names file and line of a rule with a syntax error.
        machine.shell("! udevadm test /sys/class/mem/null 2>&1 | grep tp100.rules:")
        drive_as_user(machine)
        drive_bare_board(machine)
        serve(machine)
        machine.write("/etc/tp100/second.toml", "")
        upgrade_and_purge(machine)
    finally:
        machine.close()
