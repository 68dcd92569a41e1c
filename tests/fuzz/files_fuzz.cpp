// Fuzzes the TOML files that users write: configuration, course, robot, emulated camera. A file is
// either refused in one line or has the same content when it is written and read again.

#include "byte_source.h"
#include "config/configuration.h"
#include "core/error.h"
#include "course/camera.h"
#include "course/course.h"
#include "course/path.h"
#include "course/robot_file.h"

namespace tp100 {
namespace {

using fuzz::require;

void read_configuration(const std::string& text) {
  const std::string written =
      config::write_configuration(config::parse_configuration(text, "fuzz"));
  require(config::write_configuration(config::parse_configuration(written, "fuzz")) == written,
          "a configuration comes back as it was");
}

void read_robot(const std::string& text) {
  const std::string written = course::write_robot(course::parse_robot(text, "fuzz"), "");
  require(course::write_robot(course::parse_robot(written, "fuzz"), "") == written,
          "a robot comes back as it was");
}

void read_camera(const std::string& text) {
  const std::string written = course::write_camera(course::parse_camera(text, "fuzz"), "");
  require(course::write_camera(course::parse_camera(written, "fuzz"), "") == written,
          "a camera comes back as it was");
}

void read_course(const std::string& text) {
  const course::Course read = course::parse_course(text, "fuzz");
  const course::Path path(read);
  require(path.length_m() >= 0.0 && path.length_m() < 1e6, "a path has a length");
}

}  // namespace
}  // namespace tp100

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size > 20000) return 0;
  const std::string text(reinterpret_cast<const char*>(data), size);
  for (const auto read :
       {tp100::read_configuration, tp100::read_robot, tp100::read_camera, tp100::read_course}) {
    try {
      read(text);
    } catch (const tp100::SetupError& error) {
      tp100::fuzz::require_message(error.what());
    }
  }
  return 0;
}
