#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdio>
#include <span>
#include <string_view>
#include <vector>

#include "app/commands.h"
#include "config/configuration.h"
#include "config/run_setup.h"
#include "config/setup_files.h"
#include "course/bundled_files.h"
#include "course/camera.h"
#include "course/course.h"
#include "course/path.h"
#include "course/robot_file.h"
#include "live/services.h"
#include "terrain/climbable.h"
#include "terrain/world.h"
#include "text/command_line.h"
#include "text/format.h"
#include "text/toml_document.h"

namespace tp100::app {
namespace {

struct Words {
  FileKind kind;
  std::vector<std::string_view> words;  ///< keys of its top level
};

const std::array<Words, 6> kWords = {{
    {FileKind::kConfiguration,
     {"robot", "course", "setup", "link", "loop", "estimation", "camera", "control"}},
    {FileKind::kCourse,
     {"speed_mps", "start", "segment", "disturbance", "surface", "fence", "keep_out"}},
    {FileKind::kRobot, {"shape", "drive", "emulated"}},
    {FileKind::kCamera,
     {"rate_hz", "delay_ms", "noise_m", "noise_deg", "bias_m", "dropped", "outliers", "height_m",
      "marker_size_m"}},
    {FileKind::kView, {"lens", "marker", "floor_marker", "floor_point"}},
    {FileKind::kCampaign,
     {"runs", "seed", "config", "board", "faults", "configuration", "robot_values"}},
}};

std::string text_of(const course::Course& course) {
  const course::Path path(course);
  std::string text = "course " + course.name + ": " + text::number_text(path.length_m()) +
                     " m in " + std::to_string(path.segments().size()) + " segments at " +
                     text::number_text(course.speed_mps) + " m/s, " +
                     std::to_string(course.disturbances.size()) + " disturbances";
  const std::vector<terrain::Outline> all = terrain::outlines_of(course.terrain);
  // All but kNone, the first.
  for (const auto& [kind, name] : std::span(kObstacleClassNames).subspan(1))
    text += ", " + std::to_string(std::ranges::count(all, kind, &terrain::Outline::obstacle)) +
            " " + name + "s";
  return text;
}

std::string text_of(const course::Robot& robot) {
  return "robot " + robot.name + ": wheelbase " + text::number_text(robot.model.wheelbase_m) +
         " m, slip " + text::number_text(robot.model.slip_left) + " / " +
         text::number_text(robot.model.slip_right);
}

std::string text_of(const course::EmulatedCamera& camera, const std::string& path) {
  return "camera " + course::file_stem(path) + ": " + text::number_text(camera.rate_hz) +
         " images/s, " + text::number_text(camera.delay_s * 1e3) + " ms late";
}

std::string check_configuration(const course::TextFile& file) {
  const config::RunFiles files = config::named_files(file);
  const course::Robot robot = course::parse_robot(files.robot.text, files.robot.path);
  std::string text = "configuration with " + text_of(robot);
  if (!files.course.path.empty()) {
    const course::Course course = course::parse_course(files.course.text, files.course.path);
    terrain::require_climbable(course, robot);
    text += ", " + text_of(course);
  }
  for (const std::string& note : config::hidden_files(files)) text += "; " + note;
  return text;
}

/// Prints what the service file_check answers, of a daemon with the default robot.
void describe_course(const std::string& path) {
  config::LoadedRun run;
  run.files.robot = course::read_bundled(course::Bundled::kRobots, config::Configuration{}.robot);
  run.setup = config::parse_run(run.files);
  const live::CheckedFile checked =
      live::checked_file(run, course::Bundled::kCourses, course::read_text_file(path));
  std::puts(checked.json.c_str());
  if (!checked.error.empty()) throw UserError(checked.error);
}

}  // namespace

FileKind file_kind(const std::string& text, const std::string& file) {
  const text::TomlDocument document(text, file);
  text::TomlTable root = document.root();
  std::vector<std::string_view> all;
  for (const auto& [kind, words] : kWords) all.insert(all.end(), words.begin(), words.end());
  // Each key, even misspelled, votes for the kind of file that has it.
  std::array<int, kWords.size()> votes{};
  for (const std::string& key : root.keys()) {
    const std::string_view word = text::nearest_name(key, all);
    for (const auto& [kind, words] : kWords)
      votes[static_cast<std::size_t>(kind)] += static_cast<int>(std::ranges::count(words, word));
  }
  // The one key that every campaign needs outweighs the many that it shares with a configuration.
  if (root.has("runs")) votes[static_cast<std::size_t>(FileKind::kCampaign)] += 4;
  // Two kinds of files have a table [model].
  if (root.has("model")) {
    const text::TomlTable model = root.table("model");
    const bool configures = model.has("mode") || model.has("turning_threshold_radps");
    ++votes[static_cast<std::size_t>(configures ? FileKind::kConfiguration : FileKind::kRobot)];
  }
  return static_cast<FileKind>(std::ranges::max_element(votes) - votes.begin());
}

std::string check_file(const std::string& path) {
  const course::TextFile file = course::read_text_file(path);
  switch (file_kind(file.text, file.path)) {
    case FileKind::kCourse:
      return text_of(course::parse_course(file.text, file.path));
    case FileKind::kRobot:
      return text_of(course::parse_robot(file.text, file.path));
    case FileKind::kCamera:
      return text_of(course::parse_camera(file.text, file.path), path);
    case FileKind::kView:
      throw UserError(path +
                      ": a view file of tp100-camera, which checks it itself; run tp100-camera "
                      "SOURCE --view " +
                      path);
    case FileKind::kCampaign:
      throw UserError(path +
                      ": a campaign of tp100-sim, which checks it itself; run tp100-sim campaign " +
                      path + " --out FOLDER --todo 1");
    case FileKind::kConfiguration:
      break;
  }
  return check_configuration(file);
}

int run_check(const std::vector<std::string>& files, bool json) {
  int status = 0;
  for (const std::string& path : files) {
    try {
      if (json) {
        describe_course(path);
        continue;
      }
      const std::string found = check_file(path);
      std::printf("%s: OK, %s\n", path.c_str(), found.c_str());
    } catch (const UserError& error) {
      std::fprintf(stderr, "%s\n", error.what());
      status = 2;
    }
  }
  return status;
}

void add_check(CLI::App& app, Action& action) {
  static std::vector<std::string> files;
  static bool json = false;
  CLI::App* command = app.add_subcommand("check", "Check configuration, course and robot files");
  text::option(command, "FILE", files, "FILE", "Files of any of these kinds")->required();
  command->add_flag("--json", json, "Course files only: also where path, ground and fence lie");
  command->footer("Example: tp100d check config/tp100.toml config/courses/2.toml");
  command->callback([&action] { action = [] { return run_check(files, json); }; });
}

}  // namespace tp100::app
