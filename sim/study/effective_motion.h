#pragma once
// What a robot really did on its calibration drives, from the body's exact motion: the independent
// measure that identify is judged by. Sums over whole drives, no model integrated, no camera, no
// gyro.

#include <vector>

#include "core/pose.h"
#include "course/robot.h"
#include "identify/drive.h"

namespace tp100::sim {

/// What a calibration drive is.
enum class DriveKind { kStraight, kWide, kTight, kSpin };

struct CalibrationDrive {
  DriveKind kind;
  identify::Drive drive;
  std::vector<Pose> truth;  ///< exact poses at its samples; yaw unwrapped
};

/// Effective values over all drives of a kind. Belt travel is that of the true encoders. Wheelbase
/// and turning centre of arcs that lie between the kinds of turn that the parameters are of
/// (model/turn.h) are taken apart by how far between they lie.
struct EffectiveMotion {
  double slip_left = 0.0;  ///< straight: 1 - way of the body above the belt / travel of the belt
  double slip_right = 0.0;
  double slip_angle_straight_rad = 0.0;  ///< straight: way sideways against way ahead
  double slip_angle_turning_rad = 0.0;   ///< same over arcs to both sides
  double wheelbase_m = 0.0;  ///< arcs: difference of the belts' travel, slip out / turned angle
  double wheelbase_tight_m = 0.0;  ///< same over the tight arcs
  double wheelbase_spin_m = 0.0;   ///< same over the turns on the spot
  double x_icr_m = 0.0;            ///< arcs: -(speed sideways / yaw rate), least squares
  double x_icr_tight_m = 0.0;      ///< same over the tight arcs
  double x_icr_spin_m = 0.0;       ///< same over the turns on the spot
  double turn_slip = 0.0;  ///< wide arcs: way ahead that turning left costs and right gains, in
                           ///< parts of the belts' way, slip out
  double turn_slip_tight = 0.0;  ///< same over the tight arcs
  double gyro_scale = 0.0;       ///< of the emulated sensor
};

/// Needs drives of all kinds, turns to both sides.
EffectiveMotion effective_motion(const std::vector<CalibrationDrive>& drives,
                                 const course::Emulated& robot);

}  // namespace tp100::sim
