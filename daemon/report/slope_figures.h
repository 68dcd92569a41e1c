#pragma once
// What the daemon said of the slope under the robot, against the true body.

#include <optional>
#include <vector>

#include "course/terrain.h"
#include "report/run_result.h"

namespace tp100::report {

/// The body began or ceased to lean.
struct SlopeChange {
  double at_s = 0.0;              ///< its true pitch passed 4 deg, from the start of the run
  Slope to = Slope::kFlat;        ///< what it is from then on
  std::optional<double> found_s;  ///< from there until the state said so; nothing: never
};

struct SlopeFigures {
  double ramp_pitch_max_error_rad = 0.0;  ///< the IMU's pitch on the slopes of ramps
  double ramp_pitch_rms_error_rad = 0.0;
  std::vector<SlopeChange> changes;
  int false_changes = 0;  ///< of the state, without one of the body
  int obstacles = 0;      ///< that were gone up
  int mistaken = 0;       ///< ... half a second later a ramp for a step, a step for a ramp
};

/// A change of the body counts if it lasts for 0.2 s; a state that returns within that belongs to
/// none and is false. `terrain` is what really stands on the robot's floor.
SlopeFigures slope_figures(const std::vector<TrackPoint>& points, const course::Terrain& terrain);

}  // namespace tp100::report
