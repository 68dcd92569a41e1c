#pragma once
// A calibration board held by hand in front of a small camera.

#include <cmath>

#include "scene.h"

namespace tp100::test {

/// A small camera, for which many images are drawn quickly. Its lens has no distortion by default.
inline SceneCamera small_camera(const Vec3& place_m) {
  SceneCamera camera;
  camera.width_px = 960;
  camera.height_px = 540;
  camera.focal_px = 560.0;
  camera.centre_x_px = 471.0;
  camera.centre_y_px = 281.0;
  camera.place_m = place_m;
  return camera;
}

/// A decal of `bits`, `width_m` wide and centred at `middle`, tilted about two axes and turned.
/// [rad]
inline Decal held(const cv::Mat& bits, double width_m, const Vec3& middle, double tilt_x,
                  double tilt_y, double turn = 0.0) {
  const double height_m = width_m * bits.rows / bits.cols;
  const double cx = std::cos(tilt_x), sx = std::sin(tilt_x);
  const double cy = std::cos(tilt_y), sy = std::sin(tilt_y);
  const Vec3 right = {cy, sx * sy, -cx * sy}, down = {0.0, -cx, -sx};
  const double ct = std::cos(turn), st = std::sin(turn);
  const Vec3 across = width_m * (ct * right + st * down);
  const Vec3 descent = height_m * (ct * down - st * right);
  return {bits, middle - 0.5 * (across + descent), across, descent};
}

}  // namespace tp100::test
