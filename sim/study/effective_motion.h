#pragma once
// The real motion of a robot on its calibration drives, from the body's exact poses: the
// independent reference for identify. Sums over whole drives, no model integrated, no camera, no
// gyro.

#include <vector>

#include "core/pose.h"
#include "course/robot_file.h"
#include "identify/drive.h"
#include "model/track_parameters.h"

namespace tp100::sim {

/// What a calibration drive is.
enum class DriveKind { kStraight, kWide, kTight, kSpin };

struct CalibrationDrive {
  DriveKind kind;
  identify::RecordedDrive drive;
  std::vector<Pose> truth;  ///< exact poses at its samples; yaw unwrapped
};

/// The parameters that the motion shows, each over all drives of its kind. Track travel is that of
/// the true encoders.
/// - Slip: straight, 1 - distance of the body above the track / travel of the track.
/// - Slip angles: sideways distance against forward distance, straight and over arcs to both sides.
/// - Wheelbase: arcs, difference of the tracks' travel, slip removed / turned angle; turning
/// centre:
///   -(speed sideways / yaw rate), least squares. Arcs that lie between the kinds of turn that the
///   parameters belong to (model/track_model.h) are separated by how far between they lie.
/// - Turn slip: forward distance that turning left costs and right gains, as a fraction of the
///   tracks' distance, slip removed.
/// - Gyro scale: of the emulated sensor.
/// Needs drives of all kinds, turns to both sides.
model::TrackParameters effective_motion(const std::vector<CalibrationDrive>& drives,
                                        const course::Emulated& robot);

}  // namespace tp100::sim
