#include "sim/study/covariance_study.h"

#include <algorithm>
#include <cstdio>

#include "course/bundled_files.h"
#include "estimation/parameters.h"
#include "sim/robot/options.h"
#include "sim/study/commands.h"

namespace tp100::sim {
namespace {

constexpr std::uint64_t kDrivesSeed = 9001;
constexpr std::uint64_t kSeedsApart = 1000;
constexpr double kLeastPercent = 90.0, kMaxPercent = 99.0;

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

/// Judges a share that must not be too small nor, if `too_cautious`, too large.
void judge_share(CourseStudy& study, const std::string& what, bool too_cautious, double percent) {
  study.judged.push_back(
      judged_value(study, what + " within 2 sd", "%", too_cautious ? kMaxPercent : -1.0, percent));
  study.judged.push_back(
      judged_value(study, what + " outside 2 sd", "%", 100.0 - kLeastPercent, 100.0 - percent));
}

CourseStudy study_of(const std::vector<course::Robot>& robots, bool uneven, bool camera,
                     std::uint64_t first_seed, int runs) {
  CourseStudy study;
  study.course = "1-sharp, 2";
  study.robot = "all on " + std::string(to_string(robots.front().emulated.contact_law));
  study.setup = bridge::to_string(bridge::Setup::kFlat);
  study.board = to_string(BoardKind::kNative);
  study.uneven = uneven;
  double position = 0.0, yaw = 0.0;
  // Other seeds for each robot: the same ones would place all robots alike, and the result would
  // depend on few draws.
  std::uint64_t seed = first_seed;
  for (const course::Robot& robot : robots) {
    for (const char* course : {"1-sharp", "2"}) {
      const std::vector<TrialRun> driven = run_trial({.course = load_course(course),
                                                      .robot = placed_by_hand(robot, uneven),
                                                      .first_seed = seed,
                                                      .runs = runs,
                                                      .camera = camera});
      seed += kSeedsApart;
      for (const TrialRun& run : driven) {
        position += run.figures.within_2_sd->position;
        yaw += run.figures.within_2_sd->yaw;
      }
      study.runs += static_cast<int>(driven.size());
      study.completed += completed(driven);
    }
  }
  const double percent = 100.0 / study.runs;
  const std::string what = camera ? "fused" : "odometry";
  // The emulated camera's constant error has a fixed size, always within two standard deviations of
  // the filter's assumption: with a camera, the upper limit of the position is not judged.
  judge_share(study, what + " position", !camera, percent * position);
  judge_share(study, what + " yaw", true, percent * yaw);
  std::fprintf(stderr, "%-28s %-14s %-8s %d of %d completed\n", study.course.c_str(),
               study.robot.c_str(), uneven ? "uneven" : "even", study.completed, study.runs);
  return study;
}

}  // namespace

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
  return robot;
}

std::vector<CourseStudy> study_covariance(const std::string& body, const std::string& folder,
                                          std::uint64_t first_seed, int runs) {
  const std::vector<course::Robot> robots = robots_on(body, folder);
  std::vector<CourseStudy> studies;
  for (const bool uneven : {false, true})
    for (const bool camera : {false, true})
      studies.push_back(study_of(robots, uneven, camera, first_seed, runs));
  return studies;
}

}  // namespace tp100::sim
