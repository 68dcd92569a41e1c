#pragma once
// `tp100d check`: is this file right?

#include <string>
#include <vector>

namespace tp100::app {

/// Kinds of files that a user writes.
enum class FileKind { kConfiguration, kCourse, kRobot, kCamera, kView, kCampaign };

/// What a file means to be, by its keys. Throws SetupError if the text is not TOML. Pure.
FileKind file_kind(const std::string& text, const std::string& file);

/// One line that says what is in a right file. Throws SetupError for any other, and for view
/// files and campaigns, which only tp100-camera and tp100-sim know. The robot and the course that a
/// configuration names are checked too.
std::string check_file(const std::string& path);

/// The command: one line per file, errors on stderr. Exit status 0 if all are right, else 2.
int run_check(const std::vector<std::string>& files);

}  // namespace tp100::app
