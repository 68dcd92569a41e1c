"""The rows of the test: each fault of a robot, when it begins, and the required reaction."""
import math
import time

from oddities import (ARM, AT_ONCE, COMPLETE, DRIVE, EITHER, END, ENDS, IDLE, IN_BOUNDS, NEVER_ARMED, REFUSED, ROWS,
                      RUNS_ON, RUNS_UNARMED, SILENCE, START, TURN, UNARMED, acks, altered, both, clock, delays, drives,
                      every_nth, floods, gap, hello, holds_back, log, Must, odd, pushed, put, random_bytes,
                      refuses, reports, restarts, samples, sends, steps, stop)
from robot import LSB
from wire import ARMED, DISARMED, FAULTED, RUNNING, TYPE, frame, pack

# -- 1. Motion, or its possibility, without a request
UNASKED = "unasked"
odd("runs unarmed", IDLE, drives(0.1, 0.1), RUNS_UNARMED, UNASKED)
odd("spins unarmed", IDLE, drives(-0.1, 0.1), RUNS_UNARMED, UNASKED)
odd("has a duty at standstill, unarmed", IDLE, reports(left_duty=300, right_duty=300), RUNS_UNARMED, UNASKED)
odd("reports Armed unasked", IDLE, reports(state=ARMED), UNARMED, UNASKED)
odd("reports Running unasked", IDLE, reports(state=RUNNING), UNARMED, UNASKED)
odd("runs from the start", ("session", 0.0), drives(0.1, 0.1, state=RUNNING), RUNS_UNARMED, UNASKED)
odd("is pushed by hand for 0.5 s while idle", IDLE, pushed(0.05, 0.0, 0.5), COMPLETE)
odd("is pushed by hand for ever", IDLE, pushed(0.03, 0.0, 60), stop(m=None, deg=None, arms=0), r"still|rest")
odd("restarts and runs unarmed", DRIVE, both(restarts(0.1), drives(0.1, 0.1)), AT_ONCE, r"robot_rebooted|restart")
odd("runs on after Disarm, acknowledged, reports Running", END, drives(0.1, 0.1, state=RUNNING), RUNS_ON, UNASKED)
odd("reports Armed after Disarm", END, reports(state=ARMED), AT_ONCE, UNASKED + "|not_acknowledged")
odd("runs on after a Stop", DRIVE, both(reports(accel_x=8192, accel_z=0), drives(0.1, 0.1)), IN_BOUNDS, "tilt")
odd("rolls a little after Disarm, without a duty", END, pushed(0.02, 0.0, 0.2), COMPLETE._replace(arrives=False))
odd("starts with stop_requested latched", START, put(faults=1 << 1), COMPLETE)

# -- 2. Sequences, clocks and counts
LOST = "link_lost|samples_stale|command_timeout"
odd("sequence +40000", DRIVE, steps(40000), SILENCE, LOST)
odd("sequence random", DRIVE, altered(lambda f, r: {"sequence": r.random.getrandbits(16)}), SILENCE, LOST)
odd("half of the samples lost", DRIVE, samples(lambda f, r: [f] * (r.random.random() > 0.5)), COMPLETE)
odd("no samples any more, but logs", DRIVE, both(gap(60), floods(50, log(b"still here"))), SILENCE, LOST)
odd("no samples while idle", IDLE, gap(60), NEVER_ARMED, LOST)
odd("samples at 4 Hz", DRIVE, every_nth(50), stop(250 + 300), LOST)
CLOCK = LOST + "|clock that"
odd("clock +10 s", DRIVE, clock(10000000), SILENCE, CLOCK)
odd("clock frozen", DRIVE, clock(0, -1e6), SILENCE, CLOCK)
odd("clock at twice its speed", DRIVE, clock(0, 1e6), IN_BOUNDS, CLOCK)
odd("clock answers 10 s off", DRIVE,
    put(replies=lambda f: [{**f, "received_us": (f["received_us"] + 10**7) % 2**32,
    "sent_us": (f["sent_us"] + 10**7) % 2**32}]), IN_BOUNDS, CLOCK)
odd("counts wrap at 2^31", START, put(counts_offset=2**31 - 700), COMPLETE)
def jumps(robot):
    def each():
        if robot.sequence % 10 == 0:
            robot.left.counted += 40
    robot.each = each
