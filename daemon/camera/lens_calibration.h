#pragma once
// tp100-camera SOURCE --calibrate-lens FILE: the lens from pictures of a board.

#include <string>
#include <vector>

#include "camera/board.h"
#include "camera/lens.h"
#include "camera/source.h"

namespace tp100::camera {

/// How a lens was found.
struct LensFit {
  Lens lens;
  std::size_t views = 0;   ///< pictures that count
  double covered = 0.0;    ///< share of the picture's 8 by 8 fields that had a corner
  double focal_sd_px = 0;  ///< standard deviation of the focal length
};

/// Fits a lens to the corners of at least kFewestViews pictures of one size. Throws SetupError.
LensFit fit_lens(const std::vector<BoardCorners>& views, cv::Size size);

inline constexpr std::size_t kFewestViews = 6;
/// More add time, not knowledge.
inline constexpr std::size_t kMostViews = 60;

/// The command. Returns 0; throws SetupError.
int calibrate_lens(const std::string& source, const SourceOptions& options,
                   const std::string& board, const std::string& out);

}  // namespace tp100::camera
