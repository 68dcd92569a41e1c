#pragma once
// Runs of bundled courses by bundled robots, and what every recovery from a push must be like.

#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "core/arithmetic.h"
#include "core/statistics.h"
#include "course/course.h"
#include "report/metrics.h"
#include "report/run_result.h"
#include "sim/robot/lockstep.h"
#include "sim/robot/options.h"

namespace tp100::sim {

inline LockstepSettings run_of(const std::string& course, const Loaded& loaded) {
  return {.course = load_course(course),
          .robot = loaded.robot,
          .configuration = loaded.configuration,
          .setup = loaded.setup,
          .board = loaded.board};
}
inline LockstepSettings run_of(const std::string& course, const std::string& robot = "end-loaded",
                               const std::string& board = "native") {
  return run_of(course, load({.board = board, .robot = robot}));
}
/// The same below the bundled overhead camera, whose poses steer it if `steering` is fused.
inline LockstepSettings seen_run_of(const std::string& course, const std::string& robot,
                                    PoseSource steering = PoseSource::kFused) {
  LockstepSettings run = run_of(course, robot);
  run.camera = load_camera("overhead");
  run.configuration.parameters.steering = steering;
  return run;
}

inline double max_position_error_m(const report::RunResult& result, const course::Course& course,
                                   PoseSource source) {
  return report::figures(result, course).estimates[source]->max_position_error_m;
}

/// A name of a test, made of names of files.
inline std::string test_name(std::string name) {
  std::replace(name.begin(), name.end(), '-', '_');
  return name;
}

inline void expect_recovered(const report::DisturbanceResponse& recovery) {
  ASSERT_TRUE(recovery.detection_s.has_value());
  EXPECT_LT(*recovery.detection_s, 0.10);
  ASSERT_TRUE(recovery.settling_s.has_value());
  EXPECT_LE(*recovery.settling_s, 2.5);
  // The disturbances of these courses are 4 cm and 15 deg.
  EXPECT_GT(recovery.peak_cross_track_m, 0.03);
  EXPECT_LT(recovery.peak_cross_track_m, 0.06);
  EXPECT_GT(recovery.peak_yaw_error_rad, 10.0 * kRadPerDeg);
  EXPECT_LT(recovery.overshoot_m, 0.005);
  EXPECT_LT(recovery.shortcut_m, 0.005);
}

/// Expects a recovery from every disturbance and no other detection.
inline void expect_recovered(const report::TrackingErrors& tracking, const course::Course& course) {
  EXPECT_EQ(tracking.false_alarms, 0);
  EXPECT_EQ(tracking.recovery.size(), course.disturbances.size());
  for (const report::DisturbanceResponse& recovery : tracking.recovery) expect_recovered(recovery);
}

}  // namespace tp100::sim
