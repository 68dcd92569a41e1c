#pragma once
// Subcommands of tp100-sim that try out the emulated robot, each in the source file of its name,
// and drives on slopes.

#include <cstdint>
#include <string>
#include <vector>

#include "core/arithmetic.h"
#include "core/pose.h"
#include "course/robot_file.h"
#include "course/terrain.h"
#include "identify/drive.h"
#include "sim/robot/options.h"

namespace tp100::sim {

// tp100-sim calibrate: identification drives of an emulated robot.

struct CalibrationDrive {
  identify::RecordedDrive drive;
  std::vector<Pose> truth;  ///< exact poses at its samples; yaw unwrapped
};

/// Drives of each calibration course: enough to tell what differs from run to run.
inline constexpr int kDrivesOfAKind = 2;

/// The unidentified robot: [model] at its defaults.
course::Robot without_model(course::Robot robot);

/// Drives straight ahead, arcs and turns on the spot in both directions under an overhead camera,
/// as an unidentified robot. Each drive has noise of its own. Throws UserError.
std::vector<CalibrationDrive> calibration_drives(const Loaded& loaded, int repeats,
                                                 std::uint64_t seed);

struct CalibrateCommand {
  Options options{};
  int repeats = kDrivesOfAKind;  ///< of each drive, each with noise of its own
  std::string out;               ///< folder for the recordings
};

/// Writes the recordings of calibration_drives() and slope_drives(). Returns 0. Throws UserError.
int run_calibrate(const CalibrateCommand& command);

// tp100-sim faults.

/// Prints the list of faults for --fault. Returns 0.
int run_faults();

// Drives on slopes.

/// Speed of the tracks on slopes, where slip is measured. [m/s]
inline constexpr double kSlopeTrackMps = 0.10;
/// A body that leans otherwise fell over or left the slope.
inline constexpr double kSameSlopeRad = 5.0 * kRadPerDeg;

/// A drive straight up or down a slope does not leave this ramp, whose foot is at the origin; none
/// if `slope_rad` is not above 0.
course::Terrain ramp_of(double slope_rad, double length_m);
/// On that ramp, `along_m` from its foot; its nose points up, or down if the slope is negative.
Pose standing_on_ramp(double slope_rad, double along_m);

/// Drives straight up and down boards of 8 to 28 deg, at the experiment's speed, for identify: both
/// encoders, and the distance along the board and the turn as a tape and a protractor measure them.
/// Without boards that the robot does not climb; of the body `ode` only.
std::vector<identify::RecordedDrive> slope_drives(const course::Robot& robot, std::uint64_t seed);

}  // namespace tp100::sim
