#pragma once
// The envelope of a run or a drive by hand: where the robot may be, judged alike for every pose
// that tells where it is, and how far two such poses may contradict each other.

#include <cstdint>
#include <optional>

#include "control/parameters.h"
#include "core/arithmetic.h"
#include "core/bounded_list.h"
#include "core/faults.h"
#include "core/pose.h"
#include "course/course.h"

namespace tp100::control {

/// A pose that tells where the robot is: the steering pose, or one that does not depend on the
/// camera or world that the pose before it in the list depends on, or the other way around.
struct Witness {
  Pose pose{};              ///< of the reference point, in the course's world
  double off_path_m = 0.0;  ///< distance from the path where progress says it is; not negative
  Pose other{};             ///< the same by the source that it is compared with
  /// Standard deviations of their difference, as far as the sensors on the robot determine them.
  double sd_m = 0.0, sd_rad = 0.0;
  /// What they may differ by beside that: slip on ramps and blocks, or because the robot of an
  /// external world is another one.
  double lag_m = 0.0, lag_rad = 0.0;
  double obstacle_lag_m = 0.0;  ///< the part of it that ramps and blocks explain
  /// The fault if they contradict each other, or if this pose leaves the envelope and the one
  /// before it in the list does not. Nothing: they may differ, and this one leaves it by itself.
  std::optional<Fault> contradiction{};
};

/// The poses beside the steering pose.
using Witnesses = BoundedList<Witness, 3>;

/// How far out of the envelope a pose beside the steering pose may be. The tracker and HandDrive
/// keep the steering pose inside, and this one may differ from it by as much in a healthy run. [m]
double tolerance_m(const Witness& witness);

/// A condition that must last before it counts.
class Lasting {
 public:
  /// True once `condition` has held for `needed_s`.
  bool update(bool condition, double dt_s, double needed_s) {
    held_s_ = condition ? held_s_ + dt_s : 0.0;
    return condition && held_s_ >= needed_s;
  }

 private:
  double held_s_ = 0.0;
};

/// A run or a drive in one step. SI units.
struct Whereabouts {
  Witness steering{};
  Witnesses others{};
  bool by_hand = false;  ///< no path and no time limit applies, and HandDrive keeps to the fence
  double heading_error_rad = 0.0;
  double elapsed_s = 0.0;        ///< since the run began
  double dt_s = 0.0;             ///< since the last step
  std::uint32_t recoveries = 0;  ///< how often the camera reset the fused pose, since the run began
};

/// Judges one run or drive. Two witnesses that contradict each other leave it open where the robot
/// is: that is then the only fault. No allocation; safe in the real-time thread.
class Envelope {
 public:
  /// Difference of two witnesses, beside their deviations, from which on they contradict each
  /// other: more than a disturbance from which the robot recovers.
  static constexpr double kContradictionM = 0.12;
  static constexpr double kContradictionRad = 12.0 * kRadPerDeg;
  /// A camera that resets the fused pose so often within the time of a few disturbances contradicts
  /// odometry.
  static constexpr double kMostRecoveries = 12.0;
  static constexpr double kRecoveryS = 2.0;  ///< one is forgotten after this long

  Envelope(const Parameters& parameters, course::Fence fence, double nominal_duration_s)
      : parameters_(parameters),
        fence_(std::move(fence)),
        nominal_duration_s_(nominal_duration_s) {}

  /// A run begins.
  void restart();
  /// The faults that end the run or drive now; 0 to go on.
  FaultMask update(const Whereabouts& seen);

 private:
  bool resets_too_often(const Whereabouts& seen);
  FaultMask contradictions(const Whereabouts& seen);
  FaultMask left_by(const Witness& witness, double tolerance_m) const;

  Parameters parameters_;
  course::Fence fence_;
  double nominal_duration_s_;
  Lasting heading_{};
  double remembered_ = 0.0;  ///< recoveries
  std::optional<std::uint32_t> recoveries_{};
};

}  // namespace tp100::control
