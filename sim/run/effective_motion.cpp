#include "sim/run/effective_motion.h"

#include <cmath>

#include "model/turn.h"
#include "wire/messages.h"

namespace tp100::sim {
namespace {

/// Sums of one drive.
struct Way {
  double ahead_m = 0.0, left_m = 0.0;  // along and across the heading of the moment
  double turned_rad = 0.0;
  double sideways_by_turn = 0.0, turn_by_turn = 0.0;  // for the turning centre
  double left_belt_m = 0.0, right_belt_m = 0.0;
};

Way way_of(const CalibrationDrive& drive, double counts_per_metre) {
  Way way;
  const std::vector<Pose>& truth = drive.truth;
  const std::vector<analysis::DriveSample>& samples = drive.drive.samples;
  for (std::size_t i = 1; i < truth.size(); ++i) {
    const Pose& a = truth[i - 1];
    const Pose& b = truth[i];
    const double heading = (a.yaw_rad + b.yaw_rad) / 2.0;
    const double c = std::cos(heading), s = std::sin(heading);
    const double dx = b.x_m - a.x_m, dy = b.y_m - a.y_m, turn = b.yaw_rad - a.yaw_rad;
    const double left = -s * dx + c * dy;
    const double dt_s = samples[i].t_s - samples[i - 1].t_s;
    way.ahead_m += c * dx + s * dy;
    way.left_m += left;
    way.turned_rad += turn;
    way.sideways_by_turn += left * turn / dt_s;
    way.turn_by_turn += turn * turn / dt_s;
  }
  const auto metres = [counts_per_metre](std::int64_t counts) {
    return static_cast<double>(counts) / counts_per_metre;
  };
  way.left_belt_m = metres(samples.back().left_counts - samples.front().left_counts);
  way.right_belt_m = metres(samples.back().right_counts - samples.front().right_counts);
  return way;
}

struct Ratio {
  double above = 0.0, below = 0.0;
  double value() const { return above / below; }
};

/// What arcs to both sides lose and gain; the parameter is that of the widest turn that is full.
struct TurnSlip {
  Ratio lost{};
  model::TurnShape shape{};
  double of_full_turn() const { return lost.value() / std::abs(shape.wide); }
};

}  // namespace

EffectiveMotion effective_motion(const std::vector<CalibrationDrive>& drives,
                                 const course::Emulated& robot) {
  Ratio left, right, straight_angle, turning_angle, centre, spin_centre;
  for (const CalibrationDrive& drive : drives) {
    const Way way = way_of(drive, robot.encoder.counts_per_metre);
    if (drive.kind == DriveKind::kStraight) {
      const double half = way.turned_rad * robot.body.gauge_m / 2.0;
      left.above += way.ahead_m - half;
      left.below += way.left_belt_m;
      right.above += way.ahead_m + half;
      right.below += way.right_belt_m;
      straight_angle.above += way.left_m;
      straight_angle.below += way.ahead_m;
      continue;
    }
    if (drive.kind == DriveKind::kTight) continue;
    Ratio& of_kind = drive.kind == DriveKind::kWide ? centre : spin_centre;
    of_kind.above -= way.sideways_by_turn;
    of_kind.below += way.turn_by_turn;
    if (drive.kind == DriveKind::kSpin) continue;
    turning_angle.above += way.left_m;
    turning_angle.below += way.ahead_m;
  }
  EffectiveMotion motion;
  motion.slip_left = 1.0 - left.value();
  motion.slip_right = 1.0 - right.value();
  motion.slip_angle_straight_rad = std::atan(straight_angle.value());
  motion.slip_angle_turning_rad = std::atan(turning_angle.value());
  motion.x_icr_m = centre.value();
  motion.x_icr_spin_m = spin_centre.value();

  Ratio arc, spin;
  TurnSlip wide_slip, tight_slip;
  for (const CalibrationDrive& drive : drives) {
    if (drive.kind == DriveKind::kStraight) continue;
    const Way way = way_of(drive, robot.encoder.counts_per_metre);
    const double left_m = way.left_belt_m * (1.0 - motion.slip_left);
    const double right_m = way.right_belt_m * (1.0 - motion.slip_right);
    const double difference = right_m - left_m;
    if (drive.kind != DriveKind::kSpin) {
      TurnSlip& slip = drive.kind == DriveKind::kWide ? wide_slip : tight_slip;
      slip.lost.above += way.turned_rad > 0.0 ? (left_m + right_m) / 2.0 - way.ahead_m
                                              : way.ahead_m - (left_m + right_m) / 2.0;
      slip.lost.below += (left_m + right_m) / 2.0;
      slip.shape = model::turn_shape(left_m, right_m);
    }
    if (drive.kind == DriveKind::kTight) continue;
    Ratio& ratio = drive.kind == DriveKind::kWide ? arc : spin;
    ratio.above += way.turned_rad > 0.0 ? difference : -difference;
    ratio.below += std::abs(way.turned_rad);
  }
  motion.wheelbase_m = arc.value();
  motion.wheelbase_spin_m = spin.value();
  motion.turn_slip = wide_slip.of_full_turn();
  const double tight = tight_slip.shape.tight;
  motion.turn_slip_tight = (tight_slip.of_full_turn() - (1.0 - tight) * motion.turn_slip) / tight;
  // The sensor's own counts per deg/s at this range are 2^15 / 1000.
  constexpr double kSensorLsbPerDegps = 32.768;
  motion.gyro_scale = static_cast<double>(wire::kGyroLsbPerDegps) / kSensorLsbPerDegps /
                      (1.0 + robot.imu.gyro_scale_error);
  return motion;
}

}  // namespace tp100::sim
