"""The rows of the test: each fault of a robot, when it begins, and the required reaction."""
import math
import struct
import time

from oddities import (ARM, AT_ONCE, COMPLETE, DRIVE, EITHER, END, ENDS, IDLE, IN_BOUNDS, NEVER_ARMED, REFUSED, ROWS,
                      RUNS_ON, RUNS_UNARMED, SILENCE, START, TURN, UNARMED, acks, altered, both, clock, corrupts,
                      delays, drives, every_nth, floods, gap, hello, holds_back, log, Must, number, odd, once, pushed,
                      put, random_bytes, refuses, reports, restarts, samples, sends, steps, stop, trickles)
from robot import LSB
from wire import ACCEPTED, ARMED, DISARMED, FAULTED, HELLO, RUNNING, SCHEMA, TYPE, frame, pack

# -- 1. Motion, or its possibility, without a request
UNASKED = "unasked"
odd("runs unarmed", IDLE, drives(0.1, 0.1), RUNS_UNARMED, UNASKED)
odd("runs backwards unarmed", IDLE, drives(-0.1, -0.1), RUNS_UNARMED, UNASKED)
odd("spins unarmed", IDLE, drives(-0.1, 0.1), RUNS_UNARMED, UNASKED)
odd("one track runs unarmed", IDLE, drives(0.0, 0.1), RUNS_UNARMED, UNASKED)
odd("has a duty at standstill, unarmed", IDLE, reports(left_duty=300, right_duty=300), RUNS_UNARMED, UNASKED)
odd("reports Armed unasked", IDLE, reports(state=ARMED), UNARMED, UNASKED)
odd("reports Running unasked", IDLE, reports(state=RUNNING), UNARMED, UNASKED)
odd("reports Running and runs unasked", IDLE, drives(0.1, 0.1, state=RUNNING), RUNS_UNARMED, UNASKED)
odd("is armed from the start", ("session", 0.0), reports(state=ARMED), UNARMED, UNASKED)
odd("runs from the start", ("session", 0.0), drives(0.1, 0.1, state=RUNNING), RUNS_UNARMED, UNASKED)
odd("is pushed by hand for 0.5 s while idle", IDLE, pushed(0.05, 0.0, 0.5), COMPLETE)
odd("is turned by hand for 0.5 s while idle", IDLE, pushed(0.0, 0.5, 0.5), COMPLETE)
odd("is pushed by hand for ever", IDLE, pushed(0.03, 0.0, 60), stop(m=None, deg=None, arms=0), r"still|rest")
odd("is turned by hand for ever", IDLE, pushed(0.0, 0.3, 60), stop(m=None, deg=None, arms=0), r"still|rest")
odd("restarts and runs unarmed", DRIVE, both(restarts(0.1), drives(0.1, 0.1)), AT_ONCE, r"robot_rebooted|restart")
odd("runs on after Disarm, acknowledged, reports Disarmed", END, drives(0.1, 0.1), RUNS_ON, UNASKED)
odd("runs on after Disarm, acknowledged, reports Running", END, drives(0.1, 0.1, state=RUNNING), RUNS_ON, UNASKED)
odd("reports Armed after Disarm", END, reports(state=ARMED), AT_ONCE, UNASKED + "|not_acknowledged")
odd("runs on after a Stop", DRIVE, both(reports(accel_x=8192, accel_z=0), drives(0.1, 0.1)), IN_BOUNDS, "tilt")
odd("rolls a little after Disarm, without a duty", END, pushed(0.02, 0.0, 0.2), COMPLETE._replace(arrives=False))
odd("starts with stop_requested latched", START, put(faults=1 << 1), COMPLETE)

# -- 2. Sequences, clocks and counts
odd("sequence +1000", DRIVE, steps(1000), COMPLETE)
odd("sequence +32767", DRIVE, steps(32767), EITHER)
odd("every sample twice", DRIVE, samples(lambda f, r: [f, f]), COMPLETE)
def swapped_pairs(robot):
    kept = []
    def change(fields):
        kept.append(fields)
        if len(kept) < 2:
            return []
        pair = kept[::-1]
        kept.clear()
        return pair
    robot.samples = change
odd("samples in swapped pairs", DRIVE, swapped_pairs, COMPLETE)
def replays(robot):
    kept = []
    def change(fields):
        kept.append(fields)
        return [fields] + (kept[-40:-1] if len(kept) % 50 == 0 else [])
    robot.samples = change
