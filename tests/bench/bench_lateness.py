"""scripts/bench lateness: wake-up latency of the daemon's loop and of cyclictest, in alternating rounds.

Usage: bench_lateness.py FOLDER_OF_PROGRAMS. TP100_BENCH_CPU pins every loop to that processor; default: not pinned.
"""
import collections
import json
import os
import re
import shutil
import subprocess
import sys

from bench_load import Busy
from bench_table import Table, histogram_percentile, ratio, rounds, seconds

PRIORITY = "80"
LONGEST_US = 20000
CPU = os.environ.get("TP100_BENCH_CPU", "-1")
SPIN_US = {"ours, spinning 60 us": "60", "ours, sleeping": "0"}
THEIRS = "cyclictest"


def ours(programs, rate_hz, spin_us, duration_s):
    out = subprocess.run([os.path.join(programs, "lateness_bench"), str(rate_hz), spin_us, str(duration_s), CPU],
                         stdout=subprocess.PIPE, text=True, check=True).stdout
    measured = json.loads(out)
    return {float(us): count for us, count in measured["buckets"]}, measured["refused"]


def theirs(rate_hz, duration_s):
    pinned = [] if CPU == "-1" else ["-a", CPU]
    out = subprocess.run(["cyclictest", "-q", "-m", "-t1", "-p", PRIORITY, "-i", str(1000000 // rate_hz), "-D",
                          str(round(duration_s)), "-h", str(LONGEST_US), *pinned],
                         stdout=subprocess.PIPE, text=True, check=True).stdout
    # cyclictest rounds down to whole microseconds: add half of one.
    buckets = {int(us) + 0.5: int(count) for us, count in re.findall(r"^(\d+)\s+(\d+)$", out, re.M) if int(count)}
    over = re.search(r"Histogram Overflows:\s*(\d+)", out)
    if over and int(over.group(1)):
        buckets[float(LONGEST_US)] = int(over.group(1))
    return buckets


def main():
    programs = sys.argv[1]
    duration_s, repeats = seconds(10), rounds(3)
    with_theirs = shutil.which("cyclictest") is not None
    table = Table("lateness", f"wake-up of a FIFO thread after its deadline [us], {repeats} alternating rounds of "
                  f"{duration_s:g} s each", [
                      ("load", "load", "<4s"), ("rate_hz", "Hz", "5d"), ("loop", "loop", "<20s"),
                      ("p50_us", "p50", "8.1f"), ("p99_us", "p99", "8.1f"), ("p999_us", "p99.9", "8.1f"),
                      ("max_us", "max", "9.1f"), ("p50_ratio", "/cyclic", "7.2f"), ("p99_ratio", "p99", "7.2f"),
                      ("p999_ratio", "p99.9", "7.2f")])
    refused = set()
    for busy in (False, True):
        with Busy(busy):
            for rate_hz in (200, 1000):
                merged = collections.defaultdict(collections.Counter)
                for _ in range(repeats):
                    if with_theirs:
                        merged[THEIRS].update(theirs(rate_hz, duration_s))
                    for name, spin_us in SPIN_US.items():
                        buckets, missing = ours(programs, rate_hz, spin_us, duration_s)
                        merged[name].update(buckets)
                        refused.update(missing)
                figures = {name: {"p50": histogram_percentile(buckets, 0.5), "p99": histogram_percentile(buckets, 0.99),
                                  "p999": histogram_percentile(buckets, 0.999), "max": max(buckets)}
                           for name, buckets in merged.items()}
                base = figures.get(THEIRS, {})
                for name, of in figures.items():
                    ratios = {} if name == THEIRS else {
                        f"{key}_ratio": ratio(of[key], base.get(key)) for key in ("p50", "p99", "p999")}
                    table.row(load="busy" if busy else "idle", rate_hz=rate_hz, loop=name,
                              **{f"{key}_us": value for key, value in of.items()}, **ratios)
    if not with_theirs:
        table.note("cyclictest is not installed (Debian package rt-tests), so there is nothing to compare with")
    for what in sorted(refused):
        table.note(f"not granted: {what}")
    table.save()


if __name__ == "__main__":
    main()
