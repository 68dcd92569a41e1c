#include "sim/lab/reproduce.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <functional>
#include <string_view>
#include <utility>

#include "core/arithmetic.h"
#include "core/clock.h"
#include "core/error.h"
#include "course/bundled_files.h"
#include "course/path.h"
#include "report/run_result.h"
#include "sim/lab/calibration.h"
#include "sim/lab/constants_study.h"
#include "sim/lab/covariance_study.h"
#include "sim/lab/random_study.h"
#include "sim/lab/sampled.h"
#include "sim/lab/shear_study.h"
#include "sim/lab/state_study.h"
#include "sim/lab/study_processes.h"
#include "sim/robot/options.h"
#include "sim/trials/commands.h"
#include "terrain/climbable.h"
#include "text/atomic_file.h"
#include "text/format.h"

namespace tp100::sim {
namespace {

// Different from every seed with which parameters were tuned.
constexpr std::uint64_t kHeldOutSeed = 5001;
// On the step, on the ramp, and in the curve of course 3.
constexpr double kBlindFromS[] = {15.0, 28.0, 33.0};
constexpr double kBlindS = 3.0;
constexpr int kCalibrationRepeats = 2;
// Fewer runs for the firmware image: it is slower, and differs less from the host's build than
// seeds do from each other.
constexpr int kImageRuns = 5;
constexpr int kRandomCoursesARun = 50;
// As a part of all: it drives every robot on two courses, four times.
constexpr int kCovarianceRuns = 2;
// Bodies with less friction slide off the step of course 3.
constexpr double kFrictionOfCourse3 = 0.85;

course::Robot robot_named(const std::string& name) {
  Options options;
  options.robot = name;
  return load(options).robot;
}

Trial trial_of(const ReproduceCommand& command, const course::Course& course,
               const course::Robot& robot, bridge::Setup setup) {
  return {.course = course,
          .robot = robot,
          .setup = setup,
          .first_seed = command.seed,
          .runs = command.runs};
}

/// Set-up in which the course's obstacles, if it has any, are real.
bridge::Setup floor_for(const course::Course& course) {
  return course.terrain.flat() ? bridge::Setup::kFlat : bridge::Setup::kTerrain;
}

/// Whether the robot meets every block straight. A long robot meets the step of course 3 askew,
/// while it is still in the curve, which no model here describes.
bool straight_before(const course::Course& course, const course::Robot& robot) {
  const course::ShapeValues& shape = robot.shape;
  const course::Path path(course);
  const std::size_t last = path.segments().size() - 1;
  for (const course::Obstacle& obstacle : course.terrain.obstacles) {
    const auto* block = std::get_if<course::Block>(&obstacle);
    if (block == nullptr) continue;
    const double below_m = std::max(shape.wheel_radius_m - block->height_m, 0.0);
    const double reach_m =
        shape.axle_spacing_m / 2.0 +
        std::sqrt(shape.wheel_radius_m * shape.wheel_radius_m - below_m * below_m);
    const double line_m = path.project(last, block->place.x_m, block->place.y_m, 0.0);
    if (line_m - block->depth_m / 2.0 <= reach_m) return false;
  }
  return true;
}

/// The same for a robot not designed for this course: obstacles are real only if the robot has
/// enough traction on them and meets them straight.
bridge::Setup floor_for(const course::Course& course, const course::Robot& robot) {
  const bool fit =
      robot.emulated.body.friction >= kFrictionOfCourse3 && straight_before(course, robot);
  return fit ? floor_for(course) : bridge::Setup::kFlat;
}

bool climbs(const course::Course& course, const course::Robot& robot) {
  try {
    terrain::require_climbable(course, robot);
    return true;
  } catch (const UserError& error) {
    std::fprintf(stderr, "left out: %s\n", error.what());
    return false;
  }
}

void drive_paper(const ReproduceCommand& command, Reproduction& what) {
  for (const SlopeRow& row : slope_rows())
    what.slopes.push_back(
        measure_slope(what.reference.emulated.body, row.slope_deg * kRadPerDeg, kSlopeTrackMps));
  what.turns = measure_turns(what.reference.emulated);
  const auto block = std::get<course::Block>(load_course("3").terrain.obstacles.back());
  what.climb = check_climb_pitch(what.reference, block.height_m, block.depth_m, kSlopeTrackMps);
  for (const char* kind : kPaperCourses) {
    const course::Course course = load_course(kind);
    what.studies.push_back(
        study(trial_of(command, course, what.reference, floor_for(course)), kind, true));
  }
  const course::Course course_3 = load_course("3");
  for (const bridge::Setup setup : {bridge::Setup::kFlat, bridge::Setup::kStand})
    what.studies.push_back(study(trial_of(command, course_3, what.reference, setup), "3", true));
  for (const double from_s : kBlindFromS) {
    Trial blind = trial_of(command, course_3, what.reference, bridge::Setup::kTerrain);
    blind.blind_from_s = from_s;
    blind.blind_s = kBlindS;
    what.studies.push_back(study(blind, "3", true));
  }
}

using Studies = std::vector<CourseStudy>;
/// Whether a part was asked for.
using Wanted = std::function<bool(const char*)>;

/// The paper's courses with a robot that they were not made for.
Studies drive_courses(const ReproduceCommand& command, const course::Robot& robot) {
  Studies studies;
  for (const char* kind : kPaperCourses) {
    const course::Course course = load_course(kind);
    if (climbs(course, robot))
      studies.push_back(
          study(trial_of(command, course, robot, floor_for(course, robot)), kind, false));
  }
  return studies;
}

/// Floor, tension, payload and battery are sampled by each seed.
Studies drive_uneven(const ReproduceCommand& command, course::Robot robot) {
  robot.emulated.floor = course::Floor::kUneven;
  Studies studies;
  for (const char* kind : {"1-straight", "1-curve", "1-sharp"})
    studies.push_back(
        study(trial_of(command, load_course(kind), robot, bridge::Setup::kFlat), kind, false));
  return studies;
}

Studies drive_sampled(ReproduceCommand command, const course::Robot& reference,
                      std::uint64_t number) {
  Loaded loaded = load({});
  loaded.robot = sampled_robot(reference, number);
  command.runs = 1;
  return drive_courses(command, calibrated_robot(loaded, kCalibrationRepeats, number, command.out));
}

Studies drive_held_out(const ReproduceCommand& command, const course::Robot& reference,
                       const char* kind) {
  Studies studies;
  for (std::uint64_t i = 0; i < 2; ++i) {
    const course::Course course = held_out_course(kind, kHeldOutSeed + i);
    Trial trial = trial_of(command, course, reference, floor_for(course));
    trial.first_seed = kHeldOutSeed;
    studies.push_back(study(trial, kind, true));
  }
  return studies;
}

void study_real_robots(Reproduction& what) {
  for (const RealRobot& robot : read_real_robots()) {
    what.real.push_back(study_real(robot));
    what.studies.push_back(judged(what.real.back()));
  }
}

Studies drive_image(const ReproduceCommand& command, const course::Robot& reference) {
  const course::Course course_3 = load_course("3");
  Studies studies;
  for (const bridge::Setup setup :
       {bridge::Setup::kTerrain, bridge::Setup::kFlat, bridge::Setup::kStand}) {
    Trial trial = trial_of(command, course_3, reference, setup);
    trial.board = BoardKind::kAvr;
    trial.runs = std::min(command.runs, kImageRuns);
    studies.push_back(study(trial, "3", true));
  }
  return studies;
}

void write_trajectories(const std::string& folder, const CourseStudy& study) {
  const report::RunResult& run = study.shown.result;
  if (run.points.empty()) return;
  std::string stem = folder + "/" + run.course + "-" + run.robot + "-" + run.setup;
  if (study.uneven) stem += "-uneven";
  if (study.board != to_string(BoardKind::kNative)) stem += "-" + study.board;
  if (!study.blind.empty()) {
    std::string blind = study.blind;
    std::ranges::replace(blind, ' ', '-');
    stem += "-" + blind;
  }
  text::write_file(stem + ".csv", report::poses_csv(run));
  std::string truth;
  PerSource<std::string> estimates;
  for (const report::TrajectoryPoint& point : run.points) {
    truth += report::tum_line(point.t_s, point.truth);
    for (const PoseSource source : kPoseSources)
      estimates[source] += report::tum_line(point.t_s, point.estimates[source]);
  }
  text::write_file(stem + "-truth.tum", truth);
  for (const PoseSource source : kPoseSources)
    if (run.has_estimate(source))
      text::write_file(stem + "-" + std::string(to_string(source)) + ".tum", estimates[source]);
}

/// The studies of every wanted part but those of which the page shows more than figures with
/// limits; those that take longest first.
std::vector<StudyProcesses::Job> jobs_of(const ReproduceCommand& command, const Wanted& wanted,
                                         const course::Robot& reference) {
  std::vector<StudyProcesses::Job> jobs;
  const std::vector<std::string> robots = course::bundled_names(course::Bundled::kRobots);
  const auto add = [&](StudyProcesses::Job study) {
    jobs.push_back([out = command.out, study = std::move(study)] {
      Studies studies = study();
      for (const CourseStudy& one : studies) write_trajectories(out, one);
      return studies;
    });
  };
  if (wanted("avr")) add([command, reference] { return drive_image(command, reference); });
  if (wanted("covariance")) {
    const int runs = command.part == "all" ? std::min(command.runs, kCovarianceRuns) : command.runs;
    const std::vector<course::Robot> on_body = robots_on(command.body, command.out);
    for (const bool uneven : {false, true})
      for (const bool camera : {false, true})
        add([on_body, runs, uneven, camera, seed = command.seed] {
          return Studies{study_covariance(on_body, {uneven, camera, seed, runs})};
        });
  }
  if (wanted("state"))
    add([command, reference] { return study_state(reference, command.seed, command.runs); });
  for (const std::string& name : robots) {
    if (wanted("robots") && name != reference.name)
      add([command, name] { return drive_courses(command, robot_named(name)); });
    if (wanted("uneven")) add([command, name] { return drive_uneven(command, robot_named(name)); });
    if (wanted("constants"))
      add([command, name] { return Studies{study_constants(name, command.body, command.seed)}; });
  }
  if (wanted("sampled"))
    for (int i = 0; i < command.sampled; ++i)
      add([command, reference,
           number = kSampledNumber + command.seed + static_cast<std::uint64_t>(i)] {
        return drive_sampled(command, reference, number);
      });
  if (wanted("held-out"))
    for (const char* kind : kPaperCourses)
      add([command, reference, kind] { return drive_held_out(command, reference, kind); });
  return jobs;
}

}  // namespace

int run_reproduce(const ReproduceCommand& command) {
  Options options;
  options.body = command.body;
  const course::Robot reference = load(options).robot;
  const bool shear = reference.emulated.contact_law == course::ContactLaw::kShear;
  const bool all = command.part == "all";
  const Wanted wanted = [&](const char* part) { return (all && !shear) || command.part == part; };
  constexpr std::array<std::string_view, 11> kParts = {
      "paper",   "state",    "robots", "uneven", "covariance", "constants",
      "sampled", "held-out", "real",   "avr",    "random"};
  if (!all && std::ranges::find(kParts, command.part) == kParts.end())
    throw UserError("--part " + one_line(command.part) + ": unknown" +
                    text::suggestion(command.part, {kParts.begin(), kParts.end()}) +
                    "; give paper, state, robots, uneven, covariance, constants, sampled, "
                    "held-out, real, avr, random or all");
  if (shear && !all && command.part != "covariance" && command.part != "constants")
    throw UserError("--part " + command.part +
                    ": --body shear has courses and robots of its own; leave --part out, "
                    "or give covariance or constants");
  text::make_folder(command.out);
  Reproduction what;
  what.reference = reference;
  what.runs = command.runs;
  what.seed = command.seed;
  what.date = text::utc_minute(unix_now_ns() / kNsPerS);
  what.program = "tp100-sim " TP100_VERSION;
  StudyProcesses processes(jobs_of(command, wanted, reference));
  if (shear && all) what.studies = study_shear(command.out, command.seed, command.runs);
  if (wanted("paper")) drive_paper(command, what);
  if (wanted("real")) study_real_robots(what);
  // Not part of "all": it takes longer than all others together.
  if (command.part == "random")
    what.studies.push_back(study_random(command.seed, kRandomCoursesARun * command.runs));
  for (const CourseStudy& study : what.studies) write_trajectories(command.out, study);
  for (CourseStudy& study : processes.results()) what.studies.push_back(std::move(study));
  if (wanted("constants")) what.studies.push_back(largest_criteria(what.studies));
  text::write_file(command.out + "/results.json", reproduction_json(what));
  text::write_file(command.out + "/index.html", reproduction_page(what));
  std::printf("%s%s\n%s/index.html\n", reproduction_table(what).c_str(),
              real_text(what.real).c_str(), command.out.c_str());
  return all_hold(what) ? 0 : 1;
}

}  // namespace tp100::sim