odd("left counts jump by 40 every 50 ms", DRIVE, jumps, IN_BOUNDS, "encoder")

# -- 3. Hellos
VERSION = r"protocol|version|schema"
odd("hello of protocol 2", START, hello(protocol=2), REFUSED, VERSION)
odd("hello of another schema", START, hello(schema=0x12345678), REFUSED, VERSION)
odd("restarts with protocol 2 while driving", DRIVE, both(restarts(0.1), hello(protocol=2)),
    stop(None, m=None, deg=None)._replace(exits=(1, 2)), VERSION)
odd("hello of board 77", START, hello(board=77), COMPLETE)
odd("hello of a Mega behind a pty", START, hello(board=1), Must((1,), 0, None, None, None, False),
    options=("--duration", "2"))
odd("sends no hello", START, put(hello=lambda f: [pack("Log", {"device_us": 1, "level": 0, "text": b"hi"})]), REFUSED,
    "hello|answer")
odd("sends nothing at all", START, put(transmit=lambda data: None), REFUSED, "nothing|silen|answer|received")
odd("sends what is no frame", START, both(floods(100, random_bytes(40)), put(hello=lambda f: [])), REFUSED,
    "speed|baud|firmware|frame|answer")

# -- 4. Floods and unrequested messages
odd("1000 logs a second", DRIVE, floods(1000, log(b"a line of some length, 40 bytes, or so..")), COMPLETE)
odd("logs of raw bytes and escapes", START, floods(20, log(lambda r: b"\x1b[2J\x07\r\n%s" + r.random.randbytes(34))),
    COMPLETE)
odd("2400 fault reports a second", DRIVE, floods(2400, sends("FaultReport", device_us=5, fault=4, faults=16, detail=1)),
    COMPLETE)
odd("frames of unknown types", DRIVE, floods(500, lambda r: frame(r.random.randrange(7, 0x40), r.random.randbytes(20))),
    COMPLETE)
odd("acknowledged Arms that nobody sent, while idle", IDLE,
    floods(200, sends("Acknowledge", request=0x44, token=lambda r: r.random.randrange(5), result=0, detail=0)), EITHER)
odd("hellos of the same boot while driving", DRIVE,
    lambda r: setattr(r, "each", lambda: r.send_hello(time.monotonic())), AT_ONCE,
    r"link_lost|hello|rebooted|restart|session")

# -- 5. Disobedience
odd("acknowledges Arm, stays Disarmed", ARM, both(reports(state=DISARMED), put(control=lambda now: (0.0, 0.0))),
    stop(1250), "not_acknowledged|did not|stays")
odd("stays Armed", ("armed", 0.0), both(reports(state=ARMED), put(control=lambda now: (0.0, 0.0))), IN_BOUNDS,
    "stalled|still|immobilised|does not (drive|move|follow)|not_acknowledged")
odd("ignores commands while driving", ("drive", 1.5), both(put(deaf={"Command"}), put(watch=lambda now: None)),
    IN_BOUNDS, "command|cross|heading|stalled|does not", course="bend")
odd("motors are dead", ("armed", 0.0), put(left__motor=0.0, right__motor=0.0), IN_BOUNDS,
    "stalled|encoders_against_duty|immobilised")
odd("left motor dies while driving", DRIVE, put(left__motor=0.0), IN_BOUNDS, "stalled|encoders_against_duty|heading")

# -- 6. Tracks, encoders, gyro
DUTY = "encoders_against_duty|reversed|stalled"
odd("motors reversed", ("armed", 0.0), put(left__motor=-1.0, right__motor=-1.0), IN_BOUNDS, DUTY)
odd("left motor reversed", ("armed", 0.0), put(left__motor=-1.0), IN_BOUNDS, DUTY + "|gyro_against|heading")
odd("runs away forwards", DRIVE, put(left__runs_at=0.3, right__runs_at=0.3), IN_BOUNDS,
    "encoders_against_duty|duty|speed|runs")
odd("spins", DRIVE, put(left__runs_at=-0.15, right__runs_at=0.15), IN_BOUNDS, "heading|encoders_against_duty|duty")
odd("left track stuck", DRIVE, put(left__blocked=True), IN_BOUNDS, "stalled|encoders_against_duty|duty")
odd("both tracks stuck", DRIVE, put(left__blocked=True, right__blocked=True), IN_BOUNDS,
    "stalled|encoders_against_duty|duty")
