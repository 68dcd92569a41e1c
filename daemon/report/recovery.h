#pragma once
// What happened after a push: when it was noticed, how far it went, how the robot came back.

#include <optional>
#include <vector>

#include "report/deviation.h"
#include "report/run_result.h"

namespace tp100::report {

/// One push. Truth but for the time of detection, which is the controller's.
struct Recovery {
  double begin_s = 0.0;                 ///< of the push, from the start of the run
  std::optional<double> detection_s{};  ///< from there until the controller noticed; nothing: never
  double peak_cross_track_m = 0.0;      ///< until settled, the push included
  double peak_yaw_error_rad = 0.0;
  /// From the end of the push until the robot was inside 1 cm and 3 deg and stayed there for 0.5 s;
  /// nothing: never.
  std::optional<double> settling_s{};
  double overshoot_m =
      0.0;                  ///< furthest on the other side of the path until that half second ended
  double shortcut_m = 0.0;  ///< path that was neither driven nor pushed along; 0 if it was all
};

/// One entry for each push. `deviations` belong to `points`; shoves ascending, not overlapping.
std::vector<Recovery> recoveries(const std::vector<TrackPoint>& points,
                                 const std::vector<Deviation>& deviations,
                                 const std::vector<ShoveWindow>& shoves);

/// How often the controller noticed a push that nobody made.
int false_alarms(const std::vector<TrackPoint>& points, const std::vector<ShoveWindow>& shoves);

}  // namespace tp100::report
