#pragma once
// A terminal of a container: another terminal than this machine's, under the same name.

#include <fcntl.h>
#include <sched.h>
#include <sys/mount.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <cstdlib>
#include <string>

namespace tp100::test {

/// A process that holds the terminal `path` (/dev/pts/N) of its own namespace open, until the end
/// of the lifetime. Only root can make one.
class ContainerTerminal {
 public:
  explicit ContainerTerminal(const std::string& path) {
    int ready[2];
    if (::pipe(ready) != 0) return;
    child_ = ::fork();
    if (child_ == 0) {
      ::prctl(PR_SET_PDEATHSIG, SIGKILL);
      if (hold(path) && ::write(ready[1], "x", 1) == 1) ::pause();
      ::_exit(1);
    }
    ::close(ready[1]);
    char byte = 0;
    is_held_ = ::read(ready[0], &byte, 1) == 1;
    ::close(ready[0]);
  }
  ~ContainerTerminal() {
    if (child_ <= 0) return;
    ::kill(child_, SIGKILL);
    ::waitpid(child_, nullptr, 0);
  }
  ContainerTerminal(const ContainerTerminal&) = delete;
  ContainerTerminal& operator=(const ContainerTerminal&) = delete;

  bool is_held() const { return is_held_; }

 private:
  static bool hold(const std::string& path) {
    // Inherited descriptors are the terminals of this machine.
    for (int fd = 3; fd < 1024; ++fd)
      if (::fcntl(fd, F_GETFD) >= 0 && ::isatty(fd) != 0) ::close(fd);
    // Private, so that the mount does not reach this machine; "/" is no mount in a chroot.
    if (::unshare(CLONE_NEWNS) != 0 ||
        ::mount(nullptr, "/dev/pts", nullptr, MS_PRIVATE, nullptr) != 0 ||
        ::mount("devpts", "/dev/pts", "devpts", 0, "newinstance,ptmxmode=0666") != 0)
      return false;
    // They are numbered from 0.
    for (;;) {
      const int controller = ::posix_openpt(O_RDWR | O_NOCTTY);
      if (controller < 0 || ::grantpt(controller) != 0 || ::unlockpt(controller) != 0) return false;
      if (::ptsname(controller) == path) return ::open(path.c_str(), O_RDWR | O_NOCTTY) >= 0;
    }
  }

  pid_t child_ = -1;
  bool is_held_ = false;
};

}  // namespace tp100::test
