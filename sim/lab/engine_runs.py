"""Shared by the scripts around the game engine Godot: files and settings, courses, concurrent programs, and one run in
real time with the engine as the world.
"""
import bisect
import contextlib
import csv
import glob
import json
import math
import os
import re
import shutil
import signal
import socket
import subprocess
import sys
import tempfile
import threading
import time

sys.path.append(os.path.join(os.path.dirname(os.path.realpath(__file__)), "../godot"))
from engine import PATIENCE_S, ROOT, bundled, drawn, engine_environment, fail  # also for those that import this file

# The paper's overhead camera without errors: it gives the robot's true pose.
EXACT_CAMERA = """rate_hz = 100.0
delay_ms = 5.0
delay_jitter_ms = 0.0
stamp_error_ms = 0.0
noise_m = 0.0
noise_deg = 0.0
bias_m = 0.0
dropped = 0.0
"""
LONGEST_S = 300.0  # longest run; a course takes at most 60 s
POINTS = 200       # per path in the page
BEFORE_OTHERS = ("chrt", "--rr", "1")


class Course:
    """A course file: its name, the argument that names it, the points of its path, and whether it has disturbances."""

    def __init__(self, given):
        self.given, self.name = given, os.path.basename(given).removesuffix(".toml")
        course = drawn(given)
        self.disturbed, self.path = bool(course["disturbances"]), course["path"]


class NotBegun(Exception):
    """A program did not start."""


class Programs(contextlib.ExitStack):
    """The programs of one run, with their output in `folder`; they end with the context, and with the thread that
    opened it. In real time they have priority over all others of this machine, if permitted.
    """

    def __init__(self, folder, real_time=False):
        super().__init__()
        self.folder = folder
        allowed = real_time and not subprocess.run([*BEFORE_OTHERS, "true"], stderr=subprocess.DEVNULL).returncode
        self.before = BEFORE_OTHERS if allowed else ()

    def start(self, name, *command, stdin=subprocess.DEVNULL, at_once=True):
        """`at_once`: with priority from the first instruction on, see go_first()."""
        before = ("setpriv", "--pdeathsig", "TERM", *(self.before if at_once else ()))
        with open(self.log_of(name), "w") as log:
            process = subprocess.Popen([*before, *command], stdin=stdin, stdout=log,
                                       stderr=subprocess.STDOUT, env=os.environ | {"XDG_STATE_HOME": self.folder})
        self.callback(self.end, process)
        return process

    def go_first(self, process):
        """Gives the process and its children priority over all others. For a program that computes for long until it is
        ready, call this only then: meanwhile the kernel's worker must deliver the bytes of other runs' robots."""
        pids = [process.pid] if self.before else []
        for pid in pids:
            subprocess.run([*self.before[:-1], "--all-tasks", "--pid", self.before[-1], str(pid)])
            with open(f"/proc/{pid}/task/{pid}/children") as children:
                pids += map(int, children.read().split())

    @staticmethod
    def end(process):
        process.send_signal(signal.SIGTERM)
        try:
            process.wait(timeout=10.0)
        except subprocess.TimeoutExpired:
            process.kill()
            process.wait()

    def log_of(self, name):
        return os.path.join(self.folder, name + ".log")

    def wait_for_line(self, name, process, pattern):
        """Waits until `pattern` matches a program's output; returns the match."""
        until_s = time.monotonic() + PATIENCE_S
        while time.monotonic() < until_s:
            over = process.poll() is not None
            with open(self.log_of(name)) as log:
                found = re.search(pattern, log.read())
            if found:
                return found
            if over:
                break
            time.sleep(0.05)
        raise NotBegun(f"{self.log_of(name)} never printed {pattern}")


class Truth(threading.Thread):
    """The robot's true pose over monotonic time, received from its exact camera. Forwarded to an engine that sends
    "follow", which is also told when it is over.
    """

    def __init__(self):
        super().__init__(daemon=True)
        self.socket = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
        self.socket.bind(("127.0.0.1", 0))
        self.port = self.socket.getsockname()[1]
        self.address = f"udp:127.0.0.1:{self.port}"
        self.follower = None
        self.at_s, self.places = [], []
        self.start()

    def run(self):
        while datagram := self.take():
            if self.follower:
                self.socket.sendto(datagram, self.follower)
            seen = json.loads(datagram)
            self.at_s.append(seen["stamp_us"] * 1e-6)
            self.places.append((seen["x_m"], seen["y_m"]))

    def take(self):
        while True:
            datagram, sender = self.socket.recvfrom(2048)
            if datagram != b"follow":
                return datagram
            self.follower = sender

    def close(self):
        with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as last:
            last.sendto(b"", self.socket.getsockname())
        self.join()
        if self.follower:
            self.socket.sendto(b"{}", self.follower)
        self.socket.close()

    def at(self, t_s):
        """The pose at this time; None outside the recorded times."""
        i = bisect.bisect_right(self.at_s, t_s)
        if i == 0 or i == len(self.at_s):
            return None
        share = (t_s - self.at_s[i - 1]) / (self.at_s[i] - self.at_s[i - 1])
        return tuple(a + share * (b - a) for a, b in zip(self.places[i - 1], self.places[i]))


