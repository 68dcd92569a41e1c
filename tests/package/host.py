"""What the package's tests share: running programs, failing and skipping by one line."""
import glob
import os
import shutil
import subprocess
import sys

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
SKIPPED = 77


def skip(why):
    print(f"skipped: {why}")
    sys.exit(SKIPPED)


def check(good, what):
    """Ends the test with what is wrong unless `good`."""
    if not good:
        sys.exit(f"failed: {what}")


def need(*programs):
    for program, package in programs:
        if shutil.which(program) is None:
            skip(f"{program} is missing; run scripts/setup {package}")


def run(*command, good=True, **more):
    """What the command printed, on both streams. `good`: it must end with status 0."""
    ended = subprocess.run(command, text=True, errors="replace", stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                           stdin=subprocess.DEVNULL, check=False, **more)
    check(not good or ended.returncode == 0, f"{' '.join(command)}: status {ended.returncode}\n{ended.stdout}")
    return ended.stdout


def package(build):
    """The one .deb of this build."""
    found = glob.glob(os.path.join(build, "package", "tp100_*.deb"))
    check(len(found) == 1, f"{build}/package: one tp100_*.deb expected, found {found}")
    return found[0]
