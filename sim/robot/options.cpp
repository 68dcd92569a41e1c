#include "sim/robot/options.h"

#include <limits>

#include "core/enum_names.h"
#include "core/error.h"
#include "course/bundled_files.h"

namespace tp100::sim {
namespace {

BoardKind board_kind(const std::string& name) {
  if (const auto kind = value_in(kBoardKindNames, name)) return *kind;
  throw UserError("--board " + one_line(name) + ": not a board; use native or avr");
}

/// Changes by the options to the robot's file. --body and --floor are values of the file, so that
/// recordings have them, too.
text::NamedValues robot_values(const Options& options) {
  text::NamedValues values = options.robot_values;
  if (!options.body.empty()) {
    if (!value_in(course::kContactLawNames, options.body))
      throw UserError("--body " + one_line(options.body) + ": not a body; use ode or shear");
    values.emplace_back("emulated.contact_law", options.body);
  }
  if (!options.floor.empty()) {
    if (!value_in(course::kFloorNames, options.floor))
      throw UserError("--floor " + one_line(options.floor) + ": not a floor; use even or uneven");
    values.emplace_back("emulated.floor", options.floor);
  }
  return values;
}

// The path is marked, because errors in the changed text do not refer to lines of the file.
void change(course::TextFile& file, const text::NamedValues& values) {
  if (values.empty()) return;
  file.text = text::with_values(file.text, file.path, values);
  file.path += (file.path.empty() ? "defaults" : "") + std::string(" with other values");
}

}  // namespace

std::string why_no_seed(const std::string& text) {
  const std::string most = std::to_string(std::numeric_limits<std::uint64_t>::max());
  const bool digits = text.find_first_not_of("0123456789") == std::string::npos;
  const bool fits = text.size() < most.size() || (text.size() == most.size() && text <= most);
  if (!text.empty() && digits && fits) return {};
  return "Value " + text + " not in range 0 to " + most;
}

Loaded load(const Options& options) {
  Loaded loaded;
  loaded.board = board_kind(options.board);
  course::TextFile& configuration = loaded.files.configuration;
  if (!options.config.empty()) configuration = course::read_text_file(options.config);
  change(configuration, options.configuration_values);
  if (!configuration.text.empty())
    loaded.configuration = config::parse_configuration(configuration.text, configuration.path);
  const std::string& robot = options.robot.empty() ? loaded.configuration.robot : options.robot;
  loaded.files.robot = course::read_bundled(course::Bundled::kRobots, robot);
  change(loaded.files.robot, robot_values(options));
  loaded.robot = course::parse_robot(loaded.files.robot.text, loaded.files.robot.path);
  loaded.setup = config::setup_option(options.setup, loaded.configuration.parameters.setup);
  loaded.files.setup = loaded.setup;
  return loaded;
}

course::EmulatedCamera load_camera(const std::string& name_or_path) {
  const course::TextFile file = course::read_bundled(course::Bundled::kCameras, name_or_path);
  return course::parse_camera(file.text, file.path);
}

course::Course load_course(const std::string& name_or_path) {
  const course::TextFile file = course::read_bundled(course::Bundled::kCourses, name_or_path);
  return course::parse_course(file.text, file.path);
}

}  // namespace tp100::sim
