"""scripts/bench one_core: the number of robots at 200 Hz whose daemons one processor can run without missed deadlines.

All daemons are pinned to one processor, the emulated robots to the others. The robots are on a stand (set-up `stand`),
where they need no physics and little processor time; if they are the limit, the row says so. The count doubles until
deadlines are missed, then the limit is bisected. Usage: bench_one_core.py FOLDER_OF_PROGRAMS
"""
import concurrent.futures
import contextlib
import os
import signal
import sys
import time

from bench_robot import DrivenRobot, cores
from bench_table import Table, seconds

LAPS = 50  # of 4.5 m: more than any robot drives here
MOST_ROBOTS = int(os.environ.get("TP100_BENCH_ROBOTS", "128"))
HELD = 0.001  # share of the cycles that may be skipped
FULL = 0.9  # load of the emulated robots' processors from which on they are late themselves
STARTED_AT_ONCE = 8
STATS_PERIOD_S = 1.0  # of the daemon's --stats


def processors():
    """(processor of the daemons, processors of the robots)."""
    usable = sorted(os.sched_getaffinity(0))
    ours = int(os.environ.get("TP100_BENCH_CPU", usable[-1]))
    return [ours], [number for number in usable if number != ours] or [ours]


def counted(robots):
    """Cycles, overruns and skipped cycles so far, summed over all robots."""
    loops = [robot.stats_now()["loop"] for robot in robots]
    return [sum(loop[key] for loop in loops) for key in ("cycles", "overruns", "missed")]


def measured(programs, count, duration_s):
    on = processors()
    with contextlib.ExitStack() as stack:
        robots = [DrivenRobot(programs, LAPS, setup="stand", processors=on) for _ in range(count)]
        with concurrent.futures.ThreadPoolExecutor(STARTED_AT_ONCE) as pool:
            list(pool.map(stack.enter_context, robots))
        time.sleep(2 * STATS_PERIOD_S)
        before = counted(robots)
        daemons, emulators = cores(robots, duration_s)
        cycles, overruns, missed = (now - was for now, was in zip(counted(robots), before))
        drove = sum(robot.still_drives() for robot in robots)
        for robot in robots:
            robot.daemon.send_signal(signal.SIGTERM)
    return {"robots": count, "drove": drove, "daemons": daemons, "emulators": emulators / len(on[1]),
            "late_p99_us": max(robot.stats["loop"]["lateness_us"]["p99"] for robot in robots),
            "overruns": overruns, "missed": missed / max(cycles + missed, 1)}


def verdict(row):
    if row["missed"] > HELD:
        return "deadlines missed"
    if row["drove"] < row["robots"]:
        return "robots late" if row["emulators"] > FULL else "stopped driving"
    return "held, robots late" if row["emulators"] > FULL else "held"


class Search:
    def __init__(self, programs, table, duration_s):
        self.programs, self.table, self.duration_s = programs, table, duration_s
        self.held, self.not_held, self.why = 0, None, None

    def attempt(self, count):
        try:
            row = measured(self.programs, count, self.duration_s)
            said = verdict(row)
        except SystemExit as error:  # not even a session
            row, said = {"robots": count}, "no session"
            self.table.note(str(error))
        self.table.row(**row, verdict=said)
        if said.startswith("held"):
            self.held = count
        else:
            self.not_held, self.why = count, said

    def run(self):
        count = 1
        while self.not_held is None and count <= MOST_ROBOTS:
            self.attempt(count)
            count *= 2
        while self.not_held is not None and self.not_held - self.held > max(1, self.held // 8):
            self.attempt((self.held + self.not_held) // 2)

    def note(self):
        text = f"one processor holds {self.held} robots"
        if self.not_held is None:
            return text + "; more were not tried (TP100_BENCH_ROBOTS)"
        return text + f", not {self.not_held}: {self.why}"


def main():
    programs, duration_s = sys.argv[1], seconds(20)
    ours, others = processors()
    table = Table("one_core", f"robots whose daemons share processor {ours[0]}, over {duration_s:g} s; held: at most "
                  f"{HELD:.1%} of the cycles skipped, and all drive", [
                      ("robots", "robots", "4d"), ("drove", "drove", "4d"), ("daemons", "of the processor", "7.3f"),
                      ("emulators", "robots, of theirs", "7.3f"), ("late_p99_us", "worst lateness p99 [us]", "9.1f"),
                      ("overruns", "overruns", "6d"), ("missed", "cycles skipped", "9.5f"),
                      ("verdict", "verdict", "<17s")])
    if ours == others:
        table.note("there is one processor only: the emulated robots share it")
    search = Search(programs, table, duration_s)
    search.run()
    table.note(search.note())
    table.save()


if __name__ == "__main__":
    main()
