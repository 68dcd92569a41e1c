#pragma once
// The subcommands of tp100d: options in, exit status out. Each is a source file of its name.

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "config/configuration.h"
#include "core/pose.h"
#include "course/robot_file.h"
#include "identify/drive.h"
#include "identify/next_manoeuvre.h"
#include "link/port_discovery.h"
#include "live/daemon.h"

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

/// The command. 0: course completed; 1: aborted, interrupted or --duration passed. Throws
/// UserError.
int run_run(const RunOptions& options);

// `tp100d ports`: lists the serial ports.

/// One line per port, likely ones first, with the configuration line to copy. `stable_names[i]` is
/// a path for ports[i] that survives replugging, or empty; `passed_over`: ports that `auto` does
/// not open. Pure.
std::string ports_text(const std::vector<link::PortInfo>& ports,
                       const std::vector<std::string>& stable_names,
                       const std::vector<link::PassedOver>& passed_over);

/// The command. Returns 0. Throws UserError.
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

/// The command. 0: nothing prevents the robot from driving; 1: something does. Throws UserError.
int run_doctor(const DoctorOptions& options);

// The guided calibration of `tp100d identify --drive`: drives one calibration course after the
// other on a port and records them; the end of each is measured by a camera or by hand.

struct GuidedOptions {
  RunOptions run{};  ///< port, camera, robot, configuration, go; its course is set here
  std::vector<std::string> courses;  ///< bundled names or files; empty: calibration_courses
  int repeats = 2;                   ///< of each drive
  std::string folder;  ///< for the recordings, one CSV file per drive; created if absent
  double narrow = identify::AutoSettings{}.narrow;  ///< for drive_by_itself()
};
/// The course whose fence holds the manoeuvres if none is given.
inline constexpr const char* kAutoArea = "1-straight";

struct GuidedDrives {
  std::vector<identify::RecordedDrive> drives;
  bool completed = false;  ///< all of them; else only the drives before the one that failed
  std::optional<identify::AutoProgress> progress{};  ///< of drive_by_itself
};

/// Drives all courses. On a physical port each drive waits for Enter (unless `go`). Where no camera
/// sees it, the end of a drive is asked for on standard output and read from standard input. A
/// drive that is not completed ends the calibration; earlier ones stay in the folder. Throws
/// UserError.
GuidedDrives drive_guided(const GuidedOptions& options, const course::Robot& robot);

/// The same with manoeuvres that it chooses (identify/next_manoeuvre.h), inside the fence of the
/// only course of `options`. With a camera each begins where the last one ended; without one a
/// person puts the robot back to the start each time and enters where it ended. The folder also
/// keeps the courses and the robot file as known so far.
GuidedDrives drive_by_itself(const GuidedOptions& options, const course::Robot& robot,
                             const config::Configuration& configuration);

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
  bool by_itself = false;   ///< drive manoeuvres that it chooses instead
  bool json = false;        ///< print JSON
  bool background = false;  ///< see become_background()
  GuidedOptions guided{};   ///< options of the drives; robot and configuration are taken from above
};

/// The command. Prints the report; writes a file only if everything succeeded. Returns the exit
/// status: 1 if a drive was not completed or, with `by_itself`, a confidence interval stayed too
/// wide. Throws UserError.
int run_identify(const IdentifyOptions& options);

// `tp100d replay`: runs a recording through the step, and writes a CSV file of poses.

struct ReplayOptions {
  std::string in;
  std::string out;
  std::string config;  ///< empty: as recorded
  std::string model;   ///< paper, extended, odometry or fused; empty: the steering pose
};

/// The command. Returns 0 if every result was reproduced (within kRounding on another kind of
/// processor), or if other parameters were requested; 1, without writing anything, if a result
/// differs or steps are missing. Throws UserError. One row per step that received a sample.
int run_replay(const ReplayOptions& options);

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

/// The command. Throws UserError.
int run_export(const ExportOptions& options);

// `tp100d report` and `tp100d compare`: recordings as pages, figures and numbers.

struct ReportOptions {
  std::vector<std::string> runs;  ///< recordings or their folders
  std::string out;                ///< folder; empty: beside the recording. For one run only
  bool background = false;        ///< see become_background()
};

/// Writes report.html, metrics.json and a .svg for each figure. Throws UserError.
int run_report(const ReportOptions& options);

struct CompareOptions {
  std::vector<std::string> runs;  ///< two to twenty
  std::string out = ".";          ///< folder, created if absent
  bool background = false;        ///< see become_background()
};

/// Writes compare.html, compare.json (the metrics of each run) and a .svg for each figure. Throws
/// UserError.
int run_compare(const CompareOptions& options);

// `tp100d recover`: rebuilds a complete recording from a truncated or corrupted one.

struct RecoverOptions {
  std::string in;   ///< file, or the folder of a run
  std::string out;  ///< empty: beside it, with -recovered before .mcap
};

/// Result of a recovery.
struct Recovered {
  std::string path;
  std::uint64_t messages = 0;
  std::uint64_t corrupted = 0;  ///< chunks and attachments left out
  std::string problem;          ///< the first error; empty: none
};

/// Copies all intact content of `in` to `out`, with indexes and statistics; does not change `in`.
/// Throws UserError.
Recovered recover(const std::string& in, const std::string& out);

/// The command. 0: written, or nothing to recover. Throws UserError.
int run_recover(const RecoverOptions& options);

}  // namespace tp100::app
