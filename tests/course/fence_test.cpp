#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "core/arithmetic.h"
#include "course/course.h"

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

}  // namespace
}  // namespace tp100::course
