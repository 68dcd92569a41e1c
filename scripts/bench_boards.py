"""Medians and interquartile ranges of both boards from `tp100-sim course --json` lines on standard input."""
import json
import statistics
import sys

FIGURES = (("model", "max_position_error_m"), ("odometry", "max_position_error_m"), ("tracking", "max_cross_track_m"))

runs = [json.loads(line) for line in sys.stdin]
for group, key in FIGURES:
    row = {}
    for board in ("native", "avr"):
        values = [run[group][key] * 100 for run in runs if run["board"] == board]
        low, median, high = statistics.quantiles(values, n=4, method="inclusive")
        row[board] = (median, high - low)
    apart = abs(row["native"][0] - row["avr"][0])
    wider = max(row["native"][1], row["avr"][1])
    print("  {:12s} {:12s} {:9s} {:8.3f} {:8.3f} {:8.3f} {:8.3f} {:8.3f}  {}".format(
        runs[0]["course"], runs[0]["robot"], group, *row["native"], *row["avr"], apart,
        "within" if apart <= wider else "apart"))
