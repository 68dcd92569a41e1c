#pragma once
// Encoder failures while the robot drives: how far the robot deviates until its motors are off,
// over kinds of failure, speeds, positions and robots.

#include <array>
#include <cstdint>
#include <map>
#include <span>
#include <string>
#include <string_view>
#include <tuple>
#include <vector>

#include "core/pose.h"
#include "sim/robot/emulated_robot.h"

namespace tp100::sim {

/// One kind of failure.
struct EncoderFailure {
  std::string_view fault;  ///< as for --fault, without its time
  double again_s = 0.0;    ///< repeats at this interval; 0: the failure lasts
  bool on_page = false;    ///< a row of sim/faults/FAULTS.md, driven by the tests
};

/// The robot's motion when the failure begins.
enum class Onset : std::uint8_t { kStraight, kArc, kStandstill, kSpin };

/// Names as in results.
inline constexpr std::array<EnumName<Onset>, 4> kOnsetNames = {{
    {Onset::kStraight, "straight"},
    {Onset::kArc, "arc"},
    {Onset::kStandstill, "standstill"},
    {Onset::kSpin, "spin"},
}};
constexpr const char* to_string(Onset onset) { return name_in(kOnsetNames, onset); }

std::span<const EncoderFailure> encoder_failures();
std::span<const double> encoder_speeds();  ///< of the course [m/s]
std::span<const std::string_view> encoder_robots();

struct EncoderTrial {
  EncoderFailure failure{};
  double speed_mps = 0.1;
  Onset onset = Onset::kStraight;
  std::string_view robot;
  BoardKind board = BoardKind::kNative;
};

/// Outcome of a trial until the motors were off for good.
struct EncoderOutcome {
  std::string end;           ///< "completed" or the fault that ended the run
  double off_after_s = 0.0;  ///< from the fault's beginning
  /// Greatest true deviation in position and yaw from the poses of the same robot without the fault
  /// up to that time. A mere delay is not a deviation.
  double beyond_m = 0.0;
  double beyond_rad = 0.0;

  static constexpr double kMaxM = 0.15;
  static constexpr double kMaxRad = 20.0 * kRadPerDeg;
  bool good() const { return end != "completed" && beyond_m < kMaxM && beyond_rad < kMaxRad; }
  /// Keeps the worst of each figure; `end` becomes "completed" if one outcome was.
  void merge(const EncoderOutcome& other);
};

/// Drives a line, an arc, a line, a turn on the spot and a line; caches the drives of healthy
/// robots. Deterministic.
class EncoderStudy {
 public:
  /// `host_checks` false: the daemon's own checks are off, and only the firmware's remain.
  explicit EncoderStudy(bool host_checks = true) : host_checks_(host_checks) {}
  /// Throws UserError.
  EncoderOutcome drive(const EncoderTrial& trial);

 private:
  struct Healthy {
    std::vector<Pose> truth;          ///< one per physics step, from the opening of the port
    std::map<Onset, double> onset_s;  ///< since the opening of the port
  };
  const Healthy& healthy(const EncoderTrial& trial);

  bool host_checks_;
  std::map<std::tuple<std::string_view, double, BoardKind>, Healthy> healthy_;
};

/// The trials of one cell of the table (failure and speed): every onset with every robot, or every
/// onset with one robot that changes from cell to cell.
std::vector<EncoderTrial> encoder_trials(const EncoderFailure& failure, double speed_mps,
                                         BoardKind board, bool every_robot);

/// A row of a Markdown table: the worst of the trials of one failure at each speed.
std::string encoder_row(const EncoderFailure& failure, std::span<const EncoderOutcome> by_speed);

std::string encoder_table_head();

}  // namespace tp100::sim
