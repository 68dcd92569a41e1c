#include "course/bundled_files.h"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <optional>
#include <system_error>
#include <utility>

#include "text/atomic_file.h"
#include "text/encoding.h"
#include "text/format.h"

namespace tp100::course {
namespace {

namespace fs = std::filesystem;

constexpr std::uintmax_t kLargestFile = 64U << 20U;

struct Name {
  const char* folder;
  const char* noun;
};

Name name_of(Bundled folder) {
  switch (folder) {
    case Bundled::kCourses:
      return {"courses", "course"};
    case Bundled::kRobots:
      return {"robots", "robot"};
    case Bundled::kCameras:
      break;
  }
  return {"cameras", "camera"};
}

const char* folder_name(Bundled folder) { return name_of(folder).folder; }
const char* noun(Bundled folder) { return name_of(folder).noun; }

bool is_file(const fs::path& path) {
  std::error_code error;
  return fs::exists(path, error) && !fs::is_directory(path, error);
}

/// <prefix>/share/tp100, if this program is an installed one.
std::optional<fs::path> installed_directory() {
  std::error_code error;
  const fs::path program = fs::read_symlink("/proc/self/exe", error);
  if (error) return std::nullopt;
  const fs::path installed = program.parent_path().parent_path() / "share" / "tp100";
  if (!fs::is_directory(installed / "courses", error)) return std::nullopt;
  return installed;
}

}  // namespace

TextFile read_text_file(const std::string& path) {
  std::error_code error;
  if (fs::is_directory(path, error)) {
    throw UserError(path + ": is a directory; give the path of a file");
  }
  errno = 0;
  std::ifstream file(path, std::ios::binary);
  if (!file) {
    throw UserError(path + ": cannot be opened (" + std::strerror(errno) + "); check the path");
  }
  text::note_read(path);
  TextFile result{path, {}};
  char block[1U << 14U];
  while (file.read(block, sizeof block) || file.gcount() > 0) {
    result.text.append(block, static_cast<std::size_t>(file.gcount()));
    if (result.text.size() > kLargestFile) {
      throw UserError(path + ": larger than 64 MiB; give a text file");
    }
  }
  if (file.bad()) {
    throw UserError(path + ": cannot be read (" + std::strerror(errno) + "); check the disk");
  }
  result.text = text::as_utf8(std::move(result.text));
  return result;
}

std::string config_directory() {
  return installed_directory().value_or(fs::path(TP100_SOURCE_DIR) / "config").string();
}

std::vector<std::string> bundled_names(Bundled folder) {
  std::vector<std::string> names;
  std::error_code error;
  for (fs::directory_iterator at(fs::path(config_directory()) / folder_name(folder), error), end;
       !error && at != end; at.increment(error)) {
    if (at->path().extension() == ".toml") names.push_back(at->path().stem().string());
  }
  std::sort(names.begin(), names.end());
  return names;
}

TextFile read_bundled(Bundled folder, const std::string& name_or_path) {
  if (is_file(name_or_path)) return read_text_file(name_or_path);
  if (name_or_path.find('/') != std::string::npos) return read_text_file(name_or_path);
  const std::vector<std::string> names = bundled_names(folder);
  const std::string stem = name_or_path.ends_with(".toml") ? file_stem(name_or_path) : name_or_path;
  if (std::find(names.begin(), names.end(), stem) != names.end()) {
    return read_text_file(
        (fs::path(config_directory()) / folder_name(folder) / (stem + ".toml")).string());
  }
  std::string message = name_or_path + ": no such " + noun(folder) +
                        text::suggestion(stem, {names.begin(), names.end()}) +
                        "; give a file or one of";
  for (const std::string& name : names) message += " " + name;
  throw UserError(message);
}

std::string file_stem(const std::string& path) { return fs::path(path).stem().string(); }

}  // namespace tp100::course
