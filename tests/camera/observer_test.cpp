// The observer of tp100-camera on drawn images: how exactly it places the robot, and when it says
// nothing.

#include "camera/observer.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/arithmetic.h"
#include "core/error.h"
#include "marker_scene.h"

namespace tp100::test {
namespace {

using camera::Observer;

struct Errors {
  double place_rms_m = 0.0, place_max_m = 0.0, yaw_rms_rad = 0.0, yaw_max_rad = 0.0;
};

double place_error(const camera::MarkerPose& found, const Pose& truth) {
  return std::hypot(found.x_m - truth.x_m, found.y_m - truth.y_m);
}

/// Errors for a robot that is found at places all over the floor, in every direction.
Errors errors_over_the_floor(Scene& scene, const camera::View& view, int images,
                             const Twist& twist = {}, const SceneNoise& noise = {}) {
  Observer observer(lens_of(scene.camera()), view);
  Errors errors;
  for (int i = 0; i < images; ++i) {
    // A low-discrepancy sequence makes all places different.
    const double a = std::fmod(0.5 + i * 0.7548776662, 1.0);
    const double b = std::fmod(0.5 + i * 0.5698402910, 1.0);
    const Pose truth{.x_m = -1.2 + 2.4 * a, .y_m = -0.55 + 1.1 * b, .yaw_rad = 2.4 * i};
    const auto found = observer.look(scene.image(truth, twist, noise));
    EXPECT_TRUE(found.has_value()) << i;
    if (!found) continue;
    EXPECT_NEAR(found->side_m, 0.10, 0.002);
    const double place = place_error(*found, truth);
    const double yaw = std::abs(wrap_angle(found->yaw_rad - truth.yaw_rad));
    errors.place_rms_m += place * place;
    errors.yaw_rms_rad += yaw * yaw;
    errors.place_max_m = std::max(errors.place_max_m, place);
    errors.yaw_max_rad = std::max(errors.yaw_max_rad, yaw);
  }
  errors.place_rms_m = std::sqrt(errors.place_rms_m / images);
  errors.yaw_rms_rad = std::sqrt(errors.yaw_rms_rad / images);
  return errors;
}

TEST(Observer, FindsTheRobotToAMillimetreAllOverTheFloor) {
  Scene scene = corner_scene();
  const Errors errors = errors_over_the_floor(scene, corner_view(), 24);
  EXPECT_LT(errors.place_rms_m, 0.0005);
  EXPECT_LT(errors.place_max_m, 0.001);
  EXPECT_LT(errors.yaw_rms_rad, 0.3 * kRadPerDeg);
  EXPECT_LT(errors.yaw_max_rad, 0.6 * kRadPerDeg);
}

// Also from straight above, and with pixels of four points as a person reads them off an image.
TEST(Observer, FindsTheRobotWithoutTiltAndByPixelsThatWereReadOff) {
  Scene scene = corner_scene(SceneCamera{}, 2);
  camera::View view = corner_view();
  EXPECT_LT(errors_over_the_floor(scene, view, 8).place_max_m, 0.002);
  for (const camera::FloorMarker& marker : view.floor_markers) {
    const auto pixel = scene.camera().pixel({marker.world_m.x, marker.world_m.y, 0.0});
    view.floor_points.push_back({{std::round(pixel[0]), std::round(pixel[1])}, marker.world_m});
  }
  view.floor_markers.clear();
  EXPECT_LT(errors_over_the_floor(scene, view, 8).place_max_m, 0.003);
}

TEST(Observer, BlurNoiseAndMotionCostLessThanTwoMillimetres) {
  Scene scene = corner_scene(tilted_camera(), 3);
  const Twist twist{.vx_mps = 0.2, .yaw_rate_radps = 0.8};
  const SceneNoise noise{.blur_px = 1.3, .grey_sd = 6.0, .exposure_s = 0.02};
  const Errors errors = errors_over_the_floor(scene, corner_view(), 12, twist, noise);
  EXPECT_LT(errors.place_rms_m, 0.001);
  EXPECT_LT(errors.place_max_m, 0.002);
  EXPECT_LT(errors.yaw_rms_rad, 0.4 * kRadPerDeg);
}

TEST(Observer, TheMountedAngleOfTheMarkerIsTakenOut) {
  Scene scene = corner_scene();
  camera::View view = corner_view();
  view.marker_turned_rad = kPi / 2;
  const Pose truth{.x_m = 0.3, .y_m = 0.2, .yaw_rad = 0.5};
  const auto found = Observer(lens_of(scene.camera()), view).look(scene.image(truth));
  ASSERT_TRUE(found.has_value());
  EXPECT_NEAR(wrap_angle(found->yaw_rad - (0.5 - kPi / 2)), 0.0, 0.01);
}

TEST(Observer, SaysNothingWithoutTheMarkerOrTheFloor) {
  Scene scene = corner_scene();
  Observer observer(lens_of(scene.camera()), corner_view());
  EXPECT_FALSE(observer.look(scene.empty_floor({})).has_value());
  EXPECT_TRUE(observer.take_floor_news());
  EXPECT_TRUE(observer.floor().plane().has_value());
  // The marker was seen before and is now covered: the last place must not be reported.
  EXPECT_TRUE(observer.look(scene.image({.x_m = 0.1})).has_value());
  EXPECT_FALSE(observer.look(scene.empty_floor({})).has_value());

  Scene bare(tilted_camera(), 1);
  bare.carry(marker_bits(0), 0.10, 0.06);
  Observer lost(lens_of(bare.camera()), corner_view());
  EXPECT_FALSE(lost.look(bare.image({})).has_value());
  EXPECT_NE(lost.floor().problem(), "");
}

TEST(Observer, OnlyTheMarkerOfTheRightSizeIsOurs) {
  Scene two = corner_scene();
  two.lay(marker_bits(0), 0.12, -0.6, 0.3, 1.0);
  const Pose truth{.x_m = 0.5, .y_m = 0.1};
  const auto found = Observer(lens_of(two.camera()), corner_view()).look(two.image(truth));
  ASSERT_TRUE(found.has_value());
  EXPECT_LT(place_error(*found, truth), 0.002);
  Scene large = corner_scene();
  large.carry(marker_bits(0), 0.16, 0.06);
  EXPECT_FALSE(Observer(lens_of(large.camera()), corner_view()).look(large.image({})).has_value());
}

TEST(Observer, AnotherImageSizeIsAnError) {
  const SceneCamera camera;
  Observer observer(lens_of(camera), corner_view());
  EXPECT_THROW(observer.look(cv::Mat(720, 1280, CV_8U, cv::Scalar(0))), UserError);
}

TEST(Observer, ABumpedCameraIsNoticedAndTheFloorFoundAgain) {
  Scene before = corner_scene(tilted_camera(), 6);
  SceneCamera bumped = tilted_camera();
  bumped.tilt_x_rad += 0.02;
  Scene after = corner_scene(bumped, 6);
  Observer observer(lens_of(bumped), corner_view());
  const Pose truth{.x_m = -0.4, .y_m = 0.3, .yaw_rad = 1.0};
  const cv::Mat first = before.image(truth), second = after.image(truth);
  for (int i = 0; i < 25; ++i) observer.look(first);
  ASSERT_FALSE(observer.floor().needs_images());
  std::optional<camera::MarkerPose> found;
  for (int i = 0; i < 150; ++i) found = observer.look(second);
  EXPECT_EQ(observer.floor().moves(), 1);
  ASSERT_TRUE(found.has_value());
  EXPECT_LT(place_error(*found, truth), 0.002);
}

}  // namespace
}  // namespace tp100::test
