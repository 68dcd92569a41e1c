#include "sim/lab/shear_study.h"

#include <algorithm>
#include <cstdio>

#include "course/bundled_files.h"
#include "course/path.h"
#include "sim/lab/calibration.h"
#include "sim/lab/sampled.h"
#include "sim/robot/options.h"

namespace tp100::sim {
namespace {

// Of the largest model error of a run, in percent of the path.
constexpr double kMedianLimit = 0.8;
constexpr double kWorstLimit = 5.0;
constexpr std::uint64_t kDrivesSeed = 9001;
constexpr std::uint64_t kCoursesSeed = 5001;

/// A bundled robot, and what is changed in its [emulated.shear].
struct Variant {
  std::string robot;
  std::string suffix;
  text::NamedValues values{};
  bool soft = false;
};

/// Soft tracks: K of 5 mm. Sand: K and resistance of loose sand.
std::vector<Variant> variants() {
  std::vector<Variant> all;
  for (const std::string& name : course::bundled_names(course::Bundled::kRobots))
    all.push_back({name, ""});
  const text::NamedValues soft = {{"emulated.shear.modulus_m", 0.005}};
  all.push_back({"end-loaded", "-soft", soft, true});
  all.push_back({"uniform", "-soft", soft, true});
  all.push_back({"uniform",
                 "-sand",
                 {{"emulated.shear.modulus_m", 0.025}, {"emulated.shear.motion_resistance", 0.15}},
                 true});
  return all;
}

/// Bundled ones, and others of kinds that the calibration does not have.
std::vector<course::Course> courses() {
  std::vector<course::Course> all;
  for (const char* name : {"1-straight", "1-curve", "1-sharp", "3"}) {
    all.push_back(load_course(name));
    all.back().terrain = {};
  }
  for (const char* kind : {"1-curve", "spiral", "squares", "wide"})
    all.push_back(held_out_course(kind, kCoursesSeed));
  return all;
}

/// Also of a run that was ended early, in parts of what it drove.
double model_percent(const TrialRun& run) {
  return 100.0 * run.figures.estimates[PoseSource::kModel]->max_position_error_m /
         run.result.points.back().progress_m;
}

Judged model_row(const CourseStudy& study, const char* what, double limit, const Spread& spread) {
  return {study.course, study.robot, what, "% of path", limit, spread};
}

/// All runs of several studies, with the limits if they are `limited`.
CourseStudy taken_together(const char* robots, const std::vector<double>& percents, bool limited) {
  CourseStudy all;
  all.course = "all";
  all.robot = robots;
  all.setup = bridge::to_string(bridge::Setup::kFlat);
  all.board = to_string(BoardKind::kNative);
  all.runs = all.completed = static_cast<int>(percents.size());
  const double worst = percents.empty() ? 0.0 : *std::ranges::max_element(percents);
  all.judged = {
      model_row(all, "model max, median over runs", limited ? kMedianLimit : -1.0,
                spread(percents)),
      judged_value(all, "model max, worst run", "% of path", limited ? kWorstLimit : -1.0, worst)};
  return all;
}

}  // namespace

std::vector<CourseStudy> study_shear(const std::string& folder, std::uint64_t first_seed,
                                     int runs) {
  std::vector<CourseStudy> studies;
  std::vector<double> all, soft;
  for (const Variant& variant : variants()) {
    Options options;
    options.body = "shear";
    options.robot = variant.robot;
    options.robot_values = variant.values;
    Loaded loaded = load(options);
    loaded.robot.name = variant.robot + "-shear" + variant.suffix;
    const course::Robot robot = calibrated_robot(loaded, kDrivesOfAKind, kDrivesSeed, folder);
    for (const course::Course& course : courses()) {
      const std::vector<TrialRun> driven =
          run_trial({.course = course, .robot = robot, .first_seed = first_seed, .runs = runs});
      CourseStudy study;
      study.course = course.name;
      study.robot = robot.name;
      study.setup = bridge::to_string(bridge::Setup::kFlat);
      study.board = to_string(BoardKind::kNative);
      study.runs = static_cast<int>(driven.size());
      study.completed = completed(driven);
      study.distance_m = course::Path(course).length_m();
      std::vector<double> percents;
      for (const TrialRun& run : driven)
        if (!run.result.points.empty()) percents.push_back(model_percent(run));
      study.judged = {model_row(study, "model max", -1.0, spread(percents))};
      all.insert(all.end(), percents.begin(), percents.end());
      if (variant.soft) soft.insert(soft.end(), percents.begin(), percents.end());
      for (const TrialRun& run : driven)
        if (!run.result.completed)
          std::fprintf(stderr, "%s, seed %llu: %s\n", course.name.c_str(),
                       static_cast<unsigned long long>(run.result.seed), run.result.cause.c_str());
      if (!driven.empty()) study.shown = driven.front();
      std::fprintf(stderr, "%-28s %-22s %d of %d completed\n", study.course.c_str(),
                   study.robot.c_str(), study.completed, study.runs);
      studies.push_back(std::move(study));
    }
  }
  studies.push_back(taken_together("all on shear", all, true));
  studies.push_back(taken_together("soft on shear", soft, false));
  return studies;
}

}  // namespace tp100::sim
