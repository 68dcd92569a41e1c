"""scripts/bench lateness: wake-up of the daemon's loop and of cyclictest after their deadlines, in alternating rounds.

Usage: bench_lateness.py FOLDER_OF_PROGRAMS. TP100_BENCH_CPU pins every loop to that processor; default: not pinned. The
daemon serves an emulated robot on a stand, so its figures are those of a loop that also works.
"""
import collections
import os
import re
import shutil
import statistics
import subprocess
import sys
import time

from bench_robot import DrivenRobot
from bench_table import Busy, Table, ratio, rounds, seconds

RATE_HZ = 200
FIGURES = {"p50": 0.5, "p99": 0.99, "p999": 0.999}
CPU = os.environ.get("TP100_BENCH_CPU")
OURS = {"ours, spinning 60 us": 60, "ours, sleeping": 0}
THEIRS = "cyclictest"


def ours(programs, spin_us, duration_s):
    with DrivenRobot(programs, setup="stand", config=f"[loop]\nspin_us = {spin_us}\ncpu = {CPU or -1}\n") as robot:
        time.sleep(duration_s)
    return robot.stats["loop"]["lateness_us"]


def theirs(duration_s):
    pinned = ["-a", CPU] if CPU else []
    out = subprocess.run(["cyclictest", "-q", "-m", "-t1", "-p", "80", "-i", str(1000000 // RATE_HZ), "-D",
                          str(round(duration_s)), "-h", "20000", *pinned],
                         stdout=subprocess.PIPE, text=True, check=True).stdout
    # cyclictest rounds down to whole microseconds: add half of one.
    values = sorted(int(us) + 0.5 for us, count in re.findall(r"^(\d+)\s+(\d+)$", out, re.M) for _ in range(int(count)))
    return {**{key: values[int(share * len(values))] for key, share in FIGURES.items()}, "max": values[-1]}


def main():
    programs, duration_s, repeats = sys.argv[1], seconds(10), rounds(3)
    table = Table("lateness", f"wake-up of a FIFO thread at {RATE_HZ} Hz after its deadline [us], medians of {repeats} "
                  f"alternating rounds of {duration_s:g} s each", [
                      ("load", "load", "<4s"), ("loop", "loop", "<20s"), ("p50", "p50", "8.1f"), ("p99", "p99", "8.1f"),
                      ("p999", "p99.9", "8.1f"), ("max", "max", "9.1f"), ("p50_ratio", "/cyclic", "7.2f"),
                      ("p99_ratio", "p99", "7.2f"), ("p999_ratio", "p99.9", "7.2f")])
    for busy in (False, True):
        measured = collections.defaultdict(list)
        with Busy(busy):
            for _ in range(repeats):
                if shutil.which("cyclictest"):
                    measured[THEIRS].append(theirs(duration_s))
                for loop, spin_us in OURS.items():
                    measured[loop].append(ours(programs, spin_us, duration_s))
        figures = {loop: {key: statistics.median(one[key] for one in of) for key in (*FIGURES, "max")}
                   for loop, of in measured.items()}
        base = figures.get(THEIRS, {})
        for loop, of in figures.items():
            ratios = {f"{key}_ratio": ratio(of[key], base.get(key)) for key in FIGURES} if loop != THEIRS else {}
            table.row(load="busy" if busy else "idle", loop=loop, **of, **ratios)
    if not shutil.which("cyclictest"):
        table.note("cyclictest is not installed (Debian package rt-tests), so there is nothing to compare with")
    table.save()


if __name__ == "__main__":
    main()
