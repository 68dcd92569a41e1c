"""This machine, as the test's parts need it."""
import os
import shutil
import sys

sys.path.append(os.path.join(os.path.dirname(os.path.dirname(os.path.abspath(__file__))), "support"))
from verdict import ROOT, check, run, skip  # noqa: E402, F401 (its users take them from here)


def find(program, package):
    """Where it is; /sbin is not in everybody's PATH."""
    found = shutil.which(program) or shutil.which(program, path="/usr/sbin:/sbin")
    if found is None:
        skip(f"{program} is missing; run scripts/setup {package}")
    return found
