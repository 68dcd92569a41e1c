#pragma once
// Options that several commands of tp100-sim share, and what they resolve to.

#include <cstdint>
#include <string>

#include "bridge/parameters.h"
#include "config/configuration.h"
#include "config/run_setup.h"
#include "course/camera.h"
#include "course/course.h"
#include "course/robot_file.h"
#include "sim/robot/emulated_robot.h"
#include "text/toml_document.h"

namespace tp100::sim {

/// Options as given on the command line or by a campaign.
struct Options {
  std::string board = "native";
  std::string body{};    ///< ode or shear; empty: the robot file's contact_law
  std::string floor{};   ///< even or uneven; empty: the robot file's
  std::string robot{};   ///< bundled name or file; empty: the configuration's
  std::string config{};  ///< file; empty: defaults
  std::string setup{};   ///< empty: the configuration's
  std::uint64_t seed = 1;
  text::NamedValues configuration_values{};  ///< override those in the file
  text::NamedValues robot_values{};          ///< override those in the robot's file
};

/// Why `text` is no seed, 0 or more, in one line; empty if it is one. CLI11 alone would accept -7
/// as a large number.
std::string why_no_seed(const std::string& text);

/// Everything loaded. Throws UserError.
struct Loaded {
  BoardKind board = BoardKind::kNative;
  config::Configuration configuration{};
  course::Robot robot{};
  config::RunFiles files{};  ///< the files it was loaded from; the course is added by commands that
                             ///< have one
  bridge::Setup setup = bridge::Setup::kFlat;
};
Loaded load(const Options& options);

/// A course by bundled name or file. Throws UserError.
course::Course load_course(const std::string& name_or_path);

/// An overhead camera by bundled name or file. Throws UserError.
course::EmulatedCamera load_camera(const std::string& name_or_path);

}  // namespace tp100::sim
