#pragma once
// Pictures of a robot on a floor under a camera, drawn from the laws of optics. It shares no code
// with daemon/camera: rays, projection, distortion, blur and noise are its own; OpenCV only holds
// the pictures and draws the markers' bits.
//
// World: z up. Camera frame: x right, y down, z along the view. Body: REP-103.

#include <array>
#include <cstdint>
#include <opencv2/core.hpp>
#include <random>
#include <vector>

#include "core/pose.h"

namespace tp100::test {

using Vec3 = std::array<double, 3>;

/// A camera that hangs over the floor.
struct SceneCamera {
  int width_px = 1920, height_px = 1080;
  double focal_px = 1030.0;  ///< about 86 degrees across
  double centre_x_px = 953.0, centre_y_px = 544.5;
  double k1 = 0.0, k2 = 0.0, p1 = 0.0, p2 = 0.0;
  Vec3 place_m{0.0, 0.0, 2.5};
  double tilt_x_rad = 0.0, tilt_y_rad = 0.0;  ///< away from straight down
  double turned_rad = 0.0;                    ///< about its own view

  /// Pixel of a point of the world; pixel (0, 0) is the middle of the first.
  std::array<double, 2> pixel(const Vec3& world_m) const;
  /// Direction in the world in which a pixel looks.
  Vec3 direction(double u_px, double v_px) const;
  /// The same; `frame` is axes().
  Vec3 direction(double u_px, double v_px, const std::array<Vec3, 3>& frame) const;
  /// In the world: x, y and z of the camera frame.
  std::array<Vec3, 3> axes() const;
};

/// A flat picture in space: `bits` from its top left corner along its columns and rows.
struct Decal {
  cv::Mat bits;
  Vec3 corner_m{};
  Vec3 across_m{};  ///< whole width
  Vec3 down_m{};    ///< whole height
};

struct SceneNoise {
  double blur_px = 0.7;     ///< standard deviation of the lens's blur
  double grey_sd = 2.5;     ///< of the sensor
  double exposure_s = 0.0;  ///< of a moving robot
};

/// A floor with markers on it and a robot with one on its back.
class Scene {
 public:
  Scene(const SceneCamera& camera, std::uint64_t seed);

  /// A marker that lies on the floor, turned by `yaw_rad`.
  void lay(const cv::Mat& bits, double size_m, double x_m, double y_m, double yaw_rad);
  /// The marker on the robot's back: `size_m` of black square, `height_m` above the footprint.
  void carry(const cv::Mat& bits, double size_m, double height_m);
  /// A board anywhere.
  void show(const Decal& decal);

  /// The picture of the robot at `pose`, which moves with `twist` (body frame) while the shutter is
  /// open; `pose` is that of the middle of the exposure.
  cv::Mat picture(const Pose& pose, const Twist& twist, const SceneNoise& noise);
  cv::Mat picture(const Pose& pose) { return picture(pose, {}, {}); }
  /// Without a robot.
  cv::Mat empty_floor(const SceneNoise& noise);

  const SceneCamera& camera() const { return camera_; }

 private:
  cv::Mat background() const;
  const cv::Mat& still();
  void draw(cv::Mat& grey, const std::vector<std::vector<Decal>>& instants) const;
  std::vector<Decal> robot_at(const Pose& pose) const;
  cv::Mat finish(cv::Mat grey, const SceneNoise& noise);

  SceneCamera camera_;
  std::mt19937_64 random_;
  std::vector<Decal> decals_;
  cv::Mat still_;  ///< all that does not move, once drawn
  cv::Mat marker_;
  double marker_size_m_ = 0.0, marker_height_m_ = 0.0;
  std::uint64_t clutter_;
};

}  // namespace tp100::test
