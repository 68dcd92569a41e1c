#pragma once
// What a run is set up from: files as they were loaded and what was chosen besides. A recording
// keeps it, and replay gets the same parameters back from there.

#include <memory>
#include <string>

#include "config/configuration.h"
#include "config/world_run.h"
#include "course/bundled_files.h"
#include "course/course.h"
#include "record/recording_writer.h"

namespace tp100::config {

/// The files of a run, and the set-up and kind of world in force.
struct RunFiles {
  course::TextFile configuration;  ///< empty: all defaults
  course::TextFile robot;
  course::TextFile course;  ///< empty: none
  bridge::Setup setup = bridge::Setup::kFlat;
  bridge::WorldKind world = bridge::WorldKind::kInternal;
};

/// The same, parsed.
struct RunSetup {
  Configuration configuration{};
  course::Robot robot{};
  std::shared_ptr<const course::Course> course;  ///< null: none
  bridge::Parameters parameters{};
};

/// Parses the files. Throws SetupError.
RunSetup parse_run(const RunFiles& files);

/// The run as those who talk to an external world see it.
WorldRun world_run(const RunSetup& run);

/// What --world says: internal, files or udp:[HOST:]PORT; empty: as configured. Throws SetupError.
bridge::WorldKind world_option(const std::string& option, bridge::WorldKind configured);

/// The run as every message speaks of it.
messages::Subject subject_of(const RunSetup& run);

/// What a recording of that run says of it. `more`: further names and values.
record::RunFacts run_facts(const RunFiles& files, const RunSetup& run, const record::McapMap& more);

// Names of the attachments.
inline constexpr const char* kConfigurationFile = "tp100.toml";
inline constexpr const char* kRobotFile = "robot.toml";
inline constexpr const char* kCourseFile = "course.toml";

}  // namespace tp100::config
