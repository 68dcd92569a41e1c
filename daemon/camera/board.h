#pragma once
// The flat pattern that a lens is calibrated with.

#include <opencv2/aruco/charuco.hpp>
#include <string>
#include <vector>

namespace tp100::camera {

/// Corners of the pattern in one picture and their places on the board.
struct BoardCorners {
  std::vector<cv::Point2f> pixels;
  std::vector<cv::Point3f> board_m;
};

class Board {
 public:
  /// "chessboard:9x6:0.025": 9 by 6 inner corners, squares of 25 mm.
  /// "charuco:7x5:0.04:0.03": 7 by 5 squares of 40 mm, markers of 30 mm, dictionary 4x4_50.
  /// Throws SetupError.
  static Board parse(const std::string& text);

  /// The corners in a grey picture of 8 bits; empty if they are not there.
  BoardCorners find(const cv::Mat& grey) const;
  /// A picture to print, `pixels_per_m` fine, with a margin of half a square.
  cv::Mat draw(double pixels_per_m) const;
  /// Least number of corners that make a picture useful.
  std::size_t enough() const { return enough_; }

 private:
  BoardCorners find_chessboard(const cv::Mat& grey) const;
  BoardCorners find_charuco(const cv::Mat& grey) const;

  cv::Size inner_;
  double square_m_ = 0.0;
  std::size_t enough_ = 0;
  cv::Ptr<cv::aruco::CharucoBoard> charuco_;
};

}  // namespace tp100::camera
