#pragma once
// tp100-camera SOURCE --calibrate-lens FILE: calibrates the lens with images of a board. And what
// is printed for a camera: the board, and the robot's marker.

#include <opencv2/aruco/charuco.hpp>
#include <string>
#include <vector>

#include "camera/lens.h"
#include "camera/source.h"
#include "camera/view.h"

namespace tp100::camera {

/// Corners of the pattern in one image and their positions on the board.
struct BoardCorners {
  std::vector<cv::Point2f> pixels;
  std::vector<cv::Point3f> board_m;
};

/// The flat pattern for calibrating a lens.
class CalibrationBoard {
 public:
  /// "charuco:7x5:0.04:0.03": 7 by 5 squares of 40 mm, markers of 30 mm, dictionary 4x4_50.
  /// Throws UserError.
  static CalibrationBoard parse(const std::string& text);

  /// The corners in a grey image of 8 bits; empty if the board is not found.
  BoardCorners find(const cv::Mat& grey) const;
  /// An image to print with this resolution, and a margin of half a square.
  cv::Mat draw(double pixels_per_m) const;

 private:
  cv::Ptr<cv::aruco::CharucoBoard> charuco_;
};

/// The robot's marker as an SVG drawing in true size, with its white rim and an arrow to the front.
/// Throws UserError if the dictionary has no such marker.
std::string marker_svg(const View& view, int id);

/// A calibrated lens and its quality.
struct LensFit {
  Lens lens;
  std::size_t views = 0;   ///< images used
  double covered = 0.0;    ///< fraction of the image's 8 by 8 fields that contained a corner
  double focal_sd_px = 0;  ///< standard deviation of the focal length
};

/// Fits a lens to the corners of at least kFewestViews images of one size. Throws UserError.
LensFit fit_lens(const std::vector<BoardCorners>& views, cv::Size size);

inline constexpr std::size_t kFewestViews = 6;
/// More views take time and do not improve the result.
inline constexpr std::size_t kMaxViews = 60;

/// The command. Returns 0; throws UserError.
int calibrate_lens(const std::string& source, const SourceOptions& options,
                   const std::string& board, const std::string& out);

}  // namespace tp100::camera
