"""Installs, drives, upgrades, removes and purges the package in a separate Debian."""
import os
import re
import shutil
import subprocess
import sys

from host import ROOT, check, packages, run, skip
from machine import Machine

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path.append(os.path.join(os.path.dirname(HERE), "docs"))
from run_page import blocks, script_of  # noqa: E402

CONFIG = "/etc/tp100/tp100.toml"
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
    """Checks the unit under systemd: ready, real-time, through a course, supervised, stopped. Returns the reason why
    the rights of its user, which come from limits without a capability, were not checked; empty if they were."""
    may_raise = subprocess.run(["prlimit", "--rtprio=90:90", "true"], stderr=subprocess.DEVNULL, check=False)
    machine.write("/etc/tp100/tp100.toml", 'course = "/srv/short.toml"\n[link]\nport = "/srv/robot"\n')
    with open(HERE + "/service.sh", encoding="utf-8") as file:
        output = machine.boot(file.read().replace("@MAY_RAISE@", "yes" if may_raise.returncode == 0 else "")
                              .replace("@ROS2_DROP_IN@", ros2_drop_in()))
    print(output)
    check("service: done" in output, "the service under systemd (above)")
    untried = re.findall(r"^service: not tried: (.*)", output, re.M)
    return "; ".join(untried)


def verdict_file(build):
    return os.path.join(build, "package", "rights")


def rights(build):
    """The result of the install step for the unit's LimitRTPRIO, LimitMEMLOCK and PrivateUsers."""
    if not os.path.exists(verdict_file(build)):
        skip("no service was started (package.install); see there")
    with open(verdict_file(build), encoding="utf-8") as file:
        untried = file.read()
    if untried:
        skip(untried)
    print("the unit as it is gave SCHED_FIFO and locked memory")


def left(machine):
    """All files that mention tp100 except the logs of apt and dpkg."""
    return machine.shell("""
      find / -xdev \\( -path /proc -o -path /sys -o -path /dev -o -path /srv \\) -prune -o -iname '*tp100*' -print
      grep -s tp100 /etc/passwd /etc/group /etc/shadow /etc/gshadow /var/lib/dpkg/status || true""")


def watch_marker(machine, apt):
    """Installs the camera beside the bridge, draws the marker and reads it from an image, and removes it again."""
    output = machine.shell(f"""
      ! dpkg -l 'libopencv*' | grep ^ii
      {apt} install --no-install-recommends /srv/tp100-camera.deb
      tp100-camera --print-marker /srv/marker.svg; grep -c '<svg' /srv/marker.svg
      tp100-camera --print-marker /srv/marker.svg --view /usr/share/tp100/view.toml
      {apt} purge tp100-camera; {apt} autoremove --purge; tp100d --version""")
    print(output)


def install(build):
    debs = packages(build)
    if os.path.exists(verdict_file(build)):
        os.remove(verdict_file(build))
    machine = Machine()
    try:
        for name, deb in debs.items():
            shutil.copy(deb, machine.path(f"/srv/{name}.deb"))
        newer(debs["tp100"], machine.path("/srv"))
        apt = "apt-get -qq -y -o Dpkg::Use-Pty=0 -o Dpkg::Options::=--force-confdef -o Dpkg::Options::=--force-confold "
        machine.shell(f"apt-get -qq update; {apt} install --no-install-recommends /srv/tp100.deb arduino-core-avr avrdude udev")
        if "tp100-camera" in debs:
            watch_marker(machine, apt)
        machine.shell("systemd-analyze verify --man=no tp100d@tp100.service")
        # The message names file and line of a rule with a syntax error.
        machine.shell("! udevadm test /sys/class/mem/null 2>&1 | grep tp100.rules:")
        drive_as_user(machine)
        drive_bare_board(machine)
        untried = serve(machine)
        with open(verdict_file(build), "w", encoding="utf-8") as file:
            file.write(untried)

        machine.write(CONFIG, "# of its user\n")
        machine.write("/etc/tp100/second.toml", "")
        machine.shell(f"{apt} install --no-install-recommends /srv/newer.deb; tp100d check {CONFIG}")
        check(machine.read(CONFIG) == "# of its user\n", f"the upgrade changed {CONFIG}")
        machine.shell(f"{apt} remove tp100; test -e {CONFIG}; test ! -e /usr/bin/tp100d")
        machine.shell(f"{apt} purge tp100")
        check(not (still := left(machine).strip()), f"after the purge there is still:\n{still}")
        print("installed, driven, served, upgraded, removed, purged")
        if untried:
            print(f"not tried: {untried}")
    finally:
        machine.close()
