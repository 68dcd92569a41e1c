#include "identify/identify.h"

#include <CLI/CLI.hpp>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <filesystem>
#include <iostream>
#include <optional>
#include <utility>

#include "app/commands.h"
#include "config/configuration.h"
#include "config/setup_files.h"
#include "core/arithmetic.h"
#include "core/error.h"
#include "course/bundled_files.h"
#include "course/course.h"
#include "course/robot_file.h"
#include "identify/drive_file.h"
#include "identify/identify_report.h"
#include "identify/next_manoeuvre.h"
#include "text/atomic_file.h"
#include "text/command_line.h"
#include "text/format.h"

namespace tp100::app {
namespace {

struct GuidedOptions {
  RunOptions run{};  ///< port, camera, robot, configuration, go; its course is set here
  std::vector<std::string> courses;  ///< bundled names or files; empty: calibration_courses
  int repeats = 2;                   ///< of each drive
  std::string folder;  ///< for the recordings, one CSV file per drive; created if absent
  double narrow = identify::AutoSettings{}.narrow;  ///< see IdentifyOptions::by_itself
};

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

/// A number from standard input; nothing for an empty line.
std::optional<double> ask(const std::string& question) {
  while (true) {
    std::printf("%s ", question.c_str());
    std::fflush(stdout);
    std::string line;
    if (!std::getline(std::cin, line))
      throw UserError(
          "identify --drive: no camera recorded the drive, and standard input ended before the "
          "measured values; give --camera, or enter the values");
    if (line.find_first_not_of(" \t\r") == std::string::npos) return std::nullopt;
    char* end = nullptr;
    const double value = std::strtod(line.c_str(), &end);
    const bool whole = std::string_view(end).find_first_not_of(" \t\r") == std::string_view::npos;
    if (end != line.c_str() && whole && std::isfinite(value)) return value;
    std::printf("'%s' is not a number\n", one_line(line, 40).c_str());
  }
}

std::optional<double> ask_for_turn() {
  const auto turned_deg = ask("  turned angle, left positive, including whole turns [deg]:");
  if (!turned_deg) return std::nullopt;
  return *turned_deg * kRadPerDeg;
}

void ask_for(identify::HandMeasured& measured) {
  std::printf("No camera recorded this drive. Measure it; press Enter to skip a value.\n");
  measured.distance_m = ask("  straight-line distance from start to end [m]:");
  measured.turned_rad = ask_for_turn();
}

void ask_for_end(identify::HandMeasured& measured) {
  std::printf("Measure the end of the drive from its start; press Enter to skip a value.\n");
  measured.ahead_m = ask("  distance ahead, in the direction at the start [m]:");
  measured.left_m = ask("  distance to the left of that direction [m]:");
  measured.turned_rad = ask_for_turn();
}

std::string space_for(const course::Course& course) {
  return text::format("%.1f m ahead, %.1f behind, %.1f to the left, %.1f to the right",
                      course.fence.max_x_m, -course.fence.min_x_m, course.fence.max_y_m,
                      -course.fence.min_y_m);
}

std::string today() { return text::utc_minute(std::time(nullptr)).substr(0, 10); }

/// Robot and configuration with which the drives are identified: of the given files; by default
/// those in the recordings.
class Base {
 public:
  explicit Base(const IdentifyOptions& options)
      : given_(options.drive || !options.robot.empty() || !options.config.empty()) {
    if (!options.config.empty()) {
      const course::TextFile file = course::read_text_file(options.config);
      configuration = config::parse_configuration(file.text, file.path);
    }
    robot = config::read_setup_file(course::Bundled::kRobots,
                                    options.robot.empty() ? configuration.robot : options.robot,
                                    config::library_folder(configuration.library));
  }

  /// Throws UserError: two recordings have different robots.
  void take(const record::Recording& recording) {
    if (given_) return;
    const config::RunFiles files = recorded_files(recording);
    if (first_.empty()) {
      first_ = recording.path();
      robot = files.robot;
      configuration =
          config::parse_configuration(files.configuration.text, files.configuration.path);
    } else if (files.robot.text != robot.text) {
      throw UserError(recording.path() + ": was recorded with a different robot file than " +
                      first_ + "; leave one of them out, or name the robot with --robot");
    }
  }

