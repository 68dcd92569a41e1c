#include "identify/identify.h"

#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <filesystem>
#include <iostream>
#include <optional>
#include <utility>

#include "app/commands.h"
#include "app/replay.h"
#include "config/configuration.h"
#include "core/angle.h"
#include "core/error.h"
#include "course/bundled_files.h"
#include "course/course.h"
#include "identify/drive_file.h"
#include "identify/identify_report.h"
#include "text/atomic_file.h"
#include "text/format.h"
#include "text/toml_document.h"

namespace tp100::app {
namespace {

/// A number from standard input; nothing for an empty line.
std::optional<double> ask(const std::string& question) {
  while (true) {
    std::printf("%s ", question.c_str());
    std::fflush(stdout);
    std::string line;
    if (!std::getline(std::cin, line))
      throw SetupError(
          "identify --drive: no camera saw the drive and there is no input; give --camera, or "
          "answer "
          "on standard input");
    if (line.find_first_not_of(" \t\r") == std::string::npos) return std::nullopt;
    char* end = nullptr;
    const double value = std::strtod(line.c_str(), &end);
    const bool whole = std::string_view(end).find_first_not_of(" \t\r") == std::string_view::npos;
    if (end != line.c_str() && whole && std::isfinite(value)) return value;
    std::printf("'%s' is no number\n", text::one_line(line, 40).c_str());
  }
}

void ask_for(identify::HandMeasured& measured) {
  std::printf("No camera saw this drive. Measure it; an empty line leaves a value out.\n");
  measured.distance_m = ask("  distance from start to end, straight through the air [m]:");
  const auto turned_deg = ask("  turned angle, left positive, whole turns counted [deg]:");
  if (turned_deg) measured.turned_rad = *turned_deg * kRadPerDeg;
}

std::string space_for(const course::Course& course) {
  char text[120];
  std::snprintf(text, sizeof text, "%.1f m ahead, %.1f behind, %.1f to the left, %.1f to the right",
                course.fence.max_x_m, -course.fence.min_x_m, course.fence.max_y_m,
                -course.fence.min_y_m);
  return text;
}

std::string today() {
  const std::time_t now = std::time(nullptr);
  std::tm day{};
  ::gmtime_r(&now, &day);
  std::array<char, 16> text{};
  std::strftime(text.data(), text.size(), "%Y-%m-%d", &day);
  return text.data();
}

/// What the drives are identified against.
struct Assumed {
  course::TextFile robot;
  config::Configuration configuration;
};

/// As given; else as the recordings have it, so that nobody has to remember what they were made
/// with.
class Base {
 public:
  explicit Base(const IdentifyOptions& options)
      : given_(options.drive || !options.robot.empty() || !options.config.empty()) {
    if (!options.config.empty()) {
      const course::TextFile file = course::read_text_file(options.config);
      assumed_.configuration = config::parse_configuration(file.text, file.path);
    }
    assumed_.robot =
        course::read_bundled(course::Bundled::kRobots,
                             options.robot.empty() ? assumed_.configuration.robot : options.robot);
  }

  /// Throws SetupError: two recordings have different robots.
  void take(const record::Recording& recording) {
    if (given_) return;
    const config::RunFiles files = recorded_files(recording);
    if (first_.empty()) {
      first_ = recording.path();
      assumed_ = {files.robot,
                  config::parse_configuration(files.configuration.text, files.configuration.path)};
    } else if (files.robot.text != assumed_.robot.text) {
      throw SetupError(recording.path() + ": was recorded with another robot file than " + first_ +
                       "; leave one of them out, or name the robot with --robot");
    }
  }
  const Assumed& assumed() const { return assumed_; }