def poses_of(programs, recording):
    """The rows of poses.csv, as numbers by name."""
    with tempfile.TemporaryDirectory(prefix="tp100-experiment-") as folder:
        subprocess.run([programs + "/tp100d", "export", recording, "--csv", "--out", folder], check=True,
                       stdout=subprocess.DEVNULL)
        with open(folder + "/poses.csv", newline="") as file:
            return [{name: float(value) for name, value in row.items()} for row in csv.DictReader(file)]


def report_of(programs, recording, folder):
    """Writes the report of a recording to a folder; returns its metrics and when it began on the monotonic clock."""
    subprocess.run([programs + "/tp100d", "report", recording, "--out", folder], check=True, stdout=subprocess.DEVNULL)
    with open(folder + "/metrics.json") as file:
        metrics = json.load(file)
    return metrics, int(metrics["versions"]["start_unix_ns"]) * 1e-9 + time.monotonic() - time.time()


def last_line(path):
    with open(path) as file:
        return ([""] + file.read().splitlines())[-1]


def thinned(points):
    return [[round(value, 3) for value in point] for point in points[::len(points) // POINTS + 1]]


def errors(poses, truth, start_s, disturbed):
    """Errors of odometry and model against the truth [cm], and the true path; nothing without a truth. With
    disturbances, which encoders do not measure, the model is not judged."""
    off = {"model": [], "odometry": []}
    path = []
    for pose in poses:
        place = truth.at(start_s + pose["t_s"])
        if place is None:
            continue
        path.append(place)
        for source, distances in off.items():
            distances.append(100.0 * math.dist(place, (pose[source + "_x_m"], pose[source + "_y_m"])))
    if not path:
        return {}
    return {"end_cm": off["odometry"][-1], "largest_cm": max(off["odometry"]),
            "model_largest_cm": None if disturbed else max(off["model"]),
            "floor": thinned(path)}


def judge(programs, folder, truth, disturbed):
    """The result of a run, from its recording and its daemon's figures."""
    recordings = glob.glob(folder + "/*/run.mcap")
    if not recordings:
        return {"completed": False, "cause": last_line(folder + "/daemon.log")}
    with open(folder + "/stats.json") as file:
        stats = json.load(file)
    metrics, start_s = report_of(programs, recordings[0], folder)
    poses = poses_of(programs, recordings[0])
    world = stats.get("world", {}).get("udp", {})
    age_us = metrics["timing"]["world_age_us"] or {}
    return {"completed": metrics["completed"] and stats["completed"], "cause": metrics.get("cause", ""),
            "duration_s": metrics["duration_s"], "path_cm": 100.0 * metrics["estimated"]["max_cross_track_m"],
            "answer_age_ms": {key: age_us[key] / 1e3 for key in ("p50", "p99", "max") if key in age_us},
            "round_trip_ms": {"mean": world.get("mean_round_trip_ms"), "max": world.get("max_round_trip_ms")},
            "poses": world.get("poses"), "answered": world.get("answered"), "missed": stats["loop"]["missed"],
            "cycles": stats["loop"]["cycles"], "lateness_p99_us": stats["loop"]["lateness_us"]["p99"],
            "engine": thinned([(pose["world_x_m"], pose["world_y_m"]) for pose in poses]),
            **errors(poses, truth, start_s, disturbed)}


def drive(options, programs, course, run, folder):
    """Drives one run in real time and returns its result."""
    shutil.rmtree(folder, ignore_errors=True)
    os.makedirs(folder)
    link = os.path.join(folder, "robot")
    with open(folder + "/world.toml", "w") as file:
        file.write(f'[world]\nauthority = "{options.authority}"\n')
    with open(folder + "/camera.toml", "w") as file:
        file.write(EXACT_CAMERA)
    with contextlib.closing(Truth()) as truth, Programs(folder, real_time=True) as beside:
        engine = beside.start("engine", ROOT + "/scripts/godot", "--headless", "--course", course.given, "--robot",
                              options.robot, at_once=False)
        world = "udp:" + beside.wait_for_line("engine", engine, r"listening at (\S+)").group(1)
        beside.go_first(engine)
        # On the stand the robot does not move: no camera.
        camera = ["--camera=" + folder + "/camera.toml", "--camera-to", truth.address] if run["setup"] == "flat" else []
        robot = beside.start("robot", programs + "/tp100-sim", "robot", "--link", link, "--board", run["board"], "--setup",
                             run["setup"], "--robot", options.robot, "--course", course.given, "--seed", str(run["seed"]),
                             *camera)
        beside.wait_for_line("robot", robot, "linked from")
        daemon = beside.start("daemon", programs + "/tp100d", "run", "--port", link, "--wait", "--go", "--listen", "off",
                              "--course", course.given, "--robot", options.robot, "--setup", run["setup"], "--world", world,
                              "--config", folder + "/world.toml", "--record", folder, "--stats", folder + "/stats.json",
                              "--duration", str(LONGEST_S))
        daemon.wait()
        time.sleep(0.1)  # until the camera has sent the last pose
    return judge(programs, folder, truth, course.disturbed)
