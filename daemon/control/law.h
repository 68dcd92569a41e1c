#pragma once
// A steering law: from the robot's errors against the path to the desired yaw and turn rate.
// Segments, progress, turns on the spot and speed are the tracker's and the same for every law.

#include <memory>

#include "control/parameters.h"
#include "control/track_limits.h"

namespace tp100::control {

/// The robot against the path. Everything is in the frame of the path's nearest point: x along the
/// tangent, y left. SI units.
struct PathErrors {
  /// Left positive; of the turning centre, which a rotation of the robot does not move.
  double cross_track_m = 0.0;
  double heading_rad = 0.0;     ///< robot's yaw minus the tangent's, within +-pi
  double yaw_rate_radps = 0.0;  ///< measured
  double speed_mps = 0.0;       ///< along the path, as it will be commanded; not negative
  double curvature_1pm = 0.0;   ///< at the nearest point, left positive
  double crab_rad = 0.0;        ///< slip angle: the robot moves this far to the left of its heading
  struct {
    double along_m = 0.0;
    double left_m = 0.0;
    double yaw_rad = 0.0;  ///< tangent there, unwrapped from the nearest point's
    double curvature_1pm = 0.0;
  } ahead{};  ///< the point of the path that lies look_ahead_m() further on
};

/// Output of a law: the robot's yaw loop turns at yaw_rate_radps plus its gain times the yaw error.
struct LawOutput {
  double yaw_rad = 0.0;         ///< desired, against the tangent of the nearest point
  double yaw_rate_radps = 0.0;  ///< feed-forward
};

/// Pure: the same errors give the same steering. Any finite errors give finite steering whose
/// direction of motion, yaw_rad + crab_rad, is within max_approach_rad (and what the path turns up
/// to the look-ahead) of the tangent. No allocation; safe in the real-time thread.
class Law {
 public:
  virtual ~Law() = default;
  /// Distance of `PathErrors::ahead` at this speed. [m]
  virtual double look_ahead_m(double speed_mps) const = 0;
  virtual LawOutput steer(const PathErrors& errors) const = 0;
  /// Applies the parameters that need no solving; the law itself stays the same.
  virtual void retune(const Parameters& parameters) = 0;
};

/// Creates the law that `parameters` name. Allocates and solves: set-up only.
std::unique_ptr<Law> make_law(const Parameters& parameters, const TrackLimits& limits);

}  // namespace tp100::control
