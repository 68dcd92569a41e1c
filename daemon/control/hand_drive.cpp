#include "control/hand_drive.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

#include "core/arithmetic.h"

namespace tp100::control {
namespace {

// Delay from a sample to the tracks' reaction to the command that answers it: wire, step, motors.
constexpr double kDelayS = 0.16;
// Usable share of the braking in the robot's file; slip and the motors' lag take the rest.
constexpr double kBrakingShare = 0.4;
// Error of the yaw and crab angle of the robot.
constexpr double kYawErrorRad = 4.0 * kRadPerDeg;
// Margin to the fence for sideways motion in a turn on the spot.
constexpr double kMarginM = 0.01;
constexpr double kDeviations = 2.0;
// Upper bound of the margin for uncertainty, so that a robot that was never placed can be driven.
constexpr double kMaxMarginM = 0.03;
// The same as a share of the fence's shorter side.
constexpr double kMaxMarginShare = 0.15;

// Below this speed the robot would creep on and on, or its speed loops would wind up against
// friction.
constexpr double kCreepMps = 0.01;

// The yaw error that the robot's yaw loop needs to make up for its lag in a turn. Without this
// limit it would wind up while a track is blocked.
constexpr double kMaxAheadRad = 8.0 * kRadPerDeg;
// Below this rate a turn to the other side may begin. A robot that turns faster than commanded by
// more than this still coasts.
constexpr double kTurnEndsRadps = 0.12;

/// Towards `to`: away from zero by at most `step`, towards zero at once.
double eased(double from, double to, double step) {
  if (from * to <= 0.0) from = 0.0;
  return std::abs(to) <= std::abs(from) ? to : from + std::clamp(to - from, -step, step);
}

/// Greatest speed towards an edge at this distance.
double approach_mps(double distance_m, double braking_mps2) {
  if (distance_m <= 0.0) return 0.0;
  const double delay_mps = braking_mps2 * kDelayS;
  const double mps = std::sqrt(delay_mps * delay_mps + 2.0 * braking_mps2 * distance_m) - delay_mps;
  return mps < kCreepMps ? 0.0 : mps;
}

/// Direction and distance to the fence or the edge of an area; negative: the robot is on its wrong
/// side.
struct EdgeVector {
  double x, y;
  double distance_m;
};

/// The greatest speed in a direction, limited by one edge after the other.
struct Approach {
  double x, y;  // direction of the motion
  double turned_rad;
  double margin_m;
  double braking_mps2;
  double max_mps;

  void limit(const EdgeVector& edge) {
    const double across = std::clamp(x * edge.x + y * edge.y, -1.0, 1.0);
    const double towards = std::cos(std::max(0.0, std::acos(across) - turned_rad));
    if (towards <= 0.0) return;
    max_mps = std::min(max_mps, approach_mps(edge.distance_m - margin_m, braking_mps2) / towards);
  }

