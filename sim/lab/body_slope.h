#pragma once
// The paper's slope experiment on the emulated body, and motion at constant track speeds: exact,
// without encoder, camera or model.

#include <optional>
#include <span>
#include <string>

#include "course/robot_file.h"
#include "sim/body/body.h"

namespace tp100::sim {

/// Mean motion of the reference point along the body's own x axis and about its z axis.
struct MeanMotion {
  double forward_mps = 0.0, yaw_rate_radps = 0.0;
};

/// Drives `body` at these track speeds: `run_in_s` until it is steady, then `measured_s` (> 0),
/// over which its motion is averaged.
MeanMotion mean_motion(Body& body, const TrackSpeeds& tracks, double run_in_s, double measured_s);

/// What was measured on one slope, from the body's exact motion.
struct SlopeSlip {
  double slope_rad = 0.0;
  double left = 0.0, right = 0.0;  ///< 1 - speed of the body over either track / track speed
  double yaw_rate_radps = 0.0;
  bool climbed = false;  ///< false: it slid or fell over
};

/// A slope of the experiment and the paper's values for it; its table has no row for 4 deg.
struct SlopeRow {
  double slope_deg;
  std::optional<double> paper_left, paper_right;
};
/// 0, 4 ... 28 deg.
std::span<const SlopeRow> slope_rows();

/// Measures a drive straight up an even slope, both tracks at `track_mps`, for two seconds after
/// half a second of running in. Pure.
SlopeSlip measure_slope(const course::EmulatedBody& values, double slope_rad, double track_mps);

/// `tp100-lab slope`: drives 0, 4 ... 28 deg at kSlopeTrackMps and prints the slip of both tracks
/// beside the paper's table. `robot`: bundled name or file; empty: the reference robot. Returns 0
/// if it climbed every slope, else 1. Throws UserError.
int run_slope(const std::string& robot);

}  // namespace tp100::sim
