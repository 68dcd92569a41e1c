#pragma once
// The scene of most tests: a camera 2.5 m above a floor with a marker in each corner, and the
// configuration of tp100-camera for it.

#include <opencv2/aruco.hpp>

#include "camera/lens.h"
#include "camera/view.h"
#include "scene.h"

namespace tp100::test {

inline cv::Mat marker_bits(int id, int pixels = 240) {
  cv::Mat bits;
  cv::aruco::drawMarker(cv::aruco::getPredefinedDictionary(cv::aruco::DICT_4X4_50), id, pixels,
                        bits);
  return bits;
}

/// A camera that is off-centre and tilted, and whose lens has distortion.
inline SceneCamera tilted_camera() {
  SceneCamera camera;
  camera.k1 = -0.09;
  camera.k2 = 0.02;
  camera.p1 = 0.0006;
  camera.p2 = -0.0009;
  camera.place_m = {0.15, -0.1, 2.5};
  camera.tilt_x_rad = 0.06;
  camera.tilt_y_rad = -0.045;
  camera.turned_rad = 0.3;
  return camera;
}

inline camera::Lens lens_of(const SceneCamera& scene) {
  return {.width_px = scene.width_px,
          .height_px = scene.height_px,
          .fx_px = scene.focal_px,
          .fy_px = scene.focal_px,
          .cx_px = scene.centre_x_px,
          .cy_px = scene.centre_y_px,
          .k1 = scene.k1,
          .k2 = scene.k2,
          .p1 = scene.p1,
          .p2 = scene.p2};
}

inline camera::View corner_view() {
  camera::View view;
  view.lens = "lens.toml";
  view.floor_markers = {{10, {-1.2, -0.7}}, {11, {1.2, -0.7}}, {12, {1.2, 0.7}}, {13, {-1.2, 0.7}}};
  return view;
}

inline Scene corner_scene(const SceneCamera& camera = tilted_camera(), std::uint64_t seed = 1) {
  Scene scene(camera, seed);
  double yaw_rad = 0.4;
  for (const camera::FloorMarker& marker : corner_view().floor_markers)
    scene.lay(marker_bits(marker.id), 0.12, marker.world_m.x, marker.world_m.y, yaw_rad += 0.8);
  scene.carry(marker_bits(0), 0.10, 0.06);
  return scene;
}

}  // namespace tp100::test
