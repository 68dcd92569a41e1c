#include "camera/lens.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>

#include "../programs/process.h"
#include "core/error.h"
#include "marker_scene.h"
#include "support/refusal.h"

namespace tp100::test {
namespace {

using ::testing::HasSubstr;

class LensFile : public testing::Test {
 protected:
  std::string write(const std::string& name, const std::string& text) const {
    write_bytes(folder_.file(name), text);
    return folder_.file(name);
  }
  std::string problem(const std::string& name, const std::string& text) const {
    return refusal([&] { camera::read_lens(write(name, text)); });
  }
  TemporaryFolder folder_;
};

// The scene implements the distortion independently; both must agree.
TEST(Lens, BendsRaysAsTheSceneDoes) {
  const SceneCamera scene = tilted_camera();
  const camera::Lens lens = lens_of(scene);
  SceneCamera straight = scene;
  straight.tilt_x_rad = straight.tilt_y_rad = straight.turned_rad = 0.0;
  for (double u = 0; u <= scene.width_px; u += 160) {
    for (double v = 0; v <= scene.height_px; v += 180) {
      const cv::Point2d ray = lens.ray({u, v});
      const Vec3 direction = straight.direction(u, v);
      EXPECT_NEAR(ray.x, direction[0] / -direction[2], 1e-7);
      EXPECT_NEAR(ray.y, -direction[1] / -direction[2], 1e-7);
      const cv::Point2d back = lens.pixel(ray);
      EXPECT_NEAR(back.x, u, 1e-6);
      EXPECT_NEAR(back.y, v, 1e-6);
    }
  }
}

TEST_F(LensFile, ComesBackAsItWasWritten) {
  camera::Lens lens = lens_of(tilted_camera());
  lens.rms_px = 0.21;
  const camera::Lens back = camera::read_lens(write("lens.toml", camera::write_lens(lens)));
  EXPECT_EQ(camera::write_lens(back), camera::write_lens(lens));
  EXPECT_DOUBLE_EQ(back.k1, lens.k1);
}

TEST_F(LensFile, OpenCvFilesAreTaken) {
  const std::string yaml =
      "%YAML:1.0\n---\nimage_width: 1280\nimage_height: 720\n"
      "camera_matrix: !!opencv-matrix\n   rows: 3\n   cols: 3\n   dt: d\n"
      "   data: [ 900., 0., 640., 0., 901., 360., 0., 0., 1. ]\n"
      "distortion_coefficients: !!opencv-matrix\n   rows: 1\n   cols: 5\n   dt: d\n"
      "   data: [ -0.1, 0.02, 0.001, -0.002, 0.003 ]\n";
  const camera::Lens lens = camera::read_lens(write("lens.yaml", yaml));
  EXPECT_EQ(lens.width_px, 1280);
  EXPECT_DOUBLE_EQ(lens.fy_px, 901.0);
  EXPECT_DOUBLE_EQ(lens.p2, -0.002);
  EXPECT_DOUBLE_EQ(lens.k3, 0.003);
  const std::string wide = std::string(yaml).replace(yaml.find("900."), 4, "-9e9");
  EXPECT_THAT(problem("wide.yaml", wide), HasSubstr("fx_px"));
  EXPECT_THAT(problem("cut.yaml", yaml.substr(0, 120)), HasSubstr("cut.yaml"));
  EXPECT_THAT(problem("text.yml", "hello"), HasSubstr("text.yml"));
  EXPECT_THAT(problem("nan.yml", std::string(yaml).replace(yaml.find("900."), 4, ".Nan")),
              HasSubstr("nan.yml"));
}

TEST_F(LensFile, WhatIsNoLensIsAnErrorOfOneLineThatNamesTheFile) {
  const std::string good = camera::write_lens(lens_of(tilted_camera()));
  for (const std::string& text :
       {std::string(), std::string("width_px = 1920\n"), good + "k9 = 1.0\n",
        good.substr(0, good.size() / 2), std::string("\x00\x01\xff", 3), "fx_px = nan\n" + good}) {
    const std::string message = problem("lens.toml", text);
    EXPECT_THAT(message, HasSubstr("lens.toml"));
    EXPECT_EQ(message.find('\n'), std::string::npos) << message;
  }
  EXPECT_THROW(camera::read_lens(folder_.file("nothing.toml")), SetupError);
}

TEST_F(LensFile, ADistortionThatFoldsTheImageIsRefused) {
  camera::Lens lens = lens_of(tilted_camera());
  lens.k1 = -0.9;
  EXPECT_THAT(problem("lens.toml", camera::write_lens(lens)), HasSubstr("no inverse"));
}

}  // namespace
}  // namespace tp100::test
