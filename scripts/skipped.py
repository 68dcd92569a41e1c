#!/usr/bin/env python3
"""skipped.py BUILD: the tests that the last ctest in this build folder skipped, each with its reason."""
import os
import re
import sys

# Of a log whose tests were skipped; of a run without any, the list of the run before is still there.
SAME_RUN_S = 5
TEST = re.compile(r"^\d+/\d+ Test: (.*?)\n.*?^Output:\n-+\n(.*?)^<end of output>$", re.M | re.S)
REASONS = (
    re.compile(r": Skipped\n(.*?)\n\s*\[  SKIPPED \]", re.S),  # GoogleTest
    re.compile(r"^(?:\S+: )?skipped: (.*)$", re.M),  # what ends with status 77
)


def skipped(build):
    """Their names in ctest's order, and what each test printed."""
    folder = os.path.join(build, "Testing", "Temporary")
    names, log = os.path.join(folder, "LastTestsDisabled.log"), os.path.join(folder, "LastTest.log")
    if not os.path.exists(names) or os.path.getmtime(names) < os.path.getmtime(log) - SAME_RUN_S:
        return [], {}
    with open(log, encoding="utf-8", errors="replace") as file:
        outputs = dict(TEST.findall(file.read()))
    with open(names, encoding="utf-8") as file:
        found = [line.strip().split(":", 1)[-1] for line in file]
    return [name for name in found if name in outputs], outputs


def reason(output):
    for pattern in REASONS:
        found = pattern.search(output)
        if found and found[1].strip():
            return " ".join(found[1].split())
    return "it does not say why"


def main(build):
    names, outputs = skipped(build)
    if names:
        print(f"skipped, {len(names)} of {len(outputs)} tests:")
    for name in names:
        print(f"  {name}: {reason(outputs.get(name, ''))}")


if __name__ == "__main__":
    if len(sys.argv) != 2:
        sys.exit("usage: skipped.py BUILD")
    main(sys.argv[1])
