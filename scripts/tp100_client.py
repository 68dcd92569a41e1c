"""A client of tp100d for programs in Python: one file to copy beside yours.

Needs Python 3.9 and websocket-client (Debian: python3-websocket). The daemon's channels and services are described in
daemon/messages/CHANNELS.md; this file speaks the protocol, knows a few of them by name and gives access to all.

    from tp100_client import Robot

    with Robot("127.0.0.1:8765") as robot:
        robot.start()                               # as the page's button; raises Refused with the reason
        print(robot.pose())                         # {"x_m": ..., "y_m": ..., "yaw_rad": ...}
        print(robot.wait_for_end())                 # "finished" or "aborted"

        with robot.drive_by_hand() as lease:        # nothing else may drive meanwhile
            lease.drive(speed_mps=0.1, yaw_rate_radps=0.0, duration_s=2.0)

        for message in robot.messages("/estimate", duration_s=1.0):
            print(message["odometry"]["x_m"])

        run = robot.runs()[0]["run"]                # the newest recording
        robot.note_run(run, name="wet floor", tags="lab wet")
        print(robot.report_run(run))                # the address of its report
"""
import contextlib
import json
import math
import queue
import struct
import threading
import time
import urllib.request

import websocket

SUBPROTOCOLS = ["foxglove.sdk.v1", "foxglove.websocket.v1"]
# The daemon requires 20 to 50 inputs per second.
INPUT_PERIOD_S = 0.03
# The daemon aborts a report that takes longer.
REPORT_S = 600.0
# A silent robot takes 5 s to detect; a slow disk takes longer.
DOCTOR_S = 60.0


class Refused(Exception):
    """The daemon refused a request; the text is its reason."""


class Lost(Exception):
    """There is no daemon, or the connection to it ended."""


