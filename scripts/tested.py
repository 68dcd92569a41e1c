#!/usr/bin/env python3
"""tested.py [--no-skips] RUN: what a ctest run has to say besides what failed.

RUN.xml is its --output-junit, RUN.log its --output-log and RUN.times the file of TP100_TEST_TIMES (optional). Prints

- the skipped tests, each with its reason; with --no-skips a reason that tests/SKIPS does not list is an error;
- the tests that needed a second try; more than three are an error;
- the tests in the wrong group: a run whose name ends in "realtime" is for tests that wait, any other for those that
  compute. Computing among those that wait is an error: it takes the time of tests beside it. Waiting among those that
  compute shows only where processors were idle.

Ends with status 1 after an error.
"""
import os
import re
import sys
import xml.etree.ElementTree

ROOT = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))
MOST_SECOND_TRIES = 3
# Shorter tests do not affect the others.
LONG_S = 10
# Shares of a processor. Tests that run at the same time make a test longer and its share smaller, never larger: a test
# that computes has a small share only on a busy machine, since it runs whenever a processor is idle.
COMPUTES, WAITS = 0.8, 0.2
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
    with open(os.path.join(ROOT, "tests", "SKIPS"), encoding="utf-8") as file:
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


def report_groups(run):
    if not os.path.exists(run + ".times"):
        return False
    with open(run + ".times", encoding="utf-8") as file:
        rows = [line.rstrip("\n").split("\t") for line in file]
    realtime = run.endswith("realtime")
    wrong = []
    for name, *numbers in rows:
        wall, cpu, idle = map(float, numbers)
        waits = cpu < WAITS * wall <= idle
        if wall >= LONG_S and (cpu > COMPUTES * wall if realtime else waits):
            wrong.append((name, wall, cpu))
    for name, wall, cpu in wrong:
        print(f"wrong group: {name} took {cpu:.1f} s of a processor in {wall:.1f} s; label realtime is for what waits")
    return realtime and bool(wrong)


def main(arguments):
    strict = "--no-skips" in arguments
    runs = [argument for argument in arguments if not argument.startswith("--")]
    if len(runs) != 1:
        sys.exit("usage: tested.py [--no-skips] RUN")
    errors = [report_skips(runs[0], strict), report_second_tries(runs[0]), report_groups(runs[0])]
    sys.exit(1 if any(errors) else 0)


if __name__ == "__main__":
    main(sys.argv[1:])
