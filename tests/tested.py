#!/usr/bin/env python3
"""tested.py [--no-skips] RUN: what a ctest run has to say besides what failed.

RUN.xml is its --output-junit, RUN.log its --output-log. Prints the skipped tests, each with its reason (with --no-skips
one that tests/SKIPS does not list is an error), and the tests that needed a second try (more than three are an error).
Ends with status 1 after an error.
"""
import os
import re
import sys
import xml.etree.ElementTree

MOST_SECOND_TRIES = 3
REASONS = (
    re.compile(r": Skipped\n(.*?)\n\s*\[  SKIPPED \]", re.S),  # GoogleTest
    re.compile(r"^(?:\S+: )?skipped: (.*)$", re.M),  # tests that end with status 77
)


def reason(output):
    for pattern in REASONS:
        found = pattern.search(output)
        if found and found[1].strip():
            return " ".join(found[1].split())
    return "it does not say why"


def accepted():
    """The patterns of tests/SKIPS."""
    with open(os.path.join(os.path.dirname(os.path.abspath(__file__)), "SKIPS"), encoding="utf-8") as file:
        return [re.compile(line.strip()) for line in file if line.strip() and not line.startswith("#")]


def report_skips(run, strict):
    cases = xml.etree.ElementTree.parse(run + ".xml").getroot().findall("testcase")
    skipped = {case.get("name"): reason(case.findtext("system-out", "")) for case in cases
               if case.find("skipped") is not None}
    if not skipped:
        return False
    known = accepted()
    unknown = [name for name, why in skipped.items() if not any(pattern.search(why) for pattern in known)]
    print(f"skipped, {len(skipped)} of {len(cases)} tests:")
    for name, why in skipped.items():
        print(f"  {name}: {why}" + (" (error: tests/SKIPS does not list this reason)" if strict and name in unknown else ""))
    return strict and bool(unknown)


def report_second_tries(run):
    with open(run + ".log", encoding="utf-8", errors="replace") as file:
        starts = re.findall(r"^\s*Start\s+\d+: (.*)$", file.read(), re.M)
    again = sorted({name for name in starts if starts.count(name) > 1})
    if again:
        print(f"second tries: {len(again)} of {len(set(starts))} tests")
    for name in again:
        print(f"  {name}")
    if len(again) <= MOST_SECOND_TRIES:
        return False
    print(f"error: more than {MOST_SECOND_TRIES} tests needed a second try")
    return True


def main(arguments):
    strict = "--no-skips" in arguments
    runs = [argument for argument in arguments if not argument.startswith("--")]
    if len(runs) != 1:
        sys.exit("usage: tested.py [--no-skips] RUN")
    errors = [report_skips(runs[0], strict), report_second_tries(runs[0])]
    sys.exit(1 if any(errors) else 0)


if __name__ == "__main__":
    main(sys.argv[1:])
