#include "terrain/climbable.h"

#include <cmath>
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
  for (double s = 0.0; s <= path.length_m(); s += kStepM) {
    const course::PathPoint point = path.at(s);
    const double c = std::cos(point.yaw_rad);
    const double sn = std::sin(point.yaw_rad);
    for (const double side : {-half_width_m, half_width_m}) {
      const Profile profile(outline, point.x_m - side * sn, point.y_m + side * c, c, sn);
      if (!profile.empty() && profile.begin_m() <= 0.0 && profile.end_m() >= 0.0) return true;
    }
  }
  return false;
}

[[noreturn]] void refuse(const course::Course& course, const course::Robot& robot,
                         const std::string& piece, const std::string& why) {
  throw UserError("course " + course.name + ": " + piece + " cannot be climbed by robot " +
                  robot.name + ": " + why);
}

}  // namespace

void require_climbable(const course::Course& course, const course::Robot& robot) {
  if (course.terrain.flat()) return;
  const model::ClimbGeometry geometry = climb_geometry(robot.shape);
  const course::Path path(course);
  const double limit = model::climb_limit_m(geometry);
  for (std::size_t i = 0; i < course.terrain.blocks.size(); ++i) {
    const course::Block& block = course.terrain.blocks[i];
    if (block.height_m <= limit || !meets(path, outline_of(block), robot.shape.gauge_m / 2.0))
      continue;
    refuse(course, robot, "block " + std::to_string(i + 1),
           "it is " + rounded(block.height_m, 1e-3) + " mm high, the limit is " +
               rounded(limit, 1e-3) +
               " mm; lower the block or, if the robot file is wrong, shape.com_height_m");
  }
  // On a slope the centre of mass must stay ahead of the rear contact.
  const double steepest = std::atan(geometry.com_forward_m / geometry.com_height_m);
  for (std::size_t i = 0; i < course.terrain.ramps.size(); ++i) {
    const course::Ramp& ramp = course.terrain.ramps[i];
    const double slope = std::max(ramp.up_rad, ramp.down_rad);
    if (slope < steepest || !meets(path, outline_of(ramp), robot.shape.gauge_m / 2.0)) continue;
    refuse(course, robot, "ramp " + std::to_string(i + 1),
           "it is " + rounded(slope, kRadPerDeg) + " deg steep, beyond " +
               rounded(steepest, kRadPerDeg) + " deg it falls over; make the ramp flatter");
  }
}

}  // namespace tp100::terrain