  course::TextFile robot;
  config::Configuration configuration;

 private:
  bool given_;
  std::string first_;  // the recording that they come from
};

std::vector<identify::RecordedDrive> recorded(const IdentifyOptions& options, Base& base) {
  std::vector<identify::RecordedDrive> drives;
  for (const std::string& path : options.runs) {
    if (record::is_recording(path)) {
      const record::Recording recording(path);
      base.take(recording);
      drives.push_back(identify::recorded_drive(recording));
      drives.back().name = record::run_name(path);
      continue;
    }
    const course::TextFile file = course::read_text_file(path);
    drives.push_back(identify::parse_drive(file.text, file.path));
  }
  if (!options.measured.empty()) {
    const course::TextFile file = course::read_text_file(options.measured);
    identify::add_measured(file.text, file.path, drives);
  }
  return drives;
}

/// One drive; `course` as for RunOptions. Nothing: it was not completed.
std::optional<identify::RecordedDrive> drive_once(RunOptions run, const std::string& course,
                                                  bool ran_before) {
  identify::DriveSink sink;
  run.course = course;
  run.daemon.ran_before = ran_before;
  run.daemon.sinks.push_back(&sink);
  if (run_run(run) != 0) return std::nullopt;
  return sink.drive();
}

/// A configuration file in `folder` that steers by the fused pose and else is `config`; returns its
/// path.
std::string with_fused_steering(const std::string& config, const std::string& folder) {
  const std::string text = config.empty() ? std::string() : course::read_text_file(config).text;
  std::string path = folder + "/tp100.toml";
  text::write_file(
      path,
      text::with_values_in_place(
          text, config, {{"estimation.steering", std::string(to_string(PoseSource::kFused))}}));
  return path;
}

void keep(const std::string& folder, const std::vector<identify::RecordedDrive>& drives) {
  text::write_file(folder + "/" + drives.back().name + "-samples.csv",
                   identify::write_drive(drives.back()));
  const std::string measured = identify::write_measured(drives);
  if (!measured.empty()) text::write_file(folder + "/measured.csv", measured);
}

/// The course whose fence holds the manoeuvres if none is given.
constexpr const char* kAutoArea = "1-straight";

struct GuidedDrives {
  std::vector<identify::RecordedDrive> drives;
  bool completed = false;  ///< all of them; else only the drives before the one that failed
  std::optional<identify::AutoProgress> progress{};  ///< of drive_by_itself
};

/// Drives all courses. On a physical port each drive waits for Enter (unless `go`). Where no camera
/// sees it, the end of a drive is asked for on standard output and read from standard input. A
/// drive that is not completed ends the calibration; earlier ones stay in the folder. Throws
/// UserError.
GuidedDrives drive_guided(const GuidedOptions& options, const course::Robot& robot) {
  text::make_folder(options.folder, "--runs-dir");
  const std::vector<std::string> courses =
      options.courses.empty() ? identify::calibration_courses(robot.shape) : options.courses;
  const std::size_t all = courses.size() * static_cast<std::size_t>(options.repeats);
  GuidedDrives result;
  for (const std::string& name : courses) {
    const course::TextFile file = course::read_bundled(course::Bundled::kCourses, name);
    const course::Course course = course::parse_course(file.text, file.path);
    for (int repeat = 1; repeat <= options.repeats; ++repeat) {
      std::printf("drive %zu of %zu: %s; free floor needed around the start: %s\n",
                  result.drives.size() + 1, all, course.name.c_str(), space_for(course).c_str());
      std::fflush(stdout);
      auto drive = drive_once(options.run, name, !result.drives.empty());
      if (!drive) return result;
      // In the order of the folder's listing, which numbers the runs for hand measurements.
      const std::size_t number = result.drives.size() + 1;
      drive->name = (number < 10 ? "0" : "") + std::to_string(number) + "-" + course.name;
      if (drive->camera.empty()) ask_for(drive->measured);
      result.drives.push_back(std::move(*drive));
      keep(options.folder, result.drives);
    }
  }
  result.completed = true;
  return result;
}

/// The same with manoeuvres that it chooses (identify/next_manoeuvre.h), inside the fence of the
/// only course of `options`. With a camera each begins where the last one ended; without one a
/// person puts the robot back to the start each time and enters where it ended. The folder also
/// keeps the courses and the robot file as known so far.
GuidedDrives drive_by_itself(const GuidedOptions& options, const course::Robot& robot,
                             const config::Configuration& configuration) {
  if (options.courses.size() > 1)
    throw UserError("identify --auto: more than one --course; give the one whose fence applies");
  text::make_folder(options.folder, "--runs-dir");
  const course::TextFile area = course::read_bundled(
      course::Bundled::kCourses, options.courses.empty() ? kAutoArea : options.courses.front());
  identify::AutoSettings settings;
  settings.camera = !options.run.camera.empty() || !configuration.camera.listen.empty();
  settings.narrow = options.narrow;
  identify::NextManoeuvre next(
      identify::prior_of(robot, configuration.parameters.model.turning_threshold_radps), area,
      settings);
  RunOptions run = options.run;
  // With a camera the fused pose is right whatever the robot's slip is.
  if (settings.camera) run.config = with_fused_steering(run.config, options.folder);
  // The robot with the values found so far, so that it follows each path better.
  run.robot = options.folder + "/robot.toml";
  course::Robot so_far = robot;
  GuidedDrives result;
  result.progress = next.progress();
  while (const auto manoeuvre = next.choose()) {
    const course::TextFile file = next.course_of(*manoeuvre);
    const std::string path = options.folder + "/" + file.path;
    text::write_file(path, file.text);
    text::write_file(run.robot, course::write_robot(so_far, {}));
    const Pose& start = manoeuvre->start;
    std::printf("%s, from (%.2f, %.2f) m, %.0f deg%s\n", manoeuvre->name.c_str(), start.x_m,
                start.y_m, start.yaw_rad * kDegPerRad,
                settings.camera && !result.drives.empty() ? "" : "; put the robot there");
    std::fflush(stdout);
    auto drive = drive_once(run, path, !result.drives.empty());
    if (!drive) return result;
    drive->name = manoeuvre->name;
    if (!settings.camera) {
      ask_for_end(drive->measured);
    } else if (drive->camera.empty()) {
      throw UserError("identify --auto: no camera poses arrived during " + manoeuvre->name +
                      "; start tp100-camera with --to this machine, or leave out --camera "
                      "and measure by hand");
    }
    next.take(std::move(*drive));
    so_far.model = next.tracks();
    result.drives = next.drives();
    keep(options.folder, result.drives);
    result.progress = next.progress();
    std::printf("%s\n", identify::progress_line(*result.progress).c_str());
    std::fflush(stdout);
  }
  result.completed = true;
  return result;
}

GuidedDrives driven(const IdentifyOptions& options, const course::Robot& robot,
                    const config::Configuration& configuration) {
  if (!options.runs.empty() || !options.measured.empty())
    throw UserError("identify: --drive makes its own runs; leave out RUN and --measured");
  GuidedOptions guided = options.guided;
  guided.run.config = options.config;
  guided.run.robot = options.robot;
  if (guided.folder.empty())
    guided.folder = std::filesystem::path(options.out).replace_extension().string() + "-runs";
  GuidedDrives result = options.by_itself ? drive_by_itself(guided, robot, configuration)
                                          : drive_guided(guided, robot);
  std::printf("%s in %s\n", text::counted(result.drives.size(), "recording").c_str(),
              guided.folder.c_str());
  if (!result.completed)
    std::printf(
        "not completed, so nothing was identified; give the recordings made so far as RUN\n");
  return result;
}

int run_identify(const IdentifyOptions& options) {
  if (!options.drive && options.runs.empty())
    throw UserError("identify: give recordings (RUN...), or --drive to make them");
  if (options.by_itself && !options.drive)
    throw UserError("identify: --auto works only with --drive; give both");
  Base assumed(options);
  std::vector<identify::RecordedDrive> drives;
  std::optional<identify::AutoProgress> progress;
  if (options.drive) {
    text::require_not_read(options.out);  // before an hour of drives
    GuidedDrives guided =
        driven(options, course::parse_robot(assumed.robot.text, assumed.robot.path),
               assumed.configuration);
    progress = guided.progress;
    if (!guided.completed) return 1;
    drives = std::move(guided.drives);
  } else {
    drives = recorded(options, assumed);
    text::require_not_read(options.out);
  }
  const course::Robot base = course::parse_robot(assumed.robot.text, assumed.robot.path);

  const identify::Prior prior =
      identify::prior_of(base, assumed.configuration.parameters.model.turning_threshold_radps);
  const identify::Identification found = identify::identify(drives, prior);
  const std::string date = options.date.empty() ? today() : options.date;
  const course::Robot robot = identify::identified_robot(found, base, date);
  const std::string note =
      identify::identified_note(found, course::head_note(assumed.robot.text), date);
  const std::string text = course::write_robot(robot, note);
  // Rejects impossible values here, by name and range.
  course::parse_robot(text, options.out);
  if (options.json) {
    std::printf("%s\n", identify::identify_json(found, base, robot, progress).c_str());
  } else {
    std::printf("%s", identify::identify_report(found, base).c_str());
    if (progress) std::printf("%s\n", identify::end_line(*progress).c_str());
  }
  text::write_file(options.out, text);
  if (!options.json) std::printf("written to %s\n", options.out.c_str());
  return progress && !progress->narrow ? 1 : 0;
}

}  // namespace

void add_identify(CLI::App& app, Action& action) {
  static IdentifyOptions options;
  CLI::App* command =
      app.add_subcommand("identify", "Find slip, wheelbase and gyro scale from recorded drives");
  text::option(command, "RUN", options.runs, "FILE",
               "Recordings, or CSV t_s,left_count,right_count,gyro_z_radps"
               "[,camera_x_m,camera_y_m,camera_yaw_rad], one file a run");
  text::option(command, "--out", options.out, "FILE", "Robot file to write")->required();
  text::option(command, "--robot", options.robot, "ROBOT",
               "Source of all other values: name in config/robots or file (default: the "
               "recordings', else end-loaded)");
  text::option(command, "--measured", options.measured, "FILE",
               "CSV of hand measurements: run[,distance_m][,ahead_m][,left_m][,turned_deg]"
               "[,slope_deg]; run counts from 1, slope_deg is that of a board on which the run "
               "was");
  text::option(command, "--config", options.config, "FILE",
               "Configuration (default: the recordings', else as config/tp100.toml)");
  command->add_flag("--json", options.json, "Print what was found as JSON");
  add_background(*command);
  text::option(command, "--date", options.date, "DATE",
               "Day of the runs for the file (default: today)");
  command->add_flag("--drive", options.drive,
                    "Drive the calibration courses on a port first, instead of RUN; without a "
                    "camera it asks for what was measured");
  command->add_flag("--auto", options.by_itself,
                    "--drive chooses the manoeuvres that narrow the intervals most, until all are "
                    "narrow enough; prints the seconds of driving");
  text::option(command, "--narrow", options.guided.narrow, "PARTS",
               "Goal of --auto: half width of each interval, relative to a harmless error")
      ->check(CLI::Range(0.05, 10.0))
      ->capture_default_str();
  text::option(command, "--port", options.guided.run.port, "DEVICE",
               "Serial port of --drive (default: auto)");
  text::option(command, "--camera", options.guided.run.camera, "ADDRESS",
               "Overhead camera of --drive: udp:PORT or udp:ADDRESS:PORT (default: none)");
  command->add_flag(
      "--go", options.guided.run.daemon.go,
      "Start the first drive of --drive without confirmation on a physical port, too");
  text::option(command, "--course", options.guided.courses, "COURSE",
               "Courses of --drive: names in config/courses or files (default: those that "
               "calibrate a robot of this size); with --auto the one whose fence holds the "
               "manoeuvres (default: 1-straight)");
  text::option(command, "--repeats", options.guided.repeats, "NUMBER",
               "Number of times that --drive drives each course")
      ->check(CLI::Range(1, 100))
      ->capture_default_str();
  text::option(command, "--runs-dir", options.guided.folder, "FOLDER",
               "Folder for the recordings of --drive (default: beside --out)");
  command->footer(
      "Example: tp100d identify --drive --port auto --robot mine.toml --out mine-identified.toml");
  command->callback([&action] { action = [] { return run_identify(options); }; });
}

}  // namespace tp100::app
