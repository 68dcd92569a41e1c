#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "core/arithmetic.h"
#include "course/course.h"
#include "course/path.h"

namespace tp100::course {
namespace {

/// Whole turns of the corners around a place, by the sum of the angles between them: no rays.
long turns_around(const Polygon& polygon, double x_m, double y_m) {
  double sum = 0.0;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vertex &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
    sum += wrap_angle(std::atan2(b.y_m - y_m, b.x_m - x_m) - std::atan2(a.y_m - y_m, a.x_m - x_m));
  }
  return std::lround(sum / (2.0 * kPi));
}

/// A polygon around (0, 0) whose edges do not cross, with dents.
Polygon star(std::mt19937_64& random) {
  std::uniform_real_distribution<> share(0.1, 1.0);
  const std::size_t count = 3 + random() % 20;
  Polygon polygon;
  for (std::size_t i = 0; i < count; ++i) {
    const double angle = 2.0 * kPi * static_cast<double>(i) / static_cast<double>(count);
    const double radius_m = 2.0 * share(random);
    polygon.push_back({radius_m * std::cos(angle), radius_m * std::sin(angle)});
  }
  if (random() % 2 == 0) std::reverse(polygon.begin(), polygon.end());
  return polygon;
}

double distance_m(const Polygon& polygon, double x_m, double y_m) {
  double least_m = 1e9;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vertex point = nearest_on_edge(polygon, i, x_m, y_m);
    least_m = std::min(least_m, std::hypot(point.x_m - x_m, point.y_m - y_m));
  }
  return least_m;
}

TEST(Fence, APlaceIsInsideAPolygonIfTheCornersGoAroundIt) {
  std::mt19937_64 random(1);
  std::uniform_real_distribution<> place(-2.2, 2.2);
  int inside = 0;
  for (int i = 0; i < 300; ++i) {
    const Polygon polygon = star(random);
    EXPECT_FALSE(crosses_itself(polygon));
    for (int k = 0; k < 100; ++k) {
      const double x_m = place(random), y_m = place(random);
      if (distance_m(polygon, x_m, y_m) < 1e-9) continue;
      ASSERT_EQ(contains(polygon, x_m, y_m), turns_around(polygon, x_m, y_m) != 0)
          << "polygon " << i << " at " << x_m << ", " << y_m;
      inside += contains(polygon, x_m, y_m) ? 1 : 0;
    }
  }
  EXPECT_GT(inside, 2000);
}

TEST(Fence, ARectangleAndItsCornersHoldTheSamePlaces) {
  const Fence rectangle{-1.0, 2.0, -0.5, 1.5};
  Fence polygon = rectangle;
  polygon.corners = corners_of(rectangle);
  std::mt19937_64 random(2);
  std::uniform_real_distribution<> place(-3.0, 3.0);
  for (int i = 0; i < 20000; ++i) {
    const double x_m = place(random), y_m = place(random);
    EXPECT_EQ(contains(rectangle, x_m, y_m), contains(polygon, x_m, y_m));
  }
  EXPECT_TRUE(contains(rectangle, 2.0, 1.5)) << "its edge belongs to it";
}

TEST(Fence, AKeepOutAreaIsOutside) {
  const Fence fence{-1.0, 1.0, -1.0, 1.0, {}, {{{0.2, 0.2}, {0.8, 0.2}, {0.8, 0.8}}}};
  EXPECT_TRUE(contains(fence, 0.0, 0.0));
  EXPECT_FALSE(contains(fence, 0.6, 0.4));
  EXPECT_TRUE(contains(fence, 0.4, 0.6)) << "beside its long edge";
}

TEST(Fence, FindsEdgesThatCrossOrTouch) {
  EXPECT_TRUE(crosses_itself({{0, 0}, {1, 1}, {1, 0}, {0, 1}})) << "a bow tie";
  EXPECT_TRUE(crosses_itself({{0, 0}, {2, 0}, {2, 1}, {1, 0}, {0, 1}})) << "a corner on an edge";
  EXPECT_TRUE(crosses_itself({{0, 0}, {1, 0}, {0.5, 0}})) << "without an area";
  EXPECT_TRUE(crosses_itself({{0, 0}, {1, 0}, {1, 0}, {1, 1}})) << "a corner twice";
  EXPECT_FALSE(crosses_itself({{0, 0}, {1, 0}, {2, 0}, {2, 1}, {0, 1}})) << "a corner on a line";
}

