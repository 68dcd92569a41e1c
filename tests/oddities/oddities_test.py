#!/usr/bin/env python3
"""What tp100d does with robots that do what no robot should: each row of oddities.py against a robot that was written
from firmware/PROTOCOL.md alone. Usage: oddities_test.py [--jobs N] [--verbose] PROGRAM [WORD...]; words choose rows by name.

Times are those of the robot's own loop. A run in which that loop, or the program before the oddity, stood still for
50 ms says nothing and is repeated; so is one that broke a limit of time or distance and nothing else, twice at most.
Both are counted at the end. That an Arm or a motion was asked for which should not have been fails at once."""
import argparse
import math
import multiprocessing
import os
import re
import signal
import subprocess
import sys
import tempfile
import time
from collections import namedtuple

from oddities import ROWS
from robot import COUNTS_PER_METRE, DEAD_BAND, FEED_FORWARD, SLIP_LEFT, SLIP_RIGHT, WHEELBASE, Robot, asks_motion

STOOD_STILL_S = 0.05
RUN_S = 7.0
SHORT_M = 0.12
COURSES = {"short": ("line", f"length_m = {SHORT_M}"), "line": ("line", "length_m = 3.0"),
           "bend": ("arc", "radius_m = 0.3\nangle_deg = 30.0\n[[segment]]\ntype = \"line\"\nlength_m = 3.0"),
           "arc": ("arc", "radius_m = 0.3\nangle_deg = 360.0"), "spin": ("pivot", "angle_deg = 350.0")}
FILES = {
    "robot.toml": f"""[model]
slip_left = {SLIP_LEFT}
slip_right = {SLIP_RIGHT}
slip_angle_straight_deg = 0.0
wheelbase_m = {WHEELBASE}
[drive]
counts_per_metre = {COUNTS_PER_METRE}
feed_forward = {FEED_FORWARD}
dead_band = {DEAD_BAND}
""",
    # Nothing that many programs at once cannot have, no port, nothing on the disk; the time for an answer shortened.
    "config.toml": """[link]
first_frame_timeout_ms = 1000.0
[loop]
priority = 0
spin_us = 0
lock_memory = false
hold_cpu_latency = false
[record]
black_box_s = 0.0
[server]
listen = "off"
""",
}
FENCE = "[fence]\nmin_x_m = -5.0\nmax_x_m = 5.0\nmin_y_m = -5.0\nmax_y_m = 5.0\n"
for course, (kind, size) in COURSES.items():
    FILES[course + ".toml"] = f'[[segment]]\ntype = "{kind}"\n{size}\n{FENCE}'

Result = namedtuple("Result", "row reaction status message broken late tries still output")


def live(row, program, folder):
    """One run: the robot, the program's status and what it wrote."""
    robot = Robot(row.when, row.do)
    typed = list(row.typed)
    command = [program, "run", "--port", robot.port, "--course", f"{folder}/{row.course}.toml", "--robot",
               f"{folder}/robot.toml", "--config", f"{folder}/config.toml", *row.options]
    with tempfile.TemporaryFile(mode="w+") as output, subprocess.Popen(
            command, stdin=subprocess.PIPE, stdout=output, stderr=output, text=True) as run:
        def ended():
            for item in typed[:]:
                phase, delay, text = item
                if phase in robot.since and time.monotonic() - robot.since[phase] >= delay:
                    typed.remove(item)
                    run.stdin.write(text)
                    run.stdin.flush()
            return run.poll() is not None
        try:
            robot.run_until(ended, time.monotonic() + RUN_S)
            if run.poll() is None:
                run.send_signal(signal.SIGINT)
                robot.run_until(lambda: run.poll() is not None, time.monotonic() + 1.0)
                robot.ended_by_us = True
        except BrokenPipeError:
            run.wait()
        finally:
            run.kill()
            run.stdin = None
            robot.close()
        status = run.wait()
        output.seek(0)
        return robot, status, output.read()


