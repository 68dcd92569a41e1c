"""scripts/bench turnaround: from a robot's sample to the command that answers it, over a pseudo-terminal.

Usage: bench_turnaround.py FOLDER_OF_PROGRAMS. TP100_BENCH_CPU ties everybody who answers to that processor; else to
none, and then it is the kernel's choice of processors that decides the medians of an idle machine.
"""
import collections
import json
import os
import subprocess
import sys
import tempfile

from bench_load import Busy
from bench_table import ROOT, Table, percentile, ratio, rounds, seconds

BASE = "bare C echo"
OURS = "tp100d, robot-paced"
# Its median is the wait for the next turn of the loop, by design.
HOST_PACED = "tp100d, host-paced"
TEXT = "text files, "
PINNED = ["taskset", "-c", os.environ["TP100_BENCH_CPU"]] if "TP100_BENCH_CPU" in os.environ else []


def script(name):
    return os.path.join(ROOT, "scripts", name)


def peers(programs, folder):
    """Who answers, as (kind, command)."""
    def daemon(pacing):
        config = os.path.join(folder, pacing + ".toml")
        with open(config, "w") as file:
            file.write(f'[loop]\npacing = "{pacing}"\n')
        return ("daemon", [os.path.join(programs, "tp100d"), "run", "--port", "PORT", "--listen", "off",
                           "--config", config])

    def text(poll_s):
        return ("echo", [sys.executable, script("bench_text_files.py"), "PORT", str(poll_s)])
    echo = os.path.join(programs, "pty_echo")
    return {
        BASE: ("echo", [echo, "PORT"]),
        "C echo, FIFO": ("echo", ["chrt", "-f", "80", echo, "PORT"]),
        OURS: daemon("robot"),
        HOST_PACED: daemon("host"),
        "Python os.read": ("echo", [sys.executable, script("bench_echo.py"), "PORT"]),
        TEXT + "every 10 ms": text(0.01),
        TEXT + "every 1 ms": text(0.001),
        TEXT + "spinning": text(0.0),
    }


def measure(programs, kind, command, duration_s):
    done = subprocess.run([os.path.join(programs, "turnaround_bench"), kind, str(duration_s), *PINNED, *command],
                          stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
    if done.returncode:
        raise SystemExit(f"bench: {done.stderr.strip().splitlines()[-1]}")
    return json.loads(done.stdout)


def main():
    programs = sys.argv[1]
    duration_s, repeats = seconds(10), rounds(3)
    table = Table("turnaround", f"sample to command over a pty [us], {repeats} alternating rounds of {duration_s:g} s",
                  [("load", "load", "<4s"), ("peer", "answered by", "<24s"), ("count", "samples", "6d"),
                   ("p50_us", "p50", "9.1f"), ("p99_us", "p99", "9.1f"), ("p999_us", "p99.9", "9.1f"),
                   ("p50_ratio", "/C p50", "8.2f"), ("p99_ratio", "/C p99", "8.2f"),
                   ("unanswered", "lost", "4d")])
    with tempfile.TemporaryDirectory(prefix="tp100-bench-") as folder:
        candidates = peers(programs, folder)
        for busy in (False, True):
            times, lost = collections.defaultdict(list), collections.Counter()
            with Busy(busy):
                for _ in range(repeats):
                    for name, (kind, command) in candidates.items():
                        measured = measure(programs, kind, command, duration_s)
                        times[name] += measured["us"]
                        lost[name] += measured["unanswered"]
            figures = {name: {f"{key}_us": percentile(times[name], share) for key, share in
                              (("p50", 0.5), ("p99", 0.99), ("p999", 0.999))} for name in candidates if times[name]}
            for name, of in figures.items():
                table.row(load="busy" if busy else "idle", peer=name, count=len(times[name]), unanswered=lost[name],
                          **of, p50_ratio=ratio(of["p50_us"], figures[BASE]["p50_us"]),
                          p99_ratio=ratio(of["p99_us"], figures[BASE]["p99_us"]))
            for name, of in figures.items():
                if name.startswith(TEXT):
                    table.note(f"{name}: p99 {ratio(of['p99_us'], figures[OURS]['p99_us']):.0f} times that of {OURS}")
    table.save()


if __name__ == "__main__":
    main()
