#include "sim/study/effective_motion.h"

#include <array>
#include <cmath>

#include "model/track_model.h"
#include "wire/messages.h"

namespace tp100::sim {
namespace {

/// Sums of one drive.
struct Travel {
  double ahead_m = 0.0, left_m = 0.0;  // along and across the heading of the moment
  double turned_rad = 0.0;
  double sideways_by_turn = 0.0, turn_by_turn = 0.0;  // for the turning centre
  double left_track_m = 0.0, right_track_m = 0.0;
};

Travel travel_of(const CalibrationDrive& drive, double counts_per_metre) {
  Travel travel;
  const std::vector<Pose>& truth = drive.truth;
  const std::vector<identify::DriveSample>& samples = drive.drive.samples;
  for (std::size_t i = 1; i < truth.size(); ++i) {
    const Pose& a = truth[i - 1];
    const Pose& b = truth[i];
    const double heading = (a.yaw_rad + b.yaw_rad) / 2.0;
    const double c = std::cos(heading), s = std::sin(heading);
    const double dx = b.x_m - a.x_m, dy = b.y_m - a.y_m, turn = b.yaw_rad - a.yaw_rad;
    const double left = -s * dx + c * dy;
    const double dt_s = samples[i].t_s - samples[i - 1].t_s;
    travel.ahead_m += c * dx + s * dy;
    travel.left_m += left;
    travel.turned_rad += turn;
    travel.sideways_by_turn += left * turn / dt_s;
    travel.turn_by_turn += turn * turn / dt_s;
  }
  const auto metres = [counts_per_metre](std::int64_t counts) {
    return static_cast<double>(counts) / counts_per_metre;
  };
  travel.left_track_m = metres(samples.back().left_counts - samples.front().left_counts);
  travel.right_track_m = metres(samples.back().right_counts - samples.front().right_counts);
  return travel;
}

struct Ratio {
  double above = 0.0, below = 0.0;
  double value() const { return above / below; }
};

/// All drives of one kind of turn.
struct Turns {
  Ratio wheelbase{}, centre{}, lost{};
  model::TurnShape shape{};

  void add(const Travel& travel, double left_m, double right_m) {
    const double side = travel.turned_rad > 0.0 ? 1.0 : -1.0;
    wheelbase.above += side * (right_m - left_m);
    wheelbase.below += std::abs(travel.turned_rad);
    centre.above -= travel.sideways_by_turn;
    centre.below += travel.turn_by_turn;
    lost.above += side * ((left_m + right_m) / 2.0 - travel.ahead_m);
    lost.below += (left_m + right_m) / 2.0;
    shape = model::turn_shape(left_m, right_m);
  }
  /// Loss and gain of arcs to both sides; the parameter is that of the widest turn at which `wide`
  /// is 1.
  double lost_of_full_turn() const { return lost.value() / std::abs(shape.wide); }
};

/// A value in wide turns, tight arcs and on the spot, from what drives of these shapes had of it.
std::array<double, 3> apart(const std::array<double, 3>& measured, const model::TurnShape& wide,
                            const model::TurnShape& tight) {
  // Wide drives: (1 - a) w + a t; tight ones: (1 - b) (1 - c) w + b (1 - c) t + c s.
  const double a = wide.arc, b = tight.arc, c = tight.spin;
  const double of_arcs = (measured[1] - c * measured[2]) / (1.0 - c);
  const double per_arc = (of_arcs - measured[0]) / (b - a);
  const double value = measured[0] - a * per_arc;
  return {value, value + per_arc, measured[2]};
}

}  // namespace

model::TrackParameters effective_motion(const std::vector<CalibrationDrive>& drives,
                                        const course::Emulated& robot) {
  model::TrackParameters motion;
  Ratio left, right, straight_angle, turning_angle;
  for (const CalibrationDrive& drive : drives) {
    if (drive.kind == DriveKind::kTight || drive.kind == DriveKind::kSpin) continue;
    const Travel travel = travel_of(drive, robot.encoder.counts_per_metre);
    Ratio& angle = drive.kind == DriveKind::kStraight ? straight_angle : turning_angle;
    angle.above += travel.left_m;
    angle.below += travel.ahead_m;
    if (drive.kind != DriveKind::kStraight) continue;
    const double half = travel.turned_rad * robot.body.gauge_m / 2.0;
    left.above += travel.ahead_m - half;
    left.below += travel.left_track_m;
    right.above += travel.ahead_m + half;
    right.below += travel.right_track_m;
  }
  motion.slip_left = 1.0 - left.value();
  motion.slip_right = 1.0 - right.value();
  motion.slip_angle_straight_rad = std::atan(straight_angle.value());
  motion.slip_angle_turning_rad = std::atan(turning_angle.value());

  Turns wide, tight, spin;
  for (const CalibrationDrive& drive : drives) {
    if (drive.kind == DriveKind::kStraight) continue;
    const Travel travel = travel_of(drive, robot.encoder.counts_per_metre);
    const double left_m = travel.left_track_m * (1.0 - motion.slip_left);
    const double right_m = travel.right_track_m * (1.0 - motion.slip_right);
    (drive.kind == DriveKind::kWide    ? wide
     : drive.kind == DriveKind::kTight ? tight
                                       : spin)
        .add(travel, left_m, right_m);
  }
  const auto [wheelbase, wheelbase_tight, wheelbase_spin] =
      apart({wide.wheelbase.value(), tight.wheelbase.value(), spin.wheelbase.value()}, wide.shape,
            tight.shape);
  motion.wheelbase_m = wheelbase;
  motion.wheelbase_tight_m = wheelbase_tight;
  motion.wheelbase_spin_m = wheelbase_spin;
  const auto [centre, centre_tight, centre_spin] = apart(
      {wide.centre.value(), tight.centre.value(), spin.centre.value()}, wide.shape, tight.shape);
  motion.x_icr_m = centre;
  motion.x_icr_tight_shift_m = centre_tight - centre;
  motion.x_icr_spin_shift_m = centre_spin - centre;
  motion.turn_slip = wide.lost_of_full_turn();
  const double share = tight.shape.tight;
  motion.turn_slip_tight = (tight.lost_of_full_turn() - (1.0 - share) * motion.turn_slip) / share;
  // The sensor's own counts per deg/s at this range are 2^15 / 1000.
  constexpr double kSensorLsbPerDegps = 32.768;
  motion.gyro_scale = static_cast<double>(wire::kGyroLsbPerDegps) / kSensorLsbPerDegps /
                      (1.0 + robot.imu.gyro_scale_error);
  return motion;
}

}  // namespace tp100::sim
