#pragma once
// Text files by path, and the courses and robots that come with the project by name. Set-up only.

#include <string>
#include <vector>

#include "core/error.h"

namespace tp100::course {

/// A file that was read whole.
struct TextFile {
  std::string path;  ///< as it should be named in messages
  std::string text;
};

/// Folders of config/.
enum class Bundled { kCourses, kRobots, kCameras };

/// Reads a whole file of at most 64 MiB as UTF-8 (text::as_utf8). Throws UserError naming the file
/// and why it cannot be read.
TextFile read_text_file(const std::string& path);

/// Folder of the bundled configuration: <prefix>/share/tp100 of an installed program, else config/
/// of the source tree it was built from.
std::string config_directory();

/// Names (file stems) in a folder of the bundled configuration, sorted.
std::vector<std::string> bundled_names(Bundled folder);

/// Reads `name_or_path`: an existing file, or else the bundled file of that name (with or without
/// .toml). Throws UserError that lists the bundled names.
TextFile read_bundled(Bundled folder, const std::string& name_or_path);

/// File name without folder and extension: the name of a course or robot.
std::string file_stem(const std::string& path);

}  // namespace tp100::course
