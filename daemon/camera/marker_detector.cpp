#include "camera/marker_detector.h"

#include <algorithm>
#include <opencv2/imgproc.hpp>
#include <utility>

namespace tp100::camera {
namespace {

constexpr std::array<std::pair<std::string_view, cv::aruco::PREDEFINED_DICTIONARY_NAME>, 11>
    kNames = {{{"4x4_50", cv::aruco::DICT_4X4_50},
               {"4x4_100", cv::aruco::DICT_4X4_100},
               {"4x4_250", cv::aruco::DICT_4X4_250},
               {"5x5_50", cv::aruco::DICT_5X5_50},
               {"5x5_100", cv::aruco::DICT_5X5_100},
               {"5x5_250", cv::aruco::DICT_5X5_250},
               {"6x6_50", cv::aruco::DICT_6X6_50},
               {"6x6_250", cv::aruco::DICT_6X6_250},
               {"original", cv::aruco::DICT_ARUCO_ORIGINAL},
               {"apriltag_25h9", cv::aruco::DICT_APRILTAG_25h9},
               {"apriltag_36h11", cv::aruco::DICT_APRILTAG_36h11}}};

// The window around a corner must not reach the next module, whose edges would bias it.
constexpr double kWindowShare = 0.6;
constexpr int kLargestWindow = 12;

double shortest_side(const std::array<cv::Point2f, 4>& corners) {
  double shortest = 1e9;
  for (std::size_t i = 0; i < 4; ++i)
    shortest = std::min(shortest, cv::norm(corners[i] - corners[(i + 1) % 4]));
  return shortest;
}

}  // namespace

const std::vector<std::string_view>& dictionary_names() {
  static const std::vector<std::string_view> kAll = [] {
    std::vector<std::string_view> names;
    names.reserve(std::size(kNames));
    for (const auto& [name, number] : kNames) names.push_back(name);
    return names;
  }();
  return kAll;
}

cv::Ptr<cv::aruco::Dictionary> dictionary_named(std::string_view name) {
  for (const auto& [known, number] : kNames)
    if (known == name) return cv::aruco::getPredefinedDictionary(number);
  return cv::aruco::getPredefinedDictionary(kNames.front().second);
}

cv::Point2d middle(const Marker& marker) {
  const cv::Point2d a = marker.corners[0], b = marker.corners[1];
  const cv::Point2d along = cv::Point2d(marker.corners[2]) - a;
  const cv::Point2d across = cv::Point2d(marker.corners[3]) - b;
  const double share = (b - a).cross(across) / along.cross(across);
  return a + along * share;
}

MarkerDetector::MarkerDetector(std::string_view dictionary)
    : dictionary_(dictionary_named(dictionary)),
      parameters_(cv::aruco::DetectorParameters::create()) {
  parameters_->cornerRefinementMethod = cv::aruco::CORNER_REFINE_NONE;
}

std::vector<Marker> MarkerDetector::find(const cv::Mat& grey,
                                         const std::optional<cv::Rect>& part) const {
  const cv::Rect whole(0, 0, grey.cols, grey.rows);
  const cv::Rect where = part ? *part & whole : whole;
  if (where.width < 16 || where.height < 16) return {};
  std::vector<std::vector<cv::Point2f>> corners;
  std::vector<int> ids;
  cv::aruco::detectMarkers(grey(where), dictionary_, corners, ids, parameters_);
  std::vector<Marker> markers;
  for (std::size_t i = 0; i < ids.size(); ++i) {
    Marker marker{.id = ids[i]};
    for (std::size_t k = 0; k < 4; ++k) marker.corners[k] = corners[i][k] + cv::Point2f(where.tl());
    const double module_px = shortest_side(marker.corners) / (dictionary_->markerSize + 2);
    const int window = std::clamp(static_cast<int>(module_px * kWindowShare), 2, kLargestWindow);
    std::vector<cv::Point2f> refined(marker.corners.begin(), marker.corners.end());
    cv::cornerSubPix(grey, refined, {window, window}, {-1, -1},
                     {cv::TermCriteria::COUNT + cv::TermCriteria::EPS, 40, 0.005});
    std::copy(refined.begin(), refined.end(), marker.corners.begin());
    markers.push_back(marker);
  }
  return markers;
}

}  // namespace tp100::camera
