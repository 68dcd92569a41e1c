#pragma once
// The slip-compensated skid-steer model, eqs 1-5, integrated over exact arcs.

#include "core/pose.h"
#include "model/incline.h"
#include "model/track_parameters.h"
#include "model/turn.h"

namespace tp100::model {

/// `kPaper`: exactly eqs 1-5 on a plane. `kExtended` adds -x_icr * yaw rate to Vy, lets
/// wheelbase, x_icr and slip change with the turn, multiplies the horizontal part by cos(slope),
/// climbs with sin(slope) and shifts the slip ratios with surface and slope.
enum class Mode { kPaper, kExtended };

/// L of eq 5, the turning centre, the slip that the turn adds and the slip angle, in a turn of this
/// shape. In `kPaper` always one L and one angle and nothing else.
struct Turn {
  double wheelbase_m = 0.0;
  double x_icr_m = 0.0;
  double slip = 0.0;
  double slip_angle_rad = 0.0;
};
Turn turn_of(const TrackParameters& parameters, Mode mode, const TurnShape& shape);

/// Slip angle (beta of eq 2) at this yaw rate: the turn's above the threshold, else the straight
/// one. Pure.
double slip_angle_rad(const TrackParameters& parameters, const Turn& turn, double yaw_rate_radps);

/// Slip ratios on an incline: those of the parameters in `kPaper`; else shifted by the surface, and
/// by the paper's slope table relative to its level value, so that the parameters stay those of the
/// flat floor.
struct Slip {
  double left = 0.0;
  double right = 0.0;
};
Slip slip_on(const TrackParameters& parameters, Mode mode, const Incline& incline);

/// Eqs 1, 2 and 5: body twist of tracks at `left_mps`, `right_mps`. Negative speeds take the
/// literal equations. Pure.
Twist body_twist(const TrackParameters& parameters, Mode mode, double left_mps, double right_mps,
                 const Incline& incline = {});
/// The same in a turn whose shape is known more accurately than from these speeds.
Twist body_twist(const TrackParameters& parameters, Mode mode, double left_mps, double right_mps,
                 const Incline& incline, const TurnShape& shape);

/// Eqs 3 and 4 over `dt_s` of constant twist: the exact arc; exact for any step size. z and pitch
/// follow the slope. Yaw stays unwrapped. Pure.
void advance(Pose& pose, const Twist& twist, double dt_s, const Incline& incline = {});

/// Pose by encoders alone. No allocation; safe in the real-time thread.
class TrackModel {
 public:
  TrackModel(const TrackParameters& parameters, Mode mode) : parameters_(parameters), mode_(mode) {}

  /// Continues from `pose`.
  void reset(const Pose& pose) {
    pose_ = pose;
    turn_monitor_.restart();
  }
  /// Tracks at constant speeds for `dt_s`. Returns the twist that was integrated.
  const Twist& advance(double left_mps, double right_mps, double dt_s, const Incline& incline = {});

  const Pose& pose() const { return pose_; }
  const Twist& twist() const { return twist_; }
  const Slip& slip() const { return slip_; }

 private:
  TrackParameters parameters_;
  Mode mode_;
  Pose pose_{};
  Twist twist_{};
  Slip slip_{};
  TurnMonitor turn_monitor_{};
};

}  // namespace tp100::model
