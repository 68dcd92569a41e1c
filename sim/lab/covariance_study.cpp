#include "sim/lab/covariance_study.h"

#include <algorithm>
#include <cstdio>

#include "course/bundled_files.h"
#include "estimation/parameters.h"
#include "sim/lab/calibration.h"
#include "sim/robot/options.h"

namespace tp100::sim {
namespace {

constexpr std::uint64_t kDrivesSeed = 9001;
constexpr std::uint64_t kSeedsApart = 1000;
constexpr double kLeastPercent = 90.0, kMaxPercent = 99.0;

/// Judges a share that must not be too small nor, if `too_cautious`, too large.
void judge_share(CourseStudy& study, const std::string& what, bool too_cautious, double percent) {
  study.judged.push_back(
      judged_value(study, what + " within 2 sd", "%", too_cautious ? kMaxPercent : -1.0, percent));
  study.judged.push_back(
      judged_value(study, what + " outside 2 sd", "%", 100.0 - kLeastPercent, 100.0 - percent));
}

}  // namespace

std::vector<course::Robot> robots_on(const std::string& body, const std::string& folder) {
  std::vector<course::Robot> robots;
  for (const std::string& name : course::bundled_names(course::Bundled::kRobots)) {
    Options options;
    options.body = body;
    options.robot = name;
    Loaded loaded = load(options);
    if (loaded.robot.emulated.contact_law == course::ContactLaw::kShear) {
      loaded.robot.name += "-shear";
      loaded.robot = calibrated_robot(loaded, kDrivesOfAKind, kDrivesSeed, folder);
    }
    robots.push_back(std::move(loaded.robot));
  }
  return robots;
}

course::Robot placed_by_hand(course::Robot robot, bool uneven) {
  const estimation::FilterParameters assumed;
  // The seed has an effect only if the floor is uneven.
  robot.emulated.floor = course::Floor::kUneven;
  course::EmulatedVariation& variation = robot.emulated.variation;
  if (!uneven)
    variation.friction_sd = variation.slip_sd = variation.tension_sd = variation.payload_sd_m =
        variation.battery_sd_v = 0.0;
  variation.placed_sd_m = assumed.start_sd_m;
  variation.placed_sd_rad = assumed.start_sd_rad;
  variation.gyro_scale_sd = assumed.gyro_scale_sd;
  variation.gyro_drift_sd_radps_per_degc = assumed.bias_per_degc_sd;
  robot.emulated.imu.gyro_bias_per_degc = 0.0;
  return robot;
}

CourseStudy study_covariance(const std::vector<course::Robot>& robots,
                             const CovarianceStudy& what) {
  CourseStudy study;
  study.course = "1-sharp, 2";
  study.robot = "all on " + std::string(to_string(robots.front().emulated.contact_law));
  study.setup = bridge::to_string(bridge::Setup::kFlat);
  study.board = to_string(BoardKind::kNative);
  study.uneven = what.uneven;
  const std::vector<PoseSource> sources =
      what.camera ? std::vector{PoseSource::kFused}
                  : std::vector{PoseSource::kModel, PoseSource::kOdometry};
  PerSource<report::Coverage> sums;
  int judged = 0;
  // Other seeds for each robot: the same ones would place all robots alike, and the result would
  // depend on few draws.
  std::uint64_t seed = what.first_seed;
  for (const course::Robot& robot : robots) {
    for (const char* course : {"1-sharp", "2"}) {
      const std::vector<TrialRun> driven = run_trial({.course = load_course(course),
                                                      .robot = placed_by_hand(robot, what.uneven),
                                                      .first_seed = seed,
                                                      .runs = what.runs,
                                                      .camera = what.camera});
      seed += kSeedsApart;
      for (const TrialRun& run : driven) {
        // A run that never began has no figures.
        if (!run.figures.within_2_sd[sources.front()]) continue;
        ++judged;
        for (const PoseSource source : sources) {
          sums[source].position += run.figures.within_2_sd[source]->position;
          sums[source].yaw += run.figures.within_2_sd[source]->yaw;
        }
      }
      study.runs += static_cast<int>(driven.size());
      study.completed += completed(driven);
    }
  }
  const double percent = 100.0 / judged;
  for (const PoseSource source : sources) {
    const std::string name(to_string(source));
    // The emulated camera's constant error has a fixed size, always within two standard deviations
    // of the filter's assumption: with a camera, the upper limit of the position is not judged.
    judge_share(study, name + " position", !what.camera, percent * sums[source].position);
    // The model has to allow for slip that varies along the floor until it has driven over a part
    // of it: its yaw is too cautious where the slip does not vary.
    judge_share(study, name + " yaw", source != PoseSource::kModel, percent * sums[source].yaw);
  }
  std::fprintf(stderr, "%-28s %-14s %-8s %d of %d completed\n", study.course.c_str(),
               study.robot.c_str(), what.uneven ? "uneven" : "even", study.completed, study.runs);
  return study;
}

}  // namespace tp100::sim
