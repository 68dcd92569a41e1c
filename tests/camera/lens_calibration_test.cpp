#include "camera/lens_calibration.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "core/error.h"
#include "held_board.h"
#include "marker_scene.h"

namespace tp100::test {
namespace {

using ::testing::HasSubstr;

/// A camera with more distortion than most.
SceneCamera bent_camera() {
  SceneCamera camera = small_camera({0.0, 0.0, 0.6});
  camera.k1 = -0.14;
  camera.k2 = 0.03;
  camera.p1 = 0.0008;
  camera.p2 = -0.0005;
  return camera;
}

/// Images of the board in all parts of the view.
std::vector<camera::BoardCorners> views_of(const camera::CalibrationBoard& board, double width_m) {
  const cv::Mat bits = board.draw(4000.0);
  std::vector<camera::BoardCorners> views;
  int i = 0;
  for (const double x : {-0.28, 0.0, 0.28}) {
    for (const double y : {-0.12, 0.0, 0.12}) {
      Scene scene(bent_camera(), 1);
      const double z = 0.05 + 0.03 * (i % 3);
      scene.show(held(bits, width_m, {x, y, z}, 0.35 * std::sin(2.1 * i), 0.35 * std::cos(1.7 * i),
                      0.3 * i));
      const camera::BoardCorners found =
          board.find(scene.empty_floor({.blur_px = 0.6, .grey_sd = 2.0}));
      if (!found.pixels.empty()) views.push_back(found);
      ++i;
    }
  }
  return views;
}

void expect_the_lens(const camera::LensFit& fit) {
  const SceneCamera truth = bent_camera();
  EXPECT_NEAR(fit.lens.fx_px, truth.focal_px, 0.005 * truth.focal_px);
  EXPECT_NEAR(fit.lens.cx_px, truth.centre_x_px, 2.0);
  EXPECT_NEAR(fit.lens.cy_px, truth.centre_y_px, 2.0);
  EXPECT_LT(fit.lens.rms_px, 0.3);
  // The directions of the rays matter, in the part of the image in which a robot is seen.
  const camera::Lens lens = lens_of(truth);
  double worst_px = 0.0;
  for (double u = 80; u <= 880; u += 80)
    for (double v = 60; v <= 480; v += 60)
      worst_px = std::max(worst_px, cv::norm(fit.lens.pixel(lens.ray({u, v})) - cv::Point2d(u, v)));
  EXPECT_LT(worst_px, 2.5);
  std::printf("%zu views, %.2f px rms, focal length %.1f of %.1f px, rays within %.2f px\n",
              fit.views, fit.lens.rms_px, fit.lens.fx_px, truth.focal_px, worst_px);
}

TEST(LensCalibration, AChessboardGivesTheLensBack) {
  const camera::CalibrationBoard board = camera::CalibrationBoard::parse("chessboard:8x5:0.025");
  const auto views = views_of(board, 0.025 * 10);
  ASSERT_GE(views.size(), camera::kFewestViews);
  expect_the_lens(camera::fit_lens(views, {960, 540}));
}

TEST(LensCalibration, ACharucoBoardGivesTheLensBack) {
  const camera::CalibrationBoard board = camera::CalibrationBoard::parse("charuco:8x5:0.032:0.024");
  const auto views = views_of(board, 0.032 * 9);
  ASSERT_GE(views.size(), camera::kFewestViews);
  expect_the_lens(camera::fit_lens(views, {960, 540}));
}

TEST(LensCalibration, TooFewImagesAreRefused) {
  EXPECT_THROW(camera::fit_lens({}, {960, 540}), SetupError);
}

TEST(CalibrationBoard, IsReadAsDocumentedAndNotOtherwise) {
  EXPECT_NO_THROW(camera::CalibrationBoard::parse("chessboard:9x6:0.025"));
  EXPECT_NO_THROW(camera::CalibrationBoard::parse("charuco:7x5:0.04:0.03"));
  for (const char* text :
       {"", "chessboard", "chessboard:9x6", "chessboard:1x6:0.025", "chessboard:9x6:0.025:1",
        "chessboard:9x6:nan", "chessboard:999999x6:0.02", "charuco:7x5:0.04:0.05",
        "charuco:20x20:0.04:0.03", "charuco:7x5:0.04:0.03x"})
    EXPECT_THROW(camera::CalibrationBoard::parse(text), SetupError) << text;
}

TEST(CalibrationBoard, AnImageWithoutItHasNoCorners) {
  Scene scene(bent_camera(), 1);
  const cv::Mat floor = scene.empty_floor({});
  EXPECT_TRUE(camera::CalibrationBoard::parse("chessboard:9x6:0.025").find(floor).pixels.empty());
  EXPECT_TRUE(camera::CalibrationBoard::parse("charuco:7x5:0.04:0.03").find(floor).pixels.empty());
}

}  // namespace
}  // namespace tp100::test
