#pragma once
// The subcommands of tp100d: options in, exit status or a UserError out. Each is a source file of
// its name.

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "bridge/parameters.h"
#include "config/run_setup.h"
#include "identify/next_manoeuvre.h"
#include "link/port_discovery.h"
#include "live/daemon.h"
#include "record/recording.h"
#include "record/step_difference.h"

namespace tp100::app {

/// Runs this process at idle priority and ends it when its parent ends: for work that is done while
/// a robot drives.
void become_background();

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

int run_ports();

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

// `tp100d doctor`: finds what prevents the robot from driving, with one line to fix each.

struct DoctorOptions {
  std::string config;
  std::string robot;         ///< empty: as configured
  std::string port;          ///< empty: as configured
  double link_test_s = 1.0;  ///< 0: no link test
  bool wheels_up = false;    ///< also run the guided test of the tracks
  bool json = false;
};

/// The command. 0: nothing prevents the robot from driving; 1: something does.
int run_doctor(const DoctorOptions& options);

// The guided calibration of `tp100d identify --drive`: drives one calibration course after the
// other on a port and records them; the end of each is measured by a camera or by hand.

struct GuidedOptions {
  RunOptions run{};  ///< port, camera, robot, configuration, go; its course is set here
  std::vector<std::string> courses;  ///< bundled names or files; empty: calibration_courses
  int repeats = 2;                   ///< of each drive
  std::string folder;  ///< for the recordings, one CSV file per drive; created if absent
  double narrow = identify::AutoSettings{}.narrow;  ///< see IdentifyOptions::by_itself
};

// `tp100d identify`: identifies a robot's parameters from recorded drives and writes a robot file.

struct IdentifyOptions {
  std::vector<std::string> runs;  ///< recordings or CSV files of drives; none if it drives
  std::string out;                ///< robot file to write
  std::string robot;              ///< source of all other values; empty: the configuration's
  std::string measured;           ///< CSV file of hand measurements; empty: none
  std::string config;  ///< empty: the recordings' robot and configuration, unless `robot` is given
                       ///< or it drives; else defaults
  std::string date;    ///< date of the runs for the file; empty: today
  bool drive = false;  ///< drive the calibration courses first
  bool by_itself = false;  ///< drive manoeuvres that it chooses instead
  bool json = false;       ///< print JSON
  GuidedOptions guided{};  ///< options of the drives; robot and configuration are taken from above
};

/// The command. Prints the report; writes a file only if everything succeeded. Returns the exit
/// status: 1 if a drive was not completed or, with `by_itself`, a confidence interval stayed too
/// wide.
int run_identify(const IdentifyOptions& options);

// `tp100d replay`: runs the inputs of a recording through the step again, checks whether every pose
// and command is reproduced (bit for bit, or, if it was recorded on another kind of processor,
// core/arithmetic.h, except for rounding), and writes a CSV file of poses.

struct ReplayOptions {
  std::string in;
  std::string out;
  std::string config;  ///< empty: as recorded
  std::string model;   ///< paper, extended, odometry or fused; empty: the steering pose
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

// `tp100d recover`: rebuilds a complete recording from a truncated or corrupted one.

struct RecoverOptions {
  std::string in;   ///< file, or the folder of a run
  std::string out;  ///< empty: beside it, with -recovered before .mcap
};

/// Copies all intact content of `in` to `out`, with indexes and statistics; does not change `in`.
/// 0: written, or nothing to recover.
int run_recover(const RecoverOptions& options);

}  // namespace tp100::app
