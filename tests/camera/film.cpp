// camera_film board|drive FOLDER: draws images in place of a camera's. "board": the board
// charuco:7x5:0.04:0.03, held in all parts of the image. "drive": a robot among the floor markers
// of config/view.toml, with the times in times.csv.

#include <array>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <opencv2/imgcodecs.hpp>
#include <string>
#include <utility>

#include "camera/lens_calibration.h"
#include "held_board.h"
#include "marker_scene.h"

namespace tp100::test {
namespace {

constexpr double kFps = 10.0, kPixelsPerM = 4000.0;
constexpr int kDriveImages = 30;

SceneCamera film_camera(const Vec3& place_m) {
  SceneCamera camera = small_camera(place_m);
  camera.k1 = -0.09;
  camera.k2 = 0.02;
  return camera;
}

class Film {
 public:
  explicit Film(const std::string& folder) : folder_(folder) {
    std::filesystem::create_directories(folder);
    times_.open(folder + "/times.csv");
  }
  void add(const cv::Mat& image) {
    std::array<char, 16> name{};
    std::snprintf(name.data(), name.size(), "%03d.png", count_);
    cv::imwrite(folder_ + "/" + name.data(), image, {cv::IMWRITE_PNG_COMPRESSION, 1});
    times_ << name.data() << ',' << count_++ / kFps << '\n';
  }

 private:
  std::string folder_;
  std::ofstream times_;
  int count_ = 0;
};

void film_board(Film film) {
  const cv::Mat bits = camera::CalibrationBoard::parse("charuco:7x5:0.04:0.03").draw(kPixelsPerM);
  int i = 0;
  for (const double x : {-0.28, -0.1, 0.1, 0.28}) {
    for (const double y : {-0.12, -0.06, 0.0, 0.06, 0.12}) {
      Scene scene(film_camera({0.0, 0.0, 0.6}), 1);
      scene.show(held(bits, bits.cols / kPixelsPerM, {x, y, 0.05 + 0.03 * (i % 3)},
                      0.35 * std::sin(2.1 * i), 0.35 * std::cos(1.7 * i)));
      film.add(scene.empty_floor({.blur_px = 0.6, .grey_sd = 2.0}));
      ++i;
    }
  }
}

void film_drive(Film film) {
  Scene scene(film_camera({0.95, 0.2, 1.8}), 1);
  int id = 10;
  for (const auto& [x_m, y_m] : {std::pair{-0.2, -0.5}, {2.1, -0.5}, {2.1, 0.9}, {-0.2, 0.9}})
    scene.lay(marker_bits(id++), 0.12, x_m, y_m, 0.4);
  scene.carry(marker_bits(0), 0.10, 0.06);
  for (int i = 0; i < kDriveImages; ++i) {
    const double t_s = i / kFps;
    film.add(scene.image({.x_m = 0.2 + 0.2 * t_s, .y_m = 0.05 * t_s, .yaw_rad = 0.3 * t_s}));
  }
}

}  // namespace
}  // namespace tp100::test

int main(int argc, char** argv) {
  const std::string what = argc == 3 ? argv[1] : "";
  if (what == "board") {
    tp100::test::film_board(tp100::test::Film(argv[2]));
  } else if (what == "drive") {
    tp100::test::film_drive(tp100::test::Film(argv[2]));
  } else {
    std::fprintf(stderr, "usage: camera_film board|drive FOLDER\n");
    return 2;
  }
  return 0;
}
