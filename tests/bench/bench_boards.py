"""scripts/bench boards: the image beside the host build. Usage: bench_boards.py FOLDER_OF_PROGRAMS"""
import json
import os
import statistics
import subprocess
import sys

from bench_table import Table

FIGURES = (("model", "max_position_error_m"), ("odometry", "max_position_error_m"), ("tracking", "max_cross_track_m"))


def main():
    sim, seeds = os.path.join(sys.argv[1], "tp100-sim"), os.environ.get("TP100_BENCH_SEEDS", "5")
    table = Table("boards", f"largest error [cm] over {seeds} seeds: median and interquartile range of each board", [
        ("course", "course", "<10s"), ("robot", "robot", "<10s"), ("error", "error", "<8s"),
        ("native", "native", "7.3f"), ("native_iqr", "iqr", "7.3f"), ("avr", "avr", "7.3f"), ("avr_iqr", "iqr", "7.3f"),
        ("apart", "apart", "7.3f"), ("verdict", "", "<6s")])
    for robot in ("end-loaded", "uniform"):
        for course in ("1-straight", "1-curve", "1-sharp", "2"):
            runs = {board: [json.loads(line) for line in subprocess.run(
                [sim, "course", course, "--board", board, "--robot", robot, "--runs", seeds, "--json"],
                stdout=subprocess.PIPE, text=True).stdout.splitlines()] for board in ("native", "avr")}
            for group, key in FIGURES:
                row = {}
                for board, results in runs.items():
                    low, median, high = statistics.quantiles([run[group][key] * 100 for run in results], n=4,
                                                             method="inclusive")
                    row[board], row[board + "_iqr"] = median, high - low
                apart = abs(row["native"] - row["avr"])
                table.row(course=course, robot=robot, error=group, **row, apart=apart,
                          verdict="within" if apart <= max(row["native_iqr"], row["avr_iqr"]) else "apart")
    table.save()


if __name__ == "__main__":
    main()
