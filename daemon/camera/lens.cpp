#include "camera/lens.h"

#include <array>
#include <cmath>
#include <opencv2/core/persistence.hpp>
#include <span>

#include "core/arithmetic.h"
#include "core/error.h"
#include "course/bundled_files.h"
#include "text/key.h"

namespace tp100::camera {
namespace {

using text::Key;

std::span<const Key<Lens>> keys() {
  using T = Lens;
  static const std::array<Key<T>, 12> kKeys = {{
      {"width_px", &T::width_px, {16, 16384}, "Size of the images for which these values hold"},
      {"height_px", &T::height_px, {16, 16384}, "Same"},
      {"fx_px", &T::fx_px, {10, 100000}, "Focal length, along the rows"},
      {"fy_px", &T::fy_px, {10, 100000}, "Same, along the columns"},
      {"cx_px", &T::cx_px, {-1000, 20000}, "Principal point; 0 is the middle of the first pixel"},
      {"cy_px", &T::cy_px, {-1000, 20000}, "Same"},
      {"k1", &T::k1, {-10, 10}, "Radial distortion"},
      {"k2", &T::k2, {-10, 10}, "Same"},
      {"p1", &T::p1, {-1, 1}, "Tangential distortion"},
      {"p2", &T::p2, {-1, 1}, "Same"},
      {"k3", &T::k3, {-10, 10}, "Radial distortion"},
      {"rms_px", &T::rms_px, {0, 100}, "Residual of the calibration; 0 if unknown"},
  }};
  return kKeys;
}

bool is_opencv_file(const std::string& path, const std::string& text) {
  return path.ends_with(".yml") || path.ends_with(".yaml") || path.ends_with(".xml") ||
         text.starts_with("%YAML") || text.starts_with("<?xml");
}

[[noreturn]] void fail(const std::string& path, const std::string& what) {
  throw UserError(path + ": " + what + "; make the file with tp100-camera --calibrate-lens");
}

Lens parse_opencv(const std::string& text, const std::string& path) {
  try {
    const cv::FileStorage file(text, cv::FileStorage::READ | cv::FileStorage::MEMORY);
    cv::Mat matrix, distortion;
    file["camera_matrix"] >> matrix;
    file["distortion_coefficients"] >> distortion;
    if (matrix.rows != 3 || matrix.cols != 3 || matrix.channels() != 1)
      fail(path, "no camera_matrix of 3 by 3");
    const auto count = distortion.total();
    if (distortion.channels() != 1 || (count != 4 && count != 5))
      fail(path, "distortion_coefficients must be 4 or 5 numbers");
    matrix.convertTo(matrix, CV_64F);
    distortion.convertTo(distortion, CV_64F);
    const cv::Size size(static_cast<int>(file["image_width"]),
                        static_cast<int>(file["image_height"]));
    return opencv_lens(matrix, distortion.reshape(1, 1), size);
  } catch (const cv::Exception&) {
    fail(path, "not a file of OpenCV");
  }
}

Lens parse_toml(const std::string& text, const std::string& path) {
  const text::TomlDocument document(text, path);
  text::TomlTable root = document.root();
  Lens lens;
  // None of these has a sensible default.
  for (const char* key : {"width_px", "height_px", "fx_px", "fy_px", "cx_px", "cy_px"})
    if (!root.has(key)) fail(path, std::string("no ") + key);
  text::read_keys(root, keys(), lens);
  root.finish();
  return lens;
}

/// Whether every pixel has a unique ray, out to the corners of the image.
bool sound(const Lens& lens) {
  constexpr int kSteps = 8;
  for (int i = 0; i <= kSteps; ++i) {
    for (int j = 0; j <= kSteps; ++j) {
      const cv::Point2d pixel(lens.width_px * i / static_cast<double>(kSteps),
                              lens.height_px * j / static_cast<double>(kSteps));
      const cv::Point2d back = lens.pixel(lens.ray(pixel));
      if (!(magnitude(back.x - pixel.x, back.y - pixel.y) < 0.05)) return false;
    }
  }
  return true;
}

}  // namespace

cv::Point2d Lens::pixel(const cv::Point2d& ray) const {
  const double r2 = ray.x * ray.x + ray.y * ray.y;
  const double radial = 1.0 + r2 * (k1 + r2 * (k2 + r2 * k3));
  const double x = ray.x * radial + 2.0 * p1 * ray.x * ray.y + p2 * (r2 + 2.0 * ray.x * ray.x);
  const double y = ray.y * radial + p1 * (r2 + 2.0 * ray.y * ray.y) + 2.0 * p2 * ray.x * ray.y;
  return {cx_px + fx_px * x, cy_px + fy_px * y};
}

cv::Point2d Lens::ray(const cv::Point2d& pixel) const {
  const cv::Point2d target((pixel.x - cx_px) / fx_px, (pixel.y - cy_px) / fy_px);
  cv::Point2d ray = target;
  // Newton's method with the distortion's derivatives: the usual fixed-point iteration diverges
  // towards the corners of wide lenses.
  for (int i = 0; i < 20; ++i) {
    const double x = ray.x, y = ray.y, r2 = x * x + y * y;
    const double radial = 1.0 + r2 * (k1 + r2 * (k2 + r2 * k3));
    const double slope = k1 + r2 * (2.0 * k2 + r2 * 3.0 * k3);
    const double off_x = x * radial + 2.0 * p1 * x * y + p2 * (r2 + 2.0 * x * x) - target.x;
    const double off_y = y * radial + p1 * (r2 + 2.0 * y * y) + 2.0 * p2 * x * y - target.y;
    const double xx = radial + 2.0 * x * x * slope + 2.0 * p1 * y + 6.0 * p2 * x;
    const double xy = 2.0 * x * y * slope + 2.0 * p1 * x + 2.0 * p2 * y;
    const double yy = radial + 2.0 * y * y * slope + 6.0 * p1 * y + 2.0 * p2 * x;
    const double determinant = xx * yy - xy * xy;
    const cv::Point2d step((yy * off_x - xy * off_y) / determinant,
                           (xx * off_y - xy * off_x) / determinant);
    ray -= step;
    if (std::abs(step.x) + std::abs(step.y) < 1e-12) break;
  }
  return ray;
}

Lens opencv_lens(const cv::Mat& matrix, const cv::Mat& distortion, cv::Size size) {
  return {.width_px = size.width,
          .height_px = size.height,
          .fx_px = matrix.at<double>(0, 0),
          .fy_px = matrix.at<double>(1, 1),
          .cx_px = matrix.at<double>(0, 2),
          .cy_px = matrix.at<double>(1, 2),
          .k1 = distortion.at<double>(0),
          .k2 = distortion.at<double>(1),
          .p1 = distortion.at<double>(2),
          .p2 = distortion.at<double>(3),
          .k3 = distortion.total() > 4 ? distortion.at<double>(4) : 0.0};
}

Lens read_lens(const std::string& path) {
  const course::TextFile file = course::read_text_file(path);
  const bool opencv = is_opencv_file(path, file.text);
  if (opencv && file.text.size() > text::kMaxTomlSize) fail(path, "too large for a lens file");
  // By way of TOML, so that both formats are checked for the same ranges.
  const Lens lens = opencv ? parse_toml(write_lens(parse_opencv(file.text, path)), path)
                           : parse_toml(file.text, path);
  if (!sound(lens)) fail(path, "the distortion has no inverse within the image");
  return lens;
}

std::string write_lens(const Lens& lens) {
  return text::toml_comment(
             "Lens of an overhead camera, by tp100-camera --calibrate-lens: a pinhole with Brown's "
             "distortion in OpenCV's order.") +
         "\n" + text::write_keys(keys(), lens);
}

}  // namespace tp100::camera
