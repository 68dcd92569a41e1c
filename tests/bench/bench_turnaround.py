"""scripts/bench turnaround: from a robot's sample to the command that answers it, over a pseudo-terminal.

Usage: bench_turnaround.py FOLDER_OF_PROGRAMS. Waking a program on another processor takes longer than all the work of a
bridge, and the kernel's placement is random. Therefore three placements are distinguished: "together" (robot and peer
on one processor), "apart" (on two) and "any" (chosen by the kernel); ratios are taken within each. The bridge is
compared with an echo of its own priority, because on a busy machine the kernel moves an ordinary program to the
processor of the program that wakes it.
"""
import collections
import json
import os
import shutil
import subprocess
import sys
import tempfile

from bench_table import Busy, Table, percentile, ratio, rounds, seconds

BASE = "C echo, FIFO"
LAST = str(os.cpu_count() - 1)
# Placement: (processor of the robot, processor of the peer); None: any.
PLACEMENTS = {"any": (None, None), "together": (LAST, LAST)} | ({"apart": ("0", LAST)} if LAST != "0" else {})


def peers(programs, folder):
    """The peers that answer, as (kind, command)."""
    def daemon(pacing):
        config = os.path.join(folder, pacing + ".toml")
        with open(config, "w") as file:
            file.write(f'[loop]\npacing = "{pacing}"\n')
        return ("daemon", [os.path.join(programs, "tp100d"), "run", "--port", "PORT", "--listen", "off",
                           "--config", config])

    echo = [os.path.abspath(os.path.join(programs, "turnaround_bench")), "--echo", "PORT"]
    return {
        BASE: ("echo", [shutil.which("chrt"), "-f", "80", *echo]),
        "tp100d, robot-paced": daemon("robot"),
        # By design, its median is the wait for the loop's next cycle.
        "tp100d, host-paced": daemon("host"),
    }


def tied(processor):
    return [] if processor is None else [shutil.which("taskset"), "-c", processor]


def measure(programs, placement, kind, command, duration_s):
    robot, peer = PLACEMENTS[placement]
    done = subprocess.run([*tied(robot), os.path.join(programs, "turnaround_bench"), kind, str(duration_s),
                           *tied(peer), *command],
                          stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
    if done.returncode:
        raise SystemExit(f"bench: {done.stderr.strip().splitlines()[-1]}")
    return json.loads(done.stdout)


def measure_all(programs, candidates, placement, busy):
    """Times [us] and unanswered samples of each candidate."""
    times, lost = collections.defaultdict(list), collections.Counter()
    with Busy(busy):
        for _ in range(rounds(3)):
            for name, (kind, command) in candidates.items():
                measured = measure(programs, placement, kind, command, seconds(6))
                times[name] += measured["us"]
                lost[name] += measured["unanswered"]
    return times, lost


def show(table, load, placement, times, lost):
    figures = {name: {f"{key}_us": percentile(of, share) for key, share in
                      (("p50", 0.5), ("p99", 0.99), ("p999", 0.999))} for name, of in times.items() if of}
    for name, of in figures.items():
        table.row(load=load, placement=placement, peer=name, count=len(times[name]), unanswered=lost[name], **of,
                  p50_ratio=ratio(of["p50_us"], figures[BASE]["p50_us"]),
                  p99_ratio=ratio(of["p99_us"], figures[BASE]["p99_us"]))


def main():
    programs = sys.argv[1]
    table = Table("turnaround", f"sample to command over a pty [us], {rounds(3)} alternating rounds of {seconds(6):g} s",
                  [("load", "load", "<4s"), ("placement", "placed", "<8s"), ("peer", "answered by", "<24s"),
                   ("count", "samples", "6d"), ("p50_us", "p50", "9.1f"), ("p99_us", "p99", "9.1f"),
                   ("p999_us", "p99.9", "9.1f"), ("p50_ratio", "/C p50", "8.2f"), ("p99_ratio", "/C p99", "8.2f"),
                   ("unanswered", "lost", "4d")])
    with tempfile.TemporaryDirectory(prefix="tp100-bench-") as folder:
        candidates = peers(programs, folder)
        for busy in (False, True):
            for placement in PLACEMENTS:
                show(table, "busy" if busy else "idle", placement, *measure_all(programs, candidates, placement, busy))
    table.save()


if __name__ == "__main__":
    main()
