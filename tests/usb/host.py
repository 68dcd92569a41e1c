"""Functions of this machine that the parts of the test need."""
import os
import shutil
import sys

sys.path.append(os.path.join(os.path.dirname(os.path.dirname(os.path.abspath(__file__))), "support"))
from verdict import ROOT, check, run, skip  # noqa: E402, F401 (its users import them from here)


def find(program, package):
    """Path of a program. /sbin is not in every user's PATH."""
    found = shutil.which(program) or shutil.which(program, path="/usr/sbin:/sbin")
    if found is None:
        skip(f"{program} is missing; run scripts/setup {package}")
    return found
