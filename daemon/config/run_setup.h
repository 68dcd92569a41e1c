#pragma once
// Inputs of a run: the files as they were loaded and the other choices. A recording contains them,
// so that replay gets the same parameters back.

#include <memory>
#include <string>

#include "config/configuration.h"
#include "config/world_settings.h"
#include "course/bundled_files.h"
#include "course/course.h"
#include "record/recording_writer.h"

namespace tp100::config {

/// The files of a run, and the set-up and kind of world in use.
struct RunFiles {
  course::TextFile configuration{};  ///< empty: all defaults
  course::TextFile robot{};
  course::TextFile course{};  ///< empty: none
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

/// Both together, as they are in force at one time.
struct LoadedRun {
  RunFiles files;
  RunSetup setup;
};

/// Parses the files. Throws UserError.
RunSetup parse_run(const RunFiles& files);

/// Throws UserError if course, robot and set-up do not fit together.
void require_fit(const RunSetup& run);

/// The run with other files of course and robot and another set-up, and otherwise unchanged: the
/// configuration file is not read again. Throws UserError.
LoadedRun with_files(const LoadedRun& run, const course::TextFile& course,
                     const course::TextFile& robot, bridge::Setup setup);

/// The run's data for the interfaces to an external world.
WorldRun world_run(const RunSetup& run);

/// The value of --setup; empty: as configured. Throws UserError.
bridge::Setup setup_option(const std::string& option, bridge::Setup configured);

/// The value of --world: internal, files or udp:[HOST:]PORT; empty: as configured. Throws
/// UserError.
bridge::WorldKind world_option(const std::string& option, bridge::WorldKind configured);

/// The context of the run's messages.
messages::RunContext run_context_of(const RunSetup& run);

/// A recording's facts about the run. `more`: further names and values.
record::RunFacts run_facts(const RunFiles& files, const RunSetup& run, const record::McapMap& more);

/// Name of the fact that has the text of arithmetic() (core/processor.h).
inline constexpr const char* kArithmeticFact = "arithmetic";

// Names of the attachments.
inline constexpr const char* kConfigurationFile = "tp100.toml";
inline constexpr const char* kRobotFile = "robot.toml";
inline constexpr const char* kCourseFile = "course.toml";

}  // namespace tp100::config
