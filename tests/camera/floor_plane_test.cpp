// The plane of the floor under an overhead camera, from markers at known places.

#include "camera/floor_plane.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "marker_scene.h"

namespace tp100::test {
namespace {

using ::testing::HasSubstr;

std::vector<camera::FloorPoint> points_of(const SceneCamera& scene,
                                          const std::vector<cv::Point2d>& places) {
  std::vector<camera::FloorPoint> points;
  for (const cv::Point2d& place : places) {
    const auto pixel = scene.pixel({place.x, place.y, 0.0});
    points.push_back({{pixel[0], pixel[1]}, place});
  }
  return points;
}

const std::vector<cv::Point2d> kCorners = {{-1.2, -0.7}, {1.2, -0.7}, {1.2, 0.7}, {-1.2, 0.7}};

TEST(FloorPlane, FindsTheLensAndLiftsEveryHeightExactly) {
  const SceneCamera scene = tilted_camera();
  const auto fit = camera::fit_floor(lens_of(scene), points_of(scene, kCorners));
  ASSERT_TRUE(fit.plane.has_value()) << fit.problem;
  EXPECT_NEAR(fit.plane->lens_m().x, scene.place_m[0], 1e-5);
  EXPECT_NEAR(fit.plane->lens_m().y, scene.place_m[1], 1e-5);
  EXPECT_NEAR(fit.plane->lens_m().z, scene.place_m[2], 1e-5);
  EXPECT_LT(fit.plane->rms_px(), 1e-3);
  for (const double height : {0.0, 0.06, 0.3}) {
    const auto pixel = scene.pixel({0.8, -0.4, height});
    const auto place = fit.plane->lift({pixel[0], pixel[1]}, height);
    ASSERT_TRUE(place.has_value());
    EXPECT_NEAR(place->x, 0.8, 1e-5);
    EXPECT_NEAR(place->y, -0.4, 1e-5);
  }
}

TEST(FloorPlane, PointsThatMakeNoPlaneAreRefusedWithTheReason) {
  const SceneCamera scene = tilted_camera();
  const camera::Lens lens = lens_of(scene);
  const auto problem = [&](const std::vector<camera::FloorPoint>& points) {
    const auto fit = camera::fit_floor(lens, points);
    EXPECT_FALSE(fit.plane.has_value());
    return fit.problem;
  };
  std::vector<camera::FloorPoint> good = points_of(scene, kCorners);
  EXPECT_THAT(problem({good[0], good[1], good[2]}), HasSubstr("fewer than four"));
  EXPECT_THAT(problem(points_of(scene, {{-1, 0}, {-0.5, 0}, {0.5, 0}, {1, 0}})),
              HasSubstr("one line"));
  std::vector<camera::FloorPoint> swapped = good;
  std::swap(swapped[0].world_m, swapped[1].world_m);
  EXPECT_NE(problem(swapped), "");
  std::vector<camera::FloorPoint> mirrored = good;
  for (camera::FloorPoint& point : mirrored) point.world_m.y = -point.world_m.y;
  EXPECT_NE(problem(mirrored), "");
  std::vector<camera::FloorPoint> wild = good;
  for (camera::FloorPoint& point : wild) point.pixel = {1e6, -1e6};
  EXPECT_NE(problem(wild), "");
}

TEST(FloorPlane, WhatDoesNotLookDownHasNoPlace) {
  SceneCamera scene;
  scene.tilt_x_rad = 1.1;
  scene.place_m = {0.0, -2.0, 1.0};
  const auto fit = camera::fit_floor(
      lens_of(scene), points_of(scene, {{-0.5, -0.8}, {0.5, -0.8}, {0.5, 0.2}, {-0.5, 0.2}}));
  ASSERT_TRUE(fit.plane.has_value()) << fit.problem;
  EXPECT_FALSE(fit.plane->lift({960, 0}, 0.0).has_value()) << "the ray points to the sky";
  EXPECT_FALSE(fit.plane->lift({960, 1079}, 1.2).has_value()) << "the height is above the lens";
  EXPECT_TRUE(fit.plane->lift({960, 1079}, 0.0).has_value());
}

}  // namespace
}  // namespace tp100::test
