"""scripts/bench viewers: lateness of the loop without viewers and with 50, three of them hostile.

Usage: bench_viewers.py FOLDER_OF_PROGRAMS
"""
import json
import os
import re
import statistics
import subprocess
import sys
import time

from bench_robot import DrivenRobot, cpu_s
from bench_table import Table, rounds, seconds

POLITE = 47  # of the 50
LAPS = 40  # more than the robot drives in that time


def memory_kib(pid, key):
    with open(f"/proc/{pid}/status") as status:
        return int(re.search(key + r":\s+(\d+)", status.read()).group(1))


def measure(programs, viewers, duration_s):
    """Drives one robot; returns its daemon's figures."""
    seen = {}
    with DrivenRobot(programs, LAPS, page=True) as robot:
        before_s = cpu_s(robot.daemon)
        if viewers:
            command = [os.path.join(programs, "viewer_load"), robot.page_port, str(duration_s)]
            seen = json.loads(subprocess.run(command, capture_output=True, text=True, check=True).stdout)
        else:
            time.sleep(duration_s)
        peak = memory_kib(robot.daemon.pid, "VmHWM")
        took_s = cpu_s(robot.daemon) - before_s
    loop = robot.stats["loop"]
    return {**loop["lateness_us"], "overruns": loop["overruns"], "cycles": loop["cycles"],
            "peak_mib": peak / 1024, "cpu": took_s / duration_s, **seen}


def main():
    programs = sys.argv[1]
    duration_s, repeats = seconds(20), rounds(3)
    runs = {0: [], 50: []}
    table = Table("viewers", f"lateness of the loop [us], medians of {repeats} alternating runs of {duration_s:g} s", [
        ("viewers", "viewers", "3d"), ("p50", "p50", "7.1f"), ("p99", "p99", "7.1f"), ("p999", "p99.9", "7.1f"),
        ("max", "max", "8.1f"), ("overruns", "overruns", "5.0f"), ("peak_mib", "peak MiB", "7.1f"),
        ("cpu", "cores", "6.3f"), ("dropped", "dropped for the deaf one", "6.0f"),
        ("received_per_s", "a second for each other", "6.0f")])
    for _ in range(repeats):
        for viewers, list_of in runs.items():
            list_of.append(measure(programs, viewers, duration_s))
    for viewers, list_of in runs.items():
        figures = {key: statistics.median(run[key] for run in list_of)
                   for key in ("p50", "p99", "p999", "max", "overruns", "peak_mib", "cpu")}
        if viewers:
            figures["dropped"] = statistics.median(run["dropped"] for run in list_of)
            figures["received_per_s"] = statistics.median(run["received"] / duration_s / POLITE for run in list_of)
        table.row(viewers=viewers, **figures)
    table.save()


if __name__ == "__main__":
    main()