ENCODER = "encoder|stalled|gyro_against_encoders"
for side in ("left", "right"):
    odd(f"{side} encoder dead", DRIVE, put(**{side + "__encoder": 0.0}), IN_BOUNDS, ENCODER)
    odd(f"{side} encoder dead from the start", START, put(**{side + "__encoder": 0.0}), IN_BOUNDS, ENCODER)
    odd(f"{side} encoder backwards", DRIVE, put(**{side + "__encoder": -1.0}), IN_BOUNDS, ENCODER)
    for lost in (30, 95):
        odd(f"{side} encoder loses {lost} % of its edges", DRIVE, put(**{side + "__encoder": 1 - lost / 100}),
            IN_BOUNDS, ENCODER)
odd("both encoders lose half of their edges", DRIVE, put(left__encoder=0.5, right__encoder=0.5), IN_BOUNDS, ENCODER)
odd("left encoder dead in a spin", TURN, put(left__encoder=0.0), IN_BOUNDS, ENCODER, course="spin")
GYRO = "gyro_against_encoders|gyro|imu"
odd("gyro dead in a spin", TURN, put(gyro_scale=0.0), IN_BOUNDS, GYRO, course="spin")
odd("gyro keeps the value that it has in an arc", ("drive", 1.5),
    lambda r: put(gyro_scale=0.0, gyro_bias=r.gyro * LSB)(r), IN_BOUNDS, GYRO, course="bend")
odd("gyro of the wrong sign in a spin", START, put(gyro_scale=-1.0), IN_BOUNDS, GYRO + "|heading", course="spin")
odd("gyro twice too fast in a spin", TURN, put(gyro_scale=2.0), IN_BOUNDS, GYRO, course="spin")
odd("gyro +10 deg/s", DRIVE, put(gyro_bias=0.01 + math.radians(10)), IN_BOUNDS, GYRO)
odd("gyro noisy while idle", IDLE, altered(lambda f, r: {"gyro_z": r.random.randrange(-3000, 3000)}),
    stop(m=None, deg=None, arms=0), "gyro|still|rest")
def swap_motors(robot):
    control = robot.control
    robot.control = lambda now: control(now)[::-1]
odd("motors swapped in a spin", START, swap_motors, IN_BOUNDS, DUTY + "|gyro|heading", course="spin")

# -- 7. Battery, attitude, faults and other fields of a sample
odd("battery at 5.4 V, which the board reports", DRIVE, put(battery_mv=5400), stop(1500, m=None, deg=None),
    "battery_low|low_battery")
odd("battery at 5.4 V, which the board does not report", DRIVE, both(reports(battery_mv=5400)),
    stop(2500, m=None, deg=None), "battery_below_minimum")
odd("battery at 5.4 V from the start", START, put(battery_mv=5400), NEVER_ARMED._replace(arms=1), "battery|cell")
odd("upside down from the start", START, put(accel=(0, 0, -8192)), stop(m=None, deg=None, arms=0),
    "tilt|upright|upside")
odd("falls on its back", DRIVE, put(accel=(0, 0, -8192)), IN_BOUNDS, "tilt")
for bit, name in ((0, "command_timeout"), (4, "loop_hung"), (8, "stalled_left"), (12, "parameters_missing")):
    odd(f"latches {name}", DRIVE, lambda r, bit=bit: r.latch(bit, time.monotonic()), AT_ONCE, name)
odd("unknown fault bit while running on", DRIVE, reports(faults=1 << 14), AT_ONCE,
    r"unknown.*fault|fault.*(14|unknown)")
BY_ITSELF = "(is|says|went|now|became) (disarmed|faulted)|by itself|no longer|unasked"
odd("Faulted without a fault", DRIVE, reports(state=FAULTED), AT_ONCE, BY_ITSELF)
odd("Disarmed by itself", DRIVE, lambda r: r.off(DISARMED), AT_ONCE, BY_ITSELF)
odd("state 9", DRIVE, reports(state=9), SILENCE, "")
odd("imu_age 255, gyro 0", DRIVE, reports(imu_age=255, gyro_z=0), SILENCE, "imu|gyro|mpu6050")
odd("last_command stands still", DRIVE, lambda r: reports(last_command=r.last_command)(r), IN_BOUNDS, "command")

