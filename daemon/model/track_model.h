#pragma once
// The slip-compensated skid-steer model, eqs 1-5, integrated over exact arcs.

#include "core/angle.h"
#include "core/pose.h"

namespace tp100::model {

/// `kPaper`: exactly eqs 1-5. `kExtended` adds -x_icr * yaw rate to Vy, multiplies the planar part
/// by cos(slope), climbs with sin(slope) and shifts the slip ratios with the slope.
enum class Mode { kPaper, kExtended };

/// Parameters of eqs 1-5. The defaults are the paper's (tarpaulin; wheelbase as printed).
struct TrackParameters {
  double slip_left = 0.1;
  double slip_right = 0.1188;
  double slip_angle_straight_rad = 0.404 * kRadPerDeg;
  double slip_angle_turning_rad = 0.0;
  double turning_threshold_radps =
      0.05;  ///< |yaw rate of eq 5| above it takes the turning slip angle
  double wheelbase_m = 0.2742;
  double x_icr_m = 0.0;  ///< extended only
};

/// Slip ratios that apply on a slope: the paper's in `kPaper`; else shifted by the paper's slope
/// table against its own zero, so that the parameters stay those of the flat surface.
struct Slip {
  double left = 0.0;
  double right = 0.0;
};
Slip slip_on_slope(const TrackParameters& parameters, Mode mode, double slope_rad);

/// Eqs 1, 2 and 5: body twist of belts at `left_mps`, `right_mps`. Negative speeds take the literal
/// equations. Pure.
Twist body_twist(const TrackParameters& parameters, Mode mode, double left_mps, double right_mps,
                 double slope_rad = 0.0);

/// Eqs 3 and 4 over `dt_s` of constant twist: the exact arc; exact for any step size. `slope_rad`
/// is the climb angle; pass 0 for a plane. Yaw stays unwrapped. Pure.
void advance(Pose& pose, const Twist& twist, double dt_s, double slope_rad = 0.0);

/// Pose by encoders alone. No allocation; safe in the real-time thread.
class TrackModel {
 public:
  TrackModel(const TrackParameters& parameters, Mode mode) : parameters_(parameters), mode_(mode) {}

  /// Continues from `pose`.
  void reset(const Pose& pose) { pose_ = pose; }
  /// Belts at constant speeds for `dt_s`. Returns the twist that was integrated.
  const Twist& advance(double left_mps, double right_mps, double dt_s, double slope_rad = 0.0);

  const Pose& pose() const { return pose_; }
  const Twist& twist() const { return twist_; }
  const Slip& slip() const { return slip_; }
  const TrackParameters& parameters() const { return parameters_; }
  Mode mode() const { return mode_; }

 private:
  TrackParameters parameters_;
  Mode mode_;
  Pose pose_{};
  Twist twist_{};
  Slip slip_{};
};

}  // namespace tp100::model
