"""An independent robot on a pseudo-terminal. It implements firmware/PROTOCOL.md and shares no code with the project's
firmware. It does not detect blocked or reversed tracks, which the page leaves to the robot: the host must detect them
alone. Its body is kinematic: tracks with a lag, slip, a gyro with bias and noise, a clock that drifts.

An oddity replaces attributes and functions of a running robot; `happened` is the time at which it did."""
import math
import os
import random
import select
import time
import tty

from wire import (ACCEPTED, ARMED, DISARMED, FAULTED, FAULT_PERSISTS, HELLO, OUT_OF_RANGE, PARAMETERS, PROTOCOL,
                  RUNNING, SCHEMA, STALE_TOKEN, TYPE, WRONG_BOOT, WRONG_STATE, newer, pack, signed, unpack)

PERIOD = 0.005
LSB = math.radians(1) / 32.8
COMMAND_TIMEOUT, STOP_REQUESTED, BATTERY_LOW, PARAMETERS_MISSING = 0, 1, 7, 12
# Properties of the robot; the daemon's robot file has the same values.
COUNTS_PER_METRE, WHEELBASE, SLIP_LEFT, SLIP_RIGHT, FEED_FORWARD, DEAD_BAND = 9000.0, 0.26, 0.10, 0.12, 3.4, 0.09
LAG = 0.08


def wrapped(angle):
    return math.remainder(angle, 2 * math.pi)


class Track:
    """A motor, its track and its encoder. Speeds in m/s of the track, forward positive."""

    def __init__(self, slip):
        self.slip, self.speed, self.counted, self.lag = slip, 0.0, 0.0, 0.0
        self.motor = 1.0        # strength; negative: leads are swapped
        self.encoder = 1.0      # share of the edges that are counted; negative: it counts backwards
        self.runs_at = None     # speed of the track, whatever its duty is
        self.blocked = False    # nothing moves the track

    def move(self, duty):
        """Moves the track for a period and returns its speed over ground."""
        duty *= self.motor
        target = math.copysign(max(0.0, abs(duty) - DEAD_BAND), duty) / FEED_FORWARD
        target = 0.0 if self.blocked else target if self.runs_at is None else self.runs_at
        self.speed += (target - self.speed) * PERIOD / LAG
        self.counted += self.speed * PERIOD * COUNTS_PER_METRE * self.encoder
        return self.speed * (1 - self.slip)

    def duty(self, target, measured, given):
        """Duty from the feed-forward and the PI control of the counts, with the given parameters."""
        if target == 0:
            self.lag = 0.0
            return 0.0
        self.lag = max(-0.02, min(0.02, self.lag + (target - measured) * PERIOD))
        duty = math.copysign(given["dead_band"], target) + given["feed_forward"] * target
        duty += given["speed_kp"] * (target - measured) + given["speed_ki"] * self.lag
        return max(-1.0, min(1.0, duty))


