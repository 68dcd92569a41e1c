"""Prints the table of a part whose rows come from standard input, one JSON object per line.

Usage: bench_rows.py PART
"""
import json
import sys

from bench_table import Table

PARTS = {
    "stop": ("from the press to the robot, and how long others wait [ms]", [
        ("what", "what", "<62s"), ("count", "presses", "5d"), ("p50", "p50", "8.2f"), ("p99", "p99", "8.2f"),
        ("max", "max", "8.2f")]),
    "drive": ("driving by hand in virtual time: from the driver's last input, per way to lose the driver; and drives of "
              "20 s with random commands in a fence", [
                  ("what", "what", "<62s"), ("count", "count", "5d"), ("p50", "p50", "9.1f"), ("p99", "p99", "9.1f"),
                  ("max", "max", "9.1f"), ("unit", "unit", "<3s")]),
    "firmware": ("what the firmware takes of a Mega 2560, in cycles of the emulated chip", [
        ("what", "what", "<40s"), ("now", "now", "9.2f"), ("limit", "limit", ">10s")]),
    "step": ("the bridge's step with every estimate, rewind, terrain and control on, course 3 [us]; a step's time is "
             "the median of five passes", [
        ("setup", "set-up", "<7s"), ("steps", "steps", "6d"), ("which", "which", "<22s"), ("caches", "caches", "<6s"),
        ("p50_us", "p50", "7.2f"), ("p99_us", "p99", "7.2f"), ("p999_us", "p99.9", "7.2f"), ("max_us", "max", "8.2f")]),
}


def main():
    part = sys.argv[1]
    title, columns = PARTS[part]
    table = Table(part, title, columns)
    for line in sys.stdin:
        table.row(**json.loads(line))
    table.save()


if __name__ == "__main__":
    main()
