#include "control/progress.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "lagging_robot.h"
#include "support/sequence.h"

namespace tp100::control {
namespace {

/// Lines and arcs without stops between them, and turns on the spot, away from the axes.
course::Path joined_path() {
  course::Course course = make_course(
      {course::Line{0.31}, course::Arc{0.12, 1.7}, course::Arc{0.05, -2.0}, course::Line{0.013},
       course::Line{0.2}, course::Pivot{-1.2}, course::Line{0.11}, course::Arc{0.3, -0.8},
       course::Pivot{0.9}, course::Pivot{0.4}, course::Line{0.12}});
  course.start = {.x_m = -0.4, .y_m = 0.2, .yaw_rad = -0.7};
  return course::Path(course);
}

bool is_turn(const course::PathSegment& segment) {
  return segment.kind == course::PathSegment::Kind::kPivot;
}

TEST(Progress, NeverGoesBackAndNeverFurtherAheadThanFiveCentimetresAStep) {
  const course::Path path = joined_path();
  Progress progress(path);
  test::Sequence any(8);
  double furthest_m = 0.0;
  for (int i = 0; i < 3000; ++i) {
    const double before_m = progress.here().s_m;
    const course::PathPoint at = progress.ahead(i % 7 == 0 ? any.between(-0.2, 0.2) : 0.004);
    progress.advance(at.x_m + any.between(-0.03, 0.03), at.y_m + any.between(-0.03, 0.03));
    ASSERT_GE(progress.here().s_m, before_m) << i;
    ASSERT_LE(progress.here().s_m, before_m + 0.05 + 1e-9) << i;
    furthest_m = std::max(furthest_m, progress.here().s_m - before_m);
    if (progress.left_m() < 1e-3 && !progress.next()) progress.restart();
  }
  EXPECT_GT(furthest_m, 0.04);
}

TEST(Progress, IsResumedAnywhereAndAtATurnByTheYaw) {
  const course::Path path = joined_path();
  Progress progress(path);
  for (double s_m = -0.01; s_m < path.length_m() + 0.02; s_m += 0.0137) {
    progress.resume(s_m, 0.0);
    EXPECT_NEAR(progress.here().s_m, std::clamp(s_m, 0.0, path.length_m()), 1e-9);
  }
  const course::PathSegment& turn = path.segments()[5];
  const auto resumed_turning = [&](double beside_m, double share) {
    // Whole turns of the yaw are none.
    progress.resume(turn.end.s_m + beside_m,
                    std::lerp(turn.begin.yaw_rad, turn.end.yaw_rad, share) + 2.0 * kPi);
    return is_turn(progress.segment());
  };
  for (const double beside_m : {-0.0009, 0.0, 0.0009}) {
    for (const double share : {-0.2, 0.0, 0.45}) EXPECT_TRUE(resumed_turning(beside_m, share));
    for (const double share : {0.55, 1.0, 1.2}) EXPECT_FALSE(resumed_turning(beside_m, share));
  }
  for (const double share : {0.0, 1.0}) {
    EXPECT_FALSE(resumed_turning(-0.0011, share));
    EXPECT_EQ(progress.next_turn(), 5u) << "the turn is still ahead";
    EXPECT_FALSE(resumed_turning(0.0011, share));
    EXPECT_EQ(progress.next_turn(), 8u) << "the turn is behind";
  }
}

TEST(Progress, ARobotThatIsPushedIsFoundWithinTheWindowAlsoOverJointsButNotOverATurn) {
  const course::Path path = joined_path();
  Progress progress(path);
  const double stop_m = path.segments()[5].begin.s_m;
  for (const double from_m : {0.05, 0.29, 0.33, 0.45, 0.55, 0.62, 0.7}) {
    for (double by_m = -0.12; by_m <= 0.12; by_m += 0.01) {
      SCOPED_TRACE(testing::Message() << from_m << " " << by_m);
      progress.resume(from_m, 0.0);
      const double to_m = std::clamp(from_m + by_m, 0.0, stop_m);
      const course::PathPoint at = path.at(to_m);
      progress.reproject(at.x_m, at.y_m, 0.15);
      EXPECT_NEAR(progress.here().s_m, to_m, 1e-9);
    }
  }
  const auto reprojected_m = [&](double from_m, double to_m, double window_m) {
    progress.resume(from_m, 0.0);
    progress.reproject(path.at(to_m).x_m, path.at(to_m).y_m, window_m);
    return progress.here().s_m;
  };
  EXPECT_NEAR(reprojected_m(0.05, 0.2, 0.1), 0.15, 1e-9) << "the window ends";
  EXPECT_NEAR(reprojected_m(0.2, 0.05, 0.1), 0.1, 1e-9);
  EXPECT_NEAR(reprojected_m(stop_m - 0.02, stop_m + 0.1, 0.2), stop_m, 0.03) << "a turn";
}

}  // namespace
}  // namespace tp100::control
