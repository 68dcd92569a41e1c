// camera_film board|drive FOLDER: draws images in place of a camera's. "board": the board
// charuco:7x5:0.04:0.03, held in all parts of the image. "drive": a robot among the floor markers
// of config/view.toml, with the times in times.csv.

#include <cstdio>
#include <filesystem>
#include <fstream>
#include <opencv2/imgcodecs.hpp>
#include <string>
#include <utility>
#include <vector>

#include "camera/lens_calibration.h"
#include "held_board.h"
#include "marker_scene.h"

namespace tp100::test {
namespace {

constexpr double kFps = 10.0, kPixelsPerM = 4000.0;
constexpr double kK1 = -0.09, kK2 = 0.02;
constexpr int kDriveImages = 30;

std::vector<cv::Mat> board() {
  const cv::Mat bits = camera::CalibrationBoard::parse("charuco:7x5:0.04:0.03").draw(kPixelsPerM);
  return held_all_over(small_camera({0.0, 0.0, 0.6}, kK1, kK2), bits, bits.cols / kPixelsPerM,
                       {-0.28, -0.1, 0.1, 0.28}, {-0.12, -0.06, 0.0, 0.06, 0.12}, 0.0);
}

std::vector<cv::Mat> drive() {
  Scene scene(small_camera({0.95, 0.2, 1.8}, kK1, kK2), 1);
  int id = 10;
  for (const auto& [x_m, y_m] : {std::pair{-0.2, -0.5}, {2.1, -0.5}, {2.1, 0.9}, {-0.2, 0.9}})
    scene.lay(marker_bits(id++), 0.12, x_m, y_m, 0.4);
  scene.carry(marker_bits(0), 0.10, 0.06);
  std::vector<cv::Mat> images;
  for (int i = 0; i < kDriveImages; ++i) {
    const double t_s = i / kFps;
    images.push_back(
        scene.image({.x_m = 0.2 + 0.2 * t_s, .y_m = 0.05 * t_s, .yaw_rad = 0.3 * t_s}));
  }
  return images;
}

int film(const std::string& what, const std::string& folder) {
  std::filesystem::create_directories(folder);
  std::ofstream times(folder + "/times.csv");
  int count = 0;
  for (const cv::Mat& image : what == "board" ? board() : drive()) {
    char name[16];
    std::snprintf(name, sizeof name, "%03d.png", count);
    cv::imwrite(folder + "/" + name, image, {cv::IMWRITE_PNG_COMPRESSION, 1});
    times << name << ',' << count++ / kFps << '\n';
  }
  return 0;
}

}  // namespace
}  // namespace tp100::test

int main(int argc, char** argv) {
  const std::string what = argc == 3 ? argv[1] : "";
  if (what == "board" || what == "drive") return tp100::test::film(what, argv[2]);
  std::fprintf(stderr, "usage: camera_film board|drive FOLDER\n");
  return 2;
}
