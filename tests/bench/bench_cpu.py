"""scripts/bench cpu: processor time and memory of a robot at 200 Hz, and whether they grow.

Measured by the length of the run (early and late), the length of the path, viewers and robots. Usage: bench_cpu.py
FOLDER_OF_PROGRAMS
"""
import contextlib
import os
import subprocess
import sys

from bench_robot import DrivenRobot, cores
from bench_table import Table, ratio, rounds, seconds

# Laps of 4.5 m: more than any robot drives here.
USUAL_LAPS = 50
# Time from the first window to the last, in measuring times.
LATE_AFTER = 6
MOST_ROBOTS = int(os.environ.get("TP100_BENCH_ROBOTS", "4"))


def measured(robots, duration_s):
    daemon, robot = cores(robots, duration_s)
    return {"daemon": daemon / len(robots), "robot": robot / len(robots),
            "drove": sum(r.still_drives() for r in robots)}


def loops(robots):
    """Loop figures of the worst robot; after they have ended."""
    return {"late_p99_us": max(r.stats["loop"]["lateness_us"]["p99"] for r in robots),
            "overruns": max(r.stats["loop"]["overruns"] for r in robots),
            "lost": max(r.stats["link"]["lost"] for r in robots)}


class Part:
    def __init__(self, programs, table, duration_s):
        self.programs, self.table, self.duration_s = programs, table, duration_s

    def row(self, what, first=None, **values):
        """Adds a row; the daemon's share is compared with that of `first`."""
        self.table.row(what=what, growth=first and ratio(values["daemon"], first["daemon"]), **values)
        return values

    def one(self, laps=USUAL_LAPS, board="native"):
        with contextlib.ExitStack() as stack:
            robot = stack.enter_context(DrivenRobot(self.programs, laps, board))
            values = measured([robot], self.duration_s)
        return {**values, **loops([robot])}

    def boards(self):
        for board in ("native", "avr"):
            self.row(f"one robot, {board} board", **self.one(board=board))

    def run_length(self):
        with contextlib.ExitStack() as stack:
            robot = stack.enter_context(DrivenRobot(self.programs, USUAL_LAPS))
            early = self.row(f"first {self.duration_s:g} s of a run", **measured([robot], self.duration_s))
            cores([robot], (LATE_AFTER - 2) * self.duration_s)
            self.row(f"{LATE_AFTER}th {self.duration_s:g} s of it", early, **measured([robot], self.duration_s))

    def path_length(self):
        first = None
        for laps in (2, 20, 200):
            values = self.row(f"path of {laps * 4} segments", first, **self.one(laps=laps))
            first = first or values

    def viewers(self):
        first = None
        for viewers in (0, 4, 16):
            with contextlib.ExitStack() as stack:
                robot = stack.enter_context(DrivenRobot(self.programs, USUAL_LAPS, page=True))
                looking = None
                if viewers:
                    looking = subprocess.Popen(
                        [os.path.join(self.programs, "viewer_load"), robot.page_port, str(self.duration_s + 1),
                         str(viewers)], stdout=subprocess.DEVNULL)
                values = measured([robot], self.duration_s)
                if looking:
                    looking.wait()
            values = self.row(f"{viewers} viewers", first, **values, **loops([robot]))
            first = first or values

    def robots(self):
        count, first = 1, None
        while count <= MOST_ROBOTS:
            with contextlib.ExitStack() as stack:
                robots = [stack.enter_context(DrivenRobot(self.programs, USUAL_LAPS)) for _ in range(count)]
                values = measured(robots, self.duration_s)
            values = self.row(f"{count} robots at once, each", first, **values, **loops(robots))
            first = first or values
            count *= 2


def main():
    programs, duration_s = sys.argv[1], seconds(20)
    table = Table("cpu", f"processors that a robot at 200 Hz takes, over {duration_s:g} s", [
        ("what", "what", "<28s"), ("daemon", "tp100d", "7.4f"), ("robot", "tp100-sim", "7.4f"),
        ("growth", "tp100d/first", "6.2f"), ("drove", "drove", "3d"), ("late_p99_us", "lateness p99 [us]", "8.1f"),
        ("overruns", "overruns", "5d"), ("lost", "lost", "5d")])
    part = Part(programs, table, duration_s)
    for _ in range(rounds(1)):
        for measure in (part.boards, part.run_length, part.path_length, part.viewers, part.robots):
            measure()
    table.save()


if __name__ == "__main__":
    main()