odd("old samples replayed", DRIVE, replays, COMPLETE)
LOST = "link_lost|samples_stale|command_timeout"
odd("sequence -100", DRIVE, steps(-100), SILENCE, LOST)
odd("sequence +40000", DRIVE, steps(40000), SILENCE, LOST)
odd("sequence frozen", DRIVE, reports(sequence=200), SILENCE, LOST)
odd("sequence random", DRIVE, altered(lambda f, r: {"sequence": r.random.getrandbits(16)}), SILENCE, LOST)
odd("a tenth of the samples lost", DRIVE, samples(lambda f, r: [f] * (r.random.random() > 0.1)), COMPLETE)
odd("half of the samples lost", DRIVE, samples(lambda f, r: [f] * (r.random.random() > 0.5)), COMPLETE)
odd("no samples for 100 ms", DRIVE, gap(0.1), COMPLETE)
odd("no samples for 300 ms", DRIVE, gap(0.3), SILENCE, LOST)
odd("no samples for 1 s", DRIVE, gap(1.0), SILENCE, LOST)
odd("no samples any more", DRIVE, gap(60), SILENCE, LOST)
odd("no samples any more, but logs", DRIVE, both(gap(60), floods(50, log(b"still here"))), SILENCE, LOST)
odd("no samples any more, but frames of an unknown type", DRIVE,
    both(gap(60), floods(20, lambda r: frame(0x2A, b"12345678"))), SILENCE, LOST)
odd("no samples while idle", IDLE, gap(60), NEVER_ARMED, LOST)
odd("samples at 100 Hz", START, every_nth(2), COMPLETE)
odd("samples at 20 Hz", START, every_nth(10), COMPLETE)
odd("samples at 4 Hz", DRIVE, every_nth(50), stop(250 + 300), LOST)
CLOCK = LOST + "|clock that"
odd("clock -1 s", DRIVE, clock(-1000000), SILENCE, CLOCK)
odd("clock +10 s", DRIVE, clock(10000000), SILENCE, CLOCK)
odd("clock +40 min", DRIVE, clock(2400000000), SILENCE, CLOCK)
odd("clock -50 ms", DRIVE, clock(-50000), SILENCE, CLOCK)
odd("clock frozen", DRIVE, clock(0, -1e6), SILENCE, CLOCK)
odd("clock at half its speed", DRIVE, clock(0, -5e5), IN_BOUNDS, CLOCK)
odd("clock at twice its speed", DRIVE, clock(0, 1e6), IN_BOUNDS, CLOCK)
odd("sample times +- 20 ms", DRIVE,
    altered(lambda f, r: {"device_us": (f["device_us"] + r.random.randrange(-20000, 20000)) % 2**32}), EITHER)
odd("sample times frozen", DRIVE, reports(device_us=3000000), SILENCE, CLOCK)
odd("clock 1000 ppm fast", START, put(ppm=1000.0), COMPLETE)
odd("clock 20000 ppm slow", START, put(ppm=-20000.0), COMPLETE)
odd("clock 20000 ppm fast", START, put(ppm=20000.0), COMPLETE)
odd("clock wraps while driving", START, put(clock_us=2**32 - 1800000), COMPLETE)
odd("clock wraps while connecting", START, put(clock_us=2**32 - 300000), COMPLETE)
odd("clock passes 2^31", START, put(clock_us=2**31 - 1800000), COMPLETE)
odd("clock answers 10 s off", DRIVE,
    put(replies=lambda f: [{**f, "received_us": (f["received_us"] + 10**7) % 2**32,
    "sent_us": (f["sent_us"] + 10**7) % 2**32}]), IN_BOUNDS, CLOCK)
odd("clock answers with a time of sending before receiving", START,
    put(replies=lambda f: [{**f, "sent_us": (f["received_us"] - 5000) % 2**32}]), NEVER_ARMED, "clock|answer")
odd("counts wrap at 2^31", START, put(counts_offset=2**31 - 700), COMPLETE)
odd("counts wrap at -2^31", START, put(counts_offset=-2**31 + 100), COMPLETE)
odd("left counts of one sample +10000", DRIVE, lambda r: once(left_counts=r.counts[0] + 10000)(r), COMPLETE)
odd("left counts of one sample +2e9", DRIVE, lambda r: once(left_counts=r.counts[0] + 2 * 10**9)(r), COMPLETE)
def jumps(robot):
    def each():
        if robot.sequence % 10 == 0:
            robot.left.counted += 40
    robot.each = each
