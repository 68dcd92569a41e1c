#include "sim/run/calibrate_command.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <vector>

#include "analysis/atomic_file.h"
#include "analysis/drive_file.h"
#include "analysis/identify.h"
#include "analysis/identify_report.h"
#include "app/calibration.h"
#include "app/drive_sink.h"
#include "core/error.h"
#include "sim/run/effective_motion.h"
#include "sim/run/lockstep.h"

namespace tp100::sim {
namespace {

using analysis::kParameters;
using analysis::Parameter;

// Stated accuracy: of slip, and of the wheelbase in parts of itself.
constexpr double kSlipWithin = 0.01;
constexpr double kWheelbaseWithin = 0.02;
// Seeds of the drives of one calibration lie apart, so that no two share their noise.
constexpr std::uint64_t kSeedStride = 1'000'003;

// The order of app::calibration_courses.
constexpr std::array<DriveKind, 7> kKinds = {
    DriveKind::kStraight, DriveKind::kWide, DriveKind::kWide, DriveKind::kTight,
    DriveKind::kTight,    DriveKind::kSpin, DriveKind::kSpin};

std::vector<CalibrationDrive> drive(const CalibrateCommand& command, const Loaded& loaded,
                                    std::uint64_t seed) {
  std::vector<CalibrationDrive> drives;
  course::Robot unknown = loaded.robot;
  unknown.model = {};
  const std::vector<std::string> courses = app::calibration_courses(loaded.robot.shape);
  for (std::size_t i = 0; i < kKinds.size(); ++i) {
    const std::string& name = courses.at(i);
    const course::Course course = load_course(name);
    for (int repeat = 1; repeat <= command.repeats; ++repeat) {
      app::DriveSink sink;
      const analysis::RunResult result = run_lockstep({.course = course,
                                                       .robot = unknown,
                                                       .configuration = loaded.configuration,
                                                       .board = loaded.board,
                                                       .camera = load_camera("overhead"),
                                                       .seed = seed + kSeedStride * drives.size(),
                                                       .sink = &sink});
      if (!result.completed)
        throw SetupError(name + ": " + loaded.robot.name + " did not complete it (" + result.cause +
                         "); there is nothing to learn from");
      analysis::Drive drive = sink.drive();
      drive.name = name + "-" + loaded.robot.name + "-" + std::to_string(seed) + "-" +
                   std::to_string(repeat);
      drives.push_back({kKinds[i], std::move(drive), sink.truth()});
    }
  }
  return drives;
}

void write_drives(const std::string& folder, const std::vector<CalibrationDrive>& drives) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error)
    throw SetupError(folder + ": cannot create the folder (" + error.message() +
                     "); give another --out");
  for (const CalibrationDrive& drive : drives)
    analysis::write_file(folder + "/" + drive.drive.name + "-samples.csv",
                         analysis::write_drive(drive.drive));
}

std::array<double, kParameters> values_of(const EffectiveMotion& m) {
  return {m.slip_left,
          m.slip_right,
          m.slip_angle_straight_rad,
          m.slip_angle_turning_rad,
          m.wheelbase_m,
          m.x_icr_m,
          m.wheelbase_spin_m,
          m.x_icr_spin_m - m.x_icr_m,
          m.turn_slip,
          m.turn_slip_tight,
          m.gyro_scale};
}

/// How one parameter fared over several calibrations.
struct Tally {
  double worst = 0.0, errors = 0.0, halves = 0.0;
  int inside = 0, count = 0;
};

/// True if the accuracy that is stated for this parameter was kept.
bool accurate(std::size_t i, double error, double truth) {
  switch (static_cast<Parameter>(i)) {
    case Parameter::kSlipLeft:
    case Parameter::kSlipRight:
      return std::abs(error) <= kSlipWithin;
    case Parameter::kWheelbase:
    case Parameter::kWheelbaseSpin:
      return std::abs(error) <= kWheelbaseWithin * truth;
    default:
      return true;
  }
}

void print_tallies(const std::string& robot, const std::array<Tally, kParameters>& tallies) {
  std::printf("robot %s, %d calibrations: found - true, and how often the 95 %% interval held it\n",
              robot.c_str(), tallies[0].count);
  std::printf("                             mean error   largest error   mean interval   held\n");
  for (std::size_t i = 0; i < kParameters; ++i) {
    const Tally& t = tallies[i];
    const double n = t.count * analysis::kParameterKeys[i].si;
    std::printf("  %-24s   %+10.5f      %+10.5f     +- %8.5f   %3.0f %%\n",
                analysis::kParameterKeys[i].key, t.errors / n,
                t.worst / analysis::kParameterKeys[i].si, t.halves / n, 100.0 * t.inside / t.count);
  }
}

void print_json(const std::string& robot, std::uint64_t seed, const analysis::Fit& fit,
                const std::array<double, kParameters>& truth) {
  std::printf(R"({"robot":"%s","seed":%llu)", robot.c_str(), static_cast<unsigned long long>(seed));
  for (std::size_t i = 0; i < kParameters; ++i) {
    const double si = analysis::kParameterKeys[i].si;
    std::printf(R"(,"%s":{"found":%.6g,"half_interval":%.6g,"true":%.6g})",
                analysis::kParameterKeys[i].key, fit.estimates[i].value / si,
                fit.estimates[i].half_interval / si, truth[i] / si);
  }
  std::printf("}\n");
}

}  // namespace

int run_calibrate(const CalibrateCommand& command) {
  const Loaded loaded = load(command.options);
  course::Robot unknown = loaded.robot;
  unknown.model = {};
  const analysis::Belief belief =
      analysis::belief_of(unknown, loaded.configuration.parameters.model.turning_threshold_radps);
  std::array<Tally, kParameters> tallies{};
  bool all_accurate = true;
  for (int run = 0; run < command.runs; ++run) {
    const std::uint64_t seed = command.options.seed + static_cast<std::uint64_t>(run);
    const std::vector<CalibrationDrive> driven = drive(command, loaded, seed);
    if (!command.out.empty()) write_drives(command.out, driven);
    std::vector<analysis::Drive> drives;
    for (const CalibrationDrive& d : driven) drives.push_back(d.drive);
    const analysis::Identification found = analysis::identify(drives, belief);
    const auto truth = values_of(effective_motion(driven, loaded.robot.emulated));
    for (std::size_t i = 0; i < kParameters; ++i) {
      const analysis::Estimate& estimate = found.extended.estimates[i];
      const double error = estimate.value - truth[i];
      Tally& tally = tallies[i];
      ++tally.count;
      tally.errors += error;
      tally.halves += estimate.half_interval;
      if (std::abs(error) > std::abs(tally.worst)) tally.worst = error;
      if (estimate.found && std::abs(error) <= estimate.half_interval) ++tally.inside;
      all_accurate = all_accurate && estimate.found && accurate(i, error, truth[i]);
    }
    if (command.json) {
      print_json(loaded.robot.name, seed, found.extended, truth);
    } else if (command.runs == 1) {
      std::printf("%s\n", analysis::identify_report(found, unknown).c_str());
    }
    std::fflush(stdout);
  }
  if (!command.json) print_tallies(loaded.robot.name, tallies);
  return all_accurate ? 0 : 1;
}

}  // namespace tp100::sim
