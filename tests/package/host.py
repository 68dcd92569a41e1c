"""Access to this machine and to the package that was built on it, for the package's tests."""
import glob
import os
import shutil
import sys

sys.path.append(os.path.join(os.path.dirname(os.path.dirname(os.path.abspath(__file__))), "support"))
import verdict  # noqa: E402
from verdict import ROOT, check, skip  # noqa: E402, F401 (its users import them from here)


def need(*programs):
    for program, package in programs:
        if shutil.which(program) is None:
            skip(f"{program} is missing; run scripts/setup {package}")


def run(*command, **more):
    """Returns the output of the command; see verdict.run."""
    return verdict.run(*command, **more)[1]


def package(build):
    """The only .deb of this build."""
    found = glob.glob(os.path.join(build, "package", "tp100_*.deb"))
    check(len(found) == 1, f"{build}/package: one tp100_*.deb expected, found {found}")
    return found[0]
