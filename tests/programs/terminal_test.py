#!/usr/bin/python3
"""terminal_test.py BIN: `tp100d run` of BIN at a terminal or pipe that nobody reads, and as a job of a shell."""
import contextlib
import fcntl
import os
import pty
import signal
import subprocess
import sys
import tempfile
import termios
import threading
import time

sys.dont_write_bytecode = True
from client_test import page, started, when  # noqa: E402
from verdict import check  # noqa: E402
import tp100_client  # noqa: E402

F_SETPIPE_SZ = 1031
CTRL_S, CTRL_Z = b"\x13", b"\x1a"


def shell(command, orders):
    """A shell with job control, in a session of its own: starts a job in the foreground, then follows orders."""
    signal.signal(signal.SIGTTOU, signal.SIG_IGN)
    job = subprocess.Popen(command, process_group=0, preexec_fn=lambda: signal.signal(signal.SIGTTOU, signal.SIG_DFL))
    os.tcsetpgrp(0, job.pid)
    for order in orders:
        termios.tcflush(0, termios.TCIFLUSH)  # as if the shell had read it
        os.tcsetpgrp(0, job.pid if order == "fg\n" else os.getpgrp())
        os.killpg(job.pid, signal.SIGCONT)
    os._exit(0)


class Daemon:
    """tp100d with an emulated robot, in a terminal of its own or with its output in a pipe that is full already."""

    def __init__(self, programs, folder, terminal, read):
        link, stats, pid = (os.path.join(folder, name) for name in ("robot", "stats.json", "pid"))
        self._robot_log = os.path.join(folder, "robot.log")
        self._robot = started(folder, "robot.log", programs + "/tp100-sim", "robot", "--link", link)
        when("the robot", lambda: os.path.exists(link))
        command = ["sh", "-c", 'echo $$ > "$0"; exec "$@"', pid, "setpriv", "--pdeathsig", "KILL", programs + "/tp100d",
                   "run", "--port", link, "--course", "2", "--stay", "--listen", "127.0.0.1:0", "--stats", stats]
        self._orders, self._job = None, None
        if terminal:
            orders, writes = os.pipe()
            self._shell, self.output = pty.fork()
            if self._shell == 0:
                os.close(writes)
                attributes = termios.tcgetattr(1)
                attributes[3] |= termios.TOSTOP
                termios.tcsetattr(1, termios.TCSANOW, attributes)
                shell(command, os.fdopen(orders))
            os.close(orders)
            self._orders = os.fdopen(writes, "w")
            if not read:
                self.types(CTRL_S)
        else:
            self.output, writes = os.pipe()
            os.write(writes, bytes(fcntl.fcntl(writes, F_SETPIPE_SZ, 4096)))
            self._job = subprocess.Popen(command, stdin=subprocess.DEVNULL, stdout=writes, stderr=writes)
            os.close(writes)
        if read:
            threading.Thread(target=self._read, daemon=True).start()
        self.at = when("the page", lambda: page(stats))
        with open(pid, encoding="ascii") as file:
            self.pid = int(file.read())

    def order(self, what):
        self._orders.write(what + "\n")
        self._orders.flush()
        when(what, lambda: (os.tcgetpgrp(self.output) == self.pid) == (what == "fg"))

    def types(self, keys):
        os.write(self.output, keys)

    def _read(self):
        with contextlib.suppress(OSError):
            while os.read(self.output, 65536):
                pass

    def motors_off(self):
        with open(self._robot_log, encoding="utf-8") as log:
            return "motors off" in ([""] + [line for line in log if "motors o" in line])[-1]

    def state(self):
        """As the kernel has it: R and S run, T is stopped, Z has ended."""
        try:
            with open(f"/proc/{self.pid}/stat", encoding="ascii") as file:
                return file.read().rsplit(")", 1)[1].split()[0]
        except OSError:
            return "Z"

    def close(self):
        with contextlib.suppress(ProcessLookupError):
            os.kill(self.pid, signal.SIGKILL)
        if self._orders:
            self._orders.close()
            os.waitpid(self._shell, 0)
        else:
            self._job.wait()
        self._robot.kill()
        self._robot.wait()


@contextlib.contextmanager
def daemon(programs, terminal, read=False):
    with tempfile.TemporaryDirectory(prefix="tp100-terminal-") as folder:
        it = Daemon(programs, folder, terminal, read)
        try:
            yield it
        finally:
            it.close()


def ends_though_nobody_reads(programs):
    # Whoever waits for its end would wait for ever, with the port taken.
    for terminal in (False, True):
        for end in (signal.SIGTERM, signal.SIGINT):
            with daemon(programs, terminal) as it, tp100_client.Robot(it.at) as robot:
                when("the run", lambda of=robot: of.state()["run"] == "running")
                began_s = time.monotonic()
                os.kill(it.pid, end)
                when("motors off", it.motors_off, 10.0)
                when(f"the end by {end.name}", lambda of=it: of.state() == "Z", 20.0)
                print(f"{'terminal' if terminal else 'pipe'}, {end.name}: ended in {time.monotonic() - began_s:.1f} s")


def goes_on_in_the_background(programs):
    # A daemon that is stopped serves no page, and so no STOP.
    with daemon(programs, terminal=True, read=True) as it:
        with tp100_client.Robot(it.at) as robot:
            when("the run", lambda: robot.state()["run"] == "running")
            it.types(CTRL_Z)
            when("the stop", lambda: it.state() == "T")
            when("motors off", it.motors_off)
            it.order("bg")
            when("the end of the run", lambda: robot.state()["run"] == "aborted")
            when("the robot", lambda: robot.state()["can"]["start"])
            # Typed for the shell: neither read nor flushed.
            it.types(b"go start\n")
            robot.start()
            robot.stop()
            when("the robot", lambda: robot.state()["can"]["start"])
            check(it.state() != "T", "stays a job in the background")
            it.order("fg")
            it.types(b"go start\n")
            when("the start by typing", lambda: robot.state()["run"] == "running")
            it.types(b"\n")
            when("the STOP by typing", lambda: robot.state()["run"] == "aborted")


def main():
    ends_though_nobody_reads(sys.argv[1])
    goes_on_in_the_background(sys.argv[1])


if __name__ == "__main__":
    main()
