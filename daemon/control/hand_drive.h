#pragma once
// Driving by hand: the driver's velocity inputs become speed and desired yaw, within the limits of
// the robot and of the fence.

#include <optional>
#include <utility>

#include "control/envelope.h"
#include "control/parameters.h"
#include "control/track_limits.h"
#include "core/command.h"
#include "core/limits.h"
#include "core/pose.h"
#include "core/time.h"
#include "course/course.h"

namespace tp100::control {

/// The robot as the fence limit sees it. SI units.
struct FenceMotion {
  Pose pose{};                  ///< of the reference point
  double yaw_rate_radps = 0.0;  ///< without sign: the greater of the commanded and the measured one
  double braking_mps2 = 0.6;    ///< of the tracks, by the robot's file
  double uncertainty_m = 0.0;   ///< of the position: added to the margin to the fence, up to 3 cm
  double tolerance_m = 0.0;     ///< how far outside this pose may be; taken off the margin
};

/// The ground speed nearest to `speed_mps` (backwards negative) at which the reference point can
/// still stop inside the fence, delays of sample, wire and motors included. Outside it, only motion
/// towards the inside is allowed. Turning on the spot is not limited.
double speed_inside(double speed_mps, const FenceMotion& motion, const course::Fence& fence);

/// The robot in one step.
struct HandDriveState {
  Pose pose{};                           ///< steering pose
  double measured_yaw_rate_radps = 0.0;  ///< counter-clockwise positive
  double position_sd_m = 0.0;            ///< standard deviation of the position, per axis
  TrackLimits limits{};
  double braking_mps2 = 0.6;  ///< of the tracks, by the robot's file
  /// Other poses that tell where the robot is: the fence limits it by the one nearest to it.
  Witnesses others{};
};

/// Command to the robot. The desired yaw is on the pose's branch.
struct HandCommand {
  double desired_yaw_rad = 0.0;
  double yaw_rate_radps = 0.0;
  double speed_mps = 0.0;
  bool at_fence = false;  ///< the fence limits the speed
};

/// One drive by hand. Speed and yaw rate grow with limited acceleration and fall at once, to zero
/// if the newest input is older than kFreshInputNs. No allocation; safe in the real-time thread.
class HandDrive {
 public:
  /// Without a fence nothing limits where the robot goes.
  explicit HandDrive(std::optional<course::Fence> fence) : fence_(std::move(fence)) {}

  /// A drive begins; inputs from before it do not count.
  void restart(HostNs now);
  /// Inputs that are older than the newest one are ignored; a time after `now` counts as `now`.
  void take(const VelocityInput& input, HostNs now);
  HandCommand update(const HandDriveState& state, const Parameters& parameters, HostNs now,
                     double dt_s);
  /// True after a silence of kDriveSilenceNs.
  bool silent(HostNs now) const { return now - newest_.at_ns > kDriveSilenceNs; }

 private:
  double desired_yaw(const HandDriveState& state, double dt_s);

  std::optional<course::Fence> fence_;
  VelocityInput newest_{};
  double speed_mps_ = 0.0;
  double yaw_rate_radps_ = 0.0;
  double ahead_rad_ = 0.0;              // desired yaw - yaw
  std::optional<double> last_yaw_rad_;  // of this drive
  bool holds_yaw_ = false;
};

}  // namespace tp100::control
