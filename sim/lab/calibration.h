#pragma once
// Identification of an emulated robot beside the exact motion of its body.

#include <cstdint>
#include <string>
#include <vector>

#include "course/robot_file.h"
#include "identify/identify.h"
#include "model/track_parameters.h"
#include "sim/robot/options.h"
#include "sim/trials/commands.h"

namespace tp100::sim {

/// One calibration: the identified values and the body's real ones.
struct Calibration {
  identify::Identification found{};
  model::TrackParameters truth{};
  std::vector<CalibrationDrive> drives;
  std::vector<identify::RecordedDrive> on_slopes;

  /// True if the stated accuracy was met: slip within 0.01, the wheelbases within 2 %.
  bool accurate() const;
  /// True if the interval of an identified parameter contains its truth.
  bool holds(model::TrackParameter parameter) const;
};

/// Drives the calibration courses and boards, as tp100-sim calibrate does, and identifies the
/// robot. Throws UserError.
Calibration calibrate(const Loaded& loaded, int repeats, std::uint64_t seed);

/// Calibrates the robot, writes its file `<name>.toml` with the result into `folder` and returns
/// the robot of that file. Throws UserError.
course::Robot calibrated_robot(const Loaded& loaded, int repeats, std::uint64_t seed,
                               const std::string& folder);

struct JudgeCommand {
  Options options{};
  int runs = 1;  ///< whole calibrations, with this and the following seeds
};

/// tp100-lab calibrate: calibrates and prints how far each value is from the truth and how often
/// its interval contained it. Returns 0 if every calibration met the stated accuracy, else 1.
/// Throws UserError.
int run_judge(const JudgeCommand& command);

}  // namespace tp100::sim
