// Paths, how they are mirrored, and fences around them.

#include "course/path.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "core/arithmetic.h"
#include "course/course.h"

namespace tp100::course {
namespace {

Course course_of(std::vector<Segment> path, const Pose& start = {}) {
  Course course;
  course.start = start;
  course.path = std::move(path);
  return course;
}

const Course kMixed = course_of({Line{0.5}, Arc{0.3, -kPi / 2}, Pivot{kPi / 2}, Line{0.4},
                                 Arc{0.2, 1.5 * kPi}, Pivot{-3 * kPi}},
                                {.x_m = 0.2, .y_m = -0.1, .yaw_rad = 0.3});

TEST(Path, PositionIsTheIntegralOfItsTangent) {
  const Path path(kMixed);
  for (const PathSegment& segment : path.segments()) {
    if (segment.kind == PathSegment::Kind::kPivot) continue;
    const auto index = static_cast<std::size_t>(&segment - path.segments().data());
    const double step = 1e-5;
    for (double s = step; s < segment.length_m - step; s += 0.01) {
      const PathPoint a = path.at(index, s - step), b = path.at(index, s + step);
      const PathPoint here = path.at(index, s);
      EXPECT_NEAR((b.x_m - a.x_m) / (2 * step), std::cos(here.yaw_rad), 1e-8);
      EXPECT_NEAR((b.y_m - a.y_m) / (2 * step), std::sin(here.yaw_rad), 1e-8);
      EXPECT_NEAR((b.yaw_rad - a.yaw_rad) / (2 * step), here.curvature_1pm, 1e-8);
    }
  }
}

TEST(Path, SegmentsJoinWithoutAGapAndYawIsUnwrapped) {
  const Path path(kMixed);
  EXPECT_EQ(path.at(0.0).x_m, 0.2);
  EXPECT_EQ(path.at(0.0).y_m, -0.1);
  EXPECT_EQ(path.at(0.0).yaw_rad, 0.3);
  for (std::size_t i = 1; i < path.segments().size(); ++i) {
    EXPECT_DOUBLE_EQ(path.segments()[i].begin.x_m, path.segments()[i - 1].end.x_m);
    EXPECT_DOUBLE_EQ(path.segments()[i].begin.y_m, path.segments()[i - 1].end.y_m);
    EXPECT_DOUBLE_EQ(path.segments()[i].begin.yaw_rad, path.segments()[i - 1].end.yaw_rad);
    EXPECT_DOUBLE_EQ(path.segments()[i].begin.s_m, path.segments()[i - 1].end.s_m);
  }
  EXPECT_NEAR(path.segments().back().end.yaw_rad, 0.3 - 1.5 * kPi, 1e-12);
}

// A point of an arc of many turns lies on each of them: the one that is meant is the nearest along
// the path.
TEST(Path, ProjectionReturnsTheOffsetOfPointsBesideTheSegment) {
  std::vector<Course> courses{kMixed};
  for (const double turns : {359.0 / 360.0, 1.0, 400.0 / 360.0, 2.0, -10.0})
    courses.push_back(course_of({Arc{0.3, turns * 2.0 * kPi}}));
  for (const Course& course : courses) {
    const Path path(course);
    for (std::size_t i = 0; i < path.segments().size(); ++i) {
      const double length = path.segments()[i].length_m, quarter = 0.2 * kPi / 2.0;
      for (double offset = 0.0; offset <= length; offset += 0.013) {
        const PathPoint p = path.at(i, offset);
        for (const double aside : {-0.1, 0.0, 0.1})
          for (const double about : {offset - quarter, offset, offset + quarter}) {
            const double x = p.x_m - aside * std::sin(p.yaw_rad);
            const double y = p.y_m + aside * std::cos(p.yaw_rad);
            ASSERT_NEAR(path.project(i, x, y, about), offset, 1e-9) << i << " " << about;
          }
      }
    }
  }
}

TEST(Path, ProjectionAndOffsetsStopAtTheEnds) {
  const Path path(course_of({Line{1.0}, Arc{0.5, kPi / 2}}));
  EXPECT_EQ(path.project(0, -3.0, 1.0, 0.5), 0.0);
  EXPECT_EQ(path.project(0, 4.0, 1.0, 0.5), 1.0);
  EXPECT_EQ(path.project(1, 0.9, -0.1, 0.4), 0.0);
  EXPECT_EQ(path.project(1, 1.4, 0.7, 0.4), path.segments()[1].length_m);
  EXPECT_EQ(path.at(0, -5.0).x_m, 0.0);
  EXPECT_EQ(path.at(0, 5.0).x_m, 1.0);
  EXPECT_EQ(path.at(-5.0).x_m, 0.0);
  EXPECT_NEAR(path.at(5.0).y_m, 0.5, 1e-12);
  const Path turns(course_of({Arc{0.5, 4.0 * kPi}}));
  EXPECT_EQ(turns.project(0, -0.1, 0.0, 0.0), 0.0) << "a little behind the start";
  EXPECT_EQ(turns.project(0, 0.1, 0.0, turns.length_m()), turns.length_m());
}

TEST(Path, AtAPivotTheLengthGivesThePoseBeforeIt) {
  const Path path(course_of({Line{1.0}, Pivot{1.0}, Line{1.0}, Pivot{1.0}}));
  EXPECT_DOUBLE_EQ(path.at(1.0).yaw_rad, 0.0);
  EXPECT_DOUBLE_EQ(path.at(1.5).yaw_rad, 1.0);
  EXPECT_DOUBLE_EQ(path.at(9.0).yaw_rad, 1.0);
  EXPECT_DOUBLE_EQ(path.at(9.0).x_m, 1.0 + std::cos(1.0));
}

TEST(Path, DistanceAgreesWithADenseSearch) {
  const Path path(kMixed);
  for (const auto& [from, to] : {std::pair(0.0, 9.0), std::pair(0.3, 0.7), std::pair(1.2, 2.0)})
    for (double x = -0.5; x < 1.6; x += 0.21)
      for (double y = -1.0; y < 1.0; y += 0.19) {
        double best = 1e9;
        for (double s = from; s <= std::min(to, path.length_m()); s += 1e-4) {
          const PathPoint p = path.at(s);
          best = std::min(best, std::hypot(p.x_m - x, p.y_m - y));
        }
        EXPECT_NEAR(path.distance(x, y, from, to), best, 1e-4) << x << " " << y << " " << from;
      }
}

TEST(Path, OfPivotsAloneIsAPath) {
  const Path spin(course_of({Pivot{kPi}}));
  EXPECT_EQ(spin.length_m(), 0.0);
  EXPECT_DOUBLE_EQ(spin.distance(0.3, 0.4, 0.0, 0.0), 0.5);
  EXPECT_EQ(spin.at(1.0).yaw_rad, 0.0);
}

TEST(Mirror, TurnsLeftIntoRightAndNothingElse) {
  Course course;
  course.start.yaw_rad = 0.2;
  course.path = {Line{1.0}, Arc{0.4, kPi}, Pivot{0.5}, Line{0.3}};
  course.disturbances = {{0.5, 0.04, 0.1, 0.3}};
  course.terrain.obstacles = {Ramp{{0.7, -0.8, 0.3}, 0.08, 0.4, 0.2, 0.5, 0.4}};
  course.terrain.surfaces.push_back({"felt", {0.1, 0.2, 0.3}, 1.0, 1.0, 1.0, 0.1});
  course.fence = {-1.0, 2.0, -0.5, 1.5, {}, {{{0.1, 0.2}, {0.3, 0.2}, {0.1, 0.4}}}};
  const Course other = mirrored(course);
  const Path path(course), mirror(other);
  for (double s = 0.0; s < path.length_m(); s += 0.05) {
    EXPECT_NEAR(mirror.at(s).x_m, path.at(s).x_m, 1e-12);
    EXPECT_NEAR(mirror.at(s).y_m, -path.at(s).y_m, 1e-12);
    EXPECT_NEAR(mirror.at(s).yaw_rad, -path.at(s).yaw_rad, 1e-12);
  }
  EXPECT_EQ(other.disturbances[0].sideways_m, -0.04);
  const auto ramp = std::get<Ramp>(other.terrain.obstacles[0]);
  EXPECT_EQ(ramp.place.y_m, 0.8);
  EXPECT_EQ(ramp.up_rad, 0.4);
  EXPECT_EQ(other.terrain.surfaces[0].place.heading_rad, -0.3);
  EXPECT_EQ(other.fence.min_y_m, -1.5);
  EXPECT_EQ(other.fence.max_y_m, 0.5);
  EXPECT_EQ(other.fence.keep_out.at(0).at(2).y_m, -0.4);
}

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
