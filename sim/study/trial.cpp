#include "sim/study/trial.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/angle.h"
#include "course/mirror.h"

namespace tp100::sim {
namespace {

// A body that leans by more, or did so until a moment ago, is on an obstacle; the camera's sample
// of the landing arrives a little later.
constexpr double kLeansRad = 1.0 * kRadPerDeg;
constexpr double kLiftedM = 0.002;
constexpr double kAfterwardsS = 0.1;
// What a shove does to an estimate is over once the camera has shown it.
constexpr double kSeenAfterS = 0.3;

bool shoved(const report::RunResult& run, double t_s) {
  return std::any_of(run.shoves.begin(), run.shoves.end(), [t_s](const auto& shove) {
    return t_s >= shove.begin_s && t_s <= shove.end_s + kSeenAfterS;
  });
}

void judge_fused(TrialRun& run) {
  double leaning_until_s = -1.0;
  double squares_m2 = 0.0, squares_rad2 = 0.0;
  std::size_t count = 0;
  for (const report::TrackPoint& point : run.result.points) {
    const double error_m =
        std::hypot(point.fused.x_m - point.truth.x_m, point.fused.y_m - point.truth.y_m);
    if (std::abs(point.truth.pitch_rad) > kLeansRad || point.truth.z_m > kLiftedM)
      leaning_until_s = point.t_s + kAfterwardsS;
    double& largest =
        point.t_s <= leaning_until_s ? run.fused_max_obstacle_m : run.fused_max_flat_m;
    if (shoved(run.result, point.t_s)) continue;
    largest = std::max(largest, error_m);
    const double yaw_rad = wrap_angle(point.fused.yaw_rad - point.truth.yaw_rad);
    squares_m2 += error_m * error_m;
    squares_rad2 += yaw_rad * yaw_rad;
    ++count;
  }
  const auto n = static_cast<double>(std::max<std::size_t>(count, 1));
  run.fused_rms_m = std::sqrt(squares_m2 / n);
  run.fused_rms_yaw_rad = std::sqrt(squares_rad2 / n);
}

TrialRun judged(report::RunResult result, const course::Course& course) {
  TrialRun run;
  run.result = std::move(result);
  run.figures = report::figures(run.result, course);
  if (run.result.has_camera) judge_fused(run);
  run.model_rms_m = run.figures.model.rms_position_error_m;
  run.model_rms_yaw_rad = std::sqrt(run.figures.model.mse_yaw_rad2);
  for (const std::optional<double>& time_s : run.figures.tracking.recovery_s)
    run.slowest_recovery_s =
        std::max(run.slowest_recovery_s, time_s.value_or(std::numeric_limits<double>::infinity()));
  return run;
}

}  // namespace

std::vector<TrialRun> run_trial(const Trial& trial) {
  LockstepSettings settings;
  settings.robot = trial.robot;
  settings.setup = trial.setup;
  settings.board = trial.board;
  if (trial.setup != bridge::Setup::kBench) {
    settings.camera = course::EmulatedCamera{};
    settings.camera->blind_from_s = trial.blind_from_s;
    settings.camera->blind_s = trial.blind_s;
    settings.configuration.parameters.steering = bridge::Steering::kFused;
  }
  std::vector<TrialRun> runs;
  for (int i = 0; i < trial.runs; ++i) {
    settings.seed = trial.first_seed + static_cast<std::uint64_t>(i);
    for (const bool mirror : {false, true}) {
      if (mirror && !trial.both_directions) continue;
      settings.course = mirror ? course::mirrored(trial.course) : trial.course;
      runs.push_back(judged(run_lockstep(settings), settings.course));
    }
  }
  return runs;
}

Spread spread_of(const std::vector<TrialRun>& runs, double (*figure)(const TrialRun&)) {
  std::vector<double> values;
  values.reserve(runs.size());
  for (const TrialRun& run : runs) values.push_back(figure(run));
  return spread(values);
}

int completed(const std::vector<TrialRun>& runs) {
  return static_cast<int>(std::count_if(runs.begin(), runs.end(),
                                        [](const TrialRun& run) { return run.result.completed; }));
}

}  // namespace tp100::sim
