#include <array>
#include <cstddef>
#include <cstdio>
#include <utility>

#include "app/commands.h"
#include "config/configuration.h"
#include "course/bundled_files.h"
#include "course/camera.h"
#include "course/course.h"
#include "course/path.h"
#include "course/robot_file.h"
#include "terrain/climbable.h"
#include "text/format.h"
#include "text/toml_document.h"

namespace tp100::app {
namespace {

using Word = std::pair<std::string_view, FileKind>;

constexpr std::array<Word, 40> kWords = {{
    {"robot", FileKind::kConfiguration},
    {"course", FileKind::kConfiguration},
    {"setup", FileKind::kConfiguration},
    {"link", FileKind::kConfiguration},
    {"loop", FileKind::kConfiguration},
    {"estimation", FileKind::kConfiguration},
    {"camera", FileKind::kConfiguration},
    {"control", FileKind::kConfiguration},
    {"speed_mps", FileKind::kCourse},
    {"start", FileKind::kCourse},
    {"segment", FileKind::kCourse},
    {"disturbance", FileKind::kCourse},
    {"ramp", FileKind::kCourse},
    {"block", FileKind::kCourse},
    {"surface", FileKind::kCourse},
    {"fence", FileKind::kCourse},
    {"keep_out", FileKind::kCourse},
    {"shape", FileKind::kRobot},
    {"drive", FileKind::kRobot},
    {"emulated", FileKind::kRobot},
    {"rate_hz", FileKind::kCamera},
    {"delay_ms", FileKind::kCamera},
    {"noise_m", FileKind::kCamera},
    {"noise_deg", FileKind::kCamera},
    {"bias_m", FileKind::kCamera},
    {"dropped", FileKind::kCamera},
    {"outliers", FileKind::kCamera},
    {"height_m", FileKind::kCamera},
    {"marker_size_m", FileKind::kCamera},
    {"lens", FileKind::kView},
    {"marker", FileKind::kView},
    {"floor_marker", FileKind::kView},
    {"floor_point", FileKind::kView},
    {"runs", FileKind::kCampaign},
    {"seed", FileKind::kCampaign},
    {"config", FileKind::kCampaign},
    {"board", FileKind::kCampaign},
    {"faults", FileKind::kCampaign},
    {"configuration", FileKind::kCampaign},
    {"robot_values", FileKind::kCampaign},
}};

std::string text_of(const course::Course& course) {
  const course::Path path(course);
  return "course " + course.name + ": " + text::number_text(path.length_m()) + " m in " +
         std::to_string(path.segments().size()) + " segments at " +
         text::number_text(course.speed_mps) + " m/s, " +
         std::to_string(course.disturbances.size()) + " disturbances, " +
         std::to_string(course.terrain.ramps.size()) + " ramps, " +
         std::to_string(course.terrain.blocks.size()) + " blocks";
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
  const config::Configuration configuration = config::parse_configuration(file.text, file.path);
  const course::TextFile robot_file =
      course::read_bundled(course::Bundled::kRobots, configuration.robot);
  const course::Robot robot = course::parse_robot(robot_file.text, robot_file.path);
  std::string text = "configuration with " + text_of(robot);
  if (configuration.course.empty()) return text;
  const course::TextFile course_file =
      course::read_bundled(course::Bundled::kCourses, configuration.course);
  const course::Course course = course::parse_course(course_file.text, course_file.path);
  terrain::require_climbable(course, robot);
  return text + ", " + text_of(course);
}

}  // namespace

FileKind file_kind(const std::string& text, const std::string& file) {
  const text::TomlDocument document(text, file);
  text::TomlTable root = document.root();
  std::vector<std::string_view> words;
  words.reserve(kWords.size());
  for (const Word& word : kWords) words.push_back(word.first);
  // Each key, even misspelled, votes for the kind of file that has it.
  std::array<int, 6> votes{};
  for (const std::string& key : root.keys()) {
    const std::string_view word = text::nearest_name(key, words);
    for (const auto& [name, kind] : kWords)
      if (name == word) ++votes[static_cast<std::size_t>(kind)];
  }
  // The one key that every campaign needs outweighs the many that it shares with a configuration.
  if (root.has("runs")) votes[static_cast<std::size_t>(FileKind::kCampaign)] += 4;
  // Two kinds of files have a table [model].
  if (root.has("model")) {
    const text::TomlTable model = root.table("model");
    const bool configures = model.has("mode") || model.has("turning_threshold_radps");
    ++votes[static_cast<std::size_t>(configures ? FileKind::kConfiguration : FileKind::kRobot)];
  }
  FileKind best = FileKind::kConfiguration;
  for (const FileKind kind : {FileKind::kCourse, FileKind::kRobot, FileKind::kCamera,
                              FileKind::kView, FileKind::kCampaign})
    if (votes[static_cast<std::size_t>(kind)] > votes[static_cast<std::size_t>(best)]) best = kind;
  return best;
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
      throw SetupError(path +
                       ": a view file of tp100-camera, which checks it itself; run tp100-camera "
                       "SOURCE --view " +
                       path);
    case FileKind::kCampaign:
      throw SetupError(
          path + ": a campaign of tp100-sim, which checks it itself; run tp100-sim campaign " +
          path + " --out FOLDER --todo 1");
    case FileKind::kConfiguration:
      break;
  }
  return check_configuration(file);
}

int run_check(const std::vector<std::string>& files) {
  int status = 0;
  for (const std::string& path : files) {
    try {
      const std::string found = check_file(path);
      std::printf("%s: OK, %s\n", path.c_str(), found.c_str());
    } catch (const SetupError& error) {
      std::fprintf(stderr, "%s\n", error.what());
      status = 2;
    }
  }
  return status;
}

}  // namespace tp100::app
