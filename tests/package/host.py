"""Access to this machine and to the package that was built on it, for the package's tests."""
import glob
import os
import sys

sys.path.append(os.path.join(os.path.dirname(os.path.dirname(os.path.abspath(__file__))), "support"))
import verdict  # noqa: E402
from verdict import ROOT, check, find, skip  # noqa: E402, F401 (its users import them from here)


def need(*programs):
    for program, package in programs:
        find(program, package)


def run(*command, **more):
    """Returns the output of the command; see verdict.run."""
    return verdict.run(*command, **more)[1]


def package(build, name="tp100"):
    """The only .deb of this name in this build."""
    found = glob.glob(os.path.join(build, "package", name + "_*.deb"))
    check(len(found) == 1, f"{build}/package: one {name}_*.deb expected, found {found}")
    return found[0]


def packages(build):
    """Each .deb of this build by its name: tp100, and tp100-camera if the build has it."""
    has_camera = os.path.exists(os.path.join(build, "bin", "tp100-camera"))
    return {name: package(build, name) for name in ["tp100"] + ["tp100-camera"] * has_camera}
