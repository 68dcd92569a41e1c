#include "camera/marker_pose.h"

#include <cmath>

#include "core/angle.h"

namespace tp100::camera {

std::optional<MarkerPose> marker_pose(const FloorPlane& plane, const View& view,
                                      const Marker& marker) {
  std::array<cv::Point2d, 4> corners;
  for (std::size_t i = 0; i < 4; ++i) {
    const auto place = plane.lift(marker.corners[i], view.marker_height_m);
    if (!place) return {};
    corners[i] = *place;
  }
  MarkerPose pose;
  for (std::size_t i = 0; i < 4; ++i)
    pose.side_m += cv::norm(corners[(i + 1) % 4] - corners[i]) / 4.0;
  if (!(std::abs(pose.side_m / view.marker_size_m - 1.0) < kMaxSideError)) return {};
  const cv::Point2d sum = corners[0] + corners[1] + corners[2] + corners[3];
  pose.x_m = sum.x / 4.0;
  pose.y_m = sum.y / 4.0;
  // Clockwise from the top left: the first two are the front edge.
  const cv::Point2d ahead = corners[0] + corners[1] - corners[2] - corners[3];
  pose.yaw_rad = wrap_angle(std::atan2(ahead.y, ahead.x) - view.marker_turned_rad);
  return pose;
}

}  // namespace tp100::camera