class Robot:
    def __init__(self, when=("never", 0.0), oddity=lambda robot: None):
        self.master, self.slave = os.openpty()
        tty.setraw(self.slave)
        os.set_blocking(self.master, False)
        self.port = os.ttyname(self.slave)
        self.when, self.oddity, self.happened = when, oddity, None
        self.asked_off = None       # seconds, metres and radians from the oddity until the host first asked motors off
        self.random = random.Random(1)
        self.received = []             # every good frame of the host: time, name, fields
        self.interrupted = False
        self.asked = None           # the host's last Command
        self.refused = None         # time at which it first answered an Arm with anything but Accepted
        self.since = {}             # phase: time of its beginning
        self.late = 0.0             # largest delay of this program's loop
        self.pose = [0.0, 0.0, 0.0]
        self.origin = (0.0, 0.0, 0.0)   # pose at which it was armed
        self.left, self.right = Track(SLIP_LEFT), Track(SLIP_RIGHT)
        self.sides = 1.0            # -1: both tracks, with motor and encoder, are connected to the other side
        self.gyro_bias, self.gyro_scale = 0.01, 1.0
        self.accel, self.gyro, self.turned = (0, 0, 8192), 0, 0.0
        self.counts, self.measured = (0, 0), (0.0, 0.0)     # edges; track speeds measured from them
        self.battery_mv, self.board, self.nonce, self.ppm, self.clock_us = 7800, 2, 0x51A7E001, 40.0, 1000000
        self.counts_offset = 0
        self.is_open = True
        # Attributes that oddities replace.
        self.samples = lambda fields: [fields]          # one true sample in, the samples to send out
        self.hello = lambda fields: [pack("Hello", fields)]
        self.acknowledges = lambda fields: [fields]
        self.replies = lambda fields: [fields]          # to a SyncRequest
        self.each = lambda: None                        # called in every period
        self.deaf = set()                               # names of messages that it ignores
        self.transmit = self.write
        self.reads = True
        self.report = {}                                # values that samples report instead of the true ones
        self.waiting = b""
        self.silent_until = 0.0
        self.boot(time.monotonic())

    # -- clock and wire
    def device_us(self, now):
        return int(self.clock_us + (now - self.booted) * 1e6 * (1 + self.ppm * 1e-6)) % 2**32

    def write(self, data):
        try:
            while data:
                data = data[os.write(self.master, data):]
        except OSError:
            pass  # nobody reads, or the port is closed: a real wire loses the bytes, too

    def send(self, name, **fields):
        self.transmit(pack(name, fields))

    def close(self):
        if self.is_open:
            self.is_open = False
            os.close(self.slave)
            os.close(self.master)

    # -- session
    def boot(self, now, nonce=None, silent=0.0):
        self.nonce = nonce or self.nonce
        self.booted, self.silent_until, self.last_hello, self.last_received = now + silent, now + silent, -1.0, None
        self.state, self.faults, self.arm_token, self.arm_answer = HELLO, 0, 0, None
        self.command, self.parameters, self.kept = None, None, {}
        self.sequence, self.duties, self.reset_cause = 0, (0.0, 0.0), 1
        self.command_at, self.session_at, self.low_since = None, None, None
        self.mark("boot", now)

    def mark(self, phase, now):
        self.since.setdefault(phase, now)
        self.look(now)

    def look(self, now):
        phase, delay = self.when
        if self.happened is None and phase in self.since and now - self.since[phase] >= delay:
            self.happened = now
            self.twin, self.apart = [tuple(self.pose)], [0.0, 0.0]
            self.oddity(self)

    def intended(self):
        """Speed and turn rate that the host requests at present, whether or not the robot obeys."""
        if self.asked is None or self.asked_off is not None:
            return 0.0, 0.0
        return self.asked["speed_mps"], self.asked["yaw_rate_radps"]

    def off(self, state):
        self.state, self.duties, self.command = state, (0.0, 0.0), None
        self.left.lag = self.right.lag = 0.0

    def latch(self, fault, now):
        if not self.faults >> fault & 1:
            self.faults |= 1 << fault
            self.send("FaultReport", device_us=self.device_us(now), fault=fault, faults=self.faults, detail=0)
        if self.state >= DISARMED:
            self.off(FAULTED)

    def acknowledge(self, name, token, result=ACCEPTED, detail=0):
        for fields in self.acknowledges({"request": TYPE[name], "token": token, "result": result, "detail": detail}):
            self.send("Acknowledge", **fields)
            if name == "Arm" and fields["result"] != ACCEPTED and self.refused is None:
                self.refused = time.monotonic()

    def send_hello(self, now):
        self.last_hello = now
        for data in self.hello({"protocol": PROTOCOL, "firmware": bytes((9, 8, 7)), "schema": SCHEMA,
                                "board": self.board, "boot_nonce": self.nonce, "reset_cause": self.reset_cause,
                                "state": self.state, "faults": self.faults}):
            self.transmit(b"\0" + data)

    def take(self, name, fields, now):
        self.received.append((now, name, fields))
        if (self.happened is not None and self.asked_off is None
                and (name in ("Disarm", "Stop") or name == "HelloRequest" and self.state >= DISARMED)):
            self.asked_off = (now - self.happened, *self.apart)
        if name == "Command":
            self.asked = fields
        if name in ("Arm", "Disarm", "Parameters"):
            self.mark(name, now)
        if name in self.deaf or now < self.silent_until:
            return
        self.last_received = now
        if name == "HelloRequest":
            self.off(PARAMETERS)
            self.parameters = None
            self.send_hello(now)
        elif name == "Parameters":
            self.take_parameters(fields, now)
        elif name == "Command":
            self.take_command(fields, now)
        elif name == "Arm":
            self.take_arm(fields, now)
        elif name in ("Disarm", "Stop"):
            if name == "Stop":
                self.latch(STOP_REQUESTED, now)
            if self.state in (ARMED, RUNNING):
                self.off(DISARMED)
            self.acknowledge(name, fields["token"])
        elif name == "SyncRequest":
            # On a wire, 7 bytes take 140 us to arrive and 17 bytes 340 us to be sent; a pseudo-terminal has no such
            # delays.
            time.sleep(140e-6)
            received = self.device_us(time.monotonic())
            sent = self.device_us(time.monotonic())
            time.sleep(340e-6)
            for reply in self.replies({"id": fields["id"], "received_us": received, "sent_us": sent, "corrupted": 0}):
                self.send("SyncReply", **reply)

    def take_parameters(self, fields, now):
        floats = [value for value in fields.values() if isinstance(value, float)]
        if fields["boot_nonce"] != self.nonce:
            return self.acknowledge("Parameters", fields["token"], WRONG_BOOT)
        if self.state in (ARMED, RUNNING):
            return self.acknowledge("Parameters", fields["token"], WRONG_STATE, self.state)
        if not all(map(math.isfinite, floats)) or not 100 <= fields["counts_per_metre"] <= 1e6:
            return self.acknowledge("Parameters", fields["token"], OUT_OF_RANGE, 2)
        if not (self.parameters and self.parameters["token"] == fields["token"] and self.state >= DISARMED):
            self.parameters, self.kept, self.command_at, self.session_at = fields, {}, None, now
            self.last_command = 0
            self.off(FAULTED if self.faults else DISARMED)
            self.mark("session", now)
        return self.acknowledge("Parameters", fields["token"])

    def take_command(self, fields, now):
        numbers = [value for value in fields.values() if isinstance(value, float)]
        ahead = signed(fields["expiry_us"] - self.device_us(now), 32)
        good = (self.state >= DISARMED and fields["boot_nonce"] == self.nonce and all(map(math.isfinite, numbers))
                and (self.command_at is None or newer(fields["sequence"], self.last_command))
                and fields["answers"] in self.kept
                and now - self.kept[fields["answers"]][0] <= self.parameters["yaw_window_ms"] * 1e-3
                and 0 < ahead <= 200000 and abs(fields["speed_mps"]) <= 2 and abs(fields["yaw_rate_radps"]) <= 10)
        if good:
            self.command_at, self.last_command, self.command = now, fields["sequence"], fields
            if self.state == ARMED and asks_motion(fields):
                self.state = RUNNING
                self.mark("drive", now)

    def take_arm(self, fields, now):
        if fields["token"] == self.arm_token:
            return self.acknowledge("Arm", *self.arm_answer)
        ahead = signed(fields["expiry_us"] - self.device_us(now), 32)
        fresh = (self.state >= DISARMED and self.command_at is not None
                 and now - self.command_at < self.parameters["command_life_ms"] * 1e-3)
        result, detail = ACCEPTED, 0
        if fields["boot_nonce"] != self.nonce:
            result = WRONG_BOOT
        elif fields["token"] < self.arm_token:
            result = STALE_TOKEN
        elif not 0 < ahead <= 500000:
            result, detail = OUT_OF_RANGE, 2
        elif self.state < DISARMED:
            result, detail = FAULT_PERSISTS, 1 << PARAMETERS_MISSING
        elif not fresh or self.low_since is not None:
            result = FAULT_PERSISTS
            detail = (not fresh) << COMMAND_TIMEOUT | (self.low_since is not None) << BATTERY_LOW
        else:
            self.faults, self.state, self.origin = 0, ARMED, tuple(self.pose)
        if result not in (WRONG_BOOT, STALE_TOKEN):
            self.arm_token, self.arm_answer = fields["token"], (fields["token"], result, detail)
        self.acknowledge("Arm", fields["token"], result, detail)
        if result == ACCEPTED:
            self.mark("armed", now)
        return None

    # -- one period
    def control(self, now):
        """Duties for the last command: yaw control with the gyro since the acknowledged sample, then speed control."""
        order, given = self.command, self.parameters
        if self.state != RUNNING or order is None:
            return 0.0, 0.0
        answered_at, turned_then = self.kept.get(order["answers"], (now, self.turned))
        turned = self.turned - turned_then - order["gyro_bias_radps"] * (now - answered_at)
        yaw = order["yaw_rad"] + (turned if given["flags"] & 1 else 0.0)
        rate = order["yaw_rate_radps"] + given["yaw_kp"] * wrapped(order["desired_yaw_rad"] - yaw)
        rate = max(-given["max_yaw_radps"], min(given["max_yaw_radps"], rate))
        half, most = rate * given["wheelbase_m"] / 2, given["max_track_mps"]
        speed = order["speed_mps"]
        speed = math.copysign(min(abs(speed), max(0.0, most * 0.85 - abs(half))), speed)
        left, right = (speed - half) / (1 - given["slip_left"]), (speed + half) / (1 - given["slip_right"])
        return (self.left.duty(left, self.measured[0], given), self.right.duty(right, self.measured[1], given))

    def period(self, now):
        """Updates body, sensors, time-outs and control and sends one sample, at the time `now`."""
        ground_left, ground_right = self.left.move(self.duties[0]), self.right.move(self.duties[1])
        speed = (ground_left + ground_right) / 2
        rate = self.sides * (ground_right - ground_left) / WHEELBASE
        self.pose[0] += speed * PERIOD * math.cos(self.pose[2] + rate * PERIOD / 2)
        self.pose[1] += speed * PERIOD * math.sin(self.pose[2] + rate * PERIOD / 2)
        self.pose[2] += rate * PERIOD
        self.follow_twin()
        noisy = rate * self.gyro_scale + self.gyro_bias + self.random.gauss(0, 0.0015)
        self.gyro = max(-32768, min(32767, round(noisy / LSB)))
        before, self.counts = self.counts, (math.floor(self.left.counted), math.floor(self.right.counted))
        self.measured = tuple(old + 0.3 * ((new - past) / COUNTS_PER_METRE / PERIOD - old)
                              for old, new, past in zip(self.measured, self.counts, before))
        if self.silent_until > now:
            self.duties = (0.0, 0.0)
            return
        self.look(now)
        self.each()
        if self.silent_until > now:
            return
        if self.last_received is not None and now - self.last_received > 1.0:
            self.off(HELLO)
            self.last_received = None
        if self.state == HELLO and now - self.last_hello >= 0.2:
            self.send_hello(now)
        if self.state < DISARMED:
            self.duties = (0.0, 0.0)
            return
        self.watch(now)
        given = self.parameters
        self.turned += self.gyro * given["gyro_z_radps_per_lsb"] * PERIOD
        wanted = self.control(now)
        self.duties = wanted
        self.sequence = (self.sequence + 1) % 65536
        self.kept[self.sequence] = (now, self.turned)
        self.kept.pop((self.sequence - 60) % 65536, None)
        for fields in self.samples(self.sample(now)):
            self.send("Sample", **fields)

    def sample(self, now):
        # On a wire, 45 bytes take 0.9 ms to arrive; a pseudo-terminal has no such delay.
        fields = {"sequence": self.sequence, "device_us": (self.device_us(now) - 900) % 2**32,
                  "left_counts": signed(self.counts[0] + self.counts_offset, 32),
                  "right_counts": signed(self.counts[1] + self.counts_offset, 32),
                  "gyro_x": 3, "gyro_y": -2, "gyro_z": self.gyro, "accel_x": self.accel[0], "accel_y": self.accel[1],
                  "accel_z": self.accel[2], "temperature": -3900, "battery_mv": self.battery_mv,
                  "left_duty": round(1000 * self.duties[0]), "right_duty": round(1000 * self.duties[1]),
                  "state": self.state, "faults": self.faults, "last_command": self.last_command, "imu_age": 0}
        fields.update(self.report)
        return fields

    def watch(self, now):
        """Time-outs and battery supervision, as the page requires."""
        fresh = now - (self.command_at or self.session_at)
        life = 0.7 if self.command_at is None else self.parameters["command_life_ms"] * 1e-3
        if fresh > life and now - self.session_at > 0.7:
            self.latch(COMMAND_TIMEOUT, now)
        if self.battery_mv >= self.parameters["battery_cutoff_mv"]:
            self.low_since = None
        elif self.low_since is None:
            self.low_since = now
        elif now - self.low_since > 1.0:
            self.latch(BATTERY_LOW, now)

    def follow_twin(self):
        """Updates the distance between the body and where the host's last commands would have moved it since the oddity."""
        if self.happened is None:
            return
        x, y, yaw = self.twin[-1]
        speed, rate = self.intended()
        yaw += rate * PERIOD
        self.twin.append((x + speed * PERIOD * math.cos(yaw), y + speed * PERIOD * math.sin(yaw), yaw))
        self.apart[0] = min(math.hypot(self.pose[0] - place[0], self.pose[1] - place[1]) for place in self.twin[::4])
        low, high = sorted((self.twin[0][2], yaw))
        self.apart[1] = self.pose[2] - max(low, min(high, self.pose[2]))

    # -- loop
    def run_until(self, done, deadline):
        """Runs in real time until `done()` is true or `deadline` has passed."""
        due = time.monotonic()
        while not done() and time.monotonic() < deadline:
            due += PERIOD
            while (rest := due - time.monotonic()) > 0:
                ready = self.is_open and self.reads and select.select([self.master], [], [], rest)[0]
                if ready:
                    self.receive()
                elif not self.is_open or not self.reads:
                    time.sleep(rest)
            self.late = max(self.late, -rest)
            self.period(due)

    def receive(self):
        try:
            data = os.read(self.master, 4096)
        except OSError:
            return
        *frames, self.waiting = (self.waiting + data).split(b"\0")
        for coded in frames:
            message = unpack(coded) if coded else None
            if message and self.is_open:
                self.take(*message, time.monotonic())


def asks_motion(fields):
    return (fields["speed_mps"] != 0 or fields["yaw_rate_radps"] != 0
            or abs(wrapped(fields["desired_yaw_rad"] - fields["yaw_rad"])) > 1e-6)
