#include <gtest/gtest.h>

#include <cmath>

#include "core/arithmetic.h"
#include "estimation/pose_filter.h"

namespace tp100::estimation {
namespace {

constexpr double kNoseUp = -28.0 * kRadPerDeg;

TEST(ExpectedMarker, OnAPlaneItIsThePose) {
  const Eigen::Vector3d pose(0.7, -0.4, 2.1);
  EXPECT_LT((expected_marker(pose, {}, {}, {0.5, 0.5}) - pose).norm(), 1e-12);
}

TEST(ExpectedMarker, FallsBackBy28MillimetresAt28DegreesOfPitch) {
  const Eigen::Vector3d pose(0.0, 0.0, 0.0);
  const Eigen::Vector3d seen = expected_marker(pose, {.pitch_rad = kNoseUp}, {}, {});
  EXPECT_NEAR(seen[0], -0.028, 0.0005);
  EXPECT_NEAR(seen[1], 0.0, 1e-9);
  const Eigen::Vector3d turned =
      expected_marker({0.0, 0.0, kPi / 2}, {.pitch_rad = kNoseUp}, {}, {});
  EXPECT_NEAR(turned[1], -0.028, 0.0005);
}

TEST(ExpectedMarker, ARollToTheRightShiftsItRight) {
  const Eigen::Vector3d seen =
      expected_marker({0.0, 0.0, 0.0}, {.roll_rad = 10.0 * kRadPerDeg}, {}, {});
  EXPECT_NEAR(seen[1], -0.060 * std::sin(10.0 * kRadPerDeg), 2e-4);
}

TEST(ExpectedMarker, AnOffsetOfTheCameraMakesARaisedRobotLookFurtherAway) {
  const Eigen::Vector3d seen = expected_marker({1.2, 0.0, 0.0}, {.z_m = 0.08}, {}, {});
  EXPECT_NEAR(seen[0], 1.2 * (2.5 - 0.06) / (2.5 - 0.14), 1e-9);
}

// The expected value comes from the images of two points of the marker in space.
TEST(ExpectedMarker, SeenAcrossTheSlopeAPitchedMarkerLooksTurned) {
  const CameraParameters camera;
  const double y_m = 0.9;
  const auto pictured = [&](double along_m) {
    const double pitch = kNoseUp;
    const double x = along_m * std::cos(pitch) + 0.06 * std::sin(pitch);
    const double z = -along_m * std::sin(pitch) + 0.06 * std::cos(pitch);
    const double scale = (camera.height_m - camera.marker_height_m) / (camera.height_m - z);
    return Eigen::Vector2d(x * scale, y_m * scale);
  };
  const Eigen::Vector2d along = pictured(1e-4) - pictured(-1e-4);
  const Eigen::Vector3d seen =
      expected_marker({0.0, y_m, 0.0}, {.pitch_rad = kNoseUp}, camera, {0.0, 0.0});
  EXPECT_NEAR(seen[2], std::atan2(along[1], along[0]), 1e-5);
  EXPECT_GT(seen[2], 5.0 * kRadPerDeg);
  EXPECT_NEAR(seen[0], pictured(0.0)[0], 1e-9);
  EXPECT_NEAR(seen[1], pictured(0.0)[1], 1e-9);
}

TEST(CameraUpdate, AClimbingOrTippingBodyWhoseMarkerSwaysIsCorrectedLess) {
  const MotionModel motion({}, {});
  const auto corrected_m = [&](const Ground& ground) {
    CameraUpdate update({}, {});
    FilterState state = motion.prior();
    const CameraVerdict verdict = update.apply(state, {.x_m = 0.004}, ground, {}, motion);
    EXPECT_EQ(verdict, CameraVerdict::kUsed);
    return state.mean[kX];
  };
  const double level_m = corrected_m({});
  EXPECT_GT(level_m, 0.003);
  EXPECT_LT(corrected_m({.hold_slip = true}), 0.8 * level_m);
  EXPECT_LT(corrected_m({.tilt_radps = 10.0}), 0.8 * level_m);
}

}  // namespace
}  // namespace tp100::estimation
