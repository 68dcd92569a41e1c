#pragma once
// A separate file system that a test can freeze, so that every writer to it waits. It needs root
// and a loop device.

#include <fcntl.h>
#include <linux/fs.h>
#include <sys/ioctl.h>
#include <sys/mount.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <string>

#include "temporary_folder.h"

namespace tp100::test {

class FrozenDisk {
 public:
  FrozenDisk() {
    const std::string image = folder_.file("image");
    std::filesystem::create_directory(path());
    const std::string command = "truncate -s 64M " + image + " && mkfs.ext4 -q -N 16384 " + image +
                                " && mount -o loop " + image + " " + path();
    if (::geteuid() != 0 || std::system(("{ " + command + "; } >/dev/null 2>&1").c_str()) != 0)
      return;
    root_ = ::open(path().c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    available_ = freeze() && thaw();
  }
  ~FrozenDisk() {
    if (root_ < 0) return;
    thaw();
    ::close(root_);
    ::umount2(path().c_str(), MNT_DETACH);
  }
  FrozenDisk(const FrozenDisk&) = delete;
  FrozenDisk& operator=(const FrozenDisk&) = delete;

  /// False if no file system can be frozen on this machine.
  bool available() const { return available_; }
  std::string path() const { return folder_.file("disk"); }

  bool freeze() { return ::ioctl(root_, FIFREEZE, 0) == 0; }
  bool thaw() { return ::ioctl(root_, FITHAW, 0) == 0; }

 private:
  TemporaryFolder folder_;
  int root_ = -1;
  bool available_ = false;
};

}  // namespace tp100::test
