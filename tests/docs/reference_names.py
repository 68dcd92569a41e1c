#!/usr/bin/env python3
"""reference_names.py REFERENCE.md PROGRAMS: every name that the programs print must be in that page, between backticks.

Checked are an emulated run, the report of its recording, an identification from one drive, a small campaign, the doctor
with and without a robot, and the figures of a live daemon.
"""
import glob
import json
import os
import re
import subprocess
import sys
import tempfile


# Eight runs: some fail, some are refused.
CAMPAIGN = """runs = 8
course = "1-curve"
[configuration]
control.time_limit_factor = { list = [1.0, 3.0] }
[robot_values]
drive.max_track_mps = { list = [0.2, 99.0] }
emulated.body.friction = { uniform = [0.6, 0.9] }
"""
# The keys below these are keys of files, causes and rights, not names of figures.
NAMED = {"privileges", "causes", "sampled", "rank_correlation"}


def names(value):
    """Names of all nested keys (those with dots split into parts) and of the doctor's findings."""
    if isinstance(value, list):
        return {name for one in value for name in names(one)}
    if not isinstance(value, dict):
        return set()
    own = {piece for key in value for piece in key.split(".")}
    if "severity" in value:
        own.add(value["name"])
    return own | {name for key, below in value.items() if key not in NAMED for name in names(below)}


def paths(value, above=""):
    """All keys outside of lists, each after those around it: link.samples."""
    if not isinstance(value, dict):
        return set()
    return {above + key for key in value} | {path for key in value for path in paths(value[key], f"{above}{key}.")}


def astray(page, value):
    """What a program prints below a name whose parts the page lists (`link.samples`, `.early`), and which is none of them."""
    listed = set()
    for cell in re.findall(r"^\| ([^|]*)", page, re.MULTILINE):
        parent = ""
        for name in re.findall(r"`([\w.]+)`", cell):
            if not name.startswith("."):
                parent = name.rpartition(".")[0]
            listed.add(parent + name if name.startswith(".") else name)
    parents = {name.rpartition(".")[0] for name in listed} - {""}
    return {path for path in paths(value) - listed if path.rpartition(".")[0] in parents}


def run(*command):
    return subprocess.run(command, check=True, stdout=subprocess.PIPE, text=True).stdout


def doctor(programs, port):
    """The doctor's findings, whatever its status."""
    return json.loads(subprocess.run([os.path.join(programs, "tp100d"), "doctor", "--json", "--port", port],
                                     stdout=subprocess.PIPE, text=True, check=False).stdout)


def identified(programs, folder):
    drives = os.path.join(folder, "drives")
    run(os.path.join(programs, "tp100-sim"), "course", "calibrate-spin-left", "--camera", "--record", drives)
    return json.loads(run(os.path.join(programs, "tp100d"), "identify", *glob.glob(os.path.join(drives, "*")), "--json",
                          "--out", os.path.join(folder, "robot.toml")))


def campaign(programs, folder):
    program = os.path.join(programs, "tp100-sim")
    spec, out = os.path.join(folder, "spec.toml"), os.path.join(folder, "many")
    with open(spec, "w") as file:
        file.write(CAMPAIGN)
    # Status 1 is accepted, because some runs are refused.
    for command in (["campaign", spec, "--out", out], ["merge", out]):
        subprocess.run([program, *command], stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, check=False)
    with open(os.path.join(out, "merged.json")) as file:
        return json.load(file)


def live(programs, folder):
    link, stats = os.path.join(folder, "robot"), os.path.join(folder, "stats.json")
    robot = subprocess.Popen([os.path.join(programs, "tp100-sim"), "robot", "--link", link], stdout=subprocess.DEVNULL)
    try:
        subprocess.run([os.path.join(programs, "tp100d"), "run", "--port", link, "--wait", "--setup", "stand", "--duration",
                        "5", "--listen", "off", "--stats", stats, "--record", os.path.join(folder, "live")],
                       stderr=subprocess.DEVNULL)
        examined = doctor(programs, link)
    finally:
        robot.kill()
        robot.wait()
    with open(stats) as file:
        return json.load(file), examined


def main():
    page, programs = sys.argv[1:]
    with open(page) as file:
        text = file.read()
    marked = " ".join(re.findall(r"`([^`]+)`", text))
    words = set(re.findall(r"\w+", marked)) | set(re.findall(r"[\w-]+", marked))
    with tempfile.TemporaryDirectory(prefix="tp100-docs-") as folder:
        record = os.path.join(folder, "runs")
        printed = {"tp100-sim course --json": json.loads(
            run(os.path.join(programs, "tp100-sim"), "course", "2", "--camera", "--json", "--record", record))}
        run(os.path.join(programs, "tp100d"), "report", *glob.glob(os.path.join(record, "*", "run.mcap")))
        with open(glob.glob(os.path.join(record, "*", "metrics.json"))[0]) as file:
            printed["metrics.json"] = json.load(file)
        printed["identify --json"] = identified(programs, folder)
        printed["merged.json"] = campaign(programs, folder)
        printed["--stats"], printed["doctor --json"] = live(programs, folder)
        printed["doctor --json, no robot"] = doctor(programs, os.path.join(folder, "nothing"))
    missing = [f"{where}: {name}" for where, json_value in printed.items() for name in sorted(names(json_value) - words)]
    for where in ("tp100-sim course --json", "metrics.json", "--stats"):
        missing += [f"{where}: {name}" for name in sorted(astray(text, printed[where]))]
    for line in missing:
        print(f"{page} does not explain {line}", file=sys.stderr)
    return 1 if missing else 0


if __name__ == "__main__":
    sys.exit(main())
