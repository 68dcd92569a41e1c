#!/usr/bin/env python3
"""Tests tp100d with faulty robots: runs each row of oddity_list.py with a robot that was written from
firmware/PROTOCOL.md alone. Usage: oddities_test.py [--jobs N] [--verbose] PROGRAM [WORD...]; words select rows by name.

Times are measured by the robot's loop. A failed run is repeated if that loop or the program paused for 50 ms, because
the pause may be the cause. A run that only exceeded a limit of time or distance is also repeated, at most twice. Both
are counted at the end. A forbidden Arm or motion fails the test at once, whatever the machine does."""
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

from oddity_list import ROWS
from robot import COUNTS_PER_METRE, DEAD_BAND, FEED_FORWARD, SLIP_LEFT, SLIP_RIGHT, WHEELBASE, Robot, asks_motion
from wire import GOLDEN, pack, unpack

STOOD_STILL_S = 0.05
STILL_TRIES = 5
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
    # The settings avoid what many programs cannot have at once: real-time resources, a port, files. The answer time-out
    # is shorter.
    "config.toml": """[link]
first_frame_timeout_ms = 1500.0
[loop]
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

Result = namedtuple("Result", "verdict row reaction status message broken repeated still output")


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
                robot.interrupted = True
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
    """Returns what must never happen but did, other errors, and the limits of time and distance that were exceeded."""
    must, never, wrong, late = row.must, [], [], []
    if robot.happened is None:
        return [], ["the oddity never happened"], []
    off = robot.asked_off
    arms = {fields["token"]: at for at, name, fields in reversed(robot.received) if name == "Arm"}
    motions = [at for at, name, fields in robot.received if name == "Command" and asks_motion(fields)]
    if len(arms) > must.arms:
        never.append(f"{len(arms)} Arms instead of {must.arms}")
    if must.arms == 1 and not must.arrives and row.when[0] not in ("boot", "session"):
        if any(at > robot.happened + 0.001 for at in arms.values()):
            never.append("an Arm after the oddity")
    if robot.refused is not None and motions and motions[-1] > robot.refused + 0.02:
        never.append(f"motion {1000 * (motions[-1] - robot.refused):.0f} ms after a refused Arm")
    if (must.ms or must.m) and off is not None and motions and motions[-1] > robot.happened + off[0]:
        never.append(f"motion {1000 * (motions[-1] - robot.happened - off[0]):.0f} ms after motors were asked off")
    limits = ((must.ms, 1000, "ms"), (must.m, 1, "m"), (must.deg, math.degrees(1), "deg"))
    if off is None and any(limit for limit, _, _ in limits):
        wrong.append("motors were never asked off")
    elif off is not None:
        late = [f"{abs(value) * unit:.3g} {name}, at most {limit:g}" for value, (limit, unit, name) in zip(off, limits)
                if limit is not None and abs(value) * unit > limit]
    stops = sum(name == "Stop" for _, name, _ in robot.received)
    if stops < must.stops:
        wrong.append(f"{stops} Stops, at least {must.stops}")
    if must.arrives:
        x, y, yaw = robot.origin
        error = math.hypot(robot.pose[0] - x - SHORT_M * math.cos(yaw), robot.pose[1] - y - SHORT_M * math.sin(yaw))
        if error > 0.015:
            wrong.append(f"ends {error:.3f} m beside the end")
    if robot.interrupted:
        wrong.append("the program did not end by itself")
    elif status not in must.exits:
        wrong.append(f"exit {status}")
    if not re.search(row.words, "\n".join(complaints(output)), re.IGNORECASE):
        wrong.append(f"no word of {row.words}")
    return never, wrong, late


def stood_still(row, robot, output):
    """Did this machine pause long enough to be the cause of the result?"""
    late = [int(ms) * 1e-3 for ms in re.findall(r"cycles of the loop that started late, the longest after (\d+) ms",
    output)]
    times = [at for at, name, _ in robot.received if name == "Command" and at < (robot.happened or math.inf)]
    gaps = [b - a for a, b in zip(times, times[1:])] if row.when[0] != "boot" else []
    return max([robot.late] + gaps + late) > STOOD_STILL_S


def complaints(output):
    """The daemon's output beyond its usual lines: warnings, errors, faults and the reason of an early end."""
    lines = [re.sub(r"^[\d:.]+ ", "", line) for line in output.splitlines()]
    usual = r"info |\w+: (completed|aborted|interrupted|duration) |$"
    return [line for line in lines if not re.match(usual, line)]


def trial(job):
    index, program, folder = job
    row, repeated, still = ROWS[index], 0, 0
    while True:
        robot, status, output = live(row, program, folder)
        never, wrong, late = judge(row, robot, status, output)
        if never or not (wrong or late):
            break
        if stood_still(row, robot, output):
            still += 1
            if still == STILL_TRIES:
                break
        elif wrong or robot.interrupted or repeated == 2:
            break
        else:
            repeated += 1
    off = robot.asked_off
    reaction = "" if off is None else f"{1000 * off[0]:.0f} ms {off[1]:.3f} m {abs(math.degrees(off[2])):.1f} deg"
    verdict = "ok" if not (never or wrong or late) else "FAIL" if never or still < STILL_TRIES else "????"
    return Result(verdict, row.name, reaction, status, (complaints(output) or [""])[-1], never + wrong + late, repeated,
                  still, output)


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("program")
    parser.add_argument("words", nargs="*")
    parser.add_argument("--jobs", type=int, default=8)
    parser.add_argument("--verbose", action="store_true", help="print what the program wrote")
    args = parser.parse_args()
    rows = [row for row in ROWS if not args.words or any(word in row.name for word in args.words)]
    for name, golden in GOLDEN:
        assert pack(*unpack(bytes.fromhex(golden)[:-1])).hex().upper() == golden, name
    results = []
    with tempfile.TemporaryDirectory(prefix="tp100-oddities-") as folder:
        os.environ["XDG_STATE_HOME"] = folder
        for name, text in FILES.items():
            with open(f"{folder}/{name}", "w", encoding="utf-8") as file:
                file.write(text)
        begin = time.monotonic()
        with multiprocessing.get_context("fork").Pool(args.jobs, be_punctual) as pool:
            jobs = [(index, args.program, folder) for index, row in enumerate(ROWS) if row in rows]
            for result in pool.imap(trial, jobs):
                results.append(result)
                print(f"{result.verdict:<4} {result.row:<52} {result.reaction:<28} exit {result.status}  "
                      f"{result.message}", flush=True)
                for what in result.broken:
                    print(f"     {what}", flush=True)
                if args.verbose:
                    print(result.output, flush=True)
    failed, unknown = (sum(result.verdict == verdict for result in results) for verdict in ("FAIL", "????"))
    repeated, still = (sum(counts) for counts in zip(*((result.repeated, result.still) for result in results)))
    print(f"{len(rows)} oddities, {failed} failed; repeated: {repeated} for their time, {still} as the machine stood "
          f"still; {time.monotonic() - begin:.0f} s")
    if unknown and not failed:
        print(f"skipped: the machine stood still in all {STILL_TRIES} runs of {unknown} oddities")
        sys.exit(77)
    sys.exit(1 if failed else 0)


def be_punctual():
    """Gives the robots real-time priority over other programs. Without that right, late runs are repeated."""
    try:
        os.sched_setscheduler(0, os.SCHED_FIFO | os.SCHED_RESET_ON_FORK, os.sched_param(1))
    except PermissionError:
        pass


if __name__ == "__main__":
    main()
