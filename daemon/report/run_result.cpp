#include "report/run_result.h"

#include <sstream>

#include "core/limits.h"
#include "core/pose.h"
#include "text/format.h"

namespace tp100::report {

bool at_end(const course::Path& path, const Pose& truth) {
  const course::PathPoint end = path.at(path.segments().size() - 1, path.length_m());
  return magnitude(truth.x_m - end.x_m, truth.y_m - end.y_m) <= kEndToleranceM;
}

void judge_end(RunResult& result, RunState state, FaultMask faults, std::optional<bool> at_end) {
  const std::optional<Fault> fault = first_fault(faults);
  result.finished = state == RunState::kFinished;
  result.completed = result.finished && at_end.value_or(false);
  result.cause = result.completed              ? ""
                 : !result.began_ns            ? kNeverBegan
                 : result.finished && !at_end  ? "unknown: course or poses are missing"
                 : result.finished             ? "ended too far from the end of the path"
                 : state == RunState::kRunning ? "the recording ends before the run does"
                 : fault                       ? describe(*fault).name
                                               : "interrupted";
}

std::string pose_columns(std::string_view name) {
  std::string columns;
  constexpr Pose kAny{};
  visit_fields(
      [&](auto field, double) { columns += "," + std::string(name) + "_" + std::string(field); },
      kAny);
  return columns;
}

std::string poses_csv(const RunResult& result) {
  std::ostringstream out;
  out.precision(17);
  out << "t_s";
  out << pose_columns("truth") << pose_columns("world");
  for (const PoseSource source : kPoseSources)
    if (result.has_estimate(source)) out << pose_columns(to_string(source));
  out << ",progress_m\n";
  for (const TrajectoryPoint& point : result.points) {
    out << point.t_s;
    const auto write = [&out](const Pose& pose) {
      visit_fields([&](auto, double value) { out << ',' << value; }, pose);
    };
    write(point.truth);
    write(point.world);
    for (const PoseSource source : kPoseSources)
      if (result.has_estimate(source)) write(point.estimates[source]);
    out << ',' << point.progress_m << '\n';
  }
  return out.str();
}

std::string tum_line(double t_s, const Pose& pose) {
  const Quaternion q = quaternion(pose);
  return text::format("%.6f %.6f %.6f %.6f %.9f %.9f %.9f %.9f\n", t_s, pose.x_m, pose.y_m,
                      pose.z_m, q.x, q.y, q.z, q.w);
}

}  // namespace tp100::report
