#include "course/path.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/arithmetic.h"

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

TEST(Path, ProjectionOntoAnArcOfManyTurnsStopsAtItsEnds) {
  const Path path(course_of({Arc{0.5, 4.0 * kPi}}));
  const double length = path.length_m();
  EXPECT_EQ(path.project(0, -0.1, 0.0, 0.0), 0.0) << "a little behind the start";
  EXPECT_EQ(path.project(0, 0.1, 0.0, length), length) << "a little behind the end";
}

TEST(Path, ProjectionAndOffsetsStopAtTheEnds) {
  const Path path(course_of({Line{1.0}, Arc{0.5, kPi / 2}}));
  EXPECT_EQ(path.project(0, -3.0, 1.0), 0.0);
  EXPECT_EQ(path.project(0, 4.0, 1.0), 1.0);
  EXPECT_EQ(path.project(1, 0.9, -0.1), 0.0);
  EXPECT_EQ(path.project(1, 1.4, 0.7), path.segments()[1].length_m);
  EXPECT_EQ(path.at(0, -5.0).x_m, 0.0);
  EXPECT_EQ(path.at(0, 5.0).x_m, 1.0);
  EXPECT_EQ(path.at(-5.0).x_m, 0.0);
  EXPECT_NEAR(path.at(5.0).y_m, 0.5, 1e-12);
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
  course.name = "test";
  course.start.yaw_rad = 0.2;
  course.path = {Line{1.0}, Arc{0.4, kPi}, Pivot{0.5}, Line{0.3}};
  course.disturbances = {{0.5, 0.04, 0.1, 0.3}};
  course.terrain.ramps.push_back({{0.7, -0.8, 0.3}, 0.08, 0.4, 0.2, 0.5, 0.4});
  course.terrain.blocks.push_back({{1.2, -0.8, 0.3}, 0.037, 0.1, 0.4});
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
  EXPECT_EQ(other.terrain.ramps[0].place.y_m, 0.8);
  EXPECT_EQ(other.terrain.ramps[0].up_rad, 0.4);
  EXPECT_EQ(other.terrain.blocks[0].place.heading_rad, -0.3);
  EXPECT_EQ(other.fence.min_y_m, -1.5);
  EXPECT_EQ(other.fence.max_y_m, 0.5);
  EXPECT_EQ(other.fence.keep_out.at(0).at(2).y_m, -0.4);
  const Course back = mirrored(other);
  EXPECT_EQ(back.terrain.surfaces[0].place.y_m, 0.2);
  EXPECT_EQ(back.start.yaw_rad, 0.2);
}

}  // namespace
}  // namespace tp100::course
