"""The protocol of firmware/PROTOCOL.md. The messages are read from the tables of that page; the framing follows its
text."""
import os
import re
import struct

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
with open(ROOT + "/firmware/PROTOCOL.md", encoding="utf-8") as page:
    PAGE = page.read()
PROTOCOL, SCHEMA = (int(value, 0) for value in re.search(r"protocol version (\d+), schema hash (\w+)", PAGE).groups())
ACCEPTED, WRONG_BOOT, STALE_TOKEN, FAULT_PERSISTS, OUT_OF_RANGE, WRONG_STATE = range(6)
HELLO, PARAMETERS, DISARMED, ARMED, RUNNING, FAULTED = range(6)  # states
LETTERS = {"u8": "B", "u16": "H", "u32": "I", "i16": "h", "i32": "i", "f32": "f"}

TYPE, LAYOUT = {}, {}  # type byte; struct format and names of the fields (i16[3] is three fields, u8[n] is bytes)
for section in PAGE.split("\n### ")[1:]:
    head = re.match(r"`(\w+)` (0x\w\w), (\d+) bytes", section)
    if not head:
        continue
    layout, names = "<", []
    for kind, count, field in re.findall(r"^\| \d+ \| (\w+)(?:\[(\d+)\])? \| `(\w+)`", section, re.MULTILINE):
        layout += f"{count}s" if count and kind == "u8" else count + LETTERS[kind]
        names += [f"{field}_{axis}" for axis in "xyz"] if count and kind != "u8" else [field]
    assert struct.calcsize(layout) == int(head[3]), section
    TYPE[head[1]], LAYOUT[head[1]] = int(head[2], 0), (struct.Struct(layout), names)
NAME = {byte: name for name, byte in TYPE.items()}
with open(ROOT + "/tests/wire/golden_frames.txt", encoding="utf-8") as frames:
    GOLDEN = re.findall(r"^(\w+) \|.*\| ([0-9A-F]+)$", frames.read(), re.MULTILINE)

CRC_TABLE = []
for byte in range(256):
    crc = byte << 8
    for _ in range(8):
        crc = (crc << 1) ^ (0x1021 if crc & 0x8000 else 0)
    CRC_TABLE.append(crc & 0xFFFF)


def crc16(data):
    value = 0xFFFF
    for byte in data:
        value = (value << 8 & 0xFFFF) ^ CRC_TABLE[value >> 8 ^ byte]
    return value


def frame(kind, payload):
    """The bytes of one frame, delimiter included; `kind` is the type byte."""
    body = bytes([kind]) + payload
    body += struct.pack("<H", crc16(body))
    return b"".join(bytes([len(part) + 1]) + part for part in body.split(b"\0")) + b"\0"


def pack(name, fields):
    """A frame; fields that are not given are 0."""
    layout, names = LAYOUT[name]
    return frame(TYPE[name], layout.pack(*(fields.get(key, 0) for key in names)))


def unpack(coded):
    """(name, fields) of a frame without its delimiter, or None if it is corrupted, unknown or of a wrong size."""
    body, at = bytearray(), 0
    while at < len(coded):
        end = at + coded[at]
        if coded[at] == 0 or end > len(coded):
            return None
        body += (b"\0" if at else b"") + coded[at + 1:end]
        at = end
    if len(body) < 3 or crc16(body[:-2]) != body[-2] | body[-1] << 8 or body[0] not in NAME:
        return None
    name = NAME[body[0]]
    layout, names = LAYOUT[name]
    if len(body) - 3 != layout.size:
        return (name, {}) if name == "HelloRequest" else None
    return name, dict(zip(names, layout.unpack(body[1:-2])))


def newer(a, b):
    return 1 <= (a - b) % 65536 <= 32767


def signed(value, bits):
    """The lowest bits of an integer, read in two's complement."""
    half = 1 << bits - 1
    return (value + half) % (2 * half) - half