odd("left counts jump by 40 every 50 ms", DRIVE, jumps, IN_BOUNDS, "encoder")

# -- 3. Hellos
VERSION = r"protocol|version|schema"
odd("hello of protocol 2", START, hello(protocol=2), REFUSED, VERSION)
odd("hello of protocol 2 in 38 bytes", START,
    put(hello=lambda f: [frame(1, struct.pack("<H3sI", 2, b"\3\0\1", 77) + bytes(29))]), REFUSED, VERSION)
odd("hello of protocol 0", START, hello(protocol=0), REFUSED, VERSION)
odd("hello of another schema", START, hello(schema=0x12345678), REFUSED, VERSION)
odd("hello of 9 bytes, protocol 2", START, put(hello=lambda f: [frame(1, struct.pack("<H3sI", 2, b"\3\0\1", 77))]),
    REFUSED, VERSION)
odd("hello of 8 bytes", START, put(hello=lambda f: [frame(1, bytes(8))]), REFUSED, "hello|firmware|robot")
odd("hello of protocol 1 in 20 bytes", START,
    put(hello=lambda f: [frame(1, struct.pack("<H3sIBIBBHH", 1, b"\1\0\0", f["schema"], 2, 5, 1, 0, 0, 0))]), REFUSED,
    "hello|size|bytes")
odd("restarts with protocol 2 while driving", DRIVE, both(restarts(0.1), hello(protocol=2)),
    stop(None, m=None, deg=None)._replace(exits=(1, 2)), VERSION)
odd("nonce 0", START, hello(boot_nonce=0), REFUSED, "nonce|boot number")
def new_nonces(robot):
    before = robot.hello
    def change(fields):
        robot.nonce = fields["boot_nonce"] = robot.random.getrandbits(32) | 1
        return before(fields)
    robot.hello = change
odd("another nonce in every hello", START, new_nonces, COMPLETE)
odd("hello of board 77", START, hello(board=77), COMPLETE)
odd("hello of board 0", START, hello(board=0), COMPLETE)
odd("hello of a Mega behind a pty", START, hello(board=1), Must((1,), 0, None, None, None, False),
    options=("--duration", "2"))
odd("hello of board 77 behind a pty", START, hello(board=77), Must((1,), 0, None, None, None, False),
    options=("--duration", "2"))
odd("reset cause 99", START, hello(reset_cause=99), COMPLETE)
odd("state 9 in the hello", START, hello(state=9), Must((0, 2), 1, None, None, None, False), "hello|state 9|^$")
odd("firmware 255.255.255", START, hello(firmware=b"\xff\xff\xff"), COMPLETE)
odd("sends no hello", START, put(hello=lambda f: [pack("Log", {"device_us": 1, "level": 0, "text": b"hi"})]), REFUSED,
    "hello|answer")
odd("sends nothing at all", START, put(transmit=lambda data: None), REFUSED, "nothing|silen|answer|received")
odd("sends what is no frame", START, both(floods(100, random_bytes(40)), put(hello=lambda f: [])), REFUSED,
    "speed|baud|firmware|frame|answer")
odd("boot banner before the hello", START, lambda r: r.write(b"Booting TP100...\r\nok\r\n"), COMPLETE)

# -- 4. Floods and unrequested messages
odd("1000 logs a second", DRIVE, floods(1000, log(b"a line of some length, 40 bytes, or so..")), COMPLETE)
odd("logs of raw bytes and escapes", START, floods(20, log(lambda r: b"\x1b[2J\x07\r\n%s" + r.random.randbytes(34))),
    COMPLETE)
odd("logs of level 200", START, floods(5, log(b"level", 200)), COMPLETE)
odd("2400 fault reports a second", DRIVE, floods(2400, sends("FaultReport", device_us=5, fault=4, faults=16, detail=1)),
    COMPLETE)
odd("fault report of an unknown fault", DRIVE,
    floods(20, sends("FaultReport", device_us=5, fault=200, faults=0, detail=1)), COMPLETE)