class Robot:
    """A connection to a tp100d. Its methods may be called from several threads."""

    def __init__(self, at="127.0.0.1:8765", timeout_s=5.0):
        """`at`: HOST:PORT. `timeout_s`: how long a request waits for its answer. Raises Lost."""
        self._timeout_s, self._page = timeout_s, f"http://{at}"
        self._lock = threading.Lock()
        self._channels, self._services = {}, {}
        self._kept, self._readers, self._calls = {}, {}, {}
        self._known = threading.Event()
        self._next, self._ended = 1, ""
        try:
            self._socket = websocket.create_connection(f"ws://{at}/", subprotocols=SUBPROTOCOLS, timeout=timeout_s)
        except (OSError, websocket.WebSocketException) as error:
            raise Lost(f"no tp100d answers at {at}: {error}; start it, or give its address") from error
        self._socket.settimeout(None)
        threading.Thread(target=self._receive, daemon=True).start()
        if not self._known.wait(timeout_s):
            self.close()
            raise Lost(f"what answers at {at} is no tp100d")
        self._subscribe("/state")
        self._subscribe("/estimate")

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.close()

    def close(self):
        """Ends the connection. If this client drives the robot by hand, the robot stops."""
        self._socket.close()

    # What the robot does.

    def state(self):
        """The newest message of /state: run, session, faults, battery, what is possible and why not."""
        return self._newest("/state")

    def estimate(self):
        """The newest message of /estimate: the poses, the tracks, the deviation from the path."""
        return self._newest("/estimate")

    def pose(self, source=None):
        """{"x_m", "y_m", "yaw_rad"}; `source`: "model", "odometry", "fused" or "truth"; default: the steering pose."""
        estimate = self.estimate()
        pose = estimate.get(source or estimate["steering"])
        if pose is None:
            raise Refused(f"there is no pose {source}")
        return {name: pose[name] for name in ("x_m", "y_m", "yaw_rad")}

    def messages(self, topic, duration_s=None):
        """Yields the messages of any channel as they come, for `duration_s` or for ever. Raises Lost."""
        reader = queue.Queue()
        self._subscribe(topic, reader)
        until_s = math.inf if duration_s is None else time.monotonic() + duration_s
        try:
            while (left_s := until_s - time.monotonic()) > 0.0:
                try:
                    message = reader.get(timeout=min(left_s, threading.TIMEOUT_MAX))
                except queue.Empty:
                    return
                if message is None:
                    raise Lost(self._ended)
                yield message
        finally:
            with self._lock:
                self._readers[topic].remove(reader)

    def wait_for_end(self, timeout_s=None):
        """Waits until no run is under way. Returns "finished", "aborted" or "idle"; raises TimeoutError."""
        for message in self.messages("/state", timeout_s):
            if message["run"] not in ("arming", "running", "driving"):
                return message["run"]
        raise TimeoutError(f"the run is still under way after {timeout_s} s")

    # What a person may ask.

    def call(self, service, wait_s=None, **request):
        """Calls any service with its arguments by name; returns its answer. Raises Refused and Lost."""
        with self._lock:
            if service not in self._services:
                raise Refused(f"the daemon has no service {service}")
            number, self._next = self._next, self._next + 1
            answer = self._calls[number] = queue.Queue(1)
        head = struct.pack("<BIII", 2, self._services[service], number, 4) + b"json"
        self._send(head + json.dumps(request).encode(), websocket.ABNF.OPCODE_BINARY)
        try:
            result = answer.get(timeout=wait_s or self._timeout_s)
        except queue.Empty:
            raise Lost(f"no answer to {service}") from None
        finally:
            with self._lock:
                del self._calls[number]
        if result is None:
            raise Lost(self._ended)
        if isinstance(result, str):
            raise Refused(result)
        return result

    def start(self, where="start", patience_s=2.5, seen=None):
        """Starts the course, from its "start" or from "here", the pose of state(); returns once the run is under
        way. The robot moves: the caller must ask a person first. `seen`: the state() that the person saw, at most 3 s
        old; without it, the present one. A STOP since then refuses the start. `patience_s`: longest wait for the robot
        to come to rest, and for the run to begin."""
        consent = self._consent(seen)
        self._when_possible("start", patience_s)
        self.call("start", **{"from": where}, **consent)
        for message in self.messages("/state", patience_s):
            if message["run"] in ("arming", "running"):
                return
        raise Refused("the daemon accepted the start, and no run began: " + self.state()["why_not_start"])

    def stop(self):
        """Stops the robot, whoever drives it. Returns True once the robot has acknowledged."""
        return self.call("stop")["acknowledged"]

    def drive_by_hand(self, patience_s=2.5, seen=None):
        """Arms the robot and takes the lease: `with robot.drive_by_hand() as lease: lease.drive(...)`. `patience_s`:
        longest wait for the robot to come to rest. `seen`: as for start()."""
        consent = self._consent(seen)
        self._when_possible("drive", patience_s)
        return Lease(self, consent)

    def examine(self):
        """The findings of `tp100d doctor`, while no run is under way: a list of {"severity", "name", "seen", "fix"},
        with severity "ok", "note", "warning" or "error". Nothing moves."""
        return [finding for part in ("port", "robot", "machine")
                for finding in self.call("doctor", wait_s=DOCTOR_S, part=part)["findings"]]

    # Its recordings.

    def runs(self):
        """The recorded runs, newest first: "run", "name", "note", "tags", "bytes", "active", "files" and more."""
        try:
            with urllib.request.urlopen(f"{self._page}/api/runs", timeout=self._timeout_s) as answer:
                return json.load(answer)["runs"]
        except (OSError, ValueError) as error:
            raise Lost(f"no list of runs: {error}") from error

    def note_run(self, run, **changes):
        """Changes "name", "note", "tags" (words) or "keep" of a run; the others stay. Returns all of them."""
        return self.call("run_note", run=run, **changes)

    def mark(self, text="mark", **recorded):
        """Marks this moment in the recording; or, with run=... and t_s=..., a moment of a recorded run."""
        self.call("mark", text=text, **recorded)

    def delete_run(self, run):
        """Deletes a run with all its files."""
        self.call("run_delete", run=run)

    def report_run(self, run):
        """Makes the report of a run beside it, and returns its address."""
        return self._page + self.call("run_report", wait_s=REPORT_S, run=run)["url"]

    def _consent(self, seen):
        state = seen or self.state()
        return {"stops": state["stop"]["count"], "t_s": state["t_s"]}

    def _when_possible(self, what, patience_s):
        # If it stays impossible, the request itself is refused with the reason.
        next((True for message in self.messages("/state", patience_s) if message["can"][what]), False)

    # The protocol.

    def _send(self, data, opcode):
        try:
            self._socket.send(data, opcode)
        except (OSError, websocket.WebSocketException) as error:
            raise Lost(f"the connection ended: {error}") from error

    def _subscribe(self, topic, reader=None):
        with self._lock:
            if topic not in self._channels:
                raise Refused(f"the daemon has no channel {topic}")
            new = topic not in self._readers
            readers = self._readers.setdefault(topic, [])
            if reader is not None:
                readers.append(reader)
                if topic in self._kept:
                    reader.put(self._kept[topic])
            number = self._channels[topic]
        if new:
            request = {"op": "subscribe", "subscriptions": [{"id": number, "channelId": number}]}
            self._send(json.dumps(request), websocket.ABNF.OPCODE_TEXT)

    def _newest(self, topic):
        until_s = time.monotonic() + self._timeout_s
        while time.monotonic() < until_s:
            with self._lock:
                if self._ended:
                    raise Lost(self._ended)
                if topic in self._kept:
                    return self._kept[topic]
            time.sleep(0.005)
        raise Lost(f"no message on {topic}")

    def _receive(self):
        why = "the daemon ended the connection"
        try:
            while True:
                opcode, data = self._socket.recv_data()
                if opcode == websocket.ABNF.OPCODE_TEXT:
                    self._take_text(json.loads(data))
                elif opcode == websocket.ABNF.OPCODE_BINARY:
                    self._take_binary(data)
                elif opcode == websocket.ABNF.OPCODE_CLOSE:
                    break
        except (OSError, ValueError, websocket.WebSocketException) as error:
            why = f"the connection ended: {error}"
        with self._lock:
            self._ended = why
            waiting = list(self._calls.values()) + [reader for all in self._readers.values() for reader in all]
        for one in waiting:
            one.put(None)

    def _take_text(self, message):
        operation = message.get("op")
        if operation == "advertise":
            self._channels.update({channel["topic"]: channel["id"] for channel in message["channels"]})
        elif operation == "advertiseServices":
            self._services.update({service["name"]: service["id"] for service in message["services"]})
            self._known.set()
        elif operation == "serviceCallFailure":
            self._answer(message["callId"], message["message"])

    def _take_binary(self, data):
        if data[0] == 1:
            number, _ = struct.unpack_from("<IQ", data, 1)
            message = json.loads(data[13:])
            with self._lock:
                topic = next(name for name, known in self._channels.items() if known == number)
                self._kept[topic] = message
                readers = list(self._readers.get(topic, ()))
            for reader in readers:
                reader.put(message)
        elif data[0] == 3:
            _, number, length = struct.unpack_from("<III", data, 1)
            self._answer(number, json.loads(data[13 + length:] or b"{}"))

    def _answer(self, number, result):
        with self._lock:
            waiting = self._calls.get(number)
        if waiting is not None:
            waiting.put(result)


class Lease:
    """The right to drive the armed robot by hand. Without a call of drive() for 150 ms the robot stands still."""

    def __init__(self, robot, consent):
        self._robot = robot
        self._token = robot.call("drive_take", **consent)["token"]
        self.drive(0.0, 0.0)  # at once: it shows the daemon how slow the path is

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.release()

    def drive(self, speed_mps, yaw_rate_radps, duration_s=0.0):
        """Requests a ground speed and a yaw rate (counter-clockwise positive), once or repeatedly for `duration_s`.
        Raises Refused if this program no longer drives."""
        until_s = time.monotonic() + duration_s
        while True:
            now_s = time.monotonic()
            self._robot.call("drive", token=self._token, speed_mps=speed_mps, yaw_rate_radps=yaw_rate_radps,
                             input_ms=now_s * 1e3)
            if now_s + INPUT_PERIOD_S > until_s:
                return
            time.sleep(INPUT_PERIOD_S)

    def release(self):
        """Stops and disarms the robot."""
        with contextlib.suppress(Refused):  # another client drives, or the drive has ended
            self._robot.call("drive_release", token=self._token)
