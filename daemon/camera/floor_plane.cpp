#include "camera/floor_plane.h"

#include <cmath>
#include <opencv2/calib3d.hpp>
#include <vector>

#include "core/arithmetic.h"
#include "text/format.h"

namespace tp100::camera {
namespace {

// A ray must meet the plane at least this steeply: sine of 6 degrees.
constexpr double kShallowest = 0.1;
constexpr double kLowestLensM = 0.1;
// Least ratio of the points' smaller to their larger axis; below it they are on a line.
constexpr double kThinnest = 0.03;

bool on_a_line(std::span<const FloorPoint> points) {
  cv::Point2d middle;
  for (const FloorPoint& point : points) middle += point.world_m;
  middle /= static_cast<double>(points.size());
  double xx = 0.0, xy = 0.0, yy = 0.0;
  for (const FloorPoint& point : points) {
    const cv::Point2d d = point.world_m - middle;
    xx += d.x * d.x;
    xy += d.x * d.y;
    yy += d.y * d.y;
  }
  const double half = (xx + yy) / 2.0;
  const double spread = magnitude((xx - yy) / 2.0, xy);
  return !(half - spread > kThinnest * kThinnest * (half + spread));
}

std::string text_of(double value) { return text::format("%.2f", value); }

}  // namespace

std::optional<cv::Point2d> FloorPlane::lift(const cv::Point2d& pixel, double height_m) const {
  const cv::Point2d ray = lens_.ray(pixel);
  const cv::Vec3d seen(ray.x, ray.y, 1.0);
  const cv::Vec3d direction = to_camera_.t() * seen;
  if (!(direction[2] < -kShallowest * cv::norm(seen)) || !(height_m < lens_m_.z)) return {};
  const double along = (height_m - lens_m_.z) / direction[2];
  return cv::Point2d(lens_m_.x + along * direction[0], lens_m_.y + along * direction[1]);
}

cv::Point2d FloorPlane::pixel(const cv::Point3d& world_m) const {
  const cv::Vec3d seen = to_camera_ * cv::Vec3d(world_m.x, world_m.y, world_m.z) + shift_;
  return lens_.pixel({seen[0] / seen[2], seen[1] / seen[2]});
}

FloorFit fit_floor(const Lens& lens, std::span<const FloorPoint> points) {
  if (points.size() < 4) return {{}, "fewer than four points on the floor"};
  if (on_a_line(points)) return {{}, "the points on the floor lie on one line"};
  std::vector<cv::Point3d> world;
  std::vector<cv::Point2d> rays;
  for (const FloorPoint& point : points) {
    world.emplace_back(point.world_m.x, point.world_m.y, 0.0);
    rays.push_back(lens.ray(point.pixel));
  }
  FloorPlane plane;
  plane.lens_ = lens;
  cv::Vec3d turn;
  try {
    // Starts from a homography and refines it: with points metres apart there is no second solution
    // nearby, as there is for one small marker.
    if (!cv::solvePnP(world, rays, cv::Matx33d::eye(), cv::noArray(), turn, plane.shift_, false,
                      cv::SOLVEPNP_ITERATIVE)) {
      return {{}, "no camera pose fits the points on the floor"};
    }
    cv::Rodrigues(turn, plane.to_camera_);
  } catch (const cv::Exception&) {
    return {{}, "no camera pose fits the points on the floor"};
  }
  const cv::Vec3d lens_m = -(plane.to_camera_.t() * plane.shift_);
  plane.lens_m_ = {lens_m[0], lens_m[1], lens_m[2]};
  double sum = 0.0;
  for (const FloorPoint& point : points) {
    const cv::Point2d off = plane.pixel({point.world_m.x, point.world_m.y, 0.0}) - point.pixel;
    sum += off.dot(off);
  }
  plane.rms_px_ = std::sqrt(sum / static_cast<double>(points.size()));
  if (!(plane.rms_px_ <= kMaxFloorRmsPx))
    return {{}, "the points on the floor miss their pixels by " + text_of(plane.rms_px_) + " px"};
  if (lens_m[2] < -kLowestLensM)
    return {{}, "the points on the floor are mirrored: check the sign of y"};
  if (!(lens_m[2] > kLowestLensM))
    return {{}, "the lens would hang " + text_of(lens_m[2]) + " m above the floor"};
  return {plane, {}};
}

}  // namespace tp100::camera