odd("frames of unknown types", DRIVE, floods(500, lambda r: frame(r.random.randrange(7, 0x40), r.random.randbytes(20))),
    COMPLETE)
def echo(robot):
    take = robot.take
    def both_ways(name, fields, now):
        if fields:
            robot.write(pack(name, fields))
        take(name, fields, now)
    robot.take = both_ways
odd("host's frames echoed", START, echo, COMPLETE)
odd("acknowledgements of what nobody asked", DRIVE,
    floods(200, sends("Acknowledge", request=number(8), token=number(32), result=0, detail=0)), COMPLETE)
odd("acknowledged Arms that nobody sent, while idle", IDLE,
    floods(200, sends("Acknowledge", request=0x44, token=lambda r: r.random.randrange(5), result=0, detail=0)), EITHER)
odd("refused Arms that nobody sent, while driving", DRIVE,
    floods(200, sends("Acknowledge", request=0x44, token=number(32), result=5, detail=2)), COMPLETE)
odd("500 clock answers a second", DRIVE,
    floods(500, sends("SyncReply", id=number(16), received_us=number(32), sent_us=number(32), corrupted=0)), EITHER)
odd("hellos of the same boot while driving", DRIVE,
    lambda r: setattr(r, "each", lambda: r.send_hello(time.monotonic())), AT_ONCE,
    r"link_lost|hello|rebooted|restart|session")
odd("one hello of the same boot while driving", DRIVE, lambda r: r.send_hello(time.monotonic()), AT_ONCE,
    r"link_lost|hello|rebooted|restart|session")
odd("one hello of another boot while driving", DRIVE,
    lambda r: r.write(pack("Hello",
    {"protocol": 1, "firmware": b"\1\1\1", "schema": SCHEMA, "board": 2, "boot_nonce": 99, "reset_cause": 1, "state": 0,
    "faults": 0})), AT_ONCE, "rebooted|restart")
odd("a bit flipped in a tenth of the frames", DRIVE, corrupts(0.1), COMPLETE)
odd("a bit flipped in every frame", DRIVE, corrupts(1.0), SILENCE, LOST)
odd("20 kB/s of noise between frames", DRIVE, floods(200, random_bytes(100)), EITHER)
odd("a thousand spare delimiters a second", START, floods(1000, lambda r: b"\0"), COMPLETE)
odd("frames of 4000 bytes", DRIVE, floods(5, lambda r: b"\x55" * 4000 + b"\0"), COMPLETE)
odd("samples of 41 bytes", DRIVE, lambda r: setattr(r, "samples", lambda f: r.transmit(frame(2, bytes(41))) or []),
    SILENCE, LOST)

# -- 5. Disobedience
odd("acknowledges Arm, stays Disarmed", ARM, both(reports(state=DISARMED), put(control=lambda now: (0.0, 0.0))),
    stop(1250), "not_acknowledged|did not|stays")
odd("stays Armed", ("armed", 0.0), both(reports(state=ARMED), put(control=lambda now: (0.0, 0.0))), IN_BOUNDS,
    "stalled|still|immobilised|does not (drive|move|follow)|not_acknowledged")
odd("ignores commands", ("armed", 0.0), both(put(deaf={"Command"}), put(watch=lambda now: None)), IN_BOUNDS,
    "stalled|still|immobilised|does not|command")
odd("ignores commands while driving", ("drive", 1.5), both(put(deaf={"Command"}), put(watch=lambda now: None)),
    IN_BOUNDS, "command|cross|heading|stalled|does not", course="bend")
odd("motors are dead", ("armed", 0.0), put(left__motor=0.0, right__motor=0.0), IN_BOUNDS,
    "stalled|encoders_against_duty|immobilised")
odd("left motor is dead", ("armed", 0.0), put(left__motor=0.0), IN_BOUNDS, "stalled|encoders_against_duty|heading")
odd("left motor dies while driving", DRIVE, put(left__motor=0.0), IN_BOUNDS, "stalled|encoders_against_duty|heading")
odd("right motor dies while driving", DRIVE, put(right__motor=0.0), IN_BOUNDS, "stalled|encoders_against_duty|heading")
odd("motors are 1.6 times as strong", START, put(left__motor=1.6, right__motor=1.6), COMPLETE)

