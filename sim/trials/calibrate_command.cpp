#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <vector>

#include "core/error.h"
#include "identify/drive_file.h"
#include "identify/identify.h"
#include "identify/identify_report.h"
#include "sim/robot/lockstep.h"
#include "sim/trials/commands.h"
#include "text/atomic_file.h"
#include "text/json_writer.h"

namespace tp100::sim {
namespace {

using model::kTrackParameters;
using model::TrackParameters;

constexpr std::size_t kCount = kTrackParameters.size();

// Stated accuracy: absolute for slip, relative for the wheelbase.
constexpr double kSlipWithin = 0.01;
constexpr double kWheelbaseWithin = 0.02;
// Seeds of one calibration's drives lie this far apart, so that no two share their noise.
constexpr std::uint64_t kSeedStride = 1'000'003;

std::vector<identify::RecordedDrive> all_drives(const Calibration& calibration) {
  std::vector<identify::RecordedDrive> drives = calibration.on_slopes;
  for (const CalibrationDrive& drive : calibration.drives) drives.push_back(drive.drive);
  return drives;
}

/// Sorted by their names, so that rows of the measured values belong to the files in a list of
/// them.
void write_drives(const std::string& folder, std::vector<identify::RecordedDrive> drives) {
  text::make_folder(folder);
  std::ranges::sort(drives, {}, &identify::RecordedDrive::name);
  for (const identify::RecordedDrive& drive : drives)
    text::write_file(folder + "/" + drive.name + "-samples.csv", identify::write_drive(drive));
  const std::string measured = identify::write_measured(drives);
  if (!measured.empty()) text::write_file(folder + "/measured.csv", measured);
}

/// Statistics of one parameter over several calibrations.
struct Tally {
  double worst = 0.0, errors = 0.0, halves = 0.0;
  int inside = 0, count = 0;
};

void print_tallies(const std::string& robot, const std::array<Tally, kCount>& tallies) {
  std::printf("robot %s, %d calibrations: found - true, and how often the 95 %% interval held it\n",
              robot.c_str(), tallies[0].count);
  std::printf("                             mean error   largest error   mean interval   held\n");
  for (std::size_t i = 0; i < kCount; ++i) {
    const model::ParameterRow& row = kTrackParameters[i];
    const Tally& t = tallies[i];
    const double n = t.count * row.si;
    std::printf("  %-24s   %+10.5f      %+10.5f     +- %8.5f   %3.0f %%\n", row.key, t.errors / n,
                t.worst / row.si, t.halves / n, 100.0 * t.inside / t.count);
  }
}

}  // namespace

course::Robot without_model(course::Robot robot) {
  robot.model = {};
  robot.baselines = {};
  return robot;
}

std::vector<CalibrationDrive> calibration_drives(const Loaded& loaded, int repeats,
                                                 std::uint64_t seed) {
  std::vector<CalibrationDrive> drives;
  const course::Robot unknown = without_model(loaded.robot);
  for (const std::string& name : identify::calibration_courses(loaded.robot.shape)) {
    const course::Course course = load_course(name);
    for (int repeat = 1; repeat <= repeats; ++repeat) {
      identify::DriveSink sink;
      const report::RunResult result = run_lockstep({.course = course,
                                                     .robot = unknown,
                                                     .configuration = loaded.configuration,
                                                     .board = loaded.board,
                                                     .camera = load_camera("overhead"),
                                                     .seed = seed + kSeedStride * drives.size(),
                                                     .sink = &sink});
      // Finished, not completed: an unidentified robot does not end where its course does.
      if (!result.finished)
        throw SetupError(name + ": " + loaded.robot.name + " did not finish it (" + result.cause +
                         "); nothing can be identified");
      identify::RecordedDrive drive = sink.drive();
      drive.name = name + "-" + loaded.robot.name + "-" + std::to_string(seed) + "-" +
                   std::to_string(repeat);
      drives.push_back({std::move(drive), sink.truth()});
    }
  }
  return drives;
}

std::string calibration_json(const std::string& robot, std::uint64_t seed, const identify::Fit& fit,
                             const TrackParameters& truth) {
  std::string text;
  text::JsonWriter json(text);
  json.begin_object().field("robot", robot).field("seed", seed);
  for (const model::ParameterRow& row : kTrackParameters) {
    const identify::ParameterEstimate& estimate = fit[row.value];
    json.key(row.key)
        .begin_object()
        .field("found", estimate.value / row.si)
        .field("half_interval", estimate.half_interval / row.si)
        .field("true", truth.*row.value / row.si)
        .end_object();
  }
  json.end_object();
  return text;
}

Calibration calibrate(const Loaded& loaded, int repeats, std::uint64_t seed) {
  Calibration calibration;
  calibration.drives = calibration_drives(loaded, repeats, seed);
  calibration.on_slopes = slope_drives(loaded.robot, seed);
  calibration.found = identify::identify(
      all_drives(calibration),
      identify::prior_of(without_model(loaded.robot),
                         loaded.configuration.parameters.model.turning_threshold_radps));
  calibration.truth = effective_motion(calibration.drives, loaded.robot.emulated);
  return calibration;
}

course::Robot calibrated_robot(const Loaded& loaded, int repeats, std::uint64_t seed,
                               const std::string& folder) {
  const identify::Identification found = calibrate(loaded, repeats, seed).found;
  const std::string path = folder + "/" + loaded.robot.name + ".toml";
  const std::string text = course::write_robot(identify::identified_robot(found, loaded.robot, {}),
                                               identify::identified_note(found, {}, {}));
  text::write_file(path, text);
  // Parsed from the file's text, so that it is the robot that a reader of the file gets.
  return course::parse_robot(text, path);
}

bool Calibration::holds(model::TrackParameter parameter) const {
  const identify::ParameterEstimate& estimate = found.extended[parameter];
  return estimate.found && std::abs(estimate.value - truth.*parameter) <= estimate.half_interval;
}

bool Calibration::accurate() const {
  const auto within = [this](model::TrackParameter parameter, double most) {
    const identify::ParameterEstimate& estimate = found.extended[parameter];
    return estimate.found && std::abs(estimate.value - truth.*parameter) <= most;
  };
  // wheelbase_m is relative to itself, the other wheelbases are relative to it.
  const auto wheelbase_within = [&](const model::ParameterRow& row) {
    return row.relative_to == nullptr || within(row.value, kWheelbaseWithin * truth.*row.value);
  };
  return within(&TrackParameters::slip_left, kSlipWithin) &&
         within(&TrackParameters::slip_right, kSlipWithin) &&
         std::ranges::all_of(kTrackParameters, wheelbase_within);
}

int run_calibrate(const CalibrateCommand& command) {
  const Loaded loaded = load(command.options);
  std::array<Tally, kCount> tallies{};
  bool all_accurate = true;
  for (int run = 0; run < command.runs; ++run) {
    const std::uint64_t seed = command.options.seed + static_cast<std::uint64_t>(run);
    const Calibration calibration = calibrate(loaded, command.repeats, seed);
    if (!command.out.empty()) write_drives(command.out, all_drives(calibration));
    all_accurate = all_accurate && calibration.accurate();
    for (std::size_t i = 0; i < kCount; ++i) {
      const model::TrackParameter parameter = kTrackParameters[i].value;
      const identify::ParameterEstimate& estimate = calibration.found.extended[parameter];
      const double error = estimate.value - calibration.truth.*parameter;
      Tally& tally = tallies[i];
      ++tally.count;
      tally.errors += error;
      tally.halves += estimate.half_interval;
      if (std::abs(error) > std::abs(tally.worst)) tally.worst = error;
      if (calibration.holds(parameter)) ++tally.inside;
    }
    if (command.json) {
      std::printf("%s\n", calibration_json(loaded.robot.name, seed, calibration.found.extended,
                                           calibration.truth)
                              .c_str());
    } else if (command.runs == 1) {
      const course::Robot unknown = without_model(loaded.robot);
      std::printf("%s\n", identify::identify_report(calibration.found, unknown).c_str());
    }
    std::fflush(stdout);
  }
  if (!command.json) print_tallies(loaded.robot.name, tallies);
  return all_accurate ? 0 : 1;
}

}  // namespace tp100::sim
