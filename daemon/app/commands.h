#pragma once
// The subcommands of tp100d, each a source file of its name with its options: here is the list of
// them, and what others than the command line call, options in, exit status or a UserError out.

#include <array>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "bridge/parameters.h"
#include "config/run_setup.h"
#include "link/port_discovery.h"
#include "live/daemon.h"
#include "record/recording.h"
#include "record/step_difference.h"

namespace CLI {
class App;
}

namespace tp100::app {

/// Action to run after parsing the command line. Returns the exit status.
using Action = std::function<int()>;

// Each adds one subcommand, which sets the action when it is parsed.
void add_run(CLI::App& app, Action& action);
void add_ports(CLI::App& app, Action& action);
void add_doctor(CLI::App& app, Action& action);
void add_check(CLI::App& app, Action& action);
void add_replay(CLI::App& app, Action& action);
void add_identify(CLI::App& app, Action& action);
void add_recover(CLI::App& app, Action& action);
void add_export(CLI::App& app, Action& action);
void add_report(CLI::App& app, Action& action);
void add_compare(CLI::App& app, Action& action);
inline constexpr std::array kSubcommands = {add_run,    add_ports,    add_doctor,  add_check,
                                            add_replay, add_identify, add_recover, add_export,
                                            add_report, add_compare};

/// Adds --background: runs this process at idle priority and ends it when its parent ends, for work
/// that is done while a robot drives.
void add_background(CLI::App& command);

// `tp100d run`: the live bridge.

struct RunOptions {
  std::string config;
  std::string port;  ///< empty: as configured
  std::string course;
  std::string robot;
  std::string setup;
  std::string listen;  ///< "ADDRESS:PORT", "auto" or "off"; empty: as configured
  std::string camera;  ///< "udp:[HOST:]PORT"; empty: as configured
  std::string record;  ///< folder for recordings; empty: as configured
  std::string world;   ///< internal, files or "udp:[HOST:]PORT"; empty: as configured
  live::DaemonOptions daemon{};
};

/// The command. 0: course completed; 1: aborted, interrupted or --duration passed.
int run_run(const RunOptions& options);

// `tp100d ports`: lists the serial ports.

/// One line per port, likely ones first, with the configuration line to copy. `stable_names[i]` is
/// a path for ports[i] that survives replugging, or empty; `passed_over`: ports that `auto` does
/// not open. Pure.
std::string ports_text(const std::vector<link::PortInfo>& ports,
                       const std::vector<std::string>& stable_names,
                       const std::vector<link::PassedOver>& passed_over);

// `tp100d check`: validates files.

/// Kinds of files that a user writes.
enum class FileKind { kConfiguration, kCourse, kRobot, kCamera, kView, kCampaign };

/// Infers the kind of a file from its keys. Throws UserError if the text is not TOML. Pure.
FileKind file_kind(const std::string& text, const std::string& file);

/// Summarizes a valid file in one line. Throws UserError for any other, and for view files and
/// campaigns, which only tp100-camera and tp100-sim can check. Also checks the robot and the course
/// that a configuration names.
std::string check_file(const std::string& path);

/// The command: one line per file, errors on stderr; with `json` of course files only, each as
/// the service file_check answers (CHANNELS.md). Exit status 0 if all are valid, else 2.
int run_check(const std::vector<std::string>& files, bool json = false);

// `tp100d replay`: runs the inputs of a recording through the step again, checks whether every pose
// and command is reproduced (bit for bit, or, if it was recorded on another kind of processor,
// core/arithmetic.h, except for rounding), and writes a CSV file of the steering poses.

struct ReplayOptions {
  std::string in;
  std::string out;
  std::string config;  ///< empty: as recorded
};

/// The command. Returns 0 if every result was reproduced (within kRounding on another kind of
/// processor), or if other parameters were requested; 1, without writing anything, if a result
/// differs or steps are missing. One row per step that received a sample.
int run_replay(const ReplayOptions& options);

/// The files of a recorded run. Throws UserError: they are missing or invalid.
config::RunFiles recorded_files(const record::Recording& recording);

/// Result of a replay.
struct Replayed {
  std::uint64_t first = 1;   ///< number of the first step: 1, or a restart of the step
  std::uint64_t steps = 0;   ///< replayed
  std::uint64_t before = 0;  ///< of them before the recording, to reach its initial state
  HostNs last_ns = 0;        ///< time of the last step that was compared
  /// First step after a gap. A gap ends the replay, since the state after it is unknown.
  std::optional<std::uint64_t> gap_before;
  std::optional<std::uint64_t> differs_at;  ///< number of the first step with a different result
  HostNs differs_ns = 0;                    ///< its time
  record::StepDifference difference{};
  record::LargestDifference largest{};  ///< of all steps
};

/// Differences from results of another kind of processor below this, in m and rad, are rounding.
inline constexpr double kRounding = 1e-9;

/// Feeds the recorded inputs to a step with these parameters and course. `each` receives the
/// recorded inputs with the results of the replay. `verify`: compares the results.
Replayed replay_steps(const record::Recording& recording, const bridge::Parameters& parameters,
                      std::shared_ptr<const course::Course> course, bool verify,
                      const std::function<void(const StepRecord&)>& each);

// `tp100d export`: recordings as files that other programs read.

// poses.csv and the trajectories cover the run (the whole recording, if no run began), with one row
// per step that received a sample; samples.csv has every sample of the recording. In all files t_s
// counts from the start of the recording, on the host's clock. Full double precision.
struct ExportOptions {
  std::vector<std::string> runs;  ///< recordings or their folders
  bool csv = false;               ///< samples.csv (as identify reads it), poses.csv
  bool tum = false;               ///< model.tum, odometry.tum, fused.tum, truth.tum
  std::string ros2{};             ///< folder of a rosbag2 bag; empty: none. For one run only
  /// Folder of the camera's images (image-000001.jpg, ...) and times.csv, which has their times:
  /// a source of tp100-camera. Empty: none. For one run only.
  std::string images{};
  std::string out;  ///< folder; empty: beside the recording. For one run only
};

int run_export(const ExportOptions& options);

// `tp100d report` and `tp100d compare`: recordings as pages, figures and numbers.

struct ReportOptions {
  std::vector<std::string> runs;  ///< recordings or their folders
  /// Folder, created if absent. Of a report: for one run only; empty: beside the recording.
  std::string out;
};

/// Writes report.html, metrics.json and a .svg for each figure.
int run_report(const ReportOptions& options);

/// Writes compare.html, compare.json (the metrics of each run) and a .svg for each figure, of two
/// to twenty runs.
int run_compare(const ReportOptions& options);

}  // namespace tp100::app