 private:
  bool given_;
  std::string first_;  // the recording that it comes from
  Assumed assumed_;
};

/// The name of the run's folder, or of a file of another name.
std::string run_name(const std::string& path) {
  const std::filesystem::path file =
      std::filesystem::absolute(record::recording_file(path)).lexically_normal();
  return file.stem() == "run" ? file.parent_path().filename() : file.stem();
}

std::vector<identify::RecordedDrive> recorded(const IdentifyOptions& options, Base& base) {
  std::vector<identify::RecordedDrive> drives;
  for (const std::string& path : options.runs) {
    if (record::is_recording(path)) {
      const record::Recording recording(path);
      base.take(recording);
      drives.push_back(identify::recorded_drive(recording));
      drives.back().name = run_name(path);
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

GuidedDrives driven(const IdentifyOptions& options, const course::Robot& robot) {
  if (!options.runs.empty() || !options.measured.empty())
    throw SetupError("identify: --drive makes its own runs; leave out RUN and --measured");
  GuidedOptions guided = options.guided;
  guided.run.config = options.config;
  guided.run.robot = options.robot;
  if (guided.folder.empty())
    guided.folder = std::filesystem::path(options.out).replace_extension().string() + "-runs";
  GuidedDrives result = drive_guided(guided, robot);
  std::printf("%s in %s\n", text::counted(result.drives.size(), "recording").c_str(),
              guided.folder.c_str());
  if (!result.completed)
    std::printf("not completed: nothing is identified; what there is can be given as RUN\n");
  return result;
}

}  // namespace

GuidedDrives drive_guided(const GuidedOptions& options, const course::Robot& robot) {
  std::error_code error;
  std::filesystem::create_directories(options.folder, error);
  if (error)
    throw SetupError(options.folder + ": cannot create the folder (" + error.message() +
                     "); give another --runs-dir");
  const std::vector<std::string> courses =
      options.courses.empty() ? identify::calibration_courses(robot.shape) : options.courses;
  const std::size_t all = courses.size() * static_cast<std::size_t>(options.repeats);
  GuidedDrives result;
  for (const std::string& name : courses) {
    const course::TextFile file = course::read_bundled(course::Bundled::kCourses, name);
    const course::Course course = course::parse_course(file.text, file.path);
    for (int repeat = 1; repeat <= options.repeats; ++repeat) {
      std::printf("drive %zu of %zu: %s; it needs %s of its start\n", result.drives.size() + 1, all,
                  course.name.c_str(), space_for(course).c_str());
      std::fflush(stdout);
      identify::DriveSink sink;
      RunOptions run = options.run;
      run.course = name;
      run.ran_before = !result.drives.empty();
      run.sinks.push_back(&sink);
      if (run_run(run) != 0) return result;
      identify::RecordedDrive drive = sink.drive();
      // In the order of the folder's listing, which numbers the runs for hand measurements.
      const std::size_t number = result.drives.size() + 1;
      drive.name = (number < 10 ? "0" : "") + std::to_string(number) + "-" + course.name;
      if (drive.camera.empty()) ask_for(drive.measured);
      text::write_file(options.folder + "/" + drive.name + "-samples.csv",
                       identify::write_drive(drive));
      result.drives.push_back(std::move(drive));
      const std::string measured = identify::write_measured(result.drives);
      if (!measured.empty()) text::write_file(options.folder + "/measured.csv", measured);
    }
  }
  result.completed = true;
  return result;
}

int run_identify(const IdentifyOptions& options) {
  if (options.background) become_background();
  if (!options.drive && options.runs.empty())
    throw SetupError("identify: give recordings (RUN...), or --drive to make them");
  Base assumed(options);
  std::vector<identify::RecordedDrive> drives;
  if (options.drive) {
    const course::TextFile& file = assumed.assumed().robot;
    GuidedDrives guided = driven(options, course::parse_robot(file.text, file.path));
    if (!guided.completed) return 1;
    drives = std::move(guided.drives);
  } else {
    drives = recorded(options, assumed);
  }
  const auto& [base_file, configuration] = assumed.assumed();
  const course::Robot base = course::parse_robot(base_file.text, base_file.path);

  const identify::Prior prior =
      identify::prior_of(base, configuration.parameters.model.turning_threshold_radps);
  const identify::Identification found = identify::identify(drives, prior);
  const std::string date = options.date.empty() ? today() : options.date;
  const course::Robot robot = identify::identified_robot(found, base, date);
  const std::string note =
      identify::identified_note(found, course::head_note(base_file.text), date);
  const std::string text = course::write_robot(robot, note);
  // Rejects impossible values here, by name and range.
  course::parse_robot(text, options.out);
  if (options.json) {
    std::printf("%s\n", identify::identify_json(found, base, robot).c_str());
  } else {
    std::printf("%s", identify::identify_report(found, base).c_str());
  }
  text::write_file(options.out, text);
  if (!options.json) std::printf("written to %s\n", options.out.c_str());
  return 0;
}

}  // namespace tp100::app
