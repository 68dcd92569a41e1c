#pragma once
// The slip-compensated skid-steer model, eqs 1-5, integrated over exact arcs.

#include "core/angle.h"
#include "core/pose.h"
#include "model/incline.h"
#include "model/slip_table.h"
#include "model/turn.h"

namespace tp100::model {

/// `kPaper`: exactly eqs 1-5 on a plane. `kExtended` adds -x_icr * yaw rate to Vy, lets
/// wheelbase, x_icr and slip change with the turn, multiplies the planar part by cos(slope),
/// climbs with sin(slope) and shifts the slip ratios with surface and slope.
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
  double x_icr_m = 0.0;              ///< extended only
  double wheelbase_tight_m = 0.0;    ///< extended only; L in tight arcs, 0: as on the spot
  double x_icr_tight_shift_m = 0.0;  ///< extended only; added to x_icr_m in tight arcs
  double wheelbase_spin_m = 0.0;     ///< extended only; L on the spot, 0: the same everywhere
  double x_icr_spin_shift_m = 0.0;   ///< extended only; added to x_icr_m on the spot
  double turn_slip = 0.0;        ///< extended only; slip of both belts that a left turn adds and a
                                 ///< right turn takes off: belts that creep unevenly
  double turn_slip_tight = 0.0;  ///< the same in tight turns
  SlipCurve slip_curve = SlipCurve::kTableDownhill;  ///< extended only
};

/// L of eq 5, the turning centre and what the turn takes off the forward speed, in a turn of this
/// shape. In `kPaper` always one L and nothing else.
struct Turn {
  double wheelbase_m = 0.0;
  double x_icr_m = 0.0;
  double slip = 0.0;
};
Turn turn_of(const TrackParameters& parameters, Mode mode, const TurnShape& shape);

/// Slip ratios that apply on an incline: those of the parameters in `kPaper`; else shifted by the
/// surface, and by the paper's slope table against its own zero, so that the parameters stay those
/// of the flat floor.
struct Slip {
  double left = 0.0;
  double right = 0.0;
};
Slip slip_on(const TrackParameters& parameters, Mode mode, const Incline& incline);

/// Eqs 1, 2 and 5: body twist of belts at `left_mps`, `right_mps`. Negative speeds take the literal
/// equations. Pure.
Twist body_twist(const TrackParameters& parameters, Mode mode, double left_mps, double right_mps,
                 const Incline& incline = {});
/// Same in a turn whose shape is known better than from these speeds.
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
    turn_watch_.restart();
  }
  /// Belts at constant speeds for `dt_s`. Returns the twist that was integrated.
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
  TurnWatch turn_watch_{};
};

}  // namespace tp100::model