# -- 6. Tracks, encoders, gyro
DUTY = "encoders_against_duty|reversed|stalled"
odd("motors reversed", ("armed", 0.0), put(left__motor=-1.0, right__motor=-1.0), IN_BOUNDS, DUTY)
odd("left motor reversed", ("armed", 0.0), put(left__motor=-1.0), IN_BOUNDS, DUTY + "|gyro_against|heading")
odd("right motor reversed", ("armed", 0.0), put(right__motor=-1.0), IN_BOUNDS, DUTY + "|gyro_against|heading")
odd("runs away forwards", DRIVE, put(left__runs_at=0.3, right__runs_at=0.3), IN_BOUNDS,
    "encoders_against_duty|duty|speed|runs")
odd("runs away backwards", DRIVE, put(left__runs_at=-0.3, right__runs_at=-0.3), IN_BOUNDS,
    "encoders_against_duty|duty|cross")
odd("spins", DRIVE, put(left__runs_at=-0.15, right__runs_at=0.15), IN_BOUNDS, "heading|encoders_against_duty|duty")
odd("left track stuck", DRIVE, put(left__blocked=True), IN_BOUNDS, "stalled|encoders_against_duty|duty")
odd("right track stuck", DRIVE, put(right__blocked=True), IN_BOUNDS, "stalled|encoders_against_duty|duty")
odd("both tracks stuck", DRIVE, put(left__blocked=True, right__blocked=True), IN_BOUNDS,
    "stalled|encoders_against_duty|duty")
ENCODER = "encoder|stalled|gyro_against_encoders"
for side in ("left", "right"):
    odd(f"{side} encoder dead", DRIVE, put(**{side + "__encoder": 0.0}), IN_BOUNDS, ENCODER)
    odd(f"{side} encoder dead from the start", START, put(**{side + "__encoder": 0.0}), IN_BOUNDS, ENCODER)
    odd(f"{side} encoder backwards", DRIVE, put(**{side + "__encoder": -1.0}), IN_BOUNDS, ENCODER)
    for lost in (30, 50, 70, 95):
        odd(f"{side} encoder loses {lost} % of its edges", DRIVE, put(**{side + "__encoder": 1 - lost / 100}),
            IN_BOUNDS, ENCODER)
odd("both encoders dead", DRIVE, put(left__encoder=0.0, right__encoder=0.0), IN_BOUNDS, ENCODER)
odd("both encoders dead from the start", START, put(left__encoder=0.0, right__encoder=0.0), IN_BOUNDS, ENCODER)
odd("both encoders lose half of their edges", DRIVE, put(left__encoder=0.5, right__encoder=0.5), IN_BOUNDS, ENCODER)
odd("left encoder dead in a spin", TURN, put(left__encoder=0.0), IN_BOUNDS, ENCODER, course="spin")
odd("left encoder dead in an arc", TURN, put(left__encoder=0.0), IN_BOUNDS, ENCODER, course="arc")
GYRO = "gyro_against_encoders|gyro|imu"
odd("gyro dead in an arc", TURN, put(gyro_scale=0.0), IN_BOUNDS, GYRO, course="arc")
odd("gyro dead in a spin", TURN, put(gyro_scale=0.0), IN_BOUNDS, GYRO, course="spin")
odd("gyro dead from the start, spin", START, put(gyro_scale=0.0), IN_BOUNDS, GYRO, course="spin")
odd("gyro keeps the value that it has in an arc", ("drive", 1.5),
    lambda r: put(gyro_scale=0.0, gyro_bias=r.gyro * LSB)(r), IN_BOUNDS, GYRO, course="bend")
odd("gyro of the wrong sign in an arc", START, put(gyro_scale=-1.0), IN_BOUNDS, GYRO + "|heading", course="arc")
odd("gyro of the wrong sign in a spin", START, put(gyro_scale=-1.0), IN_BOUNDS, GYRO + "|heading", course="spin")
odd("gyro twice too fast in a spin", TURN, put(gyro_scale=2.0), IN_BOUNDS, GYRO, course="spin")
odd("gyro half too slow in a spin", TURN, put(gyro_scale=0.5), IN_BOUNDS, GYRO, course="spin")
odd("gyro +30 deg/s", DRIVE, put(gyro_bias=0.01 + math.radians(30)), IN_BOUNDS, GYRO)
odd("gyro -30 deg/s", DRIVE, put(gyro_bias=0.01 - math.radians(30)), IN_BOUNDS, GYRO)
odd("gyro +10 deg/s", DRIVE, put(gyro_bias=0.01 + math.radians(10)), IN_BOUNDS, GYRO)
odd("gyro at its limit", DRIVE, put(gyro_bias=50.0), IN_BOUNDS, GYRO)
odd("gyro noisy while idle", IDLE, altered(lambda f, r: {"gyro_z": r.random.randrange(-3000, 3000)}),
    stop(m=None, deg=None, arms=0), "gyro|still|rest")
