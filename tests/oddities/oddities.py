"""Faults of a robot that violate the protocol or physics, and the required reactions; oddity_list.py has the rows."""
import time
from collections import namedtuple

from wire import DISARMED, TYPE, pack

# `when`: phase of the robot's life and seconds after its beginning. `must`: see below. `words`: a regular expression
# for the daemon's output. `course`: line, short, arc or spin. `typed`: (phase, seconds, text) for the daemon's standard
# input. `options`: of the daemon.
Oddity = namedtuple("Oddity", "name when do must words course typed options")
# `exits`: accepted exit statuses. `arms`: largest number of Arms (repeats of a token count once). `ms`, `m`, `deg`:
# limits within which the motors must be asked off, counted from the oddity; None: no limit. `arrives`: the robot must
# end where the course does. `stops`: smallest number of Stops that must be sent to a robot that does not obey.
Must = namedtuple("Must", "exits arms ms m deg arrives stops", defaults=(0,))

COMPLETE = Must((0,), 1, None, None, None, True)


def stop(ms=None, m=0.15, deg=20.0, arms=1):
    return Must((1,), arms, ms, m, deg, False)


AT_ONCE = stop(250)             # one sample reveals the fault
SILENCE = stop(300)             # missing data are detected only after 200 ms
IN_BOUNDS = stop()              # the fault is detected over a time window
UNARMED = stop(250, arms=0)     # the state reveals the fault; with a duty, the daemon sends Stop repeatedly
RUNS_UNARMED = UNARMED._replace(stops=2)
RUNS_ON = AT_ONCE._replace(stops=2)
ENDS = Must((1,), 1, None, None, None, False)
EITHER = Must((0, 1), 1, None, None, None, False)
NEVER_ARMED = Must((1, 2), 0, None, None, None, False)
REFUSED = Must((2,), 0, None, None, None, False)

START = ("boot", 0.0)
IDLE = ("session", 0.25)
ARM = ("Arm", 0.0)
DRIVE = ("drive", 0.6)
TURN = ("drive", 0.9)
END = ("Disarm", 0.0)
ROWS = []


def odd(name, when, do, must, words="", course=None, typed=(), options=("--go",)):
    course = course or ("short" if 0 in must.exits or when == END else "line")
    ROWS.append(Oddity(name, when, do, must, words, course, typed, options))


# -- kinds of oddities: each function returns a function of the robot
def both(*ways):
    return lambda robot: [way(robot) for way in ways]


def put(**attributes):
    """Replaces attributes; a dot is written as __ (left__motor)."""
    def do(robot):
        for path, value in attributes.items():
            *owners, last = path.split("__")
            owner = robot
            for part in owners:
                owner = getattr(owner, part)
            setattr(owner, last, value)
    return do


def reports(**fields):
    """Samples report these fields, whatever their true values are."""
    return lambda robot: robot.report.update(fields)


def samples(change):
    """`change(fields, robot)` returns the samples to send instead of one."""
    def do(robot):
        robot.samples = lambda fields: change(fields, robot)
    return do


def altered(change):
    """`change(fields, robot)` returns fields that replace those of each sample."""
    return samples(lambda fields, robot: [{**fields, **change(fields, robot)}])


def steps(by):
    """The robot's sequence number jumps."""
    return lambda robot: setattr(robot, "sequence", (robot.sequence + by) % 65536)


def drives(left, right, **more):
    """The tracks run at these speeds whatever the command is, and the samples report a duty."""
    return both(put(left__runs_at=left, right__runs_at=right),
                reports(left_duty=round(3000 * left), right_duty=round(3000 * right), **more))


def pushed(speed, rate, seconds):
    """A hand moves the robot, and its tracks with it."""
    def do(robot):
        end = time.monotonic() + seconds
        def each():
            on = time.monotonic() < end
            robot.left.runs_at = (speed - rate * 0.13) / 0.9 if on else None
            robot.right.runs_at = (speed + rate * 0.13) / 0.88 if on else None
        robot.each = each
    return do


def acks(change):
    """`change(fields)` returns the acknowledgements to send instead of one."""
    return put(acknowledges=change)


def refuses(name, result, state=None, detail=0):
    """Answers a request with `result` in any case; samples report `state` from then on."""
    def do(robot):
        def change(fields):
            if fields["request"] == TYPE[name]:
                fields.update(result=result, detail=detail)
                if state is not None:
                    robot.report["state"] = state
                robot.off(DISARMED if name == "Arm" else robot.state)
            return [fields]
        robot.acknowledges = change
    return do


def clock(jump_us=0, ppm=None):
    def do(robot):
        now = time.monotonic()
        robot.clock_us = robot.device_us(now) + jump_us
        robot.booted = now
        robot.ppm = robot.ppm if ppm is None else ppm
    return do


def restarts(silent=0.03, nonce=0x51A7E002, **after):
    def do(robot):
        robot.clock_us = 0
        robot.boot(time.monotonic(), nonce, silent)
        robot.left.counted = robot.right.counted = 0.0
        for key, value in after.items():
            setattr(robot, key, value)
    return do


def floods(a_second, data):
    """`data(robot)` returns the bytes to send `a_second` times a second."""
    def do(robot):
        owed = [0.0]
        def each():
            owed[0] += a_second * 0.005
            while owed[0] >= 1:
                owed[0] -= 1
                robot.transmit(data(robot))
        robot.each = each
    return do


def log(text, level=0):
    return lambda robot: pack("Log", {"device_us": robot.device_us(time.monotonic()), "level": level,
                                      "text": text(robot) if callable(text) else text})


def sends(name, **fields):
    def data(robot):
        return pack(name, {key: value(robot) if callable(value) else value for key, value in fields.items()})
    return data


def hello(**fields):
    def do(robot):
        before = robot.hello
        robot.hello = lambda true: before({**true, **fields})
    return do


def random_bytes(count):
    return lambda robot: robot.random.randbytes(count)


def holds_back(seconds):
    """Sent bytes are held back for `seconds`, and then leave at once."""
    def do(robot):
        end, kept = time.monotonic() + seconds, []
        def each():
            if time.monotonic() >= end and kept:
                robot.write(b"".join(kept))
                kept.clear()
        def transmit(data):
            kept.append(data)
            each()
        robot.transmit, robot.each = transmit, each
    return do


def delays(seconds):
    """Each byte arrives later by `seconds`."""
    def do(robot):
        kept = []
        def each():
            while kept and kept[0][0] <= time.monotonic():
                robot.write(kept.pop(0)[1])
        robot.transmit = lambda data: kept.append((time.monotonic() + seconds, data))
        robot.each = each
    return do


def every_nth(n):
    return samples(lambda fields, robot: [fields] if fields["sequence"] % n == 0 else [])


def gap(seconds):
    """The robot sends no samples for a while; everything else continues."""
    def do(robot):
        end = time.monotonic() + seconds
        robot.samples = lambda fields: [fields] if time.monotonic() > end else []
    return do
