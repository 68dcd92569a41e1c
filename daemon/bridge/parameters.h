#pragma once
// Everything that tunes a step. Filled from the configuration and the robot file by app.

#include <optional>
#include <string_view>

#include "control/parameters.h"
#include "core/steering.h"
#include "course/robot.h"
#include "estimation/parameters.h"
#include "model/track_model.h"

namespace tp100::bridge {

/// One setting that fixes pitch source, yaw source and the firmware's use of its gyro together.
enum class Setup {
  kBench,    ///< tracks spin free on a stand: the gyro must not steer
  kFlat,     ///< flat floor, obstacles only in the virtual world: yaw from the gyro
  kTerrain,  ///< the floor has the obstacles too: pitch from the IMU
};

/// Name of a set-up, as in options, files and results.
const char* to_string(Setup setup);
/// The set-up of that name, or nothing.
std::optional<Setup> setup_named(std::string_view name);

using tp100::Steering;

/// Who says what the robot stands on.
enum class WorldKind {
  kInternal,  ///< the course's ramps and blocks
  kUdp,       ///< an external world, world/1
  kFiles,     ///< an external world, two text files
};

/// Name of a kind of world, as in files.
const char* to_string(WorldKind kind);
/// The kind of that name, or nothing.
std::optional<WorldKind> world_kind_named(std::string_view name);

/// What of an external world matters to the step.
struct WorldParameters {
  WorldKind kind = WorldKind::kInternal;
  bool owns_pose = false;  ///< the controller steers by the world's pose
  double timeout_s = 0.3;  ///< the world must have answered a step not older than this
};

struct Parameters {
  Setup setup = Setup::kFlat;
  Steering steering = Steering::kOdometry;
  bool paper_model = false;  ///< `model` runs eqs 1-5 with the paper's constants
  model::SlipCurve slip_curve = model::SlipCurve::kTableDownhill;
  course::ModelValues model{};
  course::ShapeValues shape{};
  course::DriveValues drive{};
  estimation::Parameters estimation{};
  control::Parameters control{};
  WorldParameters world{};
  double command_life_s =
      0.180;  ///< expiry of a command after the step; the robot takes 0.2 at most
  double max_sample_age_s = 0.060;  ///< older samples are not answered with a command
  double sample_timeout_s = 0.2;    ///< no newer sample ends a run: link_lost or samples_stale
};

/// The extended model with this robot's values.
model::TrackParameters track_parameters(const Parameters& parameters);
/// Eqs 1-5 with the paper's constants; only the turning threshold is `values`'.
model::TrackParameters paper_parameters(const course::ModelValues& values);

}  // namespace tp100::bridge
