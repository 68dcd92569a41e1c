#!/usr/bin/env python3
"""scripts/bench soak: robot and daemon on a pseudo-terminal at 200 Hz, recording, with four viewers, for 80 minutes.

Usage: bench_soak.py FOLDER_OF_PROGRAMS SECONDS. 80 minutes are longer than the robot's clock takes to wrap (71.6
minutes). The robot is started again whenever it has driven its course. Prints what became of the samples, and how
memory, descriptors, threads and the loop's times developed. Exits with 1 if a sample was lost and not counted, the
daemon grew, no course was completed, a viewer was lost, or the recording is incomplete. Times are only printed: they
depend on the machine.
"""
import json
import os
import re
import signal
import subprocess
import sys
import tempfile
import time

VIEWERS = 4
LOOKS = 40  # measurements of the daemon over the whole time
SETTLED = LOOKS // 10  # from this one on nothing may grow by more than
MAY_GROW = {"memory_kib": 8192, "threads": 0, "descriptors": 0}  # 8 MiB: the allocator's own noise
PROGRAMS, SECONDS = sys.argv[1], float(sys.argv[2])


def wait_for(pattern, path, patience_s=20):
    """The first group of the pattern, once a program has printed it to this file."""
    for _ in range(patience_s * 10):
        with open(path) as file:
            if found := re.search(pattern, file.read()):
                return found[1]
        time.sleep(0.1)
    return sys.exit(f"soak: a program has not printed {pattern}")


def look(daemon, stats):
    """The daemon's resources and its loop's times at this moment."""
    if daemon.poll() is not None:
        sys.exit("soak: tp100d ended by itself")
    with open(f"/proc/{daemon.pid}/status") as file:
        status = file.read()
    with open(stats) as file:
        loop = json.load(file)["loop"]
    return {"memory_kib": int(re.search(r"VmRSS:\s+(\d+)", status)[1]),
            "threads": int(re.search(r"Threads:\s+(\d+)", status)[1]),
            "descriptors": len(os.listdir(f"/proc/{daemon.pid}/fd")),
            "mean_lateness_us": round(loop["lateness_us"]["mean"], 1), "mean_work_us": round(loop["work_us"]["mean"], 1)}


def drive(folder, seconds):
    """Drives for this time. Returns the looks, what the viewers saw, the robot's count of samples, the daemon's figures
    at its end, and the number of completed courses."""
    link, stats, sent, log = (os.path.join(folder, name) for name in ("robot", "stats.json", "sent", "log"))
    with open(sent, "w") as out, open(log, "w") as err:
        robot = subprocess.Popen([PROGRAMS + "/tp100-sim", "robot", "--link", link], stdout=out)
        wait_for("(linked from)", sent)
        daemon = subprocess.Popen([PROGRAMS + "/tp100d", "run", "--port", link, "--course", "1-curve", "--go", "--stay",
                                   "--listen", "127.0.0.1:0", "--stats", stats, "--record", folder + "/runs"], stderr=err)
    try:
        page = wait_for(r"page: http://127.0.0.1:(\d+)/", log)
        viewers = subprocess.Popen([PROGRAMS + "/viewer_load", page, str(seconds + 1), str(VIEWERS)],
                                   stdout=subprocess.PIPE, text=True)
        looks = []
        for _ in range(LOOKS):
            time.sleep(seconds / LOOKS)
            looks.append(look(daemon, stats))
        seen = json.loads(viewers.communicate()[0])
        robot.send_signal(signal.SIGTERM)
        samples = int(wait_for(r"sent (\d+) samples", sent))
        time.sleep(1)
    finally:
        robot.kill()
        daemon.send_signal(signal.SIGTERM)
        daemon.wait()
        robot.wait()
    with open(stats) as file, open(log) as said:
        return looks, seen, samples, json.load(file), said.read().count("running -> finished")


def judge(looks, seen, sent, figures, driven):
    """Prints everything; returns a sentence for each failure."""
    link, loop, recording = figures["link"], figures["loop"], figures["recording"]
    missing = sent - link["samples"] - link["lost"] - link["early"]
    print(f"soak: {figures['duration_s'] / 60:.1f} min, {driven} courses completed; {sent} samples sent, {missing} unaccounted for")
    for name, part in (("link", link), ("loop", loop), ("recording", recording), ("viewers", seen)):
        print(f"  {name}: {json.dumps(part)}")
    for key in looks[0]:
        print(f"  {key}: " + " ".join(str(each[key]) for each in looks[::LOOKS // 10] + looks[-1:]))
    # Samples in transit when the robot was switched off.
    wrong = [] if link["reconnects"] or 0 <= missing <= 2 else [f"{missing} samples were neither used nor counted as lost"]
    if link["reconnects"]:
        wrong.append(f"the link broke {link['reconnects']} times: samples cannot be accounted for (is the machine busy?)")
    if recording["dropped"] or recording["warning"]:
        wrong.append(f"the recording is incomplete: {recording['dropped']} messages dropped. {recording['warning']}")
    if seen["lost_viewers"]:
        wrong.append(f"{seen['lost_viewers']} of {VIEWERS} viewers were lost")
    if not driven:
        wrong.append("no course was completed")
    return wrong + [f"{key} grew from {looks[SETTLED][key]} to {looks[-1][key]}" for key, most in MAY_GROW.items()
                    if looks[-1][key] - looks[SETTLED][key] > most]


def main():
    with tempfile.TemporaryDirectory(prefix="tp100-soak-") as folder:
        wrong = judge(*drive(folder, SECONDS))
    for sentence in wrong:
        print(f"soak: {sentence}", file=sys.stderr)
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
