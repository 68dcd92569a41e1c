#include "camera/observer.h"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>
#include <utility>

#include "core/error.h"

namespace tp100::camera {
namespace {

// Whether the floor markers are still where they were is looked at this often.
constexpr int kWholeEvery = 30;

}  // namespace

Observer::Observer(const Lens& lens, const View& view)
    : lens_(lens), view_(view), detector_(view.dictionary), floor_(lens, view) {
  floor_news_ = floor_.plane().has_value();
}

bool Observer::take_floor_news() { return std::exchange(floor_news_, false); }

/// Twice the marker's size around where it was: at 30 pictures per second it cannot be further.
std::optional<cv::Rect> Observer::near_last() const {
  if (!last_ || floor_.hungry() || since_whole_ >= kWholeEvery) return {};
  const std::vector<cv::Point2f> corners(last_->corners.begin(), last_->corners.end());
  const cv::Rect box = cv::boundingRect(corners);
  const int margin = 2 * std::max(box.width, box.height);
  return cv::Rect(box.x - margin, box.y - margin, box.width + 2 * margin, box.height + 2 * margin);
}

/// Of several with its id the one whose size fits best.
const Marker* Observer::robot_marker(const std::vector<Marker>& markers, MarkerPose& pose) const {
  const Marker* best = nullptr;
  double best_error = 0.0;
  for (const Marker& marker : markers) {
    if (marker.id != view_.marker_id) continue;
    const auto found = marker_pose(*floor_.plane(), view_, marker);
    if (!found) continue;
    const double error = std::abs(found->side_m - view_.marker_size_m);
    if (best != nullptr && error >= best_error) continue;
    best = &marker;
    best_error = error;
    pose = *found;
  }
  return best;
}

std::optional<MarkerPose> Observer::look(const cv::Mat& grey) {
  if (grey.cols != lens_.width_px || grey.rows != lens_.height_px) {
    throw SetupError("pictures are " + std::to_string(grey.cols) + "x" + std::to_string(grey.rows) +
                     ", the lens was calibrated at " + std::to_string(lens_.width_px) + "x" +
                     std::to_string(lens_.height_px) + "; calibrate it at the size in use");
  }
  MarkerPose pose;
  if (const auto part = near_last(); part && floor_.plane()) {
    const std::vector<Marker> markers = detector_.find(grey, part);
    if (const Marker* marker = robot_marker(markers, pose)) {
      last_ = *marker;
      ++since_whole_;
      return pose;
    }
  }
  last_.reset();
  since_whole_ = 0;
  const std::vector<Marker> markers = detector_.find(grey);
  floor_news_ = floor_.update(markers) || floor_news_;
  if (!floor_.plane()) return {};
  const Marker* marker = robot_marker(markers, pose);
  if (marker == nullptr) return {};
  last_ = *marker;
  return pose;
}

}  // namespace tp100::camera
