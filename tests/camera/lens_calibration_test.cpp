// The lens found from drawn images of a board, and what is no board.

#include "camera/lens_calibration.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <vector>

#include "core/error.h"
#include "held_board.h"
#include "marker_scene.h"

namespace tp100::test {
namespace {

using ::testing::HasSubstr;

/// A camera with more distortion than most.
SceneCamera bent_camera() {
  SceneCamera camera = small_camera({0.0, 0.0, 0.6}, -0.14, 0.03);
  camera.p1 = 0.0008;
  camera.p2 = -0.0005;
  return camera;
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
}

TEST(LensCalibration, ABoardGivesTheLensBack) {
  const camera::CalibrationBoard board = camera::CalibrationBoard::parse("charuco:8x5:0.032:0.024");
  std::vector<camera::BoardCorners> views;
  for (const cv::Mat& image : held_all_over(bent_camera(), board.draw(4000.0), 0.032 * 9,
                                            {-0.28, 0.0, 0.28}, {-0.12, 0.0, 0.12}, 0.3))
    if (auto found = board.find(image); !found.pixels.empty()) views.push_back(found);
  ASSERT_GE(views.size(), camera::kFewestViews);
  expect_the_lens(camera::fit_lens(views, {960, 540}));
}

TEST(LensCalibration, TooFewImagesAreRefused) {
  EXPECT_THROW(camera::fit_lens({}, {960, 540}), UserError);
}

TEST(CalibrationBoard, IsReadAsDocumentedAndNotOtherwise) {
  EXPECT_NO_THROW(camera::CalibrationBoard::parse("charuco:7x5:0.04:0.03"));
  for (const char* text :
       {"", "chessboard:9x6:0.025", "charuco:7x5", "charuco:1x6:0.04:0.03", "charuco:7x5:nan:0.03",
        "charuco:999999x6:0.04:0.03", "charuco:7x5:0.04:0.05", "charuco:20x20:0.04:0.03",
        "charuco:7x5:0.04:0.03x"})
    EXPECT_THROW(camera::CalibrationBoard::parse(text), UserError) << text;
}

TEST(CalibrationBoard, AnImageWithoutItHasNoCorners) {
  Scene scene(bent_camera(), 1);
  const cv::Mat floor = scene.empty_floor({});
  EXPECT_TRUE(camera::CalibrationBoard::parse("charuco:7x5:0.04:0.03").find(floor).pixels.empty());
}

}  // namespace
}  // namespace tp100::test
