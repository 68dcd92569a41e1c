#pragma once
// Everything that tunes a step. Filled from the configuration and the robot file by config.

#include <array>
#include <string_view>

#include "control/monitor.h"
#include "control/parameters.h"
#include "control/tracker.h"
#include "core/arithmetic.h"
#include "core/command.h"
#include "core/enum_names.h"
#include "core/estimates.h"
#include "core/step_record.h"
#include "course/course.h"
#include "course/robot.h"
#include "estimation/parameters.h"
#include "model/track_parameters.h"

namespace tp100::bridge {

/// One setting that fixes pitch source, yaw source and the firmware's use of its gyro together.
enum class Setup {
  kStand,    ///< tracks spin free on a stand: the gyro must not steer
  kFlat,     ///< flat floor, obstacles only in the virtual world: yaw from the gyro
  kTerrain,  ///< the floor has the obstacles too: pitch from the IMU
};

/// Names as in options, files and results.
inline constexpr std::array<EnumName<Setup>, 3> kSetupNames = {{
    {Setup::kStand, "stand"},
    {Setup::kFlat, "flat"},
    {Setup::kTerrain, "terrain"},
}};
constexpr const char* to_string(Setup setup) { return name_in(kSetupNames, setup); }

/// Source of the terrain under the robot.
enum class WorldKind {
  kInternal,  ///< the course's ramps and blocks
  kUdp,       ///< an external world, world/1
  kFiles,     ///< an external world, two text files
};

/// Names as in files.
inline constexpr std::array<EnumName<WorldKind>, 3> kWorldKindNames = {{
    {WorldKind::kInternal, "internal"},
    {WorldKind::kUdp, "udp"},
    {WorldKind::kFiles, "files"},
}};
constexpr const char* to_string(WorldKind kind) { return name_in(kWorldKindNames, kind); }

/// Settings of an external world that matter to the step.
struct WorldParameters {
  WorldKind kind = WorldKind::kInternal;
  bool owns_pose = false;  ///< the controller steers by the world's pose
  double timeout_s = 0.3;  ///< the world must have answered a step not older than this
};

struct Parameters {
  Setup setup = Setup::kFlat;
  PoseSource steering = PoseSource::kOdometry;
  bool paper_model = false;        ///< `model` runs eqs 1-5 with the paper's constants
  model::TrackParameters model{};  ///< of this robot, for the extended model
  course::ShapeValues shape{};
  course::DriveValues drive{};
  estimation::Parameters estimation{};
  control::Parameters control{};
  WorldParameters world{};
  /// Expiry of a command after the step; the robot accepts at most 0.2 s.
  double command_life_s = 0.180;
  double max_sample_age_s = 0.060;  ///< older samples are not answered with a command
};

/// Noise of the estimators, with the resolution of this robot's encoders.
inline estimation::FilterParameters filter_noise(const Parameters& parameters) {
  estimation::FilterParameters noise = parameters.estimation.filter;
  noise.edge_m = 1.0 / parameters.drive.counts_per_metre;
  return noise;
}

/// Eqs 1-5 with the paper's constants; only the turning threshold is taken from `values`.
inline model::TrackParameters paper_parameters(const model::TrackParameters& values) {
  return {.turning_threshold_radps = values.turning_threshold_radps};
}

/// Throws UserError if they do not fit together; `course` may be null.
void require_consistent(const Parameters& parameters, const course::Course* course);
/// The robot on a path at `speed_mps`, with the steering pose in force.
control::DriveModel drive_of(const Parameters& parameters, double speed_mps);
/// The course's fence; without a course, a rectangle without bounds.
course::Fence fence_of(const course::Course* course);
/// The robot's values for the monitor; `course` may be null.
control::MonitoredRobot monitored_robot(const Parameters& parameters, const course::Course* course);

// Changes while the step runs.

/// A key of the configuration that may change: safety limits may not.
struct LiveKey {
  std::string_view name;
  double control::Parameters::*field = nullptr;  ///< null: `steering`
  double si = 1.0;                               ///< SI units of one unit of the key
};
/// By the number of LiveParameter.
inline constexpr std::array<LiveKey, kLiveParameters> kLiveKeys = {{
    {"estimation.steering"},
    {"control.preview_s", &control::Parameters::preview_s},
    {"control.cross_track_gain_1ps", &control::Parameters::cross_track_gain_1ps},
    {"control.max_approach_deg", &control::Parameters::max_approach_rad, kRadPerDeg},
    {"control.acceleration_mps2", &control::Parameters::acceleration_mps2},
    {"control.min_speed_mps", &control::Parameters::min_speed_mps},
    {"control.pivot_rate_radps", &control::Parameters::pivot_rate_radps},
    {"control.pivot_acceleration_radps2", &control::Parameters::pivot_acceleration_radps2},
}};

/// Applies `change`. False, and nothing is changed, if the value is invalid: not finite, negative,
/// an unknown pose source, or steering while `under_way`. Other limits are the caller's duty. No
/// allocation; safe in the real-time thread.
bool apply(const ParameterChange& change, bool under_way, Parameters& parameters);

/// The present values, as changes that would set them.
StepInputs::Changes live_values(const Parameters& parameters);

}  // namespace tp100::bridge
