#pragma once
// Detects ArUco markers in an image, with subpixel corners. Uses OpenCV 4.6's interface: the free
// function of the contrib module.

#include <array>
#include <opencv2/aruco.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace tp100::camera {

/// Names of the dictionaries in view files, "4x4_50" and so on.
const std::vector<std::string_view>& dictionary_names();
/// The dictionary of that name, which must be one of these.
cv::Ptr<cv::aruco::Dictionary> dictionary_named(std::string_view name);

/// Corners of the black square, clockwise as seen, from the marker's own top left one.
struct Marker {
  int id = 0;
  std::array<cv::Point2f, 4> corners{};
};

/// Where the diagonals cross: the middle of the marker, whatever the perspective.
cv::Point2d middle(const Marker& marker);

class MarkerDetector {
 public:
  explicit MarkerDetector(std::string_view dictionary);

  /// Finds markers in a grey image of 8 bits, or in the given part of it.
  std::vector<Marker> find(const cv::Mat& grey, const std::optional<cv::Rect>& part = {}) const;

 private:
  cv::Ptr<cv::aruco::Dictionary> dictionary_;
  cv::Ptr<cv::aruco::DetectorParameters> parameters_;
};

}  // namespace tp100::camera