odd("tracks swapped in an arc", START, put(sides=-1.0), IN_BOUNDS, GYRO + "|heading", course="arc")
odd("tracks swapped in a spin", START, put(sides=-1.0), IN_BOUNDS, GYRO + "|heading", course="spin")
def swap_motors(robot):
    control = robot.control
    robot.control = lambda now: control(now)[::-1]
odd("motors swapped in a spin", START, swap_motors, IN_BOUNDS, DUTY + "|gyro|heading", course="spin")

# -- 7. Battery, attitude, faults and other fields of a sample
odd("battery at 5.4 V, which the board reports", DRIVE, put(battery_mv=5400), stop(1500, m=None, deg=None),
    "battery_low|low_battery")
odd("battery at 5.4 V, which the board does not report", DRIVE, both(reports(battery_mv=5400)),
    stop(2500, m=None, deg=None), "battery_below_minimum")
odd("battery at 0 V in one sample", DRIVE, once(battery_mv=0), COMPLETE)
odd("battery at 5.4 V from the start", START, put(battery_mv=5400), NEVER_ARMED._replace(arms=1), "battery|cell")
odd("battery at 65 V", START, put(battery_mv=65535), COMPLETE)
odd("upside down from the start", START, put(accel=(0, 0, -8192)), stop(m=None, deg=None, arms=0),
    "tilt|upright|upside")
odd("on its side from the start", START, put(accel=(0, 8192, 0)), stop(m=None, deg=None, arms=0), "tilt|upright|side")
odd("falls on its back", DRIVE, put(accel=(0, 0, -8192)), IN_BOUNDS, "tilt")
odd("tips by 60 deg", DRIVE, put(accel=(7094, 0, 4096)), IN_BOUNDS, "tilt")
odd("accelerometer at zero", DRIVE, put(accel=(0, 0, 0)), EITHER)
odd("temperature of 500 deg", START, reports(temperature=32767), COMPLETE)
FAULTS = ("command_timeout stop_requested watchdog_reset brown_out loop_hung imu_missing imu_stale battery_low "
          "stalled_left stalled_right reversed_left reversed_right parameters_missing").split()
for bit, name in enumerate(FAULTS):
    odd(f"latches {name}", DRIVE, lambda r, bit=bit: r.latch(bit, time.monotonic()), AT_ONCE, name)
for bit in (13, 15):
    odd(f"latches the unknown fault {bit}", DRIVE, lambda r, bit=bit: r.latch(bit, time.monotonic()), AT_ONCE,
        rf"unknown.*fault|fault.*({bit}|unknown)")
odd("unknown fault bit while running on", DRIVE, reports(faults=1 << 14), AT_ONCE,
    r"unknown.*fault|fault.*(14|unknown)")
odd("unknown fault bit from the start", START, reports(faults=1 << 14), NEVER_ARMED,
    r"unknown.*fault|fault.*(14|unknown)")
odd("a fault bit, but runs on", DRIVE, reports(faults=1 << 4), AT_ONCE, "loop_hung")
BY_ITSELF = "(is|says|went|now|became) (disarmed|faulted)|by itself|no longer|unasked"
odd("Faulted without a fault", DRIVE, reports(state=FAULTED), AT_ONCE, BY_ITSELF)
odd("Disarmed by itself", DRIVE, lambda r: r.off(DISARMED), AT_ONCE, BY_ITSELF)
odd("state 9", DRIVE, reports(state=9), SILENCE, "")
odd("state Hello in samples", DRIVE, reports(state=HELLO), SILENCE, "")
odd("imu_age 255, gyro 0", DRIVE, reports(imu_age=255, gyro_z=0), SILENCE, "imu|gyro|mpu6050")
odd("imu_age 255, gyro 0 from the start", START, reports(imu_age=255, gyro_z=0), NEVER_ARMED._replace(arms=0),
    "imu|gyro|mpu6050")
