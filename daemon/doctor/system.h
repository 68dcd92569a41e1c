#pragma once
// Reads the files that describe a Linux system: /sys, /proc, /etc, /run/udev and /dev, below a root
// that a test may choose. Throws nothing; unreadable files count as missing.

#include <sys/types.h>

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace tp100::doctor {

/// Mode, owner and number of a device file.
struct DeviceFile {
  mode_t mode = 0;
  uid_t uid = 0;
  gid_t gid = 0;
  dev_t number = 0;
};

class System {
 public:
  explicit System(const std::filesystem::path& root = "/");

  /// Real location of `path` ("/sys/..."), for callers that open it themselves.
  std::filesystem::path file(const std::string& path) const;
  bool exists(const std::string& path) const;
  /// The whole text without trailing white space.
  std::optional<std::string> text(const std::string& path) const;
  /// The names in a folder, sorted.
  std::vector<std::string> names(const std::string& folder) const;
  /// `path` with all symbolic links followed, as seen from the root; empty if there is no such
  /// file.
  std::string real(const std::string& path) const;
  std::optional<DeviceFile> device(const std::string& path) const;
  /// Whether this process may read and write `path`: asks the kernel, which respects access lists.
  bool usable(const std::string& path) const;

 private:
  std::filesystem::path root_;
};

/// The lines of a text.
std::vector<std::string> lines(const std::string& text);
/// The parts of `line` between `separator`s, including empty ones.
std::vector<std::string> split(const std::string& line, char separator);

}  // namespace tp100::doctor
