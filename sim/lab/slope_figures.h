#pragma once
// The daemon's slope state compared with the true body.

#include <optional>
#include <vector>

#include "course/terrain.h"
#include "report/run_result.h"

namespace tp100::sim {

/// The body began or stopped leaning.
struct SlopeChange {
  double at_s = 0.0;              ///< true pitch passed 4 deg; from the start of the run
  Slope to = Slope::kFlat;        ///< state from then on
  std::optional<double> found_s;  ///< from there until the state followed; nothing: never
};

struct SlopeFigures {
  double ramp_pitch_max_error_rad = 0.0;  ///< the IMU's pitch on the slopes of ramps
  double ramp_pitch_rms_error_rad = 0.0;
  std::vector<SlopeChange> changes;
  int false_changes = 0;  ///< of the state, without a change of the body
  int obstacles = 0;      ///< obstacles climbed
  int mistaken = 0;       ///< ... half a second later, a ramp taken for a step or a step for a ramp
};

/// A change of the body counts if it lasts for 0.2 s; a state that returns within that time belongs
/// to none and counts as false. `terrain` is the real floor's.
SlopeFigures slope_figures(const std::vector<report::TrajectoryPoint>& points,
                           const course::Terrain& terrain);

}  // namespace tp100::sim
