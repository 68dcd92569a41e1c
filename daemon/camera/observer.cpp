#include "camera/observer.h"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>
#include <utility>

#include "core/arithmetic.h"
#include "core/error.h"

namespace tp100::camera {
namespace {

constexpr int kAveraged = 20;
// A marker's centre has a noise of a fraction of a pixel; a bumped camera shows a larger, lasting
// offset.
constexpr double kMovedPx = 2.0;
constexpr int kOffInARow = 3;

const Marker* find(std::span<const Marker> markers, int id) {
  const Marker* found = nullptr;
  for (const Marker& marker : markers) {
    if (marker.id != id) continue;
    // If it is found twice, one of the two is somebody else's.
    if (found != nullptr) return nullptr;
    found = &marker;
  }
  return found;
}

// Number of images between two checks of the floor markers.
constexpr int kWholeEvery = 30;

}  // namespace

FloorMonitor::FloorMonitor(const Lens& lens, const View& view)
    : lens_(lens), view_(view), seen_(view.floor_markers.size()) {
  if (view.floor_points.empty()) {
    problem_ = "no floor marker was seen yet";
    return;
  }
  FloorFit fit = fit_floor(lens, view.floor_points);
  if (!fit.plane) throw UserError("floor: " + fit.problem + "; correct [[floor_point]]");
  plane_ = fit.plane;
}

bool FloorMonitor::update(std::span<const Marker> markers) {
  if (view_.floor_markers.empty()) return false;
  if (moved(markers)) {
    ++moves_;
    forget();
  }
  if (settled_) return false;
  bool news = false;
  for (std::size_t i = 0; i < seen_.size(); ++i) {
    const Marker* marker = find(markers, view_.floor_markers[i].id);
    if (marker == nullptr || seen_[i].count >= kAveraged) continue;
    seen_[i].sum += middle(*marker);
    ++seen_[i].count;
    news = true;
  }
  return news && refit();
}

bool FloorMonitor::moved(std::span<const Marker> markers) {
  int off = 0, good = 0;
  for (std::size_t i = 0; i < seen_.size(); ++i) {
    const Marker* marker = find(markers, view_.floor_markers[i].id);
    if (marker == nullptr || seen_[i].count == 0) continue;
    ++(cv::norm(middle(*marker) - seen_[i].mean()) > kMovedPx ? off : good);
  }
  if (off == 0 && good == 0) return false;
  // A person's foot may hide some markers; most of the visible ones must have moved.
  off_in_a_row_ = off > good ? off_in_a_row_ + 1 : 0;
  return off_in_a_row_ >= kOffInARow;
}

void FloorMonitor::forget() {
  for (MeanPosition& seen : seen_) seen = MeanPosition{};
  plane_.reset();
  settled_ = false;
  off_in_a_row_ = 0;
}

bool FloorMonitor::refit() {
  std::vector<FloorPoint> points;
  bool all = true;
  for (std::size_t i = 0; i < seen_.size(); ++i) {
    all = all && seen_[i].count >= kAveraged;
    if (seen_[i].count > 0) points.push_back({seen_[i].mean(), view_.floor_markers[i].world_m});
  }
  const bool had = plane_.has_value();
  const FloorFit fit = fit_floor(lens_, points);
  plane_ = fit.plane;
  problem_ = fit.problem;
  settled_ = all && plane_.has_value();
  return plane_.has_value() != had;
}

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

Observer::Observer(const Lens& lens, const View& view)
    : lens_(lens), view_(view), detector_(view.dictionary), floor_(lens, view) {
  floor_news_ = floor_.plane().has_value();
}

bool Observer::take_floor_news() { return std::exchange(floor_news_, false); }

/// An area of twice the marker's size around the last position, which it cannot leave between two
/// images at 30 images per second.
std::optional<cv::Rect> Observer::near_last() const {
  if (!last_ || floor_.needs_images() || since_whole_ >= kWholeEvery) return {};
  const std::vector<cv::Point2f> corners(last_->corners.begin(), last_->corners.end());
  const cv::Rect box = cv::boundingRect(corners);
  const int margin = 2 * std::max(box.width, box.height);
  return cv::Rect(box.x - margin, box.y - margin, box.width + 2 * margin, box.height + 2 * margin);
}

/// Among several markers with its id, the one whose size fits best.
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
    throw UserError("images are " + std::to_string(grey.cols) + "x" + std::to_string(grey.rows) +
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
