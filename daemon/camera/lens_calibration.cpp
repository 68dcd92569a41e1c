#include "camera/lens_calibration.h"

#include <cmath>
#include <cstdio>
#include <fstream>
#include <opencv2/calib3d.hpp>
#include <set>

#include "core/error.h"
#include "text/atomic_file.h"

namespace tp100::camera {
namespace {

constexpr double kLargestRmsPx = 3.0;
constexpr double kGoodRmsPx = 1.0;
constexpr double kGoodCover = 0.5;
constexpr double kGoodFocalSd = 0.01;
// A board that is held still is one view.
constexpr double kMovedPx = 12.0;
constexpr int kFields = 8;

bool moved(const BoardCorners& a, const BoardCorners& b) {
  if (a.pixels.size() != b.pixels.size()) return true;
  double sum = 0.0;
  for (std::size_t i = 0; i < a.pixels.size(); ++i) sum += cv::norm(a.pixels[i] - b.pixels[i]);
  return sum > kMovedPx * static_cast<double>(a.pixels.size());
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

/// Every second one goes: what is left is spread over the whole recording.
void thin_out(std::vector<BoardCorners>& views) {
  std::vector<BoardCorners> kept;
  for (std::size_t i = 0; i < views.size(); i += 2) kept.push_back(std::move(views[i]));
  views = std::move(kept);
}

}  // namespace

LensFit fit_lens(const std::vector<BoardCorners>& views, cv::Size size) {
  if (views.size() < kFewestViews) {
    throw SetupError("the board is seen in " + std::to_string(views.size()) + " pictures, " +
                     std::to_string(kFewestViews) +
                     " are needed; show it tilted, near and far, in every corner of the picture, "
                     "and check --board");
  }
  std::vector<std::vector<cv::Point3f>> board;
  std::vector<std::vector<cv::Point2f>> pixels;
  for (const BoardCorners& view : views) {
    board.push_back(view.board_m);
    pixels.push_back(view.pixels);
  }
  cv::Mat matrix, distortion, deviations;
  LensFit fit;
  try {
    fit.lens.rms_px = cv::calibrateCamera(board, pixels, size, matrix, distortion, cv::noArray(),
                                          cv::noArray(), deviations, cv::noArray(), cv::noArray());
  } catch (const cv::Exception&) {
    throw SetupError("the pictures of the board fit no lens; take more, from other angles");
  }
  fit.lens.width_px = size.width;
  fit.lens.height_px = size.height;
  fit.lens.fx_px = matrix.at<double>(0, 0);
  fit.lens.fy_px = matrix.at<double>(1, 1);
  fit.lens.cx_px = matrix.at<double>(0, 2);
  fit.lens.cy_px = matrix.at<double>(1, 2);
  fit.lens.k1 = distortion.at<double>(0);
  fit.lens.k2 = distortion.at<double>(1);
  fit.lens.p1 = distortion.at<double>(2);
  fit.lens.p2 = distortion.at<double>(3);
  fit.lens.k3 = distortion.at<double>(4);
  fit.views = views.size();
  fit.covered = cover(views, size);
  fit.focal_sd_px = deviations.at<double>(0);
  if (!(fit.lens.rms_px <= kLargestRmsPx)) {
    throw SetupError("the corners miss the lens by " + std::to_string(fit.lens.rms_px) +
                     " px; check --board, keep the board flat and the pictures sharp");
  }
  return fit;
}

int calibrate_lens(const std::string& source, const SourceOptions& options,
                   const std::string& board, const std::string& out) {
  const Board pattern = Board::parse(board);
  SourceOptions any_time = options;
  // Times do not matter here.
  if (!any_time.fps) any_time.fps = 1.0;
  const auto pictures = open_source(source, any_time);
  if (pictures->live())
    throw SetupError(source +
                     ": record the board first; --calibrate-lens takes a folder or a video");
  std::vector<BoardCorners> views;
  BoardCorners last;
  cv::Size size;
  Picture picture;
  while (pictures->next(picture)) {
    if (size.empty()) size = picture.grey.size();
    if (picture.grey.size() != size)
      throw SetupError(source + ": pictures of several sizes; keep those of one");
    BoardCorners found = pattern.find(picture.grey);
    if (found.pixels.empty() || !moved(found, last)) continue;
    last = found;
    views.push_back(std::move(found));
    if (views.size() == 2 * kMostViews) thin_out(views);
  }
  if (views.size() > kMostViews) thin_out(views);
  const LensFit fit = fit_lens(views, size);
  text::write_file(out, write_lens(fit.lens));
  read_lens(out);
  std::printf(
      "%s: %zu pictures, %.2f px rms, focal length %.1f +- %.1f px, %.0f %% of the picture "
      "covered\n",
      out.c_str(), fit.views, fit.lens.rms_px, fit.lens.fx_px, fit.focal_sd_px,
      fit.covered * 100.0);
  if (fit.lens.rms_px > kGoodRmsPx || fit.covered < kGoodCover ||
      fit.focal_sd_px > kGoodFocalSd * fit.lens.fx_px)
    std::printf(
        "this is a weak calibration: show the board also in the corners, tilted, and sharp\n");
  return 0;
}

}  // namespace tp100::camera
