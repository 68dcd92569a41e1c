#pragma once
// The step climb model against the emulated body where both mean the same: belts that lose no speed
// and hardly creep.

#include "course/robot.h"

namespace tp100::sim {

/// One drive straight over a block, from first touch until the body is level behind it.
struct ClimbCheck {
  double pitch_rms_rad = 0.0;  ///< model's pitch less the body's
  double pitch_max_rad = 0.0;
  double height_m = 0.0;  ///< of the block
  bool crossed = false;   ///< the body got over it
};

/// The body of `robot` without belt deficit and with little creep, and the model as terrain::Ride
/// uses it, both with belts at `belt_mps` over a block of `height_m` by `depth_m`. Pure. Throws
/// SetupError if the model cannot climb it.
ClimbCheck check_climb_pitch(const course::Robot& robot, double height_m, double depth_m,
                             double belt_mps);

}  // namespace tp100::sim
