#pragma once
// The whole emulated TP100 in virtual time: body, motors, encoders, IMU, battery and board.

#include <array>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/enum_names.h"
#include "core/time.h"
#include "course/course.h"
#include "course/robot_file.h"
#include "course/terrain.h"
#include "sim/board/board.h"
#include "sim/body/body.h"
#include "sim/faults/fault_injector.h"
#include "sim/sensors/drive_train.h"
#include "sim/sensors/mpu6050.h"
#include "sim/sensors/quadrature_encoder.h"

namespace tp100::sim {

/// One direction of a serial cable: bytes are sent one after the other, each in a byte time (ten
/// bit times at 8N1).
class UartLine {
 public:
  explicit UartLine(std::uint32_t baud) : byte_ns_(10'000'000'000LL / baud) {}

  /// `bytes` are handed to the sending UART at `now_ns`.
  void send(std::span<const std::uint8_t> bytes, HostNs now_ns);
  /// The bytes whose stop bits end at or before `until_ns`, in order.
  const std::vector<TimedByte>& take(HostNs until_ns);
  /// Number of bytes in transmission.
  std::size_t pending() const { return bytes_.size(); }
  /// The cable is cut: bytes in transmission are lost.
  void clear() { bytes_.clear(); }

 private:
  HostNs byte_ns_;
  HostNs free_ns_ = 0;
  std::deque<TimedByte> bytes_;
  std::vector<TimedByte> taken_;
};

/// Where the firmware runs.
enum class BoardKind { kNative, kAvr };

/// Names on the command line and in results.
inline constexpr std::array<EnumName<BoardKind>, 2> kBoardKindNames = {{
    {BoardKind::kNative, "native"},
    {BoardKind::kAvr, "avr"},
}};
constexpr const char* to_string(BoardKind board) { return name_in(kBoardKindNames, board); }

/// Settings of one emulated robot. The seed determines the noise of this robot; another robot has
/// other `values`.
struct EmulatedRobotSettings {
  course::Emulated values{};
  Pose start{};
  bool on_stand = false;      ///< tracks spin free
  course::Terrain terrain{};  ///< obstacles and surfaces that are real on its floor
  std::uint64_t seed = 1;
  BoardKind board = BoardKind::kNative;
  bool bootloader = false;  ///< the avr board starts with its bootloader, silent for a second
  bool blank = false;       ///< the avr board waits for its first firmware
  std::uint32_t baud = 500000;
  std::uint32_t start_us = 0;          ///< device clock at each boot, in steps of 1024
  std::vector<PlannedFault> faults{};  ///< of the list in sim/faults/fault.h
};

/// Real time spent in parts of the emulation.
struct SpentTime {
  std::chrono::nanoseconds physics{0};  ///< motors and body
  std::chrono::nanoseconds board{0};    ///< firmware, or the chip that runs it
};

/// The same settings and the same bytes at the same times give the same bytes back.
class EmulatedRobot {
 public:
  explicit EmulatedRobot(const EmulatedRobotSettings& settings);
  ~EmulatedRobot();

  /// Restarts the board now.
  void reset(PowerUp cause);
  /// The host opens the port for the first time: times of faults count from here.
  void opened() { faults_.begin(now_ns_); }
  /// Faults that the holder of the cable must apply: the number of a fault of this kind that occurs
  /// now; once per occurrence.
  std::optional<double> take_fault(FaultKind kind) { return faults_.take(kind, now_ns_); }
  /// Bytes that the host's UART takes at `now_ns`; they arrive at byte times.
  void receive(std::span<const std::uint8_t> bytes, HostNs now_ns);
  /// Advances one physics step and returns the bytes that the robot sent in it.
  std::vector<TimedByte> advance();
  /// Pushes the robot.
  void disturbance(double sideways_m, double yaw_rad, double duration_s);
  bool disturbed() const { return body_->disturbed(); }

  HostNs now_ns() const { return now_ns_; }
  const BodyState& truth() const { return body_->state(); }
  MotorDuty motor_duty() const { return board_->motor_duty(); }
  double battery_v() const { return battery_.volts(); }
  const SpentTime& spent() const { return spent_; }

 private:
  /// `values`: those of this run, sampled from its seed.
  EmulatedRobot(const EmulatedRobotSettings& settings, const course::Emulated& values);
  /// Applies the faults of sensors and board that are due now.
  void inject();

  std::unique_ptr<Body> body_;
  Motor left_motor_, right_motor_;
  QuadratureEncoder left_encoder_, right_encoder_;
  Mpu6050 imu_;
  Battery battery_;
  FaultInjector faults_;
  ImuFaults bus_;
  std::unique_ptr<Board> board_;
  UartLine to_board_;
  std::vector<EncoderEdge> edges_;
  HostNs now_ns_ = 0;
  SpentTime spent_;
};

/// Applies a course's disturbances: measures the distance really driven and pushes the robot at
/// their positions along the path.
class DisturbanceInjector {
 public:
  explicit DisturbanceInjector(std::vector<course::Disturbance> disturbances)
      : disturbances_(std::move(disturbances)) {}

  /// Call after each physics step. Returns the disturbance that begins now, or null.
  const course::Disturbance* update(EmulatedRobot& robot);

 private:
  std::vector<course::Disturbance> disturbances_;
  std::size_t next_ = 0;
  bool started_ = false;
  double x_m_ = 0.0, y_m_ = 0.0;
  double driven_m_ = 0.0;
};

}  // namespace tp100::sim