odd("imu_age 40", DRIVE, reports(imu_age=40), SILENCE, "imu|gyro|mpu6050")
odd("last_command stands still", DRIVE, lambda r: reports(last_command=r.last_command)(r), IN_BOUNDS, "command")
odd("last_command random", DRIVE, altered(lambda f, r: {"last_command": r.random.getrandbits(16)}), EITHER)
odd("duty of 20000", DRIVE, reports(left_duty=20000), SILENCE, "")

# -- 8. Restarts
REBOOT = "robot_rebooted|link_lost|samples_stale|restarted"
odd("restarts, hello after 1.2 s", DRIVE, restarts(1.2), SILENCE, REBOOT)
odd("restarts, hello after 30 ms", DRIVE, restarts(0.03), AT_ONCE, REBOOT)
odd("restarts with the same nonce", DRIVE, restarts(0.03, 0x51A7E001), AT_ONCE, REBOOT)
odd("restarts, and is silent", DRIVE, restarts(60), SILENCE, REBOOT)
def loop(robot):
    restarts(0.1, robot.nonce + 1)(robot)
    def each():
        if time.monotonic() - robot.booted > 0.6:
            restarts(0.1, robot.nonce + 1)(robot)
    robot.each = each
odd("restarts again and again", DRIVE, loop, AT_ONCE, REBOOT)
odd("restarts again and again, from the start", IDLE, loop, NEVER_ARMED, REBOOT)
odd("restarts while it is about to be armed", IDLE, restarts(0.1), NEVER_ARMED, REBOOT)
odd("restarts on Arm", ARM, restarts(0.03), stop(300), REBOOT)
odd("restarts on Arm, silent for 1.2 s", ARM, restarts(1.2), stop(300), REBOOT + "|not_acknowledged")
odd("restarts as soon as it is armed", ("armed", 0.0), restarts(0.03), stop(300), REBOOT)
odd("restarts on Disarm at the end", ("Disarm", 0.0), restarts(0.03), EITHER, course="short")
odd("restarts by its watchdog", DRIVE, restarts(0.3, faults=4, reset_cause=4), SILENCE, REBOOT)
odd("restarts by brown-out", DRIVE, restarts(0.3, faults=8, reset_cause=3), SILENCE, REBOOT)
STAYS = ("--stay", "--duration", "4")
for text, name in (("\n", "Enter"), ("\n\n", "two Enters"), ("go\n", "go")):
    odd(f"restarts, {name} in the gap", DRIVE, restarts(0.5), SILENCE, REBOOT + "|stop_requested",
        typed=(("drive", 0.9, text),), options=STAYS)
odd("restarts, Enter just before it", DRIVE, restarts(0.5), ENDS, "stop_requested", typed=(("drive", 0.55, "\n"),),
    options=STAYS)
odd("restarts, Enter after it", DRIVE, restarts(0.1), AT_ONCE, REBOOT, typed=(("drive", 1.6, "\n"),), options=STAYS)
odd("restarts, go after it", DRIVE, restarts(0.1), Must((1,), 2, None, None, None, False), REBOOT,
    typed=(("drive", 1.6, "go\n"),), options=STAYS)
for seconds in (0.05, 0.5, 1.5):
    odd(f"is obedient; Enter stops it, and again {seconds} s later", ("drive", 0.5), put(), ENDS, "stop_requested",
        typed=(("drive", 0.5, "\n"), ("drive", 0.5 + seconds, "\n")), options=STAYS)
odd("hello of a Mega behind a pty, Enter", START, hello(board=1), COMPLETE, typed=(("session", 1.0, "\n"),), options=())

# -- 9. Refusals
for result in (1, 2, 3, 4, 5, 77):
    detail = {3: 1 << 6, 4: 2, 5: DISARMED}.get(result, 0)
    odd(f"refuses Arm with {result}", ARM, refuses("Arm", result, None, detail), stop(300), "refus|not.*arm")
    odd(f"refuses Arm with {result}, reports Running", ARM, refuses("Arm", result, RUNNING, detail), stop(300),
        "refus|not.*arm")
    odd(f"refuses Parameters with {result}", START,
        refuses("Parameters", result, None, {4: 2, 5: DISARMED}.get(result, 0)), REFUSED, "refus")
