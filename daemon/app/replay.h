#pragma once
// `tp100d replay`: belt speeds of a CSV file through the model, or a recording through the step, to
// a CSV file of poses.

#include <string>

#include "config/configuration.h"
#include "core/pose.h"
#include "model/track_model.h"

namespace tp100::app {

/// Which estimate is replayed.
enum class ReplayModel {
  kPaper,     ///< eqs 1-5 with the paper's constants
  kExtended,  ///< the robot's values, turning centre and slope
  kOdometry,  ///< belts and gyro
  kFused,     ///< these and the overhead camera; of recordings only
};

/// The model that a name on the command line means. Throws SetupError for any other.
ReplayModel replay_model(const std::string& name);

/// First line of a file of poses, and one row of it: full double precision.
extern const char* const kReplayHeader;
std::string replay_row(double t_s, const Pose& pose, const Twist& twist, const model::Slip& slip);

/// Poses for the text of a speeds file, one row per input row: row i's values hold until row i+1
/// and the pose starts at 0. `gyro_z_radps` is the calibrated rate about z; a constant part of it
/// is removed as bias once the belts have stood still. `file` is only used in messages. Throws
/// SetupError (file:line). Pure.
std::string replay_csv(const std::string& text, const std::string& file, ReplayModel model,
                       const bridge::Parameters& parameters);

/// Options of the command.
struct ReplayOptions {
  std::string in;
  std::string out;
  std::string config;  ///< empty: defaults
  std::string model;   ///< empty: as configured
};

/// The command, for a CSV file or a recording (replay_recording.h). Exit status; throws SetupError.
/// Writes nothing unless all went well.
int run_replay(const ReplayOptions& options);

}  // namespace tp100::app
