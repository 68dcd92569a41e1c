"""What tests in Python share: running programs, failing and skipping by one line."""
import os
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


def run(*command, good=True, **more):
    """Status and what the command printed, on both streams; nobody types. `good`: it must end with status 0."""
    ended = subprocess.run(command, text=True, errors="replace", stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                           stdin=subprocess.DEVNULL, check=False, **more)
    check(not good or ended.returncode == 0, f"{' '.join(command)}: status {ended.returncode}\n{ended.stdout}")
    return ended.returncode, ended.stdout
