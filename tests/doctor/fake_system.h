#pragma once
// A folder that imitates the root of a Linux system with a robot attached.

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <filesystem>
#include <string>

#include "../support/temporary_folder.h"
#include "doctor/finding.h"
#include "doctor/system.h"
#include "link/port_discovery.h"

namespace tp100::test {

inline constexpr const char* kDevice = "/dev/ttyACM0";

class FakeSystem {
 public:
  doctor::System system() const { return doctor::System(folder_.path()); }

  void write(const std::string& path, const std::string& text) {
    make_folder(path);
    write_bytes(folder_.file(path.substr(1)), text);
  }
  /// Creates a link with the text `target`, relative or absolute.
  void link(const std::string& path, const std::string& target) {
    make_folder(path);
    std::filesystem::create_symlink(target, folder_.file(path.substr(1)));
  }
  void mode(const std::string& path, mode_t mode) {
    ::chmod(folder_.file(path.substr(1)).c_str(), mode);
  }
  void process(const std::string& pid, const std::string& name) {
    write("/proc/" + pid + "/comm", name + "\n");
  }
  void opens(const std::string& pid, const std::string& what) {
    link("/proc/" + pid + "/fd/7", what);
  }
  /// A Mega at /dev/ttyACM0, wired through a USB device folder in /sys.
  void plug_in_mega() {
    write("/dev/ttyACM0", "");
    write(kUsb + "/idVendor", "2341\n");
    write(kUsb + "/dev", "189:3\n");
    write(kUsb + "/1-1:1.0/tty/ttyACM0/dev", "166:0\n");
    link("/sys/class/tty/ttyACM0", "../../devices/usb1/1-1/1-1:1.0/tty/ttyACM0");
  }
  static link::PortInfo mega(const std::string& path = "/dev/ttyACM0") {
    return {path, 0x2341, 0x0042, "7583", "Mega"};
  }

  static inline const std::string kUsb = "/sys/devices/usb1/1-1";

 private:
  void make_folder(const std::string& path) {
    std::filesystem::create_directories(
        std::filesystem::path(folder_.file(path.substr(1))).parent_path());
  }
  TemporaryFolder folder_;
};

/// The first finding with that name; one named "none" if there is none.
inline doctor::Finding find(const doctor::Findings& findings, const std::string& name) {
  for (const doctor::Finding& finding : findings) {
    if (finding.name == name) return finding;
  }
  return {doctor::Severity::kOk, "none", "", ""};
}

/// Expects the finding with that name, whose texts contain `seen` and `fix`.
inline void expect_finding(const doctor::Findings& findings, const std::string& name,
                           doctor::Severity severity, const std::string& seen = "",
                           const std::string& fix = "") {
  SCOPED_TRACE("finding " + name);
  const doctor::Finding found = find(findings, name);
  EXPECT_EQ(found.name, name);
  EXPECT_EQ(found.severity, severity);
  EXPECT_THAT(found.seen, ::testing::HasSubstr(seen));
  EXPECT_THAT(found.fix, ::testing::HasSubstr(fix));
}

}  // namespace tp100::test
