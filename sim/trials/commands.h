#pragma once
// Subcommands of tp100-sim that try out the emulated robot, each in the source file of its name.

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/pose.h"
#include "course/robot_file.h"
#include "identify/drive.h"
#include "sim/body/body.h"
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
/// as an unidentified robot. Each drive has noise of its own. Throws SetupError.
std::vector<CalibrationDrive> calibration_drives(const Loaded& loaded, int repeats,
                                                 std::uint64_t seed);

struct CalibrateCommand {
  Options options{};
  int repeats = kDrivesOfAKind;  ///< of each drive, each with noise of its own
  std::string out;               ///< folder for the recordings
};

/// Writes the recordings of calibration_drives() and slope_drives(). Returns 0. Throws SetupError.
int run_calibrate(const CalibrateCommand& command);

// tp100-sim faults: the list of faults for --fault, and their effects.

struct FaultsCommand {
  bool drive = false;           ///< drive with each fault, print expected beside observed
  bool encoders = false;        ///< sweep encoder failures over speeds, positions and robots
  bool firmware_alone = false;  ///< do that sweep without the daemon's own checks
  std::string board = "native";
};

/// Prints the list, or the table of drives. Returns 1 if a drive did not end as expected, else 0.
/// Throws SetupError.
int run_faults(const FaultsCommand& command);

// tp100-sim slope: the paper's slope experiment on the emulated body.

/// Mean motion of the reference point along the body's own x axis and about its z axis.
struct MeanMotion {
  double forward_mps = 0.0, yaw_rate_radps = 0.0;
};

/// Drives `body` at these track speeds: `run_in_s` until it is steady, then `measured_s` (> 0),
/// over which its motion is averaged.
MeanMotion mean_motion(Body& body, const TrackSpeeds& tracks, double run_in_s, double measured_s);

/// What was measured on one slope, from the body's exact motion.
struct SlopeSlip {
  double slope_rad = 0.0;
  double left = 0.0, right = 0.0;  ///< 1 - speed of the body over either track / track speed
  double yaw_rate_radps = 0.0;
  bool climbed = false;  ///< false: it slid or fell over
};

/// A slope of the experiment and the paper's values for it; its table has no row for 4 deg.
struct SlopeRow {
  double slope_deg;
  std::optional<double> paper_left, paper_right;
};
/// 0, 4 ... 28 deg.
std::span<const SlopeRow> slope_rows();

/// Speed of the tracks on slopes, where slip is measured. [m/s]
inline constexpr double kSlopeTrackMps = 0.10;

/// Measures a drive straight up an even slope, both tracks at `track_mps`, for two seconds after
/// half a second of running in. Pure.
SlopeSlip measure_slope(const course::EmulatedBody& values, double slope_rad, double track_mps);

/// Drives straight up and down boards of 8 to 28 deg, at the experiment's speed, for identify: both
/// encoders, and the distance along the board and the turn as a tape and a protractor measure them.
/// Without boards that the robot does not climb; of the body `ode` only.
std::vector<identify::RecordedDrive> slope_drives(const course::Robot& robot, std::uint64_t seed);

struct SlopeCommand {
  std::string robot;  ///< bundled name or file; empty: the reference robot
  bool json = false;
};

/// Drives 0, 4 ... 28 deg at kSlopeTrackMps and prints the slip of both tracks beside the paper's
/// table. Returns 0 if the robot climbed every slope, else 1. Throws SetupError.
int run_slope(const SlopeCommand& command);

}  // namespace tp100::sim
