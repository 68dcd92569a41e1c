#include "camera/floor_watch.h"

#include "core/error.h"

namespace tp100::camera {
namespace {

constexpr int kAveraged = 20;
// Noise of a marker's middle is a fraction of a pixel; a bumped camera shows more, and stays so.
constexpr double kMovedPx = 2.0;
constexpr int kOffInARow = 3;

const Marker* find(std::span<const Marker> markers, int id) {
  const Marker* found = nullptr;
  for (const Marker& marker : markers) {
    if (marker.id != id) continue;
    // Seen twice, one of them is not ours.
    if (found != nullptr) return nullptr;
    found = &marker;
  }
  return found;
}

}  // namespace

FloorWatch::FloorWatch(const Lens& lens, const View& view)
    : lens_(lens), view_(view), seen_(view.floor_markers.size()) {
  if (view.floor_points.empty()) {
    problem_ = "no floor marker was seen yet";
    return;
  }
  FloorFit fit = fit_floor(lens, view.floor_points);
  if (!fit.plane) throw SetupError("floor: " + fit.problem + "; correct [[floor_point]]");
  plane_ = fit.plane;
}

bool FloorWatch::update(std::span<const Marker> markers) {
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

bool FloorWatch::moved(std::span<const Marker> markers) {
  int off = 0, good = 0;
  for (std::size_t i = 0; i < seen_.size(); ++i) {
    const Marker* marker = find(markers, view_.floor_markers[i].id);
    if (marker == nullptr || seen_[i].count == 0) continue;
    ++(cv::norm(middle(*marker) - seen_[i].mean()) > kMovedPx ? off : good);
  }
  if (off == 0 && good == 0) return false;
  // A person's foot may hide some; what is seen must agree.
  off_in_a_row_ = off > good ? off_in_a_row_ + 1 : 0;
  return off_in_a_row_ >= kOffInARow;
}

void FloorWatch::forget() {
  for (Seen& seen : seen_) seen = Seen{};
  plane_.reset();
  settled_ = false;
  off_in_a_row_ = 0;
}

bool FloorWatch::refit() {
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

}  // namespace tp100::camera
