#include "sim/lab/effective_motion.h"

#include <Eigen/Core>
#include <Eigen/LU>
#include <cmath>
#include <limits>

#include "model/track_model.h"
#include "sim/sensors/mpu6050.h"
#include "wire/messages.h"

namespace tp100::sim {
namespace {

// Long against the time between two encoder edges, short against a turn.
constexpr double kIntervalS = 0.2;
// Difference of the tracks' speeds relative to their mean, up to which driving counts as straight.
constexpr double kStraightTurn = 0.05;
// Yaw rate at which the slip angle is the one of turns.
constexpr double kTurningRadps = 0.05;
// Of all driving's weight: less of it is a few passing moments, and their value is noise.
constexpr double kLeastShare = 0.003;

/// What one sample adds.
struct Step {
  double dt_s;
  double ahead_m, left_m, turned_rad;  // of the body, along and across the heading of the moment
  double left_track_m, right_track_m;
};

using Steps = std::vector<Step>;

Steps steps_of(const CalibrationDrive& drive, double counts_per_metre) {
  Steps steps;
  const std::vector<Pose>& truth = drive.truth;
  const std::vector<identify::DriveSample>& samples = drive.drive.samples;
  for (std::size_t i = 1; i < truth.size(); ++i) {
    const Pose& a = truth[i - 1];
    const Pose& b = truth[i];
    const double heading = (a.yaw_rad + b.yaw_rad) / 2.0;
    const double c = std::cos(heading), s = std::sin(heading);
    const double dx = b.x_m - a.x_m, dy = b.y_m - a.y_m;
    const auto metres = [&](std::int64_t identify::DriveSample::*counts) {
      return static_cast<double>(samples[i].*counts - samples[i - 1].*counts) / counts_per_metre;
    };
    steps.push_back({samples[i].t_s - samples[i - 1].t_s, c * dx + s * dy, -s * dx + c * dy,
                     b.yaw_rad - a.yaw_rad, metres(&identify::DriveSample::left_counts),
                     metres(&identify::DriveSample::right_counts)});
  }
  return steps;
}

/// Calls `end` with the number of the step at which each interval ends.
template <class End>
void for_intervals(const Steps& steps, End end) {
  double t_s = 0.0;
  for (std::size_t i = 0; i < steps.size(); ++i) {
    t_s += steps[i].dt_s;
    if (t_s < kIntervalS && i + 1 < steps.size()) continue;
    end(i);
    t_s = 0.0;
  }
}

struct Ratio {
  double above = 0.0, below = 0.0;
  double value() const { return above / below; }
};

/// Slip ratios and slip angle of straight pieces.
struct Straight {
  Ratio left{}, right{}, angle{};

  void add(const Steps& steps, double gauge_m) {
    Step sum{};
    for_intervals(steps, [&, from = std::size_t{0}](std::size_t to) mutable {
      sum = {};
      for (; from <= to; ++from) {
        sum.ahead_m += steps[from].ahead_m;
        sum.left_m += steps[from].left_m;
        sum.turned_rad += steps[from].turned_rad;
        sum.left_track_m += steps[from].left_track_m;
        sum.right_track_m += steps[from].right_track_m;
      }
      if (std::abs(sum.turned_rad) * gauge_m >= kStraightTurn * sum.ahead_m) return;
      const double half_m = sum.turned_rad * gauge_m / 2.0;
      left.above += sum.ahead_m - half_m;
      left.below += sum.left_track_m;
      right.above += sum.ahead_m + half_m;
      right.below += sum.right_track_m;
      angle.above += sum.left_m;
      angle.below += sum.ahead_m;
    });
  }
};

/// Least squares of a quantity that is linear in some parameters.
template <int kParameters>
class Regression {
 public:
  using Vector = Eigen::Matrix<double, kParameters, 1>;

  /// `most`: of `by`, if the interval showed only that parameter.
  void add(const Vector& by, const Vector& most, double value) {
    information_.noalias() += by * by.transpose();
    score_ += value * by;
    most_ += most.cwiseAbs2();
  }
  Vector solution() const {
    Matrix information = information_;
    // So that a parameter that never appears leaves the others determined.
    information.diagonal() += kNothing * most_;
    const Matrix covariance = information.inverse();
    Vector found = covariance * score_;
    for (Eigen::Index i = 0; i < kParameters; ++i)
      if (!(1.0 / covariance(i, i) > kLeastShare * most_[i]))
        found[i] = std::numeric_limits<double>::quiet_NaN();
    return found;
  }

