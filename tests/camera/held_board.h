#pragma once
// A calibration board held by hand in front of a small camera.

#include <cmath>
#include <vector>

#include "scene.h"

namespace tp100::test {

/// A small camera, for which many images are drawn quickly.
inline SceneCamera small_camera(const Vec3& place_m, double k1, double k2) {
  SceneCamera camera;
  camera.width_px = 960;
  camera.height_px = 540;
  camera.focal_px = 560.0;
  camera.centre_x_px = 471.0;
  camera.centre_y_px = 281.0;
  camera.k1 = k1;
  camera.k2 = k2;
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

/// Images of a board that is held in all parts of the view, at these places, each time turned by
/// `turn_rad` more.
inline std::vector<cv::Mat> held_all_over(const SceneCamera& camera, const cv::Mat& bits,
                                          double width_m, const std::vector<double>& xs,
                                          const std::vector<double>& ys, double turn_rad) {
  std::vector<cv::Mat> images;
  for (const double x : xs) {
    for (const double y : ys) {
      const int i = static_cast<int>(images.size());
      Scene scene(camera, 1);
      scene.show(held(bits, width_m, {x, y, 0.05 + 0.03 * (i % 3)}, 0.35 * std::sin(2.1 * i),
                      0.35 * std::cos(1.7 * i), turn_rad * i));
      images.push_back(scene.empty_floor({.blur_px = 0.6, .grey_sd = 2.0}));
    }
  }
  return images;
}

}  // namespace tp100::test
