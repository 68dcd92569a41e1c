// Errors of the pitch and the slope that a robot found.

#include <gtest/gtest.h>

#include <vector>

#include "core/arithmetic.h"
#include "sim/lab/slope_figures.h"

namespace tp100::sim {
namespace {

using report::TrajectoryPoint;

constexpr double kStepS = 0.005;

course::Terrain one_ramp() {
  course::Ramp ramp{};
  ramp.place.x_m = 0.5;
  ramp.height_m = 0.08;
  ramp.up_rad = ramp.down_rad = 20.0 * kRadPerDeg;
  ramp.top_m = 0.2;
  ramp.width_m = 0.4;
  course::Terrain terrain;
  terrain.obstacles.emplace_back(ramp);
  return terrain;
}

/// The robot is level, from 2 to 5 s nose-up by 20 deg near the ramp, then level again. The IMU has
/// an error of `off_rad`, and the state is `late_s` late.
std::vector<TrajectoryPoint> climb(double off_rad, double late_s) {
  std::vector<TrajectoryPoint> points;
  for (int i = 0; i * kStepS < 8.0; ++i) {
    TrajectoryPoint point;
    point.t_s = i * kStepS;
    point.truth.x_m = 0.5;
    const auto leans = [](double t_s) { return t_s >= 2.0 && t_s < 5.0; };
    point.truth.pitch_rad = leans(point.t_s) ? -20.0 * kRadPerDeg : 0.0;
    point.imu_pitch_rad = point.truth.pitch_rad + off_rad;
    if (leans(point.t_s - late_s)) {
      point.slope = Slope::kUp;
      point.obstacle_class = ObstacleClass::kRamp;
    }
    points.push_back(point);
  }
  return points;
}

TEST(SlopeFigures, TellPitchErrorAndDelay) {
  const SlopeFigures figures = slope_figures(climb(0.01, 0.2), one_ramp());
  EXPECT_NEAR(figures.ramp_pitch_max_error_rad, 0.01, 1e-12);
  EXPECT_NEAR(figures.ramp_pitch_rms_error_rad, 0.01, 1e-12);
  ASSERT_EQ(figures.changes.size(), 2u);
  EXPECT_EQ(figures.changes[0].to, Slope::kUp);
  EXPECT_NEAR(figures.changes[0].at_s, 2.0, 1e-9);
  EXPECT_NEAR(figures.changes[0].found_s.value(), 0.2, 1e-9);
  EXPECT_EQ(figures.changes[1].to, Slope::kFlat);
  EXPECT_NEAR(figures.changes[1].found_s.value(), 0.2, 1e-9);
  EXPECT_EQ(figures.false_changes, 0);
  EXPECT_EQ(figures.obstacles, 1);
  EXPECT_EQ(figures.mistaken, 0);
}

TEST(SlopeFigures, TellWhatWasNotFoundFalseOrMistaken) {
  const auto changed = [](auto change) {
    std::vector<TrajectoryPoint> points = climb(0.0, 0.1);
    for (TrajectoryPoint& point : points) change(point);
    return slope_figures(points, one_ramp());
  };
  const auto within = [](const TrajectoryPoint& point, double from_s, double to_s) {
    return point.t_s > from_s && point.t_s < to_s;
  };
  const SlopeFigures unseen = changed([](TrajectoryPoint& point) { point.slope = Slope::kFlat; });
  ASSERT_EQ(unseen.changes.size(), 2u);
  EXPECT_FALSE(unseen.changes[0].found_s.has_value());
  const SlopeFigures without_cause = changed([&](TrajectoryPoint& point) {
    if (within(point, 7.0, 7.3)) point.slope = Slope::kDown;
  });
  EXPECT_EQ(without_cause.false_changes, 2) << "one change to down and one back";
  const SlopeFigures step = changed([](TrajectoryPoint& point) {
    if (point.slope != Slope::kFlat) point.obstacle_class = ObstacleClass::kBlock;
  });
  EXPECT_EQ(step.mistaken, 1);
  const SlopeFigures knocked = changed([&](TrajectoryPoint& point) {
    if (within(point, 7.0, 7.1)) point.truth.pitch_rad = 0.2;
  });
  EXPECT_EQ(knocked.changes.size(), 2u) << "what does not last is no change of the body";
}

}  // namespace
}  // namespace tp100::sim
