"""The wire of firmware/PROTOCOL.md, written from that page alone: frames, messages and their fields."""
import struct

PROTOCOL, SCHEMA = 1, 0x9286885F
ACCEPTED, WRONG_BOOT, STALE_TOKEN, FAULT_PERSISTS, OUT_OF_RANGE, WRONG_STATE = range(6)
HELLO, PARAMETERS, DISARMED, ARMED, RUNNING, FAULTED = range(6)  # states

MESSAGES = {  # name: type, layout, fields
    "Hello": (0x01, "<H3sIBIBBH", "protocol firmware schema board boot_nonce reset_cause state faults"),
    "Sample": (0x02, "<HIiihhhhhhhHhhBHHB",
               "sequence device_us left_counts right_counts gyro_x gyro_y gyro_z accel_x accel_y accel_z temperature "
               "battery_mv left_duty right_duty state faults last_command imu_age"),
    "Acknowledge": (0x03, "<BIBH", "request token result detail"),
    "SyncReply": (0x04, "<HIIH", "id received_us sent_us damaged"),
    "FaultReport": (0x05, "<IBHi", "device_us fault faults detail"),
    "Log": (0x06, "<IB40s", "device_us level text"),
    "HelloRequest": (0x41, "<HI", "protocol schema"),
    "Parameters": (0x42, "<II13fHHHHHB",
                   "boot_nonce token counts_per_metre wheelbase_m slip_left slip_right max_track_mps max_track_mps2 "
                   "feed_forward dead_band speed_kp speed_ki yaw_kp max_yaw_radps gyro_z_radps_per_lsb "
                   "battery_cutoff_mv stall_duty stall_ms command_life_ms yaw_window_ms flags"),
    "Command": (0x43, "<IHH6fIf",
                "boot_nonce sequence answers x_m y_m yaw_rad desired_yaw_rad yaw_rate_radps speed_mps expiry_us "
                "gyro_bias_radps"),
    "Arm": (0x44, "<III", "boot_nonce token expiry_us"),
    "Disarm": (0x45, "<I", "token"),
    "Stop": (0x46, "<I", "token"),
    "SyncRequest": (0x47, "<H", "id"),
}
TYPE = {name: row[0] for name, row in MESSAGES.items()}
NAME = {row[0]: name for name, row in MESSAGES.items()}
LAYOUT = {name: (struct.Struct(row[1]), row[2].split()) for name, row in MESSAGES.items()}
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
    layout, names = LAYOUT[name]
    return frame(TYPE[name], layout.pack(*(fields[key] for key in names)))


def unpack(coded):
    """(name, fields) of a frame without its delimiter, or None if it is damaged, unknown or of a wrong size."""
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
