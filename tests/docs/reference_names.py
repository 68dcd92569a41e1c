#!/usr/bin/env python3
"""reference_names.py REFERENCE.md PROGRAMS: every name that the programs print stands in that page, between backticks.

An emulated run, the report of its recording, and the figures of a live daemon are asked.
"""
import glob
import json
import os
import re
import subprocess
import sys
import tempfile


def names(value):
    """Of all keys below, each by itself; what is counted by name (rights that were granted) has none."""
    if isinstance(value, list):
        return {name for one in value for name in names(one)}
    if not isinstance(value, dict):
        return set()
    return set(value) | {name for key, below in value.items() if key != "privileges" for name in names(below)}


def run(*command):
    return subprocess.run(command, check=True, stdout=subprocess.PIPE, text=True).stdout


def live(programs, folder):
    link, stats = os.path.join(folder, "robot"), os.path.join(folder, "stats.json")
    robot = subprocess.Popen([os.path.join(programs, "tp100-sim"), "robot", "--link", link], stdout=subprocess.DEVNULL)
    try:
        subprocess.run([os.path.join(programs, "tp100d"), "run", "--port", link, "--wait", "--setup", "bench", "--duration",
                        "5", "--listen", "off", "--stats", stats, "--record", os.path.join(folder, "live")],
                       stderr=subprocess.DEVNULL)
    finally:
        robot.kill()
        robot.wait()
    with open(stats) as file:
        return json.load(file)


def main():
    page, programs = sys.argv[1:]
    with open(page) as file:
        words = set(re.findall(r"\w+", " ".join(re.findall(r"`([^`]+)`", file.read()))))
    with tempfile.TemporaryDirectory(prefix="tp100-docs-") as folder:
        record = os.path.join(folder, "runs")
        printed = {"tp100-sim course --json": json.loads(
            run(os.path.join(programs, "tp100-sim"), "course", "2", "--camera", "--json", "--record", record))}
        run(os.path.join(programs, "tp100d"), "report", *glob.glob(os.path.join(record, "*", "run.mcap")))
        with open(glob.glob(os.path.join(record, "*", "metrics.json"))[0]) as file:
            printed["metrics.json"] = json.load(file)
        printed["--stats"] = live(programs, folder)
    missing = [f"{where}: {name}" for where, json_value in printed.items() for name in sorted(names(json_value) - words)]
    for line in missing:
        print(f"{page} does not explain {line}", file=sys.stderr)
    return 1 if missing else 0


if __name__ == "__main__":
    sys.exit(main())
