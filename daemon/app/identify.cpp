#include "app/identify.h"

#include <array>
#include <cstdio>
#include <ctime>
#include <filesystem>
#include <utility>

#include "config/configuration.h"
#include "core/error.h"
#include "course/bundled_files.h"
#include "identify/drive_file.h"
#include "identify/drive_sink.h"
#include "identify/identify.h"
#include "identify/identify_report.h"
#include "text/atomic_file.h"

namespace tp100::app {
namespace {

std::string today() {
  const std::time_t now = std::time(nullptr);
  std::tm day{};
  ::gmtime_r(&now, &day);
  std::array<char, 16> text{};
  std::strftime(text.data(), text.size(), "%Y-%m-%d", &day);
  return text.data();
}

std::vector<identify::Drive> recorded(const IdentifyOptions& options) {
  std::vector<identify::Drive> drives;
  for (const std::string& path : options.runs) {
    if (record::is_recording(path)) {
      drives.push_back(identify::recorded_drive(record::Recording(path)));
      drives.back().name = path;
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
  std::printf("%zu recordings in %s\n", result.drives.size(), guided.folder.c_str());
  if (!result.completed)
    std::printf("not completed: nothing is identified; what there is can be given as RUN\n");
  return result;
}

}  // namespace

int run_identify(const IdentifyOptions& options) {
  config::Configuration configuration;
  if (!options.config.empty()) {
    const course::TextFile file = course::read_text_file(options.config);
    configuration = config::parse_configuration(file.text, file.path);
  }
  const course::TextFile base_file = course::read_bundled(
      course::Bundled::kRobots, options.robot.empty() ? configuration.robot : options.robot);
  const course::Robot base = course::parse_robot(base_file.text, base_file.path);

  if (!options.drive && options.runs.empty())
    throw SetupError("identify: give recordings (RUN...), or --drive to make them");
  std::vector<identify::Drive> drives;
  if (options.drive) {
    GuidedDrives guided = driven(options, base);
    if (!guided.completed) return 1;
    drives = std::move(guided.drives);
  } else {
    drives = recorded(options);
  }

  const identify::Belief belief =
      identify::belief_of(base, configuration.parameters.model.turning_threshold_radps);
  const identify::Identification found = identify::identify(drives, belief);
  const std::string date = options.date.empty() ? today() : options.date;
  const course::Robot robot = identify::identified_robot(found, base, date);
  const std::string note =
      identify::identified_note(found, course::head_note(base_file.text), date);
  const std::string text = course::write_robot(robot, note);
  // What no robot has is refused here, by name and range.
  course::parse_robot(text, options.out);
  std::printf("%s", identify::identify_report(found, base).c_str());
  text::write_file(options.out, text);
  std::printf("written to %s\n", options.out.c_str());
  return 0;
}

}  // namespace tp100::app
