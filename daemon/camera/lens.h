#pragma once
// The lens of a camera: converts pixels to rays, and back.
//
// Camera frame: x to the right of the image, y down, z along the view (OpenCV's). Pixel (0, 0) is
// the middle of the top left one. Distortion: Brown's model with k1, k2, k3 radial, p1, p2
// tangential, in OpenCV's order.

#include <opencv2/core.hpp>
#include <string>

namespace tp100::camera {

struct Lens {
  int width_px = 1920;  ///< of the images for which these values hold
  int height_px = 1080;
  double fx_px = 1030.0, fy_px = 1030.0;
  double cx_px = 959.5, cy_px = 539.5;
  double k1 = 0.0, k2 = 0.0, p1 = 0.0, p2 = 0.0, k3 = 0.0;
  double rms_px = 0.0;  ///< residual of the calibration; 0: unknown

  /// Direction (x, y, 1) of a pixel. Not finite where the distortion has no inverse.
  cv::Point2d ray(const cv::Point2d& pixel) const;
  /// Pixel of a direction (x, y, 1).
  cv::Point2d pixel(const cv::Point2d& ray) const;
};

/// OpenCV's description of a lens: a camera matrix of 3 by 3 and at least four coefficients of
/// distortion in one row, all of double.
Lens opencv_lens(const cv::Mat& matrix, const cv::Mat& distortion, cv::Size size);

/// Reads a lens file: TOML as written by write_lens, or OpenCV's YAML or XML with camera_matrix,
/// distortion_coefficients, image_width and image_height. Throws UserError, also for a lens whose
/// distortion folds the image over.
Lens read_lens(const std::string& path);

/// A commented TOML file that read_lens reads back.
std::string write_lens(const Lens& lens);

}  // namespace tp100::camera
