// The lens of an overhead camera, and the files that describe it and what it looks at.

#include "camera/lens.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "../programs/process.h"
#include "core/error.h"
#include "marker_scene.h"
#include "support/accepted.h"
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
      const Vec3 direction = straight.direction(u, v, straight.axes());
      EXPECT_NEAR(ray.x, direction[0] / -direction[2], 1e-7);
      EXPECT_NEAR(ray.y, -direction[1] / -direction[2], 1e-7);
      const cv::Point2d back = lens.pixel(ray);
      EXPECT_NEAR(back.x, u, 1e-6);
      EXPECT_NEAR(back.y, v, 1e-6);
    }
  }
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
  EXPECT_THAT(problem("nan.yml", std::string(yaml).replace(yaml.find("900."), 4, ".Nan")),
              HasSubstr("nan.yml"));
}

TEST_F(LensFile, WhatIsNoLensIsAnErrorOfOneLineThatNamesTheFile) {
  const std::string good = camera::write_lens(lens_of(tilted_camera()));
  for (const std::string& text :
       {std::string(), std::string("width_px = 1920\n"), good + "k9 = 1.0\n",
        good.substr(0, good.size() / 2), std::string("\x00\x01\xff", 3), "fx_px = nan\n" + good}) {
    EXPECT_THAT(problem("lens.toml", text), HasSubstr("lens.toml"));
  }
  EXPECT_THROW(camera::read_lens(folder_.file("nothing.toml")), UserError);
}

TEST_F(LensFile, ADistortionThatFoldsTheImageIsRefused) {
  camera::Lens lens = lens_of(tilted_camera());
  lens.k1 = -0.9;
  EXPECT_THAT(problem("lens.toml", camera::write_lens(lens)), HasSubstr("no inverse"));
}

camera::View example() {
  camera::View view;
  view.lens = "lens.toml";
  view.floor_markers = {{10, {-0.2, -0.5}}, {11, {2.1, -0.5}}, {12, {2.1, 0.9}}, {13, {-0.2, 0.9}}};
  return view;
}

std::string view_problem(const std::string& text) {
  return refusal([&] { camera::parse_view(text, "view.toml"); });
}

// `scripts/test --accept` rewrites the example from the key table.
TEST(ViewFile, TheExampleIsWhatTheKeyTableSays) {
  expect_accepted("config/view.toml", camera::write_view(example()));
}

TEST(ViewFile, ReadsBackWhatItWrites) {
  camera::View view = example();
  view.dictionary = "apriltag_36h11";
  view.marker_turned_rad = 1.5;
  view.delay_s = 0.03;
  view.images = {.rate_hz = 2.5, .width_px = 320};
  EXPECT_EQ(camera::write_view(camera::parse_view(camera::write_view(view), "f")),
            camera::write_view(view));
  view.floor_markers.clear();
  view.floor_points = {{{1, 2}, {0, 0}}, {{3, 2}, {1, 0}}, {{3, 9}, {1, 1}}, {{1, 9}, {0, 1}}};
  EXPECT_EQ(camera::write_view(camera::parse_view(camera::write_view(view), "f")),
            camera::write_view(view));
}

TEST(ViewFile, WhatIsWrongIsNamedWithItsPlace) {
  const std::string good = camera::write_view(example());
  EXPECT_THAT(view_problem(""), HasSubstr("no lens file"));
  EXPECT_THAT(view_problem("lens = \"l\"\n"), HasSubstr("fewer than four points"));
  EXPECT_THAT(view_problem(good + "[[floor_marker]]\nid = 10\nx_m = 0\ny_m = 0\n"),
              HasSubstr("twice"));
  EXPECT_THAT(view_problem(good + "[[floor_marker]]\nid = 0\nx_m = 0\ny_m = 0\n"),
              HasSubstr("own"));
  EXPECT_THAT(view_problem(good + "[[floor_marker]]\nid = 14\nx_m = 0\n"), HasSubstr("y_m"));
  EXPECT_THAT(view_problem(good + "[[floor_marker]]\nid = 14\nx_m = 1e9\ny_m = 0\n"),
              HasSubstr("allowed"));
  EXPECT_THAT(view_problem(good + "[[floor_point]]\nu_px = 1\nv_px = 1\nx_m = 0\ny_m = 0\n"),
              HasSubstr("not both"));
  EXPECT_THAT(view_problem("lens = \"l\"\n[marker]\ndictionary = \"9x9\"\n"), HasSubstr("4x4_50"));
  EXPECT_THAT(view_problem("lens = \"l\"\n[marker]\nsize_m = nan\n"), HasSubstr("size_m"));
}

}  // namespace
}  // namespace tp100::test
