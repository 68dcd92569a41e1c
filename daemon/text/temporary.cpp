#include "text/temporary.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <string_view>
#include <system_error>

namespace tp100::text {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view kBegin = ".tp100-", kPattern = ".tp100-XXXXXX";

bool is_temporary(std::string_view name) {
  return name.size() == kPattern.size() && name.starts_with(kBegin) &&
         std::all_of(name.begin() + kBegin.size(), name.end(), [](unsigned char c) {
           return (c >= '0' && c <= '9') || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
         });
}

std::string pattern_in(const std::string& folder) { return (fs::path(folder) / kPattern).string(); }

/// False: another program has swept it before it was locked.
bool locked(int descriptor) {
  ::flock(descriptor, LOCK_SH);
  struct stat status {};
  return ::fstat(descriptor, &status) != 0 || status.st_nlink > 0;
}

}  // namespace

int make_temporary_file(const std::string& folder, std::string& path) {
  for (;;) {
    path = pattern_in(folder);
    const int descriptor = ::mkostemp(path.data(), O_CLOEXEC);
    if (descriptor < 0 || locked(descriptor)) return descriptor;
    ::close(descriptor);
  }
}

int make_temporary_folder(const std::string& folder, std::string& path) {
  for (;;) {
    path = pattern_in(folder);
    if (::mkdtemp(path.data()) == nullptr) return -1;
    const int descriptor = ::open(path.c_str(), O_RDONLY | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC);
    if (descriptor >= 0 && locked(descriptor)) return descriptor;
    if (descriptor >= 0) ::close(descriptor);
  }
}

void sweep_temporary(const std::string& folder) {
  std::error_code error;
  for (fs::directory_iterator at(folder.empty() ? "." : folder, error), end; !error && at != end;
       at.increment(error)) {
    const fs::path& path = at->path();
    if (!is_temporary(path.filename().native())) continue;
    const int descriptor = ::open(path.c_str(), O_RDONLY | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC);
    struct stat status {};
    if (descriptor >= 0 && ::fstat(descriptor, &status) == 0 && status.st_uid == ::geteuid() &&
        (S_ISREG(status.st_mode) || S_ISDIR(status.st_mode)) &&
        ::flock(descriptor, LOCK_EX | LOCK_NB) == 0) {
      std::error_code stays;
      fs::remove_all(path, stays);
    }
    if (descriptor >= 0) ::close(descriptor);
  }
}

}  // namespace tp100::text