def judge(row, robot, status, output):
    """(what was broken, limits of time or distance that were exceeded)."""
    must, broken, late = row.must, [], []
    if robot.happened is None:
        return [], ["the oddity never happened"]
    arms = {fields["token"]: at for at, name, fields, _ in reversed(robot.heard) if name == "Arm"}
    if len(arms) > must.arms:
        broken.append(f"{len(arms)} Arms instead of {must.arms}")
    if must.arms == 1 and not must.arrives and row.when[0] not in ("boot", "session"):
        if any(at > robot.happened + 0.001 for at in arms.values()):
            broken.append("an Arm after the oddity")
    motions = [at for at, name, fields, _ in robot.heard if name == "Command" and asks_motion(fields)]
    if robot.refused is not None and motions and motions[-1] > robot.refused + 0.02:
        broken.append(f"motion {1000 * (motions[-1] - robot.refused):.0f} ms after a refused Arm")
    off = robot.asked_off
    if (must.ms or must.m) and off is not None and motions and motions[-1] > robot.happened + off[0]:
        broken.append(f"motion {1000 * (motions[-1] - robot.happened - off[0]):.0f} ms after motors were asked off")
    limits = ((must.ms, 1000, "ms"), (must.m, 1, "m"), (must.deg, math.degrees(1), "deg"))
    for index, (limit, unit, name) in enumerate(limits):
        if limit is not None and off is None:
            broken.append("motors were never asked off")
            break
        if limit is not None and abs(off[index]) * unit > limit:
            late.append(f"{abs(off[index]) * unit:.3g} {name}, at most {limit:g}")
    if must.arrives:
        x, y, yaw = robot.origin
        error = math.hypot(robot.pose[0] - x - SHORT_M * math.cos(yaw), robot.pose[1] - y - SHORT_M * math.sin(yaw))
        if error > 0.015:
            broken.append(f"ends {error:.3f} m beside the end")
    if robot.ended_by_us:
        broken.append("the program did not end by itself")
    elif status not in must.exits:
        broken.append(f"exit {status}")
    if not re.search(row.says, "\n".join(complaints(output)), re.IGNORECASE):
        broken.append(f"no word of {row.says}")
    return broken, late


def stood_still(row, robot):
    """Did this machine stand still for long enough to be the cause of whatever happened?"""
    times = [at for at, name, _, _ in robot.heard if name == "Command" and at < (robot.happened or math.inf)]
    gaps = [b - a for a, b in zip(times, times[1:])] if row.when[0] != "boot" else []
    return max([robot.late] + gaps) > STOOD_STILL_S


def complaints(output):
    """What the program wrote beyond what it always writes: warnings, errors, faults, the reason of an early end."""
    lines = [re.sub(r"^[\d:.]+ ", "", line) for line in output.splitlines()]
    usual = r"info |\w+: (completed|aborted|interrupted|duration) |$"
    return [line for line in lines if not re.match(usual, line)]


def trial(job):
    row, program, folder = job
    tries = still = 0
    while True:
        robot, status, output = live(row, program, folder)
        if stood_still(row, robot) and still < 4:
            still += 1
            continue
        broken, late = judge(row, robot, status, output)
        tries += 1
        if broken or not late or robot.ended_by_us or tries == 3:
            break
    off = robot.asked_off
    reaction = "" if off is None else f"{1000 * off[0]:.0f} ms {off[1]:.3f} m {abs(math.degrees(off[2])):.1f} deg"
    return Result(row.name, reaction, status, (complaints(output) or [""])[-1], broken, late, tries, still, output)


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("program")
    parser.add_argument("words", nargs="*")
    parser.add_argument("--jobs", type=int, default=8)
    parser.add_argument("--verbose", action="store_true", help="print what the program wrote")
    args = parser.parse_args()
    rows = [row for row in ROWS if not args.words or any(word in row.name for word in args.words)]
    failed = tries = still = 0
    with tempfile.TemporaryDirectory(prefix="tp100-oddities-") as folder:
        os.environ["XDG_STATE_HOME"] = folder
        for name, text in FILES.items():
            with open(f"{folder}/{name}", "w", encoding="utf-8") as file:
                file.write(text)
        begin = time.monotonic()
        with multiprocessing.get_context("fork").Pool(args.jobs) as pool:
            jobs = [(index, args.program, folder) for index, row in enumerate(ROWS) if row in rows]
            for result in pool.imap(trial_of, jobs):
                bad = result.broken + result.late
                failed, tries, still = failed + bool(bad), tries + result.tries - 1, still + result.still
                print(f"{'FAIL' if bad else 'ok  '} {result.row:<52} {result.reaction:<28} exit {result.status}  "
                      f"{result.message}", flush=True)
                for what in bad:
                    print(f"       {what}", flush=True)
                if args.verbose:
                    print(result.output, flush=True)
    print(f"{len(rows)} oddities, {failed} failed, {tries} repeated for their time, {still} because the machine stood "
          f"still, {time.monotonic() - begin:.0f} s")
    sys.exit(1 if failed else 0)


def trial_of(job):
    index, program, folder = job
    return trial((ROWS[index], program, folder))


if __name__ == "__main__":
    main()
