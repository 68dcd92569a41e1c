#include "terrain/climbable.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <string>

#include "core/arithmetic.h"
#include "core/error.h"
#include "course/path.h"
#include "terrain/terrain_follower.h"
#include "terrain/world.h"
#include "text/toml_document.h"

namespace tp100::terrain {
namespace {

constexpr double kStepM = 0.01;

std::string rounded(double value, double unit) {
  return text::number_text(std::round(value / unit * 10.0) / 10.0);
}

bool meets(const course::Path& path, const Outline& outline, double half_width_m) {
  const int steps = static_cast<int>(path.length_m() / kStepM);
  for (int step = 0; step <= steps; ++step) {
    const course::PathPoint point = path.at(step * kStepM);
    const double c = std::cos(point.yaw_rad);
    const double sn = std::sin(point.yaw_rad);
    for (const double side : {-half_width_m, half_width_m}) {
      const Profile profile(outline, point.x_m - side * sn, point.y_m + side * c, c, sn);
      if (!profile.empty() && profile.begin_m() <= 0.0 && profile.end_m() >= 0.0) return true;
    }
  }
  return false;
}

}  // namespace

void require_climbable(const course::Course& course, const course::Robot& robot) {
  if (course.terrain.flat()) return;
  const model::ClimbGeometry geometry = climb_geometry(robot.shape);
  const course::Path path(course);
  const double limit_m = model::climb_limit_m(geometry);
  // On a slope the centre of mass must stay ahead of the rear contact.
  const double limit_rad = std::atan(geometry.com_forward_m / geometry.com_height_m);
  std::map<std::string, int> numbers;
  for (const Outline& outline : outlines_of(course.terrain)) {
    const std::string kind = to_string(outline.obstacle);
    const int number = ++numbers[kind];
    double wall_m = 0.0, slope_rad = 0.0;
    for (std::size_t i = 1; i < outline.points.size(); ++i) {
      const double ahead_m = outline.points[i].along_m - outline.points[i - 1].along_m;
      const double up_m = std::abs(outline.points[i].height_m - outline.points[i - 1].height_m);
      double& most = ahead_m > 0.0 ? slope_rad : wall_m;
      most = std::max(most, ahead_m > 0.0 ? std::atan(up_m / ahead_m) : up_m);
    }
    std::string why;
    if (slope_rad >= limit_rad)
      why = rounded(slope_rad, kRadPerDeg) + " deg steep, beyond " +
            rounded(limit_rad, kRadPerDeg) + " deg it falls over; make the " + kind + " flatter";
    if (wall_m > limit_m)
      why = rounded(wall_m, 1e-3) + " mm high, the limit is " + rounded(limit_m, 1e-3) +
            " mm; lower the " + kind + " or, if the robot file is wrong, shape.com_height_m";
    if (why.empty() || !meets(path, outline, robot.shape.gauge_m / 2.0)) continue;
    throw UserError("course " + course.name + ": " + kind + " " + std::to_string(number) +
                    " cannot be climbed by robot " + robot.name + ": it is " + why);
  }
}

}  // namespace tp100::terrain