/// The first of points 1 mm apart at which the reference point may not be.
std::optional<PathPoint> first_sample_outside(const Path& path, const Fence& fence) {
  for (std::size_t i = 0; i < path.segments().size(); ++i) {
    const double length_m = path.segments()[i].length_m;
    for (double offset_m = 0.0; offset_m <= length_m; offset_m += 0.001) {
      const PathPoint point = path.at(i, offset_m);
      if (!contains(fence, point.x_m, point.y_m)) return point;
    }
  }
  return std::nullopt;
}

// A course whose path leaves its fence or crosses a keep-out area would drive the robot there.
TEST(Fence, APathIsOutsideWhereItFirstCrossesAnEdge) {
  std::mt19937_64 random(5);
  std::uniform_real_distribution<> place(-0.2, 0.2), length(0.05, 0.8), turn(-7.0, 7.0),
      area(-1.5, 1.5);
  int inside = 0, outside = 0;
  for (int i = 0; i < 2000; ++i) {
    Course course;
    course.start = {.x_m = place(random), .y_m = place(random), .yaw_rad = turn(random)};
    for (int k = 0; k < 3; ++k) {
      if (random() % 2 == 0) course.path.push_back(Line{length(random)});
      if (random() % 2 == 0) course.path.push_back(Pivot{turn(random)});
      course.path.push_back(Arc{length(random) / 3.0, turn(random)});
    }
    if (random() % 4 == 0) {
      course.fence = {-1.0, 1.0, -1.0, 1.0};
    } else {
      course.fence = {-2.0, 2.0, -2.0, 2.0, star(random)};
    }
    for (std::size_t k = random() % 3; k > 0; --k) {
      const double x_m = area(random), y_m = area(random);
      Polygon polygon = star(random);
      for (Vertex& corner : polygon) corner = {x_m + 0.2 * corner.x_m, y_m + 0.2 * corner.y_m};
      course.fence.keep_out.push_back(polygon);
    }
    const Path path(course);
    const auto found = first_point_outside(path, course.fence);
    const auto sampled = first_sample_outside(path, course.fence);
    if (sampled) {
      ASSERT_TRUE(found) << "path " << i;
      // Rectangles are sampled more coarsely.
      const double late_m = course.fence.corners.empty() ? 0.05 : 1e-6;
      EXPECT_LE(found->s_m, sampled->s_m + late_m) << "path " << i;
      ++outside;
    } else {
      ++inside;
    }
    // What the samples miss is a corner that the path cuts off or touches.
    if (found && (!sampled || found->s_m < sampled->s_m - 0.002)) {
      double least_m = 1e9;
      for (const Polygon& each : course.fence.keep_out)
        least_m = std::min(least_m, distance_m(each, found->x_m, found->y_m));
      if (!course.fence.corners.empty())
        least_m = std::min(least_m, distance_m(course.fence.corners, found->x_m, found->y_m));
      EXPECT_LT(least_m, 1e-9) << "path " << i;
    }
  }
  EXPECT_GT(inside, 200);
  EXPECT_GT(outside, 200);
}

// Going back by that distance is enough, and by less is not.
TEST(Fence, HowFarOutsideIsTheDistanceToTheNearestPlaceInside) {
  const Fence rectangle{-1.0, 2.0, -0.5, 1.5};
  Fence corners = rectangle;
  corners.corners = corners_of(rectangle);
  Fence kept = rectangle;
  kept.keep_out = {{{0.0, 0.0}, {1.0, 0.0}, {0.0, 1.0}}};
  std::mt19937_64 random(7);
  std::uniform_real_distribution<> anywhere(-3.0, 4.0);
  for (int i = 0; i < 2000; ++i) {
    const double x_m = anywhere(random), y_m = anywhere(random);
    EXPECT_NEAR(outside_m(rectangle, x_m, y_m), outside_m(corners, x_m, y_m), 1e-12);
    for (const Fence& fence : {rectangle, corners, kept}) {
      const double out_m = outside_m(fence, x_m, y_m);
      ASSERT_EQ(out_m == 0.0, contains(fence, x_m, y_m)) << x_m << ' ' << y_m;
      if (out_m == 0.0) continue;
      bool nearer = false, there = false;
      for (int turn = 0; turn < 720; ++turn) {
        const double c = std::cos(turn * kPi / 360.0), s = std::sin(turn * kPi / 360.0);
        nearer |= contains(fence, x_m + 0.99 * out_m * c, y_m + 0.99 * out_m * s);
        there |= contains(fence, x_m + 1.01 * out_m * c, y_m + 1.01 * out_m * s);
      }
      EXPECT_TRUE(there && !nearer) << x_m << ' ' << y_m;
    }
  }
}

}  // namespace
}  // namespace tp100::course
