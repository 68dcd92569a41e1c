#include "sim/lab/calibration.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

#include "identify/identify_report.h"
#include "sim/lab/effective_motion.h"
#include "text/atomic_file.h"

namespace tp100::sim {
namespace {

using model::kTrackParameters;
using model::TrackParameters;

constexpr std::size_t kCount = kTrackParameters.size();

// Stated accuracy: absolute for slip, relative for the wheelbase.
constexpr double kSlipWithin = 0.01;
constexpr double kWheelbaseWithin = 0.02;

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

Calibration calibrate(const Loaded& loaded, int repeats, std::uint64_t seed) {
  Calibration calibration;
  calibration.drives = calibration_drives(loaded, repeats, seed);
  calibration.on_slopes = slope_drives(loaded.robot, seed);
  std::vector<identify::RecordedDrive> drives = calibration.on_slopes;
  for (const CalibrationDrive& drive : calibration.drives) drives.push_back(drive.drive);
  calibration.found = identify::identify(
      drives, identify::prior_of(without_model(loaded.robot),
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

int run_judge(const JudgeCommand& command) {
  const Loaded loaded = load(command.options);
  std::array<Tally, kCount> tallies{};
  bool all_accurate = true;
  for (int run = 0; run < command.runs; ++run) {
    const std::uint64_t seed = command.options.seed + static_cast<std::uint64_t>(run);
    const Calibration calibration = calibrate(loaded, kDrivesOfAKind, seed);
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
  }
  print_tallies(loaded.robot.name, tallies);
  return all_accurate ? 0 : 1;
}

}  // namespace tp100::sim
