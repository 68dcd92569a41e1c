#include "course/goal.h"

#include <cmath>

#include "core/arithmetic.h"
#include "core/error.h"
#include "course/course.h"
#include "text/format.h"
#include "text/toml_document.h"

namespace tp100::course {
namespace {

/// Reads back as the same number.
std::string exact(double value) { return text::format("%.17g", value); }

std::string text_of(const Pose& start, const std::vector<Segment>& path) {
  std::string text = "\n[start]\nx_m = " + exact(start.x_m) + "\ny_m = " + exact(start.y_m) +
                     "\nyaw_deg = " + exact(wrap_angle(start.yaw_rad) * kDegPerRad) + "\n";
  for (const Segment& segment : path) text += segment_text(segment);
  return text;
}

std::string without(const TextFile& course, std::vector<std::string_view> keys) {
  if (course.text.empty())
    throw UserError("there is no course, and so no fence to drive within; choose a course first");
  for (const char* key : {"description", "identifies", "start", "segment", "disturbance"})
    keys.emplace_back(key);
  return text::without_keys(course.text, course.path, keys);
}

}  // namespace

TextFile course_to(const TextFile& course, const Goal& goal) {
  const std::string kept = without(course, {});
  std::vector<Segment> path;
  double yaw_rad = goal.from.yaw_rad;
  const auto turn_to = [&](double wanted_rad) {
    const double angle_rad = wrap_angle(wanted_rad - yaw_rad);
    if (std::abs(angle_rad * kDegPerRad) < kSmallestTurnDeg) return;
    path.emplace_back(Pivot{angle_rad});
    yaw_rad += angle_rad;
  };
  const double x_m = goal.to.x_m - goal.from.x_m, y_m = goal.to.y_m - goal.from.y_m;
  const double length_m = magnitude(x_m, y_m);
  if (length_m >= kSmallestLengthM) {
    turn_to(std::atan2(y_m, x_m));
    path.emplace_back(Line{length_m});
  }
  turn_to(goal.to.yaw_rad);
  if (path.empty()) throw UserError("the robot is there already");
  return {std::string(kGoalCourse) + ".toml",
          text::format("description = \"to (%.3f, %.3f) m, %.1f deg\"\n", goal.to.x_m, goal.to.y_m,
                       goal.to.yaw_rad * kDegPerRad) +
              kept + text_of(goal.from, path)};
}

TextFile course_along(const TextFile& course, const OtherPath& other) {
  const std::string kept = without(course, {"speed_mps"});
  return {other.name + ".toml", "description = \"" + one_line(other.description) +
                                    "\"\nspeed_mps = " + exact(other.speed_mps) +
                                    "\nidentifies = " + (other.identifies ? "true" : "false") +
                                    "\n" + kept + text_of(other.start, other.path)};
}

}  // namespace tp100::course
