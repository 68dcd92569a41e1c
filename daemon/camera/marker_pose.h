#pragma once
// Place and direction of the robot from the four corners of its marker.

#include <optional>

#include "camera/floor_plane.h"
#include "camera/marker_detector.h"
#include "camera/view.h"

namespace tp100::camera {

/// In the world frame, as seen in the plane at the marker's height (core/camera_sample.h).
struct MarkerPose {
  double x_m = 0.0;  ///< middle
  double y_m = 0.0;
  double yaw_rad = 0.0;  ///< -pi to pi: direction of the robot's front
  double side_m = 0.0;   ///< mean side as seen; the marker's own where robot and plane are level
};

/// Lifts the corners to the marker's height. Nothing if that is no such marker: a side that differs
/// by more than kMaxSideError of the size (a marker that tilts looks shorter).
///
/// The direction is that of the line through the middles of the front and the back edge, not the
/// mean of all four: where the robot tilts, only that line turns as the estimator expects.
std::optional<MarkerPose> marker_pose(const FloorPlane& plane, const View& view,
                                      const Marker& marker);

inline constexpr double kMaxSideError = 0.35;

}  // namespace tp100::camera
