#include "control/envelope.h"

#include <algorithm>
#include <cmath>

namespace tp100::control {
namespace {

constexpr double kHeadingErrorS = 0.5;
constexpr double kMostDeviations = 2.0;
// Odometry is usually better than its deviation, most of which is slip that might be there.
constexpr double kUsualDeviations = 0.5;
constexpr double kClosestM = 0.005;
// Two poses of which one alone has left the envelope need not be as far apart.
constexpr double kAloneM = 0.02;

/// Whether the two poses are farther apart than that, beside what explains it.
bool apart(const Witness& one, double margin_m, double deviations) {
  const double apart_m = magnitude(one.pose.x_m - one.other.x_m, one.pose.y_m - one.other.y_m);
  return apart_m > margin_m + deviations * one.sd_m + one.lag_m;
}

bool contradicts(const Witness& one) {
  const double turned_rad = std::abs(wrap_angle(one.pose.yaw_rad - one.other.yaw_rad));
  return apart(one, Envelope::kContradictionM, kMostDeviations) ||
         turned_rad > Envelope::kContradictionRad + kMostDeviations * one.sd_rad + one.lag_rad;
}

}  // namespace

double tolerance_m(const Witness& witness) {
  return kClosestM + kUsualDeviations * witness.sd_m + witness.obstacle_lag_m;
}

void Envelope::restart() {
  heading_ = {};
  remembered_ = 0.0;
  recoveries_.reset();
}

bool Envelope::resets_too_often(const Whereabouts& seen) {
  const std::uint32_t before = recoveries_.value_or(seen.recoveries);
  recoveries_ = seen.recoveries;
  remembered_ = std::max(0.0, remembered_ - seen.dt_s / kRecoveryS);
  if (seen.recoveries > before) remembered_ += seen.recoveries - before;
  return remembered_ > kMostRecoveries;
}

FaultMask Envelope::left_by(const Witness& witness, double tolerance_m) const {
  FaultMask faults = 0;
  if (witness.off_path_m > parameters_.max_cross_track_m + tolerance_m)
    faults |= fault_bit(Fault::cross_track);
  if (course::outside_m(fence_, witness.pose.x_m, witness.pose.y_m) > tolerance_m)
    faults |= fault_bit(Fault::fence);
  return faults;
}

FaultMask Envelope::contradictions(const Whereabouts& seen) {
  FaultMask faults = 0;
  if (resets_too_often(seen)) faults |= fault_bit(Fault::camera_against_odometry);
  bool before_left = !seen.by_hand && left_by(seen.steering, 0.0) != 0;
  for (const Witness& one : seen.others) {
    const bool left = !seen.by_hand && left_by(one, tolerance_m(one)) != 0;
    const bool alone = left ? !before_left : before_left && apart(one, kAloneM, 1.0);
    if (one.contradiction && (alone || contradicts(one))) faults |= fault_bit(*one.contradiction);
    before_left = left;
  }
  return faults;
}

FaultMask Envelope::update(const Whereabouts& seen) {
  FaultMask faults = contradictions(seen);
  if (faults != 0 || seen.by_hand) return faults;
  const auto raise = [&faults](bool condition, Fault fault) {
    if (condition) faults |= fault_bit(fault);
  };
  faults |= left_by(seen.steering, 0.0);
  for (const Witness& one : seen.others) faults |= left_by(one, tolerance_m(one));
  raise(heading_.update(std::abs(seen.heading_error_rad) > parameters_.max_heading_error_rad,
                        seen.dt_s, kHeadingErrorS),
        Fault::heading);
  raise(seen.elapsed_s > parameters_.time_limit_factor * nominal_duration_s_, Fault::time_limit);
  return faults;
}

}  // namespace tp100::control
