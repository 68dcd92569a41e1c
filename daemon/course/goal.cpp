#include "course/goal.h"

#include <cmath>

#include "core/angle.h"
#include "core/arithmetic.h"
#include "course/course.h"
#include "text/format.h"
#include "text/toml_document.h"

namespace tp100::course {
namespace {

/// The same number when it is read again.
std::string exact(double value) { return text::format("%.17g", value); }

}  // namespace

TextFile course_to(const TextFile& course, const Goal& goal) {
  if (course.text.empty())
    throw SetupError("there is no course, and so no fence to drive within; choose a course first");
  std::string path;
  double yaw_rad = goal.from.yaw_rad;
  const auto turn_to = [&](double wanted_rad) {
    const double angle_rad = wrap_angle(wanted_rad - yaw_rad);
    const double angle_deg = angle_rad * kDegPerRad;
    if (std::abs(angle_deg) < kSmallestTurnDeg) return;
    path += "\n[[segment]]\ntype = \"pivot\"\nangle_deg = " + exact(angle_deg) + "\n";
    yaw_rad += angle_rad;
  };
  const double x_m = goal.to.x_m - goal.from.x_m, y_m = goal.to.y_m - goal.from.y_m;
  const double length_m = magnitude(x_m, y_m);
  if (length_m >= kSmallestLengthM) {
    turn_to(std::atan2(y_m, x_m));
    path += "\n[[segment]]\ntype = \"line\"\nlength_m = " + exact(length_m) + "\n";
  }
  turn_to(goal.to.yaw_rad);
  if (path.empty()) throw SetupError("the robot is there already");

  const std::string kept = text::without_keys(
      course.text, course.path, {"description", "identifies", "start", "segment", "disturbance"});
  return {std::string(kGoalCourse) + ".toml",
          text::format("description = \"to (%.3f, %.3f) m, %.1f deg\"\n", goal.to.x_m, goal.to.y_m,
                       goal.to.yaw_rad * kDegPerRad) +
              kept + "\n[start]\nx_m = " + exact(goal.from.x_m) +
              "\ny_m = " + exact(goal.from.y_m) +
              "\nyaw_deg = " + exact(wrap_angle(goal.from.yaw_rad) * kDegPerRad) + "\n" + path};
}

}  // namespace tp100::course