odd("refuses Arm with 5, reports Armed", ARM, refuses("Arm", 5, ARMED, DISARMED), stop(300), "refus|not.*arm")

# -- 10. Missing answers, and answers to other requests
odd("does not answer Parameters", START, put(deaf={"Parameters"}), REFUSED, "parameter|receives nothing")
odd("does not answer SyncRequests", START, put(deaf={"SyncRequest"}), REFUSED, "clock|sync|answer")
odd("does not answer SyncRequests while driving", DRIVE, put(deaf={"SyncRequest"}), COMPLETE)
def unanswered(name):
    return acks(lambda fields: [] if fields["request"] == TYPE[name] else [fields])
UNANSWERED = "not_acknowledged|not confirm|did not answer|acknowledge"
odd("obeys Arm, does not answer", ARM, unanswered("Arm"), stop(450), UNANSWERED)
odd("does not take Arm", ARM, put(deaf={"Arm"}), stop(450), UNANSWERED)
odd("obeys Disarm, does not answer", DRIVE, unanswered("Disarm"), EITHER, "", course="short")
odd("does not take Disarm", DRIVE, put(deaf={"Disarm"}), ENDS, "disarm", course="short")
odd("answers Arm with another token", ARM,
    acks(lambda f: [{**f, "token": f["token"] + 1}] if f["request"] == TYPE["Arm"] else [f]), stop(450), UNANSWERED)
odd("answers Disarm with another token, reports Running", DRIVE,
    both(acks(lambda f: [{**f, "token": f["token"] + 1}]), put(deaf={"Disarm"})), ENDS, "disarm", course="short")
odd("answers Arm as if it were Parameters", ARM,
    acks(lambda f: [{**f, "request": TYPE["Parameters"]}] if f["request"] == TYPE["Arm"] else [f]), stop(450),
    UNANSWERED)
odd("answers everything twice", START, acks(lambda f: [f, f]), COMPLETE)
def changes_its_mind(robot):
    def change(fields):
        robot.send("Acknowledge", **fields)
        if fields["request"] == TYPE["Arm"]:
            robot.send("Acknowledge", **{**fields, "result": 5})
        return []
    robot.acknowledges = change
odd("accepts Arm, then refuses it", ARM, changes_its_mind, EITHER)
odd("does not take Stop", DRIVE, both(put(deaf={"Stop", "Disarm"}), put(accel=(0, 0, -8192))), IN_BOUNDS, "tilt")
def late_arm(robot):
    unanswered("Arm")(robot)
    begin = time.monotonic()
    robot.hold = True
    def each():
        if robot.arm_answer and time.monotonic() - begin > 0.35 and robot.hold:
            robot.hold = False
            robot.send("Acknowledge", request=TYPE["Arm"], token=robot.arm_answer[0], result=ACCEPTED, detail=0)
    robot.each = each
odd("answers Arm after 350 ms", ARM, late_arm, stop(450), UNANSWERED)

# -- 11. Bytes and their timing
odd("one byte a millisecond", START, trickles, REFUSED)
def byte_by_byte(robot):
    robot.transmit = lambda data: [robot.write(data[i:i + 1]) for i in range(len(data))]
odd("byte by byte at full rate", START, byte_by_byte, COMPLETE)
odd("2 s of bytes held back, then sent at once", DRIVE, holds_back(2.0), SILENCE, LOST)
odd("gaps of 40 ms", DRIVE, holds_back(0.04, 0.2), COMPLETE)
odd("gaps of 100 ms", DRIVE, holds_back(0.1, 0.4), COMPLETE)
odd("all bytes 20 ms late", START, delays(lambda r: 0.02), COMPLETE)
odd("all bytes 100 ms late", DRIVE, delays(lambda r: 0.1), IN_BOUNDS, LOST)
odd("bytes up to 15 ms late", DRIVE, delays(lambda r: r.random.random() * 0.015), COMPLETE)
odd("the port goes", DRIVE, lambda r: r.close(), ENDS, "link_lost|port|lost")
odd("the port goes while idle", IDLE, lambda r: r.close(), Must((1, 2), 0, None, None, None, False), "")
odd("the host's bytes are not read", DRIVE, put(reads=False), ENDS, "command_timeout|link_lost|acknowledge|answer")
