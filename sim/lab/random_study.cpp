#include "sim/lab/random_study.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <vector>

#include "core/arithmetic.h"
#include "core/error.h"
#include "course/bundled_files.h"
#include "course/path.h"
#include "sim/lab/sampled.h"
#include "sim/robot/options.h"

namespace tp100::sim {
namespace {

// Spacing of the points that represent the path.
constexpr double kSpacingM = 0.002;
// Only points within this distance of the run's progress are compared, because the path may pass
// the same place again.
constexpr double kWindowM = 0.15;
constexpr double kRecoveryS = 4.0;
// Deviations up to this one need not be reported.
constexpr double kUnnoticedM = 0.025;

std::vector<course::PathPoint> points_of(const course::Path& path) {
  std::vector<course::PathPoint> points;
  for (std::size_t i = 0; i < path.segments().size(); ++i) {
    const double length_m = path.segments()[i].length_m;
    const int parts = std::max(1, static_cast<int>(length_m / kSpacingM));
    for (int part = 0; part <= parts; ++part) points.push_back(path.at(i, length_m * part / parts));
  }
  return points;
}

double distance_m(const std::vector<course::PathPoint>& path,
                  const report::TrajectoryPoint& point) {
  double least_m = std::numeric_limits<double>::infinity();
  for (const course::PathPoint& at : path)
    if (std::abs(at.s_m - point.progress_m) <= kWindowM)
      least_m = std::min(least_m, magnitude(at.x_m - point.world.x_m, at.y_m - point.world.y_m));
  return least_m;
}

}  // namespace

RandomDrive drive_random(std::uint64_t seed) {
  const std::vector<std::string> robots = course::bundled_names(course::Bundled::kRobots);
  RandomDrive drive;
  drive.seed = seed;
  drive.robot = robots[seed % robots.size()];
  Options options;
  options.robot = drive.robot;
  Trial trial{.course = random_course(seed),
              .robot = load(options).robot,
              .first_seed = seed,
              .runs = 1,
              .both_directions = false};
  if (!trial.course.terrain.flat() && seed % 2 == 0) trial.setup = bridge::Setup::kTerrain;
  std::vector<TrialRun> runs;
  try {
    runs = run_trial(trial);
  } catch (const UserError& error) {
    drive.refused = error.what();
    return drive;
  }
  const report::RunResult& run = runs.front().result;
  drive.completed = run.completed;
  drive.cause = run.cause;
  const std::vector<course::PathPoint> path = points_of(course::Path(trial.course));
  for (const report::TrajectoryPoint& point : run.points)
    if (!point.recovering && !disturbed(run, point.t_s, kRecoveryS))
      drive.deviation_m = std::max(drive.deviation_m, distance_m(path, point));
  drive.false_alarms = runs.front().figures.tracking.false_alarms;
  const double reported_m = runs.front().figures.tracking.max_cross_track_m;
  if (drive.deviation_m > kUnnoticedM)
    drive.unreported_m = std::max(0.0, drive.deviation_m - reported_m);
  return drive;
}

CourseStudy study_random(std::uint64_t first_seed, int count) {
  CourseStudy study;
  study.course = "random";
  study.robot = "all in turn";
  study.setup = "flat, terrain";
  study.board = to_string(BoardKind::kNative);
  std::vector<double> deviations_cm;
  double unreported_cm = 0.0;
  int false_alarms = 0;
  for (int i = 0; i < count; ++i) {
    const RandomDrive drive = drive_random(first_seed + static_cast<std::uint64_t>(i));
    const auto seed = static_cast<unsigned long long>(drive.seed);
    if (!drive.refused.empty()) {
      std::fprintf(stderr, "random course %llu refused: %s\n", seed, drive.refused.c_str());
      continue;
    }
    ++study.runs;
    study.completed += drive.completed;
    deviations_cm.push_back(100.0 * drive.deviation_m);
    unreported_cm = std::max(unreported_cm, 100.0 * drive.unreported_m);
    false_alarms += drive.false_alarms;
    if (!drive.completed || drive.unreported_m > 0.0 || drive.false_alarms > 0)
      std::fprintf(stderr,
                   "random course %llu, %s: %s, %.1f cm off the path, %.1f cm unreported, "
                   "%d false alarms\n",
                   seed, drive.robot.c_str(), drive.completed ? "completed" : drive.cause.c_str(),
                   100.0 * drive.deviation_m, 100.0 * drive.unreported_m, drive.false_alarms);
    if (study.runs % 50 == 0)
      std::fprintf(stderr, "%d of %d random courses, %d completed\n", i + 1, count,
                   study.completed);
  }
  study.judged = {
      {study.course, study.robot, "distance from the path", "cm", -1.0, spread(deviations_cm)},
      judged_value(study, "largest part of it that no figure shows", "cm", 0.2, unreported_cm),
      judged_value(study, kFalseAlarms, "", -1.0, false_alarms)};
  return study;
}

}  // namespace tp100::sim
