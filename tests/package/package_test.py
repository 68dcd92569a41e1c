#!/usr/bin/env python3
"""package_test.py STEP BUILD: one test of the Debian package of a build folder."""
import gzip
import os
import sys
import tempfile

from container_test import container
from host import ROOT, check, need, package, packages, run
from install_test import install
from setup_test import setup

LARGEST_EXPOSURE = 2.0


def make(build):
    for old in os.listdir(folder) if os.path.isdir(folder := os.path.join(build, "package")) else []:
        if old.endswith(".deb"):
            os.remove(os.path.join(folder, old))
    need(("dpkg-shlibdeps", "dpkg-dev"))
    run("cpack", cwd=build)
    written = run("dpkg-parsechangelog", "-l", ROOT + "/scripts/debian/changelog", "-S", "Version").strip()
    with open(build + "/CMakeCache.txt", encoding="utf-8") as cache:
        with_dds = "\nTP100_BUILD_ROS2:BOOL=ON\n" in cache.read()
    for name, deb in packages(build).items():
        version = run("dpkg-deb", "-f", deb, "Version").strip()
        check(version == written, f"scripts/debian/changelog is of version {written}, {name} of {version}")
        depends = run("dpkg-deb", "-f", deb, "Depends")
        check(("libopencv" in depends) == (name == "tp100-camera"), f"{name} depends on: {depends}")
        # CMake only warns where it is missing.
        check(("libddsc0debian" in depends) == (with_dds and name == "tp100"), f"{name} depends on: {depends}")
    there = run("dpkg-deb", "-c", package(build))
    for path in ("bin/tp100-campaign", "share/doc/tp100/README.md", "share/doc/tp100/config/TUTORIALS.md", "share/tp100/tp100_fake.hex",
                 "share/doc/tp100/examples/64-tp100-bridges.rules"):
        check(f" ./usr/{path}\n" in there, f"the package has no /usr/{path}")


def lintian(build):
    need(("lintian", "lintian"))
    print(run("lintian", "--allow-root", "--fail-on", "error,warning", *packages(build).values()))


def exposure(_build):
    need(("systemd-analyze", "systemd"))
    print(run("systemd-analyze", "security", "--offline=true", f"--threshold={LARGEST_EXPOSURE * 10:.0f}", "--no-pager",
              ROOT + "/config/systemd/tp100d@.service"))


def completed(scripts, line):
    """What bash, with the completion of these programs, offers for the last word of `line`."""
    words = line.split(" ")
    script = (f'PATH={scripts}/usr/bin:$PATH; source {scripts}/usr/share/bash-completion/completions/{words[0]}; '
              f'COMP_WORDS=({" ".join(map(repr, words))}); COMP_CWORD={len(words) - 1}; '
              f'_tp100 {words[0]} {words[-1]!r} {words[-2]}; printf "%s\\n" "${{COMPREPLY[@]}}"')
    return run("bash", "-c", script).split()


def completion(build):
    with tempfile.TemporaryDirectory() as at:
        for deb in packages(build).values():
            run("dpkg-deb", "-x", deb, at)
        programs = sorted(os.listdir(at + "/usr/bin"))
        for line, offered in (("tp100d re", ["replay", "recover", "report"]), ("tp100d run --set", ["--setup"]),
                              ("tp100-sim robot --board a", ["avr"]), ("tp100-flash --port a", ["auto"]),
                              ("tp100-campaign --engine s", ["slurm"]), ("tp100-camera --tu", ["--tum"])):
            if line.split(" ", maxsplit=1)[0] in programs:
                check((got := completed(at, line)) == offered, f"bash offers {got} after '{line}', not {offered}")
        for program in programs:
            page = gzip.open(f"{at}/usr/share/man/man1/{program}.1.gz", "rt").read()
            check("\n" + program.replace("-", "\\-") + " \\- " in page, f"{program}: no whatis line")
            check(".SH EXAMPLES\n.nf\n" + program.replace("-", "\\-") in page, f"{program}: no example")


STEPS = {step.__name__: step for step in (make, lintian, exposure, completion, container, install, setup)}

if __name__ == "__main__":
    if len(sys.argv) != 3 or sys.argv[1] not in STEPS:
        sys.exit(f"usage: package_test.py {'|'.join(STEPS)} BUILD")
    STEPS[sys.argv[1]](sys.argv[2])
