// Every message of the wire, defined once for firmware, daemon and emulator. Byte tables, state
// diagram and timings in prose: firmware/PROTOCOL.md. C++11 without libstdc++.
//
// Frames and signs: x forward, y left, z up, yaw counter-clockwise positive (REP-103); left and
// right as seen from the driver's seat; a positive count, speed or duty moves that track forward.
#ifndef TP100_WIRE_MESSAGES_H
#define TP100_WIRE_MESSAGES_H

#include "fields.h"

namespace tp100 {
namespace wire {

/// Raised when a robot or client of the old version could misread the new one.
const uint16_t kProtocolVersion = 1;
/// FNV-1a of every message's type, field names and field types; a test recomputes it.
const uint32_t kSchemaHash = 0xD27DA467;
const uint32_t kBaud = 500000;

/// Longest time for which a robot may drive on one command, whatever the command's expiry is. [ms]
const uint16_t kMaxCommandLifeMs = 200;
/// Sample and IMU period. [us]
const uint16_t kSamplePeriodUs = 5000;
/// Hello period in State::kHello. [ms]
const uint16_t kHelloPeriodMs = 200;
/// A robot without a valid host frame for this long sends hello again. [ms]
const uint16_t kHostSilenceMs = 1000;

/// Gyro full scale +-1000 deg/s, accelerometer +-4 g (MPU-6000/6050 register map rev 4.2, 4.4
/// and 4.5).
const float kGyroLsbPerDegps = 32.8f;
constexpr float kAccelLsbPerG = 8192.0f;
/// Temperature [deg C] = raw / 340 + 36.53 (register map rev 4.2, 4.18).
const float kTemperatureLsbPerDegc = 340.0f;
const float kTemperatureOffsetDegc = 36.53f;
/// Duties are sent as thousandths, -1000..1000.
const int16_t kFullDuty = 1000;

enum class Type : uint8_t {
  // robot -> host
  kHello = 0x01,
  kSample = 0x02,
  kAcknowledge = 0x03,
  kSyncReply = 0x04,
  kFaultReport = 0x05,
  kLog = 0x06,
  // host -> robot
  kHelloRequest = 0x41,
  kParameters = 0x42,
  kCommand = 0x43,
  kArm = 0x44,
  kDisarm = 0x45,
  kStop = 0x46,
  kSyncRequest = 0x47,
};

enum class BoardType : uint8_t {
  kUnknown = 0,
  kMega2560 = 1,
  kNative = 2,     ///< the firmware in a program of the host
  kFakeRobot = 3,  ///< a Mega that simulates its robot (FAKE_ROBOT): nothing outside it moves
};

/// Robot states, in the order in which a session passes them.
enum class State : uint8_t {
  kHello = 0,       ///< no host yet: hello frames, outputs forced off
  kParameters = 1,  ///< host connected, parameters awaited, outputs forced off
  kDisarmed = 2,    ///< samples flow, commands are checked but move nothing
  kArmed = 3,       ///< armed, no motion commanded yet
  kRunning = 4,     ///< following fresh commands
  kFaulted = 5,     ///< a fault is latched, outputs off until a fresh arm
};

enum class ResetCause : uint8_t {
  kUnknown = 0,
  kPowerOn = 1,
  kExternal = 2,
  kBrownOut = 3,
  kWatchdog = 4
};

enum class Result : uint8_t {
  kAccepted = 0,
  kWrongBoot = 1,      ///< nonce of another boot
  kStaleToken = 2,     ///< token not above the last one
  kFaultPersists = 3,  ///< detail: mask of faults whose cause persists
  kOutOfRange = 4,     ///< detail: index of the field
  kWrongState = 5,     ///< detail: state
};

/// robot -> host: identification. At boot, every kHelloPeriodMs in kHello, and in answer to a hello
/// request.
struct Hello {
  static constexpr Type kType = Type::kHello;
  static constexpr size_t kSize = 18;
  uint16_t protocol;    ///< kProtocolVersion of the firmware
  uint8_t firmware[3];  ///< major, minor, patch
  uint32_t schema;      ///< kSchemaHash of the firmware
  uint8_t board;        ///< BoardType
  uint32_t boot_nonce;  ///< differs at every boot; never 0
  uint8_t reset_cause;  ///< ResetCause
  uint8_t state;        ///< State
  uint16_t faults;      ///< latched robot faults
  TP100_WIRE_FIELDS(protocol, firmware, schema, board, boot_nonce, reset_cause, state, faults)
};

/// robot -> host, every kSamplePeriodUs once parameters are accepted.
struct Sample {
  static constexpr Type kType = Type::kSample;
  static constexpr size_t kSize = 40;
  uint16_t sequence;    ///< +1 per sample, wraps
  uint32_t device_us;   ///< when counts and IMU were read; wraps after 71.6 min [us]
  int32_t left_counts;  ///< quadrature edges since boot, wraps
  int32_t right_counts;
  int16_t gyro[3];      ///< x, y, z; kGyroLsbPerDegps
  int16_t accel[3];     ///< x, y, z; kAccelLsbPerG
  int16_t temperature;  ///< kTemperatureLsbPerDegc
  uint16_t battery_mv;  ///< the whole battery [mV]
  int16_t left_duty;    ///< -kFullDuty..kFullDuty, as applied
  int16_t right_duty;
  uint8_t state;          ///< State
  uint16_t faults;        ///< latched robot faults
  uint16_t last_command;  ///< sequence of the last accepted command of this session; 0 none
  uint8_t imu_age;        ///< samples since the last new IMU values; 0 fresh, 255 never
  TP100_WIRE_FIELDS(sequence, device_us, left_counts, right_counts, gyro, accel, temperature,
                    battery_mv, left_duty, right_duty, state, faults, last_command, imu_age)
};

/// robot -> host: answer to parameters, arm, disarm and stop.
struct Acknowledge {
  static constexpr Type kType = Type::kAcknowledge;
  static constexpr size_t kSize = 8;
  uint8_t request;  ///< Type of the message that is answered
  uint32_t token;   ///< its token
  uint8_t result;   ///< Result
  uint16_t detail;  ///< see Result
  TP100_WIRE_FIELDS(request, token, result, detail)
};

/// robot -> host: the two device times of a clock-sync exchange.
struct SyncReply {
  static constexpr Type kType = Type::kSyncReply;
  static constexpr size_t kSize = 14;
  uint16_t id;            ///< of the request
  uint32_t received_us;   ///< device time at which the request's last byte was taken [us]
  uint32_t sent_us;       ///< device time at which this reply was handed to the UART [us]
  uint16_t corrupted;     ///< corrupted frames received since the board's start, modulo 65536
  uint16_t missed_edges;  ///< of both encoders since the board's start, modulo 65536
  TP100_WIRE_FIELDS(id, received_us, sent_us, corrupted, missed_edges)
};

/// robot -> host, once when a fault latches.
struct FaultReport {
  static constexpr Type kType = Type::kFaultReport;
  static constexpr size_t kSize = 11;
  uint32_t device_us;  ///< when it latched [us]
  uint8_t fault;       ///< Fault
  uint16_t faults;     ///< all latched robot faults
  int32_t detail;      ///< fault-specific number, see PROTOCOL.md
  TP100_WIRE_FIELDS(device_us, fault, faults, detail)
};

/// robot -> host: a short ASCII text, zero-padded.
struct Log {
  static constexpr Type kType = Type::kLog;
  static constexpr size_t kTextSize = 40;
  static constexpr size_t kSize = 5 + kTextSize;
  uint32_t device_us;  ///< [us]
  uint8_t level;       ///< 0 information, 1 warning, 2 error
  uint8_t text[kTextSize];
  TP100_WIRE_FIELDS(device_us, level, text)
};

/// host -> robot: asks for identification. Disarms and starts a new session.
struct HelloRequest {
  static constexpr Type kType = Type::kHelloRequest;
  static constexpr size_t kSize = 6;
  uint16_t protocol;  ///< kProtocolVersion of the host
  uint32_t schema;    ///< kSchemaHash of the host
  TP100_WIRE_FIELDS(protocol, schema)
};

/// Bits of Parameters::flags.
enum ParameterFlag {
  kUseGyro = 1 << 0,  ///< propagate the answered sample's yaw with the gyro (not on a stand)
  kInvertLeftEncoder = 1 << 1,
  kInvertRightEncoder = 1 << 2,
  kInvertLeftMotor = 1 << 3,
  kInvertRightMotor = 1 << 4,
  kSwapTracks = 1 << 5,
};

/// host -> robot at connect; acknowledged. Refused while armed or running, and if any value is out
/// of range.
struct Parameters {
  static constexpr Type kType = Type::kParameters;
  static constexpr size_t kSize = 83;
  uint32_t boot_nonce;      ///< of this boot
  uint32_t token;           ///< comes back in the acknowledgement
  float counts_per_metre;   ///< edges per metre of track, 100..1e6
  float wheelbase_m;        ///< equivalent wheelbase L of eq 5 in wide turns, 0.05..2
  float wheelbase_tight_m;  ///< the same in tight arcs, 0.05..2
  float wheelbase_spin_m;   ///< the same on the spot, 0.05..2
  float turn_slip_share;    ///< part of a turn by which gyro and tracks may differ for long, 0..1;
                            ///< 1: it is not known how the robot turns
  float slip_left;          ///< slip ratio used to invert eqs 1 and 5, -0.5..0.9
  float slip_right;
  float max_track_mps;         ///< track speed limit, 0.01..2
  float max_track_mps2;        ///< track acceleration limit, 0.05..20
  float feed_forward;          ///< duty per (m/s) above the dead band, 0..100
  float dead_band;             ///< duty at which a track just moves, 0..0.9
  float speed_kp;              ///< duty per (m/s) of error, 0..100
  float speed_ki;              ///< duty per m of track lag, 0..1000
  float yaw_kp;                ///< (rad/s) per rad, 0..50
  float max_yaw_radps;         ///< 0.05..10
  float gyro_z_radps_per_lsb;  ///< sign and calibrated scale, |value| 1e-5..1e-2
  uint16_t battery_cutoff_mv;  ///< fault below this for 1 s; 0 never [mV]
  uint16_t stall_duty;         ///< a track at standstill above this duty is stalled, thousandths, 0
                               ///< never
  uint16_t stall_ms;           ///< time until a stall is a fault, 50..10000
  uint16_t command_life_ms;    ///< 20..kMaxCommandLifeMs
  uint16_t yaw_window_ms;      ///< greatest age of an answered sample, 20..200
  uint8_t flags;               ///< ParameterFlag bits
  TP100_WIRE_FIELDS(boot_nonce, token, counts_per_metre, wheelbase_m, wheelbase_tight_m,
                    wheelbase_spin_m, turn_slip_share, slip_left, slip_right, max_track_mps,
                    max_track_mps2, feed_forward, dead_band, speed_kp, speed_ki, yaw_kp,
                    max_yaw_radps, gyro_z_radps_per_lsb, battery_cutoff_mv, stall_duty, stall_ms,
                    command_life_ms, yaw_window_ms, flags)
};

/// host -> robot, once per cycle. Streams in every state from kParameters on; moves only an armed
/// robot.
struct Command {
  static constexpr Type kType = Type::kCommand;
  static constexpr size_t kSize = 40;
  uint32_t boot_nonce;  ///< of this boot
  uint16_t sequence;    ///< +1 per command, wraps; one not newer than the last is ignored
  uint16_t answers;     ///< sequence of the sample to which the pose belongs
  float x_m;            ///< estimated pose at that sample; |value| < 1e4
  float y_m;
  float yaw_rad;          ///< unwrapped; |value| < 1e3
  float desired_yaw_rad;  ///< unwrapped; |value| < 1e3
  float yaw_rate_radps;   ///< feed-forward turn rate, |value| <= 10
  float speed_mps;        ///< ground speed of the reference point, |value| <= 2
  uint32_t expiry_us;     ///< device time after which it must not be used [us]
  float gyro_bias_radps;  ///< of the z axis, subtracted while propagating the yaw, |value| <= 1
  TP100_WIRE_FIELDS(boot_nonce, sequence, answers, x_m, y_m, yaw_rad, desired_yaw_rad,
                    yaw_rate_radps, speed_mps, expiry_us, gyro_bias_radps)
};

/// host -> robot, one shot: clears latched faults whose cause is gone and enables the motors.
struct Arm {
  static constexpr Type kType = Type::kArm;
  static constexpr size_t kSize = 12;
  uint32_t boot_nonce;  ///< of this boot
  uint32_t token;      ///< above the last token of this boot; a repeated one is answered as before,
                       ///< without effect
  uint32_t expiry_us;  ///< device time after which it must not be used [us]
  TP100_WIRE_FIELDS(boot_nonce, token, expiry_us)
};

/// host -> robot: motors off, no fault. Accepted in every state and from any boot.
struct Disarm {
  static constexpr Type kType = Type::kDisarm;
  static constexpr size_t kSize = 4;
  uint32_t token;  ///< comes back in the acknowledgement
  TP100_WIRE_FIELDS(token)
};

/// host -> robot: motors off and stop_requested latched. Accepted in every state and from any boot.
struct Stop {
  static constexpr Type kType = Type::kStop;
  static constexpr size_t kSize = 4;
  uint32_t token;  ///< comes back in the acknowledgement
  TP100_WIRE_FIELDS(token)
};

/// host -> robot: clock-sync request.
struct SyncRequest {
  static constexpr Type kType = Type::kSyncRequest;
  static constexpr size_t kSize = 2;
  uint16_t id;  ///< returned in the reply; replies to other ids are discarded
  TP100_WIRE_FIELDS(id)
};

}  // namespace wire
}  // namespace tp100

#endif
