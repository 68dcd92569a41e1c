#pragma once
// The camera's pose, from points on the floor, and with it the position of anything whose height is
// known.
//
// World frame: z up from the floor, x and y as the floor points give them (the course's). In an
// image taken straight down, counterclockwise turns on the floor are counterclockwise.

#include <opencv2/core.hpp>
#include <optional>
#include <span>
#include <string>

#include "camera/lens.h"

namespace tp100::camera {

/// A point on the floor and the pixel that shows it.
struct FloorPoint {
  cv::Point2d pixel;
  cv::Point2d world_m;
};

struct FloorFit;

class FloorPlane {
 public:
  /// World position, at `height_m` above the floor, of what a pixel shows: the plane's homography,
  /// projected from the floor towards the lens. Nothing if the pixel's ray does not meet that plane
  /// from above.
  std::optional<cv::Point2d> lift(const cv::Point2d& pixel, double height_m) const;
  /// Pixel that shows a point of the world.
  cv::Point2d pixel(const cv::Point3d& world_m) const;
  /// Position of the lens in the world.
  const cv::Point3d& lens_m() const { return lens_m_; }
  /// Distance between the floor points' measured and predicted pixels, root mean square.
  double rms_px() const { return rms_px_; }

 private:
  friend FloorFit fit_floor(const Lens& lens, std::span<const FloorPoint> points);
  Lens lens_{};
  cv::Matx33d to_camera_ = cv::Matx33d::eye();
  cv::Vec3d shift_{};
  cv::Point3d lens_m_{};
  double rms_px_ = 0.0;
};

/// The plane, or why there is none.
struct FloorFit {
  std::optional<FloorPlane> plane;
  std::string problem;
};

/// Fits the camera's position and direction to at least four points, not all on one line. Rejects
/// points whose residual exceeds kMaxFloorRmsPx, that lie on one line, or that are mirrored.
FloorFit fit_floor(const Lens& lens, std::span<const FloorPoint> points);

inline constexpr double kMaxFloorRmsPx = 5.0;

}  // namespace tp100::camera