# -- 8. Restarts
REBOOT = "robot_rebooted|link_lost|samples_stale|restarted"
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
odd("restarts on Arm", ARM, restarts(0.03), stop(300), REBOOT)
odd("restarts by brown-out", DRIVE, restarts(0.3, faults=8, reset_cause=3), SILENCE, REBOOT)
STAYS = ("--stay", "--duration", "4")
for text, name in (("\n", "Enter"), ("\n\n", "two Enters"), ("go\n", "go")):
    odd(f"restarts, {name} in the gap", DRIVE, restarts(0.5), SILENCE, REBOOT + "|stop_requested",
        typed=(("drive", 0.9, text),), options=STAYS)
odd("restarts, Enter after it", DRIVE, restarts(0.1), AT_ONCE, REBOOT, typed=(("drive", 1.6, "\n"),), options=STAYS)
odd("restarts, go after it", DRIVE, restarts(0.1), Must((1,), 2, None, None, None, False), REBOOT,
    typed=(("drive", 1.6, "go start\n"),), options=STAYS)
for seconds in (0.05, 1.5):
    odd(f"is obedient; Enter stops it, and again {seconds} s later", ("drive", 0.5), put(), ENDS, "stop_requested",
        typed=(("drive", 0.5, "\n"), ("drive", 0.5 + seconds, "\n")), options=STAYS)
odd("hello of a Mega behind a pty, Enter", START, hello(board=1), COMPLETE, typed=(("session", 1.0, "\n"),), options=())

# -- 9. Refusals
for result in (1, 3, 5, 77):
    detail = {3: 1 << 6, 4: 2, 5: DISARMED}.get(result, 0)
    odd(f"refuses Arm with {result}, reports Running", ARM, refuses("Arm", result, RUNNING, detail), stop(300),
        "refus|not.*arm")
    odd(f"refuses Parameters with {result}", START,
        refuses("Parameters", result, None, {4: 2, 5: DISARMED}.get(result, 0)), REFUSED, "refus")

# -- 10. Missing answers, and answers to other requests
odd("does not answer Parameters", START, put(deaf={"Parameters"}), REFUSED, "parameter|receives nothing")
odd("does not answer SyncRequests", START, put(deaf={"SyncRequest"}), REFUSED, "clock|sync|answer")
def unanswered(name):
    return acks(lambda fields: [] if fields["request"] == TYPE[name] else [fields])
UNANSWERED = "not_acknowledged|not confirm|did not answer|acknowledge"
odd("obeys Arm, does not answer", ARM, unanswered("Arm"), stop(450), UNANSWERED)
odd("does not take Arm", ARM, put(deaf={"Arm"}), stop(450), UNANSWERED)
odd("does not take Disarm", DRIVE, put(deaf={"Disarm"}), ENDS, "disarm", course="short")
def changes_its_mind(robot):
    def change(fields):
        robot.send("Acknowledge", **fields)
        if fields["request"] == TYPE["Arm"]:
            robot.send("Acknowledge", **{**fields, "result": 5})
        return []
    robot.acknowledges = change
odd("accepts Arm, then refuses it", ARM, changes_its_mind, EITHER)
odd("does not take Stop", DRIVE, both(put(deaf={"Stop", "Disarm"}), put(accel=(0, 0, -8192))), IN_BOUNDS, "tilt")

# -- 11. Bytes and their timing
def byte_by_byte(robot):
    robot.transmit = lambda data: [robot.write(data[i:i + 1]) for i in range(len(data))]
odd("byte by byte at full rate", START, byte_by_byte, COMPLETE)
odd("2 s of bytes held back, then sent at once", DRIVE, holds_back(2.0), SILENCE, LOST)
odd("all bytes 100 ms late", DRIVE, delays(0.1), IN_BOUNDS, LOST)
odd("the port goes", DRIVE, lambda r: r.close(), ENDS, "link_lost|port|lost")
odd("the port goes while idle", IDLE, lambda r: r.close(), Must((1, 2), 0, None, None, None, False), "")
odd("the host's bytes are not read", DRIVE, put(reads=False), ENDS, "command_timeout|link_lost|acknowledge|answer")
