"""Tests scripts/setup, build and campaign on a simulated machine: programs in a folder at the front of PATH."""
import os
import re
import shutil
import subprocess
import tempfile

from host import ROOT, check, run

GNU = 'echo "GNU parallel 20221122"'
MOREUTILS = "echo \"parallel: invalid option -- '-'\" >&2; exit 1"


class Machine:
    """All packages but `parallel` are installed; apt-get logs its calls, and sudo drops variables."""

    def __init__(self, folder, parallel, installed=""):
        self.folder, self.log = folder, folder + "/apt"
        self.path = f"{folder}/bin:{os.environ['PATH']}"
        os.makedirs(folder + "/bin")
        for name, script in {
                "parallel": parallel,
                "dpkg-query": f'[ "$3" = parallel ] && echo "{installed}" || echo "install ok installed"',
                "apt-get": f'echo "$DEBIAN_FRONTEND $*" >> {self.log}',
                "sudo": 'exec env -i PATH="$PATH" "$@"',
                "id": "echo 1000",
                "tp100-sim": "echo 1"}.items():
            self.replace(name, script)

    def run(self, *command, good=True):
        return run(*command, good=good, env=dict(os.environ, PATH=self.path, TP100_BIN=self.folder + "/bin"))

    def replace(self, name, script):
        with open(f"{self.folder}/bin/{name}", "w", encoding="utf-8") as file:
            file.write(f"#!/bin/bash\n{script}\n")
        os.chmod(f"{self.folder}/bin/{name}", 0o755)

    def asked(self):
        """The logged calls of apt-get."""
        if not os.path.exists(self.log):
            return ""
        with open(self.log, encoding="utf-8") as file:
            return file.read()


def failures(at):
    """An error of apt-get must be reported in one line."""
    for name, says, line in (
            ("offline", "W: Failed to fetch http://deb/Packages  Temporary failure resolving 'deb'", "to the network"),
            ("full", "E: You don't have enough free space in /var/cache/apt/archives/.", "make room"),
            ("refused", "sudo: a password is required", "ask an administrator for: apt-get install parallel"),
            ("other", "E: Unmet dependencies.", "what the log says")):
        machine = Machine(f"{at}/{name}", MOREUTILS)
        machine.replace("apt-get", f'for i in 1 2 3; do echo "{says}" >&2; done; [ $1 = update ]')
        lines = machine.run(at + "/tree/scripts/setup", "parallel", good=False).splitlines()
        check(len(lines) == 2 and line in lines[1] and "parallel" in lines[1], f"{name}: scripts/setup said {lines}")
        log = re.search(r"\(log: (.*)\)$", lines[1])
        with open(log[1], encoding="utf-8") as file:
            check(says in file.read(), f"{name}: {log[1]} does not have what apt-get said")


def parts(at):
    """Only what the targets need is installed and configured, and the configuration is kept."""
    machine = Machine(at + "/builder", GNU)
    # Stores its options in the cache as CMake does, without configuring or building anything.
    machine.replace("cmake", f"""[ "$1" = --preset ] || exit 0
echo "$0 $*" >> {machine.log}
touch build/$2/build.ninja build/$2/CMakeCache.txt
for part in FIRMWARE CAMERA ROS2 LAB TESTS; do
  # What is not named keeps its value.
  if [[ "$*" == *_$part=OFF* ]]; then value=OFF
  elif [[ "$*" == *_$part=ON* ]] || ! grep -q "_$part:BOOL=OFF" build/$2/CMakeCache.txt; then value=ON
  else value=OFF; fi
  echo "TP100_BUILD_$part:BOOL=$value"
done > build/$2/cache
mv build/$2/cache build/$2/CMakeCache.txt""")
    # No package is installed and no program is found.
    machine.replace("dpkg-query", "exit 1")

    def asked(*targets):
        if os.path.exists(machine.log):
            os.remove(machine.log)
        machine.run(at + "/tree/scripts/build", "dev", *targets)
        return machine.asked()

    demo = asked("tp100d", "tp100-sim")
    check("libode-dev" in demo and not re.search("libopencv-dev|gcc-avr|libgtest-dev", demo)
          and all(f"{part}=OFF" in demo for part in ("FIRMWARE", "CAMERA", "ROS2", "LAB", "TESTS")), f"for the demo: {demo}")
    check("--preset" not in (again := asked("tp100d")), f"configured for nothing: {again}")
    image = asked("tp100d", "tp100_image")
    check("gcc-avr" in image and "FIRMWARE=OFF" not in image and "CAMERA=OFF" in image, f"for the image: {image}")
    camera = asked("tp100-camera")
    check("libopencv-dev" in camera and "ROS2=OFF" in camera and "TESTS=OFF" in camera and camera.count("=OFF") == 3, f"and the camera: {camera}")
    everything = asked()
    check("libgtest-dev" in everything and "=OFF" not in everything, f"for everything: {everything}")
    # A program built by the demo without ROS 2 refuses it and names this command.
    check("cyclonedds-dev" in everything and "ROS2=ON" in everything, f"for everything: {everything}")
    check("--preset" not in (fewer := asked("tp100d")), f"what was configured is left out again: {fewer}")


def options(at):
    """An option must not be taken for a preset."""
    asked = subprocess.run([at + "/tree/scripts/build", "dev", "-j2"], capture_output=True, text=True, check=False)
    check(asked.returncode == 2 and asked.stderr.startswith("scripts/build [PRESET]") and not asked.stdout, f"scripts/build dev -j2: {asked}")


def setup(_build):
    with tempfile.TemporaryDirectory() as at:
        shutil.copytree(ROOT + "/scripts", at + "/tree/scripts")
        shutil.copy(ROOT + "/CMakePresets.json", at + "/tree")
        failures(at)
        options(at)
        parts(at)
        for name, parallel, pattern in (("moreutils", MOREUTILS, "noninteractive install .* parallel\n"), ("gnu", GNU, "")):
            machine = Machine(f"{at}/{name}", parallel)
            machine.run(ROOT + "/scripts/setup", "parallel")
            asked = machine.asked()
            check(re.fullmatch(pattern, asked), f"beside the parallel of {name}, and by sudo, apt-get was asked '{asked}'")

        machine = Machine(at + "/hidden", MOREUTILS, "install ok installed")
        os.mkdir(at + "/out")
        output = machine.run(ROOT + "/scripts/campaign", ROOT + "/config/campaigns/course-3.toml", "--out", at + "/out",
                             good=False)
        check("is not GNU parallel; " in output, f"scripts/campaign with moreutils' parallel said '{output}'")
