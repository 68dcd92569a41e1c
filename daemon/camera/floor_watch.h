#pragma once
// The floor as the camera sees it: from fixed points, or from markers on the floor that are
// averaged over the first pictures and watched from then on.

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "camera/floor_plane.h"
#include "camera/marker_detector.h"
#include "camera/view.h"

namespace tp100::camera {

class FloorWatch {
 public:
  /// Throws SetupError if the view's floor points make no plane.
  FloorWatch(const Lens& lens, const View& view);

  /// Markers of a picture. True: the plane was found anew or has moved.
  bool update(std::span<const Marker> markers);
  /// False: enough pictures are averaged; only a moved camera would need more.
  bool hungry() const { return !view_.floor_markers.empty() && !settled_; }
  const std::optional<FloorPlane>& plane() const { return plane_; }
  /// Why there is no plane yet.
  const std::string& problem() const { return problem_; }
  /// Times that the camera, or a marker on the floor, was found to have moved.
  int moves() const { return moves_; }

 private:
  struct Seen {
    cv::Point2d sum;
    int count = 0;
    cv::Point2d mean() const { return sum / static_cast<double>(count); }
  };
  bool moved(std::span<const Marker> markers);
  void forget();
  bool refit();

  Lens lens_;
  View view_;
  std::vector<Seen> seen_;
  std::optional<FloorPlane> plane_;
  std::string problem_;
  bool settled_ = false;
  int off_in_a_row_ = 0;
  int moves_ = 0;
};

}  // namespace tp100::camera