 private:
  using Matrix = Eigen::Matrix<double, kParameters, kParameters>;
  static constexpr double kNothing = 1e-9;

  Matrix information_ = Matrix::Zero();
  Vector score_ = Vector::Zero(), most_ = Vector::Zero();
};

/// Wheelbases in wide turns, medium and tight arcs and on the spot, turning centres in arcs and on
/// the spot, loss of distance.
struct Turns {
  Regression<4> wheelbase{};
  Regression<3> centre{};  // the last one is the slip angle's tangent
  Regression<2> lost{};

  void add(const Steps& steps, double slip_left, double slip_right) {
    model::TurnShapeFilter filter;
    for_intervals(steps, [&, from = std::size_t{0}](std::size_t to) mutable {
      double difference_m = 0.0, lost_m = 0.0, left_m = 0.0, ahead_m = 0.0;
      double turned_rad = 0.0, took_s = 0.0, travel_m = 0.0;
      Eigen::Vector4d by_turn = Eigen::Vector4d::Zero();
      Eigen::Vector2d by_travel = Eigen::Vector2d::Zero();
      for (; from <= to; ++from) {
        const Step& step = steps[from];
        const double left = step.left_track_m * (1.0 - slip_left);
        const double right = step.right_track_m * (1.0 - slip_right);
        const model::TurnShape shape =
            filter.update(left / step.dt_s, right / step.dt_s, step.dt_s);
        const double mean = (left + right) / 2.0;
        travel_m += (std::abs(left) + std::abs(right)) / 2.0;
        difference_m += right - left;
        lost_m += mean - step.ahead_m;
        left_m += step.left_m;
        ahead_m += step.ahead_m;
        turned_rad += step.turned_rad;
        took_s += step.dt_s;
        by_turn += step.turned_rad * Eigen::Vector4d(1.0 - shape.medium, shape.medium - shape.arc,
                                                     shape.arc - shape.spin, shape.spin);
        by_travel += mean * Eigen::Vector2d(shape.wide, shape.curved);
      }
      wheelbase.add(by_turn, Eigen::Vector4d::Constant(turned_rad), difference_m);
      lost.add(by_travel, Eigen::Vector2d::Constant(travel_m), lost_m);
      if (std::abs(turned_rad) > kTurningRadps * took_s)
        centre.add({-turned_rad + by_turn[3], -by_turn[3], ahead_m},
                   {turned_rad, turned_rad, ahead_m}, left_m);
    });
  }
};

}  // namespace

model::TrackParameters effective_motion(const std::vector<CalibrationDrive>& drives,
                                        const course::Emulated& robot) {
  std::vector<Steps> all;
  Straight straight;
  for (const CalibrationDrive& drive : drives) {
    all.push_back(steps_of(drive, robot.encoder.counts_per_metre));
    straight.add(all.back(), robot.body.gauge_m);
  }
  model::TrackParameters motion;
  motion.slip_left = 1.0 - straight.left.value();
  motion.slip_right = 1.0 - straight.right.value();
  motion.slip_angle_straight_rad = std::atan(straight.angle.value());

  Turns turns;
  for (const Steps& steps : all) turns.add(steps, motion.slip_left, motion.slip_right);
  const Eigen::Vector4d wheelbase = turns.wheelbase.solution();
  motion.wheelbase_m = wheelbase[0];
  motion.wheelbase_medium_m = wheelbase[1];
  motion.wheelbase_tight_m = wheelbase[2];
  motion.wheelbase_spin_m = wheelbase[3];
  const Eigen::Vector3d centre = turns.centre.solution();
  motion.x_icr_m = centre[0];
  motion.x_icr_spin_shift_m = centre[1] - centre[0];
  motion.slip_angle_turning_rad = std::atan(centre[2]);
  const Eigen::Vector2d lost = turns.lost.solution();
  motion.turn_slip = lost[0];
  motion.turn_loss = lost[1];
  motion.gyro_scale = static_cast<double>(wire::kGyroLsbPerDegps) / Mpu6050::kGyroLsbPerDegps /
                      (1.0 + robot.imu.gyro_scale_error);
  return motion;
}

}  // namespace tp100::sim
