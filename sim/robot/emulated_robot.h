#pragma once
// The whole emulated TP100 in virtual time: body, motors, encoders, IMU, battery and board.

#include <chrono>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "course/robot.h"
#include "course/terrain.h"
#include "sim/board/board.h"
#include "sim/body/body.h"
#include "sim/faults/fault_injector.h"
#include "sim/sensors/battery.h"
#include "sim/sensors/motor.h"
#include "sim/sensors/mpu6050.h"
#include "sim/sensors/quadrature_encoder.h"
#include "sim/wire/uart_line.h"

namespace tp100::sim {

/// What runs the firmware.
enum class BoardKind { kNative, kAvr };

/// As on the command line and in results.
const char* to_string(BoardKind board);

/// One emulated robot. A seed is the noise of one robot; another robot is another `values`.
struct EmulatedRobotSettings {
  course::Emulated values{};
  Pose start{};
  bool on_stand = false;      ///< belts spin free
  course::Terrain terrain{};  ///< what really stands and lies on its floor
  std::uint64_t seed = 1;
  BoardKind board = BoardKind::kNative;
  bool bootloader = false;  ///< the avr board starts as on a desk, silent for a second
  bool blank = false;       ///< the avr board waits for its first firmware
  std::uint32_t baud = 500000;
  std::uint32_t start_us = 0;          ///< device clock at each boot, in steps of 1024
  std::vector<PlannedFault> faults{};  ///< of the list in sim/faults/fault_kind.h
};

/// What the parts that somebody else wrote took of this machine's time.
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
  /// What whoever holds the cable has to do itself: the number of a fault of this kind that happens
  /// now, once for each time it happens.
  std::optional<double> take_fault(FaultKind kind) { return faults_.take(kind, now_ns_); }
  /// Bytes that the host's UART takes at `now_ns`; they arrive at byte times.
  void receive(std::span<const std::uint8_t> bytes, std::int64_t now_ns);
  /// Advances one physics step and returns the bytes that the robot sent in it.
  std::vector<TimedByte> advance();
  /// Someone pushes the robot.
  void shove(double sideways_m, double yaw_rad, double duration_s);
  bool shoving() const { return body_.shoving(); }

  std::int64_t now_ns() const { return now_ns_; }
  const BodyState& truth() const { return body_.state(); }
  Drive drive() const { return board_->drive(); }
  double battery_v() const { return battery_.volts(); }
  const SpentTime& spent() const { return spent_; }

 private:
  /// What happens to sensors and board as a whole now.
  void inject();

  Body body_;
  Motor left_motor_, right_motor_;
  QuadratureEncoder left_encoder_, right_encoder_;
  Mpu6050 imu_;
  Battery battery_;
  FaultInjector faults_;
  ImuFaults bus_;
  std::unique_ptr<Board> board_;
  UartLine to_board_;
  std::vector<Edge> edges_;
  std::int64_t now_ns_ = 0;
  SpentTime spent_;
};

}  // namespace tp100::sim
