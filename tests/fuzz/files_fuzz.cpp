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

template <class Parse, class Write>
void comes_back(const std::string& text, Parse parse, Write write) {
  const std::string written = write(parse(text, "fuzz"));
  require(write(parse(written, "fuzz")) == written, "a file comes back as it was");
}

void read_configuration(const std::string& text) {
  comes_back(text, config::parse_configuration, config::write_configuration);
}

void read_robot(const std::string& text) {
  comes_back(text, course::parse_robot, [](const auto& read) { return write_robot(read, ""); });
}

void read_camera(const std::string& text) {
  comes_back(text, course::parse_camera, [](const auto& read) { return write_camera(read, ""); });
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
    } catch (const tp100::UserError& error) {
      tp100::fuzz::require_message(error.what());
    }
  }
  return 0;
}
