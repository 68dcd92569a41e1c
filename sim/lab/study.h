#pragma once
// Many runs of one robot on one course: statistics and limits.

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "config/configuration.h"
#include "core/statistics.h"
#include "report/metrics.h"
#include "report/run_result.h"
#include "sim/lab/slope_figures.h"
#include "sim/robot/lockstep.h"

namespace tp100::sim {

/// The paper's courses.
inline constexpr std::array kPaperCourses = {"1-straight", "1-curve", "1-sharp", "2", "3"};

/// One course and one robot with seeds from `first_seed` on, steered by the fused pose; on a stand
/// or without a camera by odometry.
struct Trial {
  course::Course course{};
  course::Robot robot{};
  bridge::Setup setup = bridge::Setup::kFlat;
  BoardKind board = BoardKind::kNative;
  std::uint64_t first_seed = 1;
  int runs = 10;
  bool both_directions = true;  ///< each seed on the mirrored course too
  bool camera = true;           ///< with an overhead camera; never on a stand
  double blind_from_s = 0.0;    ///< the camera sees nothing from this time after its first image
  double blind_s = 0.0;         ///< for this long
};

struct TrialRun {
  report::RunResult result{};
  report::RunFigures figures{};
  SlopeFigures slope{};
  double fused_max_flat_m = 0.0;                      ///< largest fused error with the body level
  double fused_max_obstacle_m = 0.0;                  ///< the same with the body on an obstacle
  double fused_rms_m = 0.0, fused_rms_yaw_rad = 0.0;  ///< outside the disturbances
  double model_rms_yaw_rad = 0.0;
  double slowest_recovery_s = 0.0;  ///< infinite if it never recovered
};

/// Whether the robot is being pushed at `t_s`, or was until `after_s` ago.
bool disturbed(const report::RunResult& run, double t_s, double after_s);

/// Drives all runs, one after the other.
std::vector<TrialRun> run_trial(const Trial& trial);

/// Summary of one figure over several runs.
struct Spread {
  double median = 0.0;
  double p95 = 0.0;
  std::size_t count = 0;
};
Spread spread(const std::vector<double>& values);
/// Of one figure over the runs.
Spread spread_of(const std::vector<TrialRun>& runs, double (*figure)(const TrialRun&));

/// Number of completed runs.
int completed(const std::vector<TrialRun>& runs);

/// One line of the table of limits. A value above `limit`, or NaN, does not hold.
struct Judged {
  std::string course, robot;
  std::string what;    ///< model, fused or tracking, and the name of the figure
  std::string unit;    ///< of all three values
  double limit = 0.0;  ///< negative: shown, not judged
  Spread ours{};
  bool holds() const { return limit < 0.0 || ours.median <= limit; }
};

/// Errors of one pose: medians of every figure over the runs.
struct FormErrors {
  std::string form;  ///< a key of model::kBaselines, extended, odometry or fused
  report::PoseErrors median{};
};

/// Every run of one robot on one course in one set-up, and the figures that are judged.
struct CourseStudy {
  std::string course, robot, setup, board;
  bool uneven = false;  ///< the floor was sampled by the seeds
  std::string blind;    ///< when the camera saw nothing; empty: never
  int runs = 0, completed = 0;
  double distance_m = 0.0;
  std::vector<Judged> judged;
  std::vector<FormErrors> forms;  ///< those that the runs have, simplest first; none on a stand
  Spread mse_x_m2{}, mse_y_m2{}, mse_yaw_rad2{};  ///< of the model
  TrialRun shown{};                               ///< the first run, for the figures
};

/// Drives `trial` and judges it by the limits of its kind of course: 1-straight, 1-curve, 1-sharp,
/// 2 or 3. `reference`: uses the reference robot's limits; those of other robots may be wider. Eqs
/// 1-5 alone, fitted, and the extended model have limits of their own.
CourseStudy study(const Trial& trial, const std::string& kind, bool reference);

/// A line for a figure that has one value for all runs together.
Judged judged_value(const CourseStudy& study, std::string what, std::string unit, double limit,
                    double value);

/// False alarms of all runs together, as a median would not show those of a few. On a level floor
/// none is allowed.
inline constexpr const char* kFalseAlarms = "tracking: false alarms, all runs";
Judged judged_false_alarms(const CourseStudy& study, const std::vector<TrialRun>& runs);

/// The errors of a form in a study; null if it has none.
const report::PoseErrors* errors_of(const CourseStudy& study, std::string_view form);

}  // namespace tp100::sim
