"""An emulated robot and its daemon in real time, as a context, and their use of the machine."""
import json
import os
import re
import signal
import subprocess
import tempfile
import time

TICK_S = 1.0 / os.sysconf("SC_CLK_TCK")
LAPS = 50  # of 4.5 m: more than any robot drives here


def cpu_s(process):
    with open(f"/proc/{process.pid}/stat") as stat:
        fields = stat.read().rsplit(") ", 1)[1].split()
    return (int(fields[11]) + int(fields[12])) * TICK_S


def course(laps):
    """A course file with `laps` laps in one place, of four segments each."""
    line = '[[segment]]\ntype = "line"\nlength_m = 1.0\n'
    arc = '[[segment]]\ntype = "arc"\nradius_m = 0.4\nangle_deg = 180.0\n'
    return (f"speed_mps = 0.10\n{(line + arc) * 2 * laps}"
            "[fence]\nmin_x_m = -5.0\nmax_x_m = 5.0\nmin_y_m = -5.0\nmax_y_m = 5.0\n")


class DrivenRobot:
    """Drives on entering, unless the machine is too busy for it; ends both programs on leaving.

    `page`: serve viewers, at port .page_port. `config`: text of the daemon's configuration. `processors`: those of the
    daemon and those of the robot, as lists of numbers; empty: all. After leaving, .stats has the daemon's figures.
    """

    def __init__(self, programs, laps=LAPS, page=False, setup="flat", config="", processors=((), ())):
        self.programs, self.laps, self.page, self.setup = programs, laps, page, setup
        self.config, self.processors = config, processors

    def _start(self, processors, name, words, out):
        tied = ["taskset", "-c", ",".join(map(str, processors))] if processors else []
        return subprocess.Popen([*tied, os.path.join(self.programs, name), *words, "--setup", self.setup],
                                stdin=subprocess.DEVNULL, stdout=out, stderr=subprocess.STDOUT)

    def _file(self, name, text=""):
        path = os.path.join(self.folder.name, name)
        if text:
            with open(path, "w") as file:
                file.write(text)
        return path

    def __enter__(self):
        self.folder = tempfile.TemporaryDirectory(prefix="tp100-bench-")
        link, self.stats_path = self._file("robot"), self._file("stats.json")
        with open(self._file("log"), "w") as log:
            self.robot = self._start(self.processors[1], "tp100-sim", ["robot", "--link", link], subprocess.DEVNULL)
            self.daemon = self._start(self.processors[0], "tp100d", [
                "run", "--port", link, "--wait", "--stay", "--course", self._file("laps.toml", course(self.laps)),
                "--config", self._file("tp100.toml", self.config or "# the defaults\n"),
                "--listen", "127.0.0.1:0" if self.page else "off", "--stats", self.stats_path], log)
        self.page_port = None
        for _ in range(150):
            time.sleep(0.1)
            text = self.log()
            if self.daemon.poll() is not None:
                break
            port = re.search(r"page: http://127.0.0.1:(\d+)/", text)
            self.page_port = port and port.group(1)
            if self.still_drives() and (port or not self.page):
                return self
        if self.daemon.poll() is None and "-> ready" in text and (self.page_port or not self.page):
            return self  # on a machine too busy to drive; still_drives() says so
        self.__exit__()
        raise SystemExit(f"bench: no session with the emulated robot: {text.strip().splitlines()[-1:]}")

    def __exit__(self, *_):
        for process in (self.daemon, self.robot):
            process.send_signal(signal.SIGTERM)
            process.wait()
        self.stats = self.stats_now()
        self.folder.cleanup()

    def stats_now(self):
        """The daemon's figures of the last second; None if nothing was written yet."""
        if not os.path.exists(self.stats_path):
            return None
        with open(self.stats_path) as file:
            return json.load(file)

    def log(self):
        with open(self._file("log")) as file:
            return file.read()

    def still_drives(self):
        return re.findall(r"-> (running|finished|aborted|idle)", self.log())[-1:] == ["running"]


def cores(robots, seconds):
    """Processor load over this time: (sum of the daemons, sum of the emulators), in processors."""
    before = [(cpu_s(r.daemon), cpu_s(r.robot)) for r in robots]
    began = time.monotonic()
    time.sleep(seconds)
    took = time.monotonic() - began
    return tuple(sum(cpu_s(getattr(r, name)) - was[i] for r, was in zip(robots, before)) / took
                 for i, name in enumerate(("daemon", "robot")))
