#include "sim/lab/auto_study.h"

#include <array>
#include <cmath>
#include <cstdio>

#include "core/error.h"
#include "identify/drive_file.h"
#include "identify/identify_report.h"
#include "sim/lab/effective_motion.h"
#include "sim/lab/sampled.h"
#include "sim/lab/study.h"
#include "sim/robot/lockstep.h"
#include "text/format.h"

namespace tp100::sim {
namespace {

using model::kTrackParameters;

// Seeds of one robot's drives lie this far apart, so that no two share their noise.
constexpr std::uint64_t kManoeuvreStride = 1'000'003;

/// All robots of the command.
std::vector<Loaded> robots_of(const AutoCommand& command) {
  std::vector<Loaded> robots;
  Options options = command.options;
  std::vector<std::string> names = {options.robot};
  if (options.robot.empty() && command.sampled > 0)
    names = course::bundled_names(course::Bundled::kRobots);
  for (const std::string& name : names) {
    options.robot = name;
    robots.push_back(load(options));
  }
  options.robot.clear();
  for (int i = 0; i < command.sampled; ++i) {
    Loaded loaded = load(options);
    loaded.robot =
        sampled_robot(loaded.robot, kSampledNumber + options.seed + static_cast<std::uint64_t>(i));
    robots.push_back(std::move(loaded));
  }
  return robots;
}

struct Held {
  int inside = 0, all = 0;
  double percent() const { return all == 0 ? 0.0 : 100.0 * inside / all; }
};

/// Whether the parameter has an interval and a truth, else the drives could not identify it.
bool shown(const AutoCalibration& of, model::TrackParameter parameter) {
  return of.calibration.found.extended[parameter].found &&
         std::isfinite(of.calibration.truth.*parameter);
}

void print(const AutoCalibration& of, const std::string& robot, const Held& held) {
  std::printf("%-14s %3zu %8.1f s   %-5s  %2d of %2d held;", robot.c_str(), of.progress.manoeuvres,
              of.progress.driving_s, of.progress.narrow ? "yes" : "no", held.inside, held.all);
  for (const model::ParameterRow& row : kTrackParameters)
    if (shown(of, row.value) && !of.calibration.holds(row.value))
      std::printf(
          " %s %+.4f (+- %.4f)", row.key,
          (of.calibration.found.extended[row.value].value - of.calibration.truth.*row.value) /
              row.si,
          of.calibration.found.extended[row.value].half_interval / row.si);
  std::printf("\n");
  std::fflush(stdout);
}

}  // namespace

AutoCalibration calibrate_by_itself(const Loaded& loaded, const course::TextFile& area,
                                    std::uint64_t seed) {
  AutoCalibration result;
  course::Robot robot = without_model(loaded.robot);
  const identify::Prior prior =
      identify::prior_of(robot, loaded.configuration.parameters.model.turning_threshold_radps);
  identify::NextManoeuvre next(prior, area);
  config::Configuration configuration = loaded.configuration;
  configuration.parameters.steering = PoseSource::kFused;
  while (const auto manoeuvre = next.choose()) {
    const course::TextFile file = next.course_of(*manoeuvre);
    identify::DriveSink sink;
    const report::RunResult run =
        run_lockstep({.course = course::parse_course(file.text, file.path),
                      .robot = robot,
                      .configuration = configuration,
                      .board = loaded.board,
                      .camera = load_camera("overhead"),
                      .seed = seed + kManoeuvreStride * result.manoeuvres.size(),
                      .sinks = {&sink},
                      .truth_sinks = {&sink}});
    if (!run.finished)
      throw UserError(manoeuvre->name + ": " + loaded.robot.name + " did not finish it (" +
                      run.cause + ")");
    identify::RecordedDrive drive = sink.drive();
    drive.name = manoeuvre->name;
    result.calibration.drives.push_back({drive, sink.truth()});
    next.take(std::move(drive));
    robot.model = next.tracks();
    result.manoeuvres.push_back(manoeuvre->name);
    result.progress = next.progress();
    std::fprintf(stderr, "%s: %s, %s\n", loaded.robot.name.c_str(), manoeuvre->name.c_str(),
                 identify::progress_line(result.progress).c_str());
  }
  result.calibration.found = identify::identify(next.drives(), prior);
  result.calibration.truth = effective_motion(result.calibration.drives, loaded.robot.emulated);
  return result;
}

int run_auto(const AutoCommand& command) {
  const course::TextFile area = course::read_bundled(course::Bundled::kCourses, command.area);
  std::vector<double> seconds;
  Held all;
  std::array<Held, kTrackParameters.size()> by_parameter{};
  bool narrow = true;
  int failed = 0;
  for (const Loaded& loaded : robots_of(command)) {
    for (int run = 0; run < command.runs; ++run) {
      AutoCalibration of;
      try {
        of = calibrate_by_itself(loaded, area,
                                 command.options.seed + static_cast<std::uint64_t>(run));
      } catch (const UserError& error) {
        // Go on with the other robots.
        std::printf("%-14s %s\n", loaded.robot.name.c_str(), error.what());
        ++failed;
        continue;
      }
      Held held;
      for (std::size_t i = 0; i < by_parameter.size(); ++i) {
        if (!shown(of, kTrackParameters[i].value)) continue;
        const int inside = of.calibration.holds(kTrackParameters[i].value) ? 1 : 0;
        for (Held* tally : {&held, &all, &by_parameter[i]}) {
          tally->inside += inside;
          ++tally->all;
        }
      }
      seconds.push_back(of.progress.driving_s);
      narrow = narrow && of.progress.narrow;
      print(of, loaded.robot.name, held);
    }
  }
  for (std::size_t i = 0; i < by_parameter.size(); ++i)
    std::printf("  %-24s %5.1f %%\n", kTrackParameters[i].key, by_parameter[i].percent());
  std::printf(
      "driving, median %.1f s, 95 %% of them at most %.1f s; intervals hold the truth in "
      "%.1f %% of %d\n",
      spread(seconds).median, spread(seconds).p95, all.percent(), all.all);
  if (failed > 0) std::printf("%d did not finish\n", failed);
  return narrow && failed == 0 ? 0 : 1;
}

}  // namespace tp100::sim
