"""scripts/bench page: runs with and without the page open in a browser, both beside four other viewers and a build.

Usage: bench_page.py FOLDER_OF_PROGRAMS. The build compiles the project's own sources at nice 10, one on each processor.
The browser renders in software, at its usual priority.
"""
import json
import os
import shlex
import signal
import statistics
import subprocess
import sys
import tempfile
import threading
import time

from bench_robot import DrivenRobot
from bench_table import Table, ratio, rounds, seconds

VIEWERS = 4
LAPS = 40  # more than the robot drives in that time
BROWSER = os.environ.get("TP100_CHROMIUM", "/usr/bin/chromium-headless-shell")


class Build:
    """Compiles at nice 10 on every processor, as a context."""

    def __init__(self, build, folder):
        with open(os.path.join(build, "compile_commands.json")) as file:
            commands = json.load(file)
        self.commands = [each for each in commands if "/daemon/" in each["file"]]
        self.folder, self.over = folder, False

    def _compile(self, first):
        at = first
        while not self.over:
            each = self.commands[at % len(self.commands)]
            at += os.cpu_count()
            arguments = shlex.split(each["command"])
            # Without the compiler's cache.
            arguments = arguments[next(i for i, word in enumerate(arguments) if not word.endswith("ccache")):]
            arguments[arguments.index("-o") + 1] = os.path.join(self.folder, f"{first}.o")
            with subprocess.Popen(["nice", "-n", "10", *arguments], cwd=each["directory"], start_new_session=True,
                                  env={**os.environ, "CCACHE_DISABLE": "1"}, stderr=subprocess.DEVNULL) as compiler:
                while compiler.poll() is None:
                    if self.over:
                        os.killpg(compiler.pid, signal.SIGKILL)
                    time.sleep(0.05)
            if compiler.returncode > 0:
                raise SystemExit(f"bench: {each['file']} does not compile: {each['command']}")

    def __enter__(self):
        self.threads = [threading.Thread(target=self._compile, args=(i,)) for i in range(os.cpu_count())]
        for thread in self.threads:
            thread.start()
        return self

    def __exit__(self, *_):
        self.over = True
        for thread in self.threads:
            thread.join()


class OpenPage:
    """The page in a browser, as a context; `shown` False opens none."""

    def __init__(self, shown, port, folder):
        self.command = [BROWSER, "--headless", "--no-sandbox", "--disable-gpu", "--window-size=1440,900",
                        "--no-first-run", f"--user-data-dir={folder}/browser", "--remote-debugging-port=0",
                        f"http://127.0.0.1:{port}/"] if shown else None

    def __enter__(self):
        self.browser = self.command and subprocess.Popen(self.command, stdout=subprocess.DEVNULL,
                                                         stderr=subprocess.DEVNULL, start_new_session=True)
        return self

    def __exit__(self, *_):
        if self.browser:
            os.killpg(self.browser.pid, signal.SIGTERM)
            self.browser.wait()


def measure(programs, shown, duration_s):
    """Drives one run; returns its daemon's figures, and whether it was aborted."""
    with tempfile.TemporaryDirectory(prefix="tp100-bench-", ignore_cleanup_errors=True) as folder, \
            Build(os.path.dirname(programs), folder):
        with DrivenRobot(programs, LAPS, page=True) as robot:
            with OpenPage(shown, robot.page_port, folder):
                seen = json.loads(subprocess.run(
                    [os.path.join(programs, "viewer_load"), robot.page_port, str(duration_s), str(VIEWERS)],
                    stdout=subprocess.PIPE, text=True, check=True).stdout)
            aborted = robot.log().count("-> aborted")
        loop = robot.stats["loop"]
        return {"aborted": aborted, "cycles": loop["cycles"], "missed": loop["missed"], "p99": loop["lateness_us"]["p99"],
                "received_per_s": seen["received"] / duration_s / VIEWERS}


def main():
    programs = sys.argv[1]
    duration_s, repeats = seconds(20), rounds(20)
    table = Table("page", f"{repeats} alternating runs of {duration_s:g} s with and without the page in a browser, beside "
                  f"{VIEWERS} viewers and a build at nice 10", [
                      ("page", "page", "<7s"), ("runs", "runs", "4d"), ("aborted", "aborted", "7d"),
                      ("cycles", "cycles", "7d"), ("missed", "missed", "6d"), ("missed_ratio", "of without", "10.2f"),
                      ("p99_us", "lateness p99 [us], median", "9.1f"),
                      ("received_per_s", "a second for each viewer", "6.0f")])
    runs = {False: [], True: []}
    for _ in range(repeats):
        for shown, list_of in runs.items():
            list_of.append(measure(programs, shown, duration_s))
    missed = {shown: sum(run["missed"] for run in list_of) for shown, list_of in runs.items()}
    for shown, list_of in runs.items():
        table.row(page="open" if shown else "closed", runs=len(list_of), missed=missed[shown],
                  missed_ratio=ratio(missed[shown], missed[False]) if shown else None,
                  p99_us=statistics.median(run["p99"] for run in list_of),
                  received_per_s=statistics.median(run["received_per_s"] for run in list_of),
                  **{key: sum(run[key] for run in list_of) for key in ("aborted", "cycles")})
    table.save()


if __name__ == "__main__":
    main()
