"""Functions that tests in Python share: they run programs, and fail or skip a test with one line."""
import os
import shutil
import subprocess
import sys

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
SKIPPED = 77


def skip(why):
    print(f"skipped: {why}")
    sys.exit(SKIPPED)


def find(program, package):
    """Path of a program. /sbin is not in every user's PATH."""
    found = shutil.which(program) or shutil.which(program, path="/usr/sbin:/sbin")
    return found or skip(f"{program} is missing; run scripts/setup {package}")


def check(good, what):
    """Ends the test with the message unless `good`."""
    if not good:
        sys.exit(f"failed: {what}")


def run(*command, good=True, **more):
    """Returns status and output of the command, on both streams; its input is empty. `good`: the status must be 0."""
    ended = subprocess.run(command, text=True, errors="replace", stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                           stdin=subprocess.DEVNULL, check=False, **more)
    check(not good or ended.returncode == 0, f"{' '.join(command)}: status {ended.returncode}\n{ended.stdout}")
    return ended.returncode, ended.stdout
