#pragma once
// Draws images of a robot on a floor under a camera from the laws of optics. It shares no code with
// daemon/camera: rays, projection and distortion are implemented here; OpenCV holds the images,
// blurs them, and draws noise and the markers' bits.
//
// World: z up. Camera frame: x right, y down, z along the view. Body: REP-103.

#include <array>
#include <cstdint>
#include <opencv2/core.hpp>
#include <vector>

#include "core/pose.h"

namespace tp100::test {

using Vec3 = cv::Vec3d;

/// A camera above the floor.
struct SceneCamera {
  int width_px = 1920, height_px = 1080;
  double focal_px = 1030.0;  ///< horizontal field of view of about 86 degrees
  double centre_x_px = 953.0, centre_y_px = 544.5;
  double k1 = 0.0, k2 = 0.0, p1 = 0.0, p2 = 0.0;
  Vec3 place_m{0.0, 0.0, 2.5};
  double tilt_x_rad = 0.0, tilt_y_rad = 0.0;  ///< tilt away from straight down
  double turned_rad = 0.0;                    ///< rotation about the view axis

  /// Pixel of a point of the world; pixel (0, 0) is the centre of the first pixel.
  std::array<double, 2> pixel(const Vec3& world_m) const;
  /// Direction of a pixel's ray in the world; `frame` is axes().
  Vec3 direction(double u_px, double v_px, const std::array<Vec3, 3>& frame) const;
  /// The x, y and z axes of the camera frame in the world.
  std::array<Vec3, 3> axes() const;
};

/// A flat image in space: `bits` from its top left corner along its columns and rows.
struct Decal {
  cv::Mat bits;
  Vec3 corner_m{};
  Vec3 across_m{};  ///< over the whole width
  Vec3 down_m{};    ///< over the whole height
};

struct SceneNoise {
  double blur_px = 0.7;     ///< standard deviation of the lens's blur
  double grey_sd = 2.5;     ///< standard deviation of the sensor's noise
  double exposure_s = 0.0;  ///< a moving robot is blurred by it
};

/// A floor with markers, and a robot that carries one.
class Scene {
 public:
  Scene(const SceneCamera& camera, std::uint64_t seed);

  /// Adds a marker on the floor, turned by `yaw_rad`.
  void lay(const cv::Mat& bits, double size_m, double x_m, double y_m, double yaw_rad);
  /// Puts a marker on the robot's back: `size_m` of black square, `height_m` above the footprint.
  void carry(const cv::Mat& bits, double size_m, double height_m);
  /// Adds a board at any place.
  void show(const Decal& decal);

  /// The image of the robot at `pose`, which is its pose in the middle of the exposure; the robot
  /// moves with `twist` (body frame) during the exposure.
  cv::Mat image(const Pose& pose, const Twist& twist = {}, const SceneNoise& noise = {});
  /// The image without a robot.
  cv::Mat empty_floor(const SceneNoise& noise);

  const SceneCamera& camera() const { return camera_; }

 private:
  cv::Mat background() const;
  const cv::Mat& still();
  void draw(cv::Mat& grey, const std::vector<std::vector<Decal>>& instants) const;
  std::vector<Decal> robot_at(const Pose& pose) const;
  cv::Mat finish(cv::Mat grey, const SceneNoise& noise);

  SceneCamera camera_;
  cv::RNG random_;
  std::vector<Decal> decals_;
  cv::Mat still_;  ///< everything static, drawn once
  cv::Mat marker_;
  double marker_size_m_ = 0.0, marker_height_m_ = 0.0;
  std::uint64_t clutter_;
};

}  // namespace tp100::test
