#pragma once
// Computes poses from images with detector, floor and marker. No clock, no files.

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "camera/floor_plane.h"
#include "camera/lens.h"
#include "camera/marker_detector.h"
#include "camera/view.h"

namespace tp100::camera {

/// The floor's plane in the camera's images: from fixed points, or from floor markers that are
/// averaged over the first images and monitored from then on.
class FloorMonitor {
 public:
  /// Throws UserError if the view's floor points do not define a plane.
  FloorMonitor(const Lens& lens, const View& view);

  /// Takes the markers of an image. True: the plane was found again or has moved.
  bool update(std::span<const Marker> markers);
  /// False: enough images are averaged; only a moved camera would need more.
  bool needs_images() const { return !view_.floor_markers.empty() && !settled_; }
  const std::optional<FloorPlane>& plane() const { return plane_; }
  /// Why there is no plane yet.
  const std::string& problem() const { return problem_; }
  /// How often the camera, or a marker on the floor, was found to have moved.
  int moves() const { return moves_; }

 private:
  struct MeanPosition {
    cv::Point2d sum;
    int count = 0;
    cv::Point2d mean() const { return sum / static_cast<double>(count); }
  };
  bool moved(std::span<const Marker> markers);
  void forget();
  bool refit();

  Lens lens_;
  View view_;
  std::vector<MeanPosition> seen_;
  std::optional<FloorPlane> plane_;
  std::string problem_;
  bool settled_ = false;
  int off_in_a_row_ = 0;
  int moves_ = 0;
};

/// Position and heading of the robot from the four corners of its marker. In the world frame, as
/// seen in the plane at the marker's height (core/sample.h).
struct MarkerPose {
  double x_m = 0.0;  ///< middle
  double y_m = 0.0;
  double yaw_rad = 0.0;  ///< -pi to pi: direction of the robot's front
  double side_m = 0.0;   ///< mean side as seen; the marker's true side if robot and plane are level
};

/// Projects the corners to the marker's height. Nothing if the marker has another size: a side
/// differs by more than kMaxSideError of the size (a tilted marker looks shorter).
///
/// The heading is that of the line through the centres of the front and the back edge, not the mean
/// of all four: where the robot tilts, only that line turns as the estimator expects.
std::optional<MarkerPose> marker_pose(const FloorPlane& plane, const View& view,
                                      const Marker& marker);

inline constexpr double kMaxSideError = 0.35;

class Observer {
 public:
  /// Throws UserError.
  Observer(const Lens& lens, const View& view);

  /// Processes a grey image of 8 bits. Nothing if it does not contain the marker or the floor is
  /// not known yet. Throws UserError for an image of another size than the lens's.
  std::optional<MarkerPose> look(const cv::Mat& grey);

  const FloorMonitor& floor() const { return floor_; }
  /// True once after the floor was found, for the first time or again.
  bool take_floor_news();

 private:
  std::optional<cv::Rect> near_last() const;
  const Marker* robot_marker(const std::vector<Marker>& markers, MarkerPose& pose) const;

  Lens lens_;
  View view_;
  MarkerDetector detector_;
  FloorMonitor floor_;
  std::optional<Marker> last_;
  int since_whole_ = 0;
  bool floor_news_ = false;
};

}  // namespace tp100::camera
