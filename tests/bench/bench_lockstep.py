"""scripts/bench lockstep: speed of courses in virtual time on one core, and which parts take the time.

Usage: bench_lockstep.py FOLDER_OF_PROGRAMS
"""
import json
import os
import statistics
import subprocess
import sys

from bench_table import Table, rounds


def course(programs, board, robot, name, seeds):
    core = {min(os.sched_getaffinity(0))}
    out = subprocess.run([os.path.join(programs, "tp100-sim"), "course", name, "--board", board, "--robot", robot,
                          "--runs", str(seeds), "--json"], stdout=subprocess.PIPE, text=True,
                         preexec_fn=lambda: os.sched_setaffinity(0, core)).stdout
    return [json.loads(line) for line in out.splitlines()]


def main():
    programs, seeds = sys.argv[1], rounds(5)
    table = Table("lockstep", f"times real time on one core, {seeds} seeds; shares of the time; ours is all but "
                  "physics and board", [
                      ("board", "board", "<6s"), ("course", "course", "<10s"), ("robot", "robot", "<10s"),
                      ("min", "min", "7.1f"), ("median", "median", "7.1f"), ("max", "max", "7.1f"),
                      ("step_us", "our step [us]", "7.2f"), ("physics", "physics", "7.1%"),
                      ("emulation", "board", "7.1%"), ("ours", "ours", "7.1%"),
                      ("ours_ratio", "ours/(physics+board)", "7.2f")])
    for board in ("native", "avr"):
        for robot in ("end-loaded", "uniform"):
            for name in ("1-straight", "1-curve", "1-sharp", "2"):
                runs = course(programs, board, robot, name, seeds)
                speed = [run["realtime_factor"] for run in runs]
                spent = {key: statistics.median(run["loop"][key] for run in runs)
                         for key in ("physics_s", "board_s", "rest_s")}
                whole = sum(spent.values())
                table.row(board=board, course=name, robot=robot, min=min(speed), median=statistics.median(speed),
                          max=max(speed), step_us=statistics.median(run["loop"]["mean_step_us"] for run in runs),
                          physics=spent["physics_s"] / whole, emulation=spent["board_s"] / whole,
                          ours=spent["rest_s"] / whole,
                          ours_ratio=spent["rest_s"] / (spent["physics_s"] + spent["board_s"]))
    table.save()


if __name__ == "__main__":
    main()
