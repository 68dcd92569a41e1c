#pragma once
// Requirements for every recovery from a disturbance of the bundled courses.

#include <gtest/gtest.h>

#include "core/arithmetic.h"
#include "course/course.h"
#include "report/metrics.h"

namespace tp100::sim {

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
