// Compares three computations of the place where an overhead camera sees a tilted robot:
// tp100-camera on a drawn image, the emulated camera, and the estimator's expectation.

#include <gtest/gtest.h>

#include <cmath>

#include "camera/observer.h"
#include "core/arithmetic.h"
#include "estimation/pose_filter.h"
#include "marker_scene.h"
#include "sim/sensors/overhead_camera.h"

namespace tp100::test {
namespace {

struct Seen {
  double x_m, y_m, yaw_rad;
};

constexpr double kHeightM = 2.5;

/// A camera at the place of the emulated camera. Its tilt has no effect: only the place of the lens
/// matters.
SceneCamera hanging() {
  SceneCamera camera = tilted_camera();
  camera.place_m = {0.2, -0.1, kHeightM};
  return camera;
}

Seen rendered(Scene& scene, const Pose& pose) {
  camera::Observer observer(lens_of(scene.camera()), corner_view());
  const auto found = observer.look(scene.image(pose));
  EXPECT_TRUE(found.has_value());
  return found ? Seen{found->x_m, found->y_m, found->yaw_rad} : Seen{};
}

Seen emulated(const Pose& pose) {
  course::EmulatedCamera values;
  values.noise_m = values.noise_rad = values.bias_m = values.dropped = values.stamp_error_s = 0.0;
  values.height_m = kHeightM;
  values.offset_x_m = 0.2;
  values.offset_y_m = -0.1;
  sim::OverheadCamera camera(values, 0.0, 0.0, 1);
  std::optional<CameraSample> last;
  for (HostNs now = 0; now < 300 * kNsPerMs; now += kNsPerMs) {
    camera.look(pose, now);
    while (const auto sample = camera.take(now)) last = sample;
  }
  EXPECT_TRUE(last.has_value());
  return last ? Seen{last->x_m, last->y_m, last->yaw_rad} : Seen{};
}

Seen expected(const Pose& pose) {
  estimation::CameraParameters camera;
  camera.height_m = kHeightM;
  const Eigen::Vector3d marker = estimation::expected_marker(
      {pose.x_m, pose.y_m, pose.yaw_rad},
      {.z_m = pose.z_m, .roll_rad = pose.roll_rad, .pitch_rad = pose.pitch_rad}, camera,
      {0.2, -0.1});
  return {marker[0], marker[1], marker[2]};
}

void expect_agreement(Scene& scene, const Pose& pose) {
  const Seen image = rendered(scene, pose), sensor = emulated(pose), estimate = expected(pose);
  EXPECT_LT(std::hypot(image.x_m - sensor.x_m, image.y_m - sensor.y_m), 0.001);
  EXPECT_LT(std::hypot(image.x_m - estimate.x_m, image.y_m - estimate.y_m), 0.001);
  EXPECT_NEAR(wrap_angle(image.yaw_rad - sensor.yaw_rad), 0.0, 0.7 * kRadPerDeg);
  EXPECT_NEAR(wrap_angle(image.yaw_rad - estimate.yaw_rad), 0.0, 0.7 * kRadPerDeg);
}

TEST(TiltedRobot, AMarkerSixtyMillimetresUpFallsBackBy28AtTwentyEightDegrees) {
  Scene scene = corner_scene(hanging(), 1);
  // The robot is below the lens, so that only the tilt shifts the marker.
  const Pose pose{.x_m = 0.2, .y_m = -0.1, .pitch_rad = -28.0 * kRadPerDeg};
  EXPECT_NEAR(rendered(scene, pose).x_m - pose.x_m, -0.06 * std::sin(28.0 * kRadPerDeg), 0.001);
  expect_agreement(scene, pose);
}

TEST(TiltedRobot, TheThreeAgreeOnRampsAllOverTheFloor) {
  Scene scene = corner_scene(hanging(), 2);
  for (const Pose& pose :
       {Pose{.x_m = 0.9, .y_m = 0.4, .z_m = 0.08, .pitch_rad = -28.0 * kRadPerDeg, .yaw_rad = 0.6},
        Pose{.x_m = -0.8, .y_m = 0.5, .z_m = 0.12, .pitch_rad = 28.0 * kRadPerDeg, .yaw_rad = 2.1},
        Pose{.x_m = -0.2,
        .y_m = -0.5,
        .z_m = 0.03,
        .pitch_rad = -15.0 * kRadPerDeg,
        .yaw_rad = -1.2},
        Pose{.x_m = 0.6, .y_m = -0.4, .z_m = 0.02, .roll_rad = 8.0 * kRadPerDeg, .yaw_rad = 3.0},
        Pose{.x_m = 1.0, .y_m = 0.1, .yaw_rad = -2.6}}) {
    SCOPED_TRACE(pose.yaw_rad);
    expect_agreement(scene, pose);
  }
}

TEST(TiltedRobot, AcrossTheSlopeItLooksTurnedByDegreesAndTheThreeAgree) {
  Scene scene = corner_scene(hanging(), 3);
  const Pose pose{.x_m = 0.2, .y_m = 0.55, .z_m = 0.05, .pitch_rad = -28.0 * kRadPerDeg};
  EXPECT_GT(rendered(scene, pose).yaw_rad, 3.0 * kRadPerDeg);
  expect_agreement(scene, pose);
}

}  // namespace
}  // namespace tp100::test
