"""scripts/bench cpu and one_core: what a robot at 200 Hz takes of the processors.

`cpu`: processor time by the length of the run (early and late), the length of the path, and viewers. `one_core`: the
number of robots whose daemons one processor can run without missed deadlines. Their daemons are pinned to it, the
emulated robots to the others and on a stand (set-up `stand`), where they need no physics and little processor time; if
they are the limit, the row says so. The count doubles until deadlines are missed, then the limit is bisected.
Usage: bench_cpu.py FOLDER_OF_PROGRAMS cpu|one_core
"""
import concurrent.futures
import contextlib
import os
import subprocess
import sys
import time

from bench_robot import LAPS, DrivenRobot, cores
from bench_table import Table, ratio, seconds

LATE_AFTER = 6  # measuring times from the first window to the last
MOST_ROBOTS = int(os.environ.get("TP100_BENCH_ROBOTS", "128"))
HELD = 0.001  # share of the cycles that may be skipped
FULL = 0.9  # load of the emulated robots' processors from which on they are late themselves
STARTED_AT_ONCE = 8
STATS_PERIOD_S = 1.0  # of the daemon's --stats


def one_robot(programs, duration_s, laps=LAPS, viewers=0, late=False):
    """Processors that one robot takes, and how its loop fared."""
    with DrivenRobot(programs, laps, page=viewers > 0) as robot:
        looking = viewers and subprocess.Popen(
            [os.path.join(programs, "viewer_load"), robot.page_port, str(duration_s + 1), str(viewers)],
            stdout=subprocess.DEVNULL)
        if late:
            time.sleep((LATE_AFTER - 1) * duration_s)
        daemon, emulator = cores([robot], duration_s)
        if looking:
            looking.wait()
    loop = robot.stats["loop"]
    return {"daemon": daemon, "robot": emulator, "late_p99_us": loop["lateness_us"]["p99"],
            "overruns": loop["overruns"], "lost": robot.stats["link"]["lost"]}


def cpu(programs, duration_s):
    table = Table("cpu", f"processors that a robot at 200 Hz takes, over {duration_s:g} s", [
        ("what", "what", "<28s"), ("daemon", "tp100d", "7.4f"), ("robot", "tp100-sim", "7.4f"),
        ("growth", "tp100d/first", "6.2f"), ("late_p99_us", "lateness p99 [us]", "8.1f"),
        ("overruns", "overruns", "5d"), ("lost", "lost", "5d")])
    first = None
    for what, case in [("early in a run", {}), (f"{LATE_AFTER}th {duration_s:g} s of it", {"late": True}),
                       *((f"path of {laps * 4} segments", {"laps": laps}) for laps in (2, 200)),
                       *((f"{viewers} viewers", {"viewers": viewers}) for viewers in (4, 16))]:
        values = one_robot(programs, duration_s, **case)
        table.row(what=what, growth=first and ratio(values["daemon"], first), **values)
        first = first or values["daemon"]
    table.save()


def processors():
    """(processor of the daemons, processors of the robots)."""
    usable = sorted(os.sched_getaffinity(0))
    ours = int(os.environ.get("TP100_BENCH_CPU", usable[-1]))
    return [ours], [number for number in usable if number != ours] or [ours]


def counted(robots):
    """Cycles, overruns and skipped cycles so far, summed over all robots."""
    loops = [robot.stats_now()["loop"] for robot in robots]
    return [sum(loop[key] for loop in loops) for key in ("cycles", "overruns", "missed")]


def many_robots(programs, count, duration_s):
    on = processors()
    with contextlib.ExitStack() as stack:
        robots = [DrivenRobot(programs, setup="stand", processors=on) for _ in range(count)]
        with concurrent.futures.ThreadPoolExecutor(STARTED_AT_ONCE) as pool:
            list(pool.map(stack.enter_context, robots))
        time.sleep(2 * STATS_PERIOD_S)
        before = counted(robots)
        daemons, emulators = cores(robots, duration_s)
        cycles, overruns, missed = (now - was for now, was in zip(counted(robots), before))
        drove = sum(robot.still_drives() for robot in robots)
        for robot in robots:
            robot.daemon.terminate()
    return {"robots": count, "drove": drove, "daemons": daemons, "emulators": emulators / len(on[1]),
            "late_p99_us": max(robot.stats["loop"]["lateness_us"]["p99"] for robot in robots),
            "overruns": overruns, "missed": missed / max(cycles + missed, 1)}


def verdict(row):
    if row["missed"] > HELD:
        return "deadlines missed"
    if row["drove"] < row["robots"]:
        return "robots late" if row["emulators"] > FULL else "stopped driving"
    return "held, robots late" if row["emulators"] > FULL else "held"


def one_core(programs, duration_s):
    table = Table("one_core", f"robots whose daemons share a processor, over {duration_s:g} s; held: at most "
                  f"{HELD:.1%} of the cycles skipped, and all drive", [
                      ("robots", "robots", "4d"), ("drove", "drove", "4d"), ("daemons", "of the processor", "7.3f"),
                      ("emulators", "robots, of theirs", "7.3f"), ("late_p99_us", "worst lateness p99 [us]", "9.1f"),
                      ("overruns", "overruns", "6d"), ("missed", "cycles skipped", "9.5f"),
                      ("verdict", "verdict", "<17s")])
    if len(os.sched_getaffinity(0)) == 1:
        table.note("there is one processor only: the emulated robots share it")
    held, not_held, count = 0, None, 1
    while count <= MOST_ROBOTS and (not_held is None or not_held - held > max(1, held // 8)):
        try:
            row = many_robots(programs, count, duration_s)
            said = verdict(row)
        except SystemExit as error:  # not even a session
            row, said = {"robots": count}, "no session"
            table.note(str(error))
        table.row(**row, verdict=said)
        if said.startswith("held"):
            held = count
        else:
            not_held = count
        count = held * 2 if not_held is None else (held + not_held) // 2
    beyond = "more were not tried (TP100_BENCH_ROBOTS)" if not_held is None else f"not {not_held}"
    table.note(f"one processor holds {held} robots; {beyond}")
    table.save()


if __name__ == "__main__":
    {"cpu": cpu, "one_core": one_core}[sys.argv[2]](sys.argv[1], seconds(20))
