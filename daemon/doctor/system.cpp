#include "doctor/system.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <fstream>
#include <sstream>
#include <system_error>

namespace tp100::doctor {

namespace fs = std::filesystem;

namespace {

fs::path canonical_or_same(const fs::path& path) {
  std::error_code error;
  fs::path found = fs::canonical(path, error);
  return error ? path : found;
}

}  // namespace

System::System(const fs::path& root) : root_(canonical_or_same(root)) {}

fs::path System::file(const std::string& path) const {
  return root_ / fs::path(path).relative_path();
}

bool System::exists(const std::string& path) const {
  std::error_code error;
  return fs::exists(file(path), error);
}

std::optional<std::string> System::text(const std::string& path) const {
  std::ifstream in(file(path), std::ios::binary);
  if (!in) return std::nullopt;
  std::ostringstream all;
  all << in.rdbuf();
  std::string text = all.str();
  // Nothing was read, not even white space: a folder, or an attribute that refuses to be read.
  if (text.empty() && !in) return std::nullopt;
  text.erase(text.find_last_not_of(" \t\r\n") + 1);
  return text;
}

std::vector<std::string> System::names(const std::string& folder) const {
  std::vector<std::string> names;
  std::error_code error;
  for (fs::directory_iterator at(file(folder), error), end; !error && at != end;
       at.increment(error))
    names.push_back(at->path().filename());
  std::sort(names.begin(), names.end());
  return names;
}

std::string System::real(const std::string& path) const {
  std::error_code error;
  const fs::path found = fs::canonical(file(path), error);
  if (error) return {};
  const fs::path below = found.lexically_relative(root_);
  return (below.empty() || *below.begin() == "..") ? found.string() : "/" + below.string();
}

std::optional<DeviceFile> System::device(const std::string& path) const {
  struct stat status {};
  if (::stat(file(path).c_str(), &status) != 0) return std::nullopt;
  return DeviceFile{status.st_mode, status.st_uid, status.st_gid, status.st_rdev};
}

bool System::usable(const std::string& path) const {
  return ::faccessat(AT_FDCWD, file(path).c_str(), R_OK | W_OK, AT_EACCESS) == 0;
}

std::vector<std::string> lines(const std::string& text) { return split(text, '\n'); }

std::vector<std::string> split(const std::string& line, char separator) {
  std::vector<std::string> parts;
  std::istringstream in(line);
  std::string part;
  while (std::getline(in, part, separator)) parts.push_back(part);
  return parts;
}

}  // namespace tp100::doctor