  /// Limits the speed inside of a polygon, or outside of it. While the robot is on the wrong side,
  /// only its nearest edge counts: the robot may drive back over it.
  void limit(const course::Polygon& polygon, const Pose& pose, bool inside) {
    const bool right = course::contains(polygon, pose.x_m, pose.y_m) == inside;
    EdgeVector nearest{0.0, 0.0, -std::numeric_limits<double>::infinity()};
    for (std::size_t i = 0; i < polygon.size(); ++i) {
      const course::Vertex point = course::nearest_on_edge(polygon, i, pose.x_m, pose.y_m);
      const double dx = point.x_m - pose.x_m, dy = point.y_m - pose.y_m;
      const double distance_m = magnitude(dx, dy);
      // On the edge the direction to it is undefined.
      if (distance_m == 0.0) continue;
      if (right) {
        limit({dx / distance_m, dy / distance_m, distance_m});
      } else if (-distance_m > nearest.distance_m) {
        nearest = {-dx / distance_m, -dy / distance_m, -distance_m};
      }
    }
    if (!right) limit(nearest);
  }
};

}  // namespace

double speed_inside(double speed_mps, const FenceMotion& motion, const course::Fence& fence) {
  const Pose& pose = motion.pose;
  const double side_m = std::min(fence.max_x_m - fence.min_x_m, fence.max_y_m - fence.min_y_m);
  const double sign = speed_mps < 0.0 ? -1.0 : 1.0;
  Approach approach{.x = sign * std::cos(pose.yaw_rad),
                    .y = sign * std::sin(pose.yaw_rad),
                    .turned_rad = kYawErrorRad + motion.yaw_rate_radps * kDelayS,
                    .margin_m = std::min({kMarginM + kDeviations * motion.uncertainty_m,
                                          kMaxMarginM, kMaxMarginShare * side_m}) -
                                motion.tolerance_m,
                    .braking_mps2 = kBrakingShare * motion.braking_mps2,
                    .max_mps = std::abs(speed_mps)};
  if (fence.corners.empty()) {
    approach.limit({-1.0, 0.0, pose.x_m - fence.min_x_m});
    approach.limit({1.0, 0.0, fence.max_x_m - pose.x_m});
    approach.limit({0.0, -1.0, pose.y_m - fence.min_y_m});
    approach.limit({0.0, 1.0, fence.max_y_m - pose.y_m});
  } else {
    approach.limit(fence.corners, pose, true);
  }
  for (const course::Polygon& area : fence.keep_out) approach.limit(area, pose, false);
  return sign * approach.max_mps;
}

void HandDrive::restart(HostNs now) {
  newest_ = {.at_ns = now};
  speed_mps_ = yaw_rate_radps_ = ahead_rad_ = 0.0;
  last_yaw_rad_.reset();
  holds_yaw_ = false;
}

void HandDrive::take(const VelocityInput& input, HostNs now) {
  if (input.at_ns < newest_.at_ns) return;
  newest_ = input;
  newest_.at_ns = std::min(input.at_ns, now);
}

HandCommand HandDrive::update(const HandDriveState& state, const Parameters& parameters, HostNs now,
                              double dt_s) {
  const TrackLimits& limits = state.limits;
  const bool fresh = now - newest_.at_ns <= kFreshInputNs;
  const double speed = fresh ? newest_.speed_mps : 0.0;
  const bool creeps = std::abs(speed_mps_) < kCreepMps;
  // Friction holds a robot that is to turn so slowly on the spot, and its speed loops wind up.
  const bool turns = fresh && !(creeps && std::abs(newest_.yaw_rate_radps) < kStandstillRadps);
  const double rate = turns ? newest_.yaw_rate_radps : 0.0;
  speed_mps_ = eased(speed_mps_, std::clamp(speed, -limits.max_track_mps, limits.max_track_mps),
                     parameters.acceleration_mps2 * dt_s);
  yaw_rate_radps_ =
      eased(yaw_rate_radps_, std::clamp(rate, -limits.max_yaw_radps, limits.max_yaw_radps),
            parameters.pivot_acceleration_radps2 * dt_s);
  // The previous turn must end first: a robot that turns against its command seems to be miswired.
  if (yaw_rate_radps_ * state.measured_yaw_rate_radps < 0.0 &&
      std::abs(state.measured_yaw_rate_radps) > kTurnEndsRadps)
    yaw_rate_radps_ = 0.0;

  HandCommand out;
  const double wanted_mps = speed_mps_;
  if (fence_) {
    const double turning_radps = std::max(std::abs(turn_asked(ahead_rad_, yaw_rate_radps_, limits)),
                                          std::abs(state.measured_yaw_rate_radps));
    FenceMotion motion{.pose = state.pose,
                       .yaw_rate_radps = turning_radps,
                       .braking_mps2 = state.braking_mps2,
                       .uncertainty_m = state.position_sd_m};
    speed_mps_ = speed_inside(wanted_mps, motion, *fence_);
    motion.uncertainty_m = 0.0;
    for (const Witness& other : state.others) {
      motion.pose = other.pose;
      motion.tolerance_m = tolerance_m(other);
      speed_mps_ = speed_inside(speed_mps_, motion, *fence_);
    }
    out.at_fence = speed_mps_ != wanted_mps;
  }
  out.desired_yaw_rad = desired_yaw(state, dt_s);
  out.yaw_rate_radps = yaw_rate_radps_;
  const double turn_radps = turn_asked(ahead_rad_, yaw_rate_radps_, limits);
  // If the turn uses a track's whole limit, no speed is left.
  const double within = skid_steer(limits).speed_within(speed_mps_, turn_radps);
  out.speed_mps = within * speed_mps_ > 0.0 ? within : 0.0;
  return out;
}

double HandDrive::desired_yaw(const HandDriveState& state, double dt_s) {
  const double yaw_rad = state.pose.yaw_rad;
  const bool turns = yaw_rate_radps_ != 0.0;
  // While the robot coasts, the desired yaw moves with it.
  const bool coasts =
      std::abs(state.measured_yaw_rate_radps) > std::abs(yaw_rate_radps_) + kTurnEndsRadps;
  // Straight on, the robot holds the yaw that it had at the end of the turn.
  holds_yaw_ = !turns && std::abs(speed_mps_) >= kCreepMps &&
               (holds_yaw_ || std::abs(state.measured_yaw_rate_radps) < kStandstillRadps);
  if ((turns && !coasts) || holds_yaw_) {
    ahead_rad_ =
        std::clamp(ahead_rad_ + last_yaw_rad_.value_or(yaw_rad) - yaw_rad + yaw_rate_radps_ * dt_s,
                   -kMaxAheadRad, kMaxAheadRad);
  } else {
    ahead_rad_ = 0.0;
  }
  last_yaw_rad_ = yaw_rad;
  return yaw_rad + ahead_rad_;
}

}  // namespace tp100::control
