#!/usr/bin/python3
"""client_test.py BIN: scripts/tp100_client.py against the real programs in BIN, as a program of its user would."""
import json
import math
import os
import signal
import subprocess
import sys
import tempfile
import time
import urllib.request

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
sys.path += [os.path.join(ROOT, "scripts"), os.path.join(ROOT, "tests", "support")]
sys.dont_write_bytecode = True
from verdict import check  # noqa: E402
import tp100_client  # noqa: E402

COURSE = """[[segment]]
type = "line"
length_m = 0.5
[fence]
min_x_m = -1
max_x_m = 2
min_y_m = -1
max_y_m = 1
"""


def started(folder, name, *command):
    """Starts a program with its output in a file. It ends with this test, however that ends."""
    with open(os.path.join(folder, name), "w", encoding="utf-8") as log:
        return subprocess.Popen(["setpriv", "--pdeathsig", "KILL", *command], stdin=subprocess.DEVNULL, stdout=log,
                                stderr=subprocess.STDOUT)


def when(what, condition, patience_s=60.0):
    """Waits until the condition is true; returns its value."""
    until_s = time.monotonic() + patience_s
    while time.monotonic() < until_s:
        if value := condition():
            return value
        time.sleep(0.02)
    return check(False, f"{what} did not happen within {patience_s} s")


def page(stats):
    try:
        with open(stats, encoding="utf-8") as file:
            return json.load(file)["page"].removeprefix("http://").rstrip("/")
    except (OSError, ValueError):
        return ""


def refused(call):
    """The reason of a refusal."""
    try:
        call()
    except tp100_client.Refused as refusal:
        return str(refusal)
    return check(False, "was not refused")


def distance(a, b):
    return math.hypot(a["x_m"] - b["x_m"], a["y_m"] - b["y_m"])


def drives(at):
    with tp100_client.Robot(at) as robot, tp100_client.Robot(at) as other:
        check("no service" in refused(lambda: robot.call("fly")), "an unknown service is named")
        # The first run on an emulator's port begins by itself.
        when("the run", lambda: robot.state()["run"] != "idle")
        check("under way" in refused(lambda: robot.start(patience_s=0.0)), "a second start is refused")
        check(robot.wait_for_end(60.0) == "finished", f"the course is completed: {robot.state()}")
        check(abs(robot.pose()["x_m"] - 0.5) < 0.05, f"the pose is the course's end: {robot.pose()}")
        check(robot.estimate()["progress_m"] > 0.45, "the estimate tells the progress")

        before = robot.pose("odometry")
        with robot.drive_by_hand() as lease:
            lease.drive(0.1, 0.0, 0.2)
            check("drives" in refused(lambda: other.drive_by_hand(0.0)), "one driver at a time")
            lease.drive(0.1, 0.0, 1.5)
            check(robot.state()["run"] == "driving", "the state tells who drives")
        check(robot.wait_for_end(10.0) == "idle", "released, the robot is disarmed")
        check(0.05 < distance(before, robot.pose("odometry")) < 0.4, "it has moved by hand")

        robot.start(patience_s=20.0)
        check(other.stop(), "the robot acknowledges STOP")
        check(robot.wait_for_end(10.0) == "aborted", "STOP ends the run")
        check([fault["name"] for fault in robot.state()["faults"]] == ["stop_requested"], "its fault is in force")
        check(sum(1 for _ in robot.messages("/estimate", 0.5)) > 20, "a channel is read as it comes")


def manages(at):
    with tp100_client.Robot(at) as robot:
        finished = when("both recordings", lambda: [run for run in robot.runs() if not run["active"]][1:])[-1]["run"]
        check(robot.note_run(finished, name="first", tags="a b")["tags"] == "a b", "a note is taken")
        check(robot.note_run(finished, note="good")["name"] == "first", "what is not named stays")
        with urllib.request.urlopen(robot.report_run(finished), timeout=60) as page_of_it:
            check(b"</html>" in page_of_it.read(), "the report is a page")
        check("no such run" in refused(lambda: robot.report_run("none")), "only recorded runs are judged")
        check("name of a run" in refused(lambda: robot.delete_run("../" + finished)), "no path is taken")
        robot.delete_run(finished)
        check(finished not in [run["run"] for run in robot.runs()], "is deleted")


def main():
    programs = sys.argv[1]
    with tempfile.TemporaryDirectory(prefix="tp100-client-") as folder:
        course, link, stats = (os.path.join(folder, name) for name in ("short.toml", "robot", "stats.json"))
        with open(course, "w", encoding="utf-8") as file:
            file.write(COURSE)
        body = started(folder, "robot.log", programs + "/tp100-sim", "robot", "--link", link, "--course", course)
        when("the robot", lambda: os.path.exists(link))
        daemon = started(folder, "daemon.log", programs + "/tp100d", "run", "--port", link, "--course", course, "--stay",
                         "--listen", "127.0.0.1:0", "--stats", stats, "--record", os.path.join(folder, "runs"))
        try:
            at = when("the page", lambda: page(stats))
            drives(at)
            manages(at)
            watched = tp100_client.Robot(at)
            check("firmware" in [found["name"] for found in watched.examine() if found["severity"] == "ok"],
                  "examines robot and machine")
            daemon.send_signal(signal.SIGTERM)
            daemon.wait(30)
            when("the loss", lambda: lost(watched.state))
            check(lost(lambda: tp100_client.Robot(at)), "without a daemon there is no robot")
        except BaseException:
            with open(os.path.join(folder, "daemon.log"), encoding="utf-8") as log:
                print(log.read())
            raise
        finally:
            for program in (daemon, body):
                program.kill()
                program.wait()


def lost(call):
    try:
        call()
    except tp100_client.Lost:
        return True
    return False


if __name__ == "__main__":
    main()
