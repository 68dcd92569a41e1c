#include "camera/board.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <opencv2/calib3d.hpp>
#include <opencv2/imgproc.hpp>

#include "camera/marker_detector.h"
#include "core/error.h"
#include "text/toml_document.h"

namespace tp100::camera {
namespace {

constexpr const char* kDictionary = "4x4_50";
constexpr int kMostSquares = 40;

bool size_in_range(double m) { return m >= 0.002 && m <= 1.0; }

}  // namespace

Board Board::parse(const std::string& text) {
  Board board;
  int columns = 0, rows = 0, used = -1;
  double square_m = 0.0, marker_m = 0.0;
  const auto whole = [&] { return used == static_cast<int>(text.size()); };
  const bool chess =
      std::sscanf(text.c_str(), "chessboard:%dx%d:%lf%n", &columns, &rows, &square_m, &used) == 3 &&
      whole();
  used = -1;
  const bool charuco = !chess &&
                       std::sscanf(text.c_str(), "charuco:%dx%d:%lf:%lf%n", &columns, &rows,
                                   &square_m, &marker_m, &used) == 4 &&
                       whole();
  const bool sizes = columns >= 3 && rows >= 3 && columns <= kMostSquares && rows <= kMostSquares &&
                     size_in_range(square_m);
  const bool markers =
      !charuco || (size_in_range(marker_m) && marker_m < square_m && columns * rows / 2 <= 50);
  if (!(chess || charuco) || !sizes || !markers) {
    throw SetupError("--board " + text::one_line(text) +
                     ": not a board; use chessboard:9x6:0.025 (inner corners, square in m) or "
                     "charuco:7x5:0.04:0.03 (squares, square and marker in m; at most 50 markers)");
  }
  board.inner_ = chess ? cv::Size(columns, rows) : cv::Size(columns - 1, rows - 1);
  board.square_m_ = square_m;
  board.enough_ = chess ? static_cast<std::size_t>(columns * rows) : 8;
  if (charuco) {
    board.charuco_ = cv::aruco::CharucoBoard::create(columns, rows, static_cast<float>(square_m),
                                                     static_cast<float>(marker_m),
                                                     dictionary_named(kDictionary));
  }
  return board;
}

BoardCorners Board::find(const cv::Mat& grey) const {
  BoardCorners found = charuco_ ? find_charuco(grey) : find_chessboard(grey);
  return found.pixels.size() < enough_ ? BoardCorners{} : found;
}

BoardCorners Board::find_chessboard(const cv::Mat& grey) const {
  BoardCorners found;
  constexpr int kFlags =
      cv::CALIB_CB_ADAPTIVE_THRESH + cv::CALIB_CB_NORMALIZE_IMAGE + cv::CALIB_CB_FAST_CHECK;
  if (!cv::findChessboardCorners(grey, inner_, found.pixels, kFlags)) return {};
  // The window must stay within the squares that meet at the corner.
  double shortest = 1e9;
  for (std::size_t i = 1; i < found.pixels.size(); ++i)
    shortest = std::min(shortest, cv::norm(found.pixels[i] - found.pixels[i - 1]));
  const int window = std::clamp(static_cast<int>(shortest * 0.4), 2, 11);
  cv::cornerSubPix(grey, found.pixels, {window, window}, {-1, -1},
                   {cv::TermCriteria::COUNT + cv::TermCriteria::EPS, 40, 0.005});
  for (int row = 0; row < inner_.height; ++row)
    for (int column = 0; column < inner_.width; ++column)
      found.board_m.emplace_back(static_cast<float>(column * square_m_),
                                 static_cast<float>(row * square_m_), 0.0F);
  return found;
}

BoardCorners Board::find_charuco(const cv::Mat& grey) const {
  std::vector<std::vector<cv::Point2f>> corners;
  std::vector<int> ids, corner_ids;
  cv::aruco::detectMarkers(grey, charuco_->dictionary, corners, ids);
  BoardCorners found;
  if (ids.empty()) return found;
  cv::aruco::interpolateCornersCharuco(corners, ids, grey, charuco_, found.pixels, corner_ids);
  for (const int id : corner_ids)
    found.board_m.push_back(charuco_->chessboardCorners[static_cast<std::size_t>(id)]);
  return found;
}

cv::Mat Board::draw(double pixels_per_m) const {
  const int square = std::max(8, static_cast<int>(std::lround(square_m_ * pixels_per_m)));
  const int margin = square / 2;
  const int columns = inner_.width + 1, rows = inner_.height + 1;
  const cv::Size size(columns * square + 2 * margin, rows * square + 2 * margin);
  cv::Mat picture(size, CV_8U, cv::Scalar(255));
  if (charuco_) {
    charuco_->draw(size, picture, margin);
    return picture;
  }
  for (int row = 0; row < rows; ++row)
    for (int column = row % 2; column < columns; column += 2)
      picture(cv::Rect(margin + column * square, margin + row * square, square, square)) = 0;
  return picture;
}

}  // namespace tp100::camera
