#include "camera/lens_calibration.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <opencv2/aruco.hpp>
#include <opencv2/calib3d.hpp>
#include <set>

#include "camera/marker_detector.h"
#include "core/error.h"
#include "text/atomic_file.h"
#include "text/format.h"

namespace tp100::camera {
namespace {

constexpr const char* kDictionary = "4x4_50";
constexpr int kMaxSquares = 40;
constexpr std::size_t kFewestCorners = 8;  // for an image to be used

bool size_in_range(double m) { return m >= 0.002 && m <= 1.0; }

constexpr double kLargestRmsPx = 3.0;
constexpr double kGoodRmsPx = 1.0;
constexpr double kGoodCover = 0.5;
constexpr double kGoodFocalSd = 0.01;
// A board is a new view if its corners moved by more than this in the mean.
constexpr double kMovedBoardPx = 12.0;
constexpr int kFields = 8;

bool moved(const BoardCorners& a, const BoardCorners& b) {
  if (a.pixels.size() != b.pixels.size()) return true;
  double sum = 0.0;
  for (std::size_t i = 0; i < a.pixels.size(); ++i) sum += cv::norm(a.pixels[i] - b.pixels[i]);
  return sum > kMovedBoardPx * static_cast<double>(a.pixels.size());
}

double cover(const std::vector<BoardCorners>& views, cv::Size size) {
  if (size.empty()) return 0.0;
  std::set<int> fields;
  for (const BoardCorners& view : views)
    for (const cv::Point2f& pixel : view.pixels)
      fields.insert(static_cast<int>(pixel.x) * kFields / size.width +
                    static_cast<int>(pixel.y) * kFields / size.height * kFields);
  return static_cast<double>(fields.size()) / (kFields * kFields);
}

/// Drops every second view, so that the others still cover the whole recording.
void thin_out(std::vector<BoardCorners>& views) {
  std::vector<BoardCorners> kept;
  for (std::size_t i = 0; i < views.size(); i += 2) kept.push_back(std::move(views[i]));
  views = std::move(kept);
}

}  // namespace

CalibrationBoard CalibrationBoard::parse(const std::string& text) {
  int columns = 0, rows = 0, used = -1;
  double square_m = 0.0, marker_m = 0.0;
  const bool whole = std::sscanf(text.c_str(), "charuco:%dx%d:%lf:%lf%n", &columns, &rows,
                                 &square_m, &marker_m, &used) == 4 &&
                     used == static_cast<int>(text.size());
  const bool sizes = columns >= 3 && rows >= 3 && columns <= kMaxSquares && rows <= kMaxSquares &&
                     columns * rows / 2 <= 50 && size_in_range(square_m) &&
                     size_in_range(marker_m) && marker_m < square_m;
  if (!whole || !sizes) {
    throw UserError("--board " + one_line(text) +
                    ": not a board; use charuco:7x5:0.04:0.03 (squares, square and marker in m; at "
                    "most 50 markers)");
  }
  CalibrationBoard board;
  board.charuco_ =
      cv::aruco::CharucoBoard::create(columns, rows, static_cast<float>(square_m),
                                      static_cast<float>(marker_m), dictionary_named(kDictionary));
  return board;
}

BoardCorners CalibrationBoard::find(const cv::Mat& grey) const {
  std::vector<std::vector<cv::Point2f>> corners;
  std::vector<int> ids, corner_ids;
  cv::aruco::detectMarkers(grey, charuco_->dictionary, corners, ids);
  BoardCorners found;
  if (ids.empty()) return found;
  cv::aruco::interpolateCornersCharuco(corners, ids, grey, charuco_, found.pixels, corner_ids);
  for (const int id : corner_ids)
    found.board_m.push_back(charuco_->chessboardCorners[static_cast<std::size_t>(id)]);
  return found.pixels.size() < kFewestCorners ? BoardCorners{} : found;
}

cv::Mat CalibrationBoard::draw(double pixels_per_m) const {
  const double square_m = charuco_->getSquareLength();
  const int square = std::max(8, static_cast<int>(std::lround(square_m * pixels_per_m)));
  const int margin = square / 2;
  cv::Mat image;
  charuco_->draw(charuco_->getChessboardSize() * square + cv::Size(2 * margin, 2 * margin), image,
                 margin);
  return image;
}

std::string marker_svg(const View& view, int id) {
  const cv::Ptr<cv::aruco::Dictionary> dictionary = dictionary_named(view.dictionary);
  if (id < 0 || id >= dictionary->bytesList.rows)
    throw UserError("marker " + std::to_string(id) + ": dictionary " + view.dictionary +
                    " ends at " + std::to_string(dictionary->bytesList.rows - 1));
  const int modules = dictionary->markerSize + 2;
  cv::Mat bits;
  cv::aruco::drawMarker(dictionary, id, modules, bits);
  const double module_mm = view.marker_size_m * 1e3 / modules;
  // The detector needs one and a half modules of white around the black square.
  const double rim_mm = 1.5 * module_mm;
  const double side_mm = view.marker_size_m * 1e3 + 2.0 * rim_mm;
  const auto mm = [](double value) { return text::number_text(value); };
  std::string svg = "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"" + mm(side_mm) +
                    "mm\" height=\"" + mm(side_mm) + "mm\" viewBox=\"0 0 " + mm(side_mm) + " " +
                    mm(side_mm) + "\">\n<rect width=\"100%\" height=\"100%\" fill=\"white\"/>\n";
  for (int row = 0; row < modules; ++row) {
    for (int column = 0; column < modules; ++column) {
      if (bits.at<unsigned char>(row, column) != 0) continue;
      svg += "<rect x=\"" + mm(rim_mm + column * module_mm) + "\" y=\"" +
             mm(rim_mm + row * module_mm) + "\" width=\"" + mm(module_mm) + "\" height=\"" +
             mm(module_mm) + "\" fill=\"black\"/>\n";
    }
  }
  svg += "<path d=\"M " + mm(side_mm / 2) + " " + mm(rim_mm * 0.1) + " l " + mm(rim_mm * 0.3) +
         " " + mm(rim_mm * 0.4) + " h " + mm(-rim_mm * 0.6) + " z\" fill=\"#bbb\"/>\n<text x=\"" +
         mm(rim_mm) + "\" y=\"" + mm(side_mm - rim_mm * 0.3) + "\" font-size=\"" +
         mm(rim_mm * 0.3) + "\" fill=\"#888\">" + view.dictionary + " " + std::to_string(id) +
         ", " + mm(view.marker_size_m * 1e3) + " mm</text>\n</svg>\n";
  return svg;
}

LensFit fit_lens(const std::vector<BoardCorners>& views, cv::Size size) {
  if (views.size() < kFewestViews) {
    throw UserError("the board is seen in " + std::to_string(views.size()) + " images, " +
                    std::to_string(kFewestViews) +
                    " are needed; show it tilted, near and far, in every corner of the image, "
                    "and check --board");
  }
  std::vector<std::vector<cv::Point3f>> board;
  std::vector<std::vector<cv::Point2f>> pixels;
  for (const BoardCorners& view : views) {
    board.push_back(view.board_m);
    pixels.push_back(view.pixels);
  }
  cv::Mat matrix, distortion, deviations;
  double rms_px = 0.0;
  try {
    rms_px = cv::calibrateCamera(board, pixels, size, matrix, distortion, cv::noArray(),
                                 cv::noArray(), deviations, cv::noArray(), cv::noArray());
  } catch (const cv::Exception&) {
    throw UserError("no lens fits the images of the board; take more images from other angles");
  }
  if (!(rms_px <= kLargestRmsPx)) {
    throw UserError("the corners miss the lens by " + std::to_string(rms_px) +
                    " px; check --board, keep the board flat and the images sharp");
  }
  LensFit fit{opencv_lens(matrix, distortion, size), views.size(), cover(views, size),
              deviations.at<double>(0)};
  fit.lens.rms_px = rms_px;
  return fit;
}

int calibrate_lens(const std::string& source, const SourceOptions& options,
                   const std::string& board, const std::string& out) {
  const CalibrationBoard pattern = CalibrationBoard::parse(board);
  SourceOptions any_time = options;
  // The calibration does not use times: any rate will do.
  if (!any_time.fps) any_time.fps = 1.0;
  const auto images = open_source(source, any_time);
  if (!images->ends())
    throw UserError(source +
                    ": record the board first; --calibrate-lens takes a folder, a video or a pipe");
  std::vector<BoardCorners> views;
  BoardCorners last;
  cv::Size size;
  Image image;
  while (images->next(image)) {
    if (size.empty()) size = image.grey.size();
    if (image.grey.size() != size)
      throw UserError(source + ": images of several sizes; keep those of one");
    BoardCorners found = pattern.find(image.grey);
    if (found.pixels.empty() || !moved(found, last)) continue;
    last = found;
    views.push_back(std::move(found));
    if (views.size() == 2 * kMaxViews) thin_out(views);
  }
  if (views.size() > kMaxViews) thin_out(views);
  const LensFit fit = fit_lens(views, size);
  text::write_file(out, write_lens(fit.lens));
  read_lens(out);
  std::printf(
      "%s: %s, %.2f px rms, focal length %.1f +- %.1f px, %.0f %% of the image "
      "covered\n",
      out.c_str(), text::counted(fit.views, "image").c_str(), fit.lens.rms_px, fit.lens.fx_px,
      fit.focal_sd_px, fit.covered * 100.0);
  if (fit.lens.rms_px > kGoodRmsPx || fit.covered < kGoodCover ||
      fit.focal_sd_px > kGoodFocalSd * fit.lens.fx_px)
    std::printf(
        "this is a weak calibration: show the board also in the corners, tilted, and sharp\n");
  return 0;
}

}  // namespace tp100::camera
