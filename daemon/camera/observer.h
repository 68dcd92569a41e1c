#pragma once
// Pictures in, poses out: detector, floor and marker joined. No clock, no files.

#include <cstdint>
#include <optional>
#include <string>

#include "camera/floor_watch.h"
#include "camera/lens.h"
#include "camera/marker_detector.h"
#include "camera/marker_pose.h"
#include "camera/view.h"

namespace tp100::camera {

class Observer {
 public:
  /// Throws SetupError.
  Observer(const Lens& lens, const View& view);

  /// Looks at a grey picture of 8 bits. Nothing if the marker is not in it or the floor is not
  /// known yet. Throws SetupError for a picture of another size than the lens's.
  std::optional<MarkerPose> look(const cv::Mat& grey);

  const FloorWatch& floor() const { return floor_; }
  /// True once after the floor was found or found anew.
  bool take_floor_news();

 private:
  std::optional<cv::Rect> near_last() const;
  const Marker* robot_marker(const std::vector<Marker>& markers, MarkerPose& pose) const;

  Lens lens_;
  View view_;
  MarkerDetector detector_;
  FloorWatch floor_;
  std::optional<Marker> last_;
  int since_whole_ = 0;
  bool floor_news_ = false;
};

}  // namespace tp100::camera
