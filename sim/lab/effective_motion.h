#pragma once
// The real motion of a robot on its identification drives, from the body's exact poses: the
// independent reference for identify. Linear regression over short intervals, no model integrated,
// no camera, no gyro.

#include <vector>

#include "course/robot_file.h"
#include "model/track_parameters.h"
#include "sim/trials/commands.h"

namespace tp100::sim {

/// The parameters that the motion shows, over all drives, whatever each is made of. Track travel is
/// that of the true encoders, ground travel is that less the slip of straight driving, and the
/// shape of the turn (model/track_model.h) is that of the ground travel.
/// - Slip: straight, 1 - distance of the body above the track / travel of the track.
/// - Slip angle straight: sideways distance against forward distance.
/// - Wheelbases: difference of the tracks' ground travel against the turned angle.
/// - Turning centre and slip angle turning: sideways distance against turned angle and forward
///   distance.
/// - Turn slip: forward distance that turning left costs and right gains, against the mean of the
///   tracks' ground travel; turn loss: what turning to either side costs.
/// - Gyro scale: of the emulated sensor.
/// NaN is what the drives do not show.
model::TrackParameters effective_motion(const std::vector<CalibrationDrive>& drives,
                                        const course::Emulated& robot);

}  // namespace tp100::sim
