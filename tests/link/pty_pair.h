#pragma once
// A pseudo-terminal: this class holds its far end; the program under test opens the near end by
// name.

#include <fcntl.h>
#include <poll.h>
#include <stdlib.h>
#include <termios.h>
#include <unistd.h>

#include <cstdint>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

namespace tp100 {

class PtyPair {
 public:
  PtyPair() { open(); }
  ~PtyPair() { close(); }
  PtyPair(const PtyPair&) = delete;
  PtyPair& operator=(const PtyPair&) = delete;

  /// Opens a new pair, as after unplugging and plugging in again.
  void open() {
    far_ = ::posix_openpt(O_RDWR | O_NOCTTY | O_NONBLOCK | O_CLOEXEC);
    char name[64];
    if (far_ < 0 || ::grantpt(far_) != 0 || ::unlockpt(far_) != 0 ||
        ::ptsname_r(far_, name, sizeof name) != 0) {
      throw std::runtime_error("no pty");
    }
    near_ = name;
    // The near end is kept open: otherwise the far end reports a hang-up between two clients.
    keeper_ = ::open(name, O_RDWR | O_NOCTTY | O_CLOEXEC);
    termios settings{};
    ::tcgetattr(keeper_, &settings);
    ::cfmakeraw(&settings);
    ::tcsetattr(keeper_, TCSANOW, &settings);
  }
  void close() {
    if (keeper_ >= 0) ::close(keeper_);
    if (far_ >= 0) ::close(far_);
    keeper_ = far_ = -1;
  }

  const std::string& near() const { return near_; }
  int far() const { return far_; }

  /// Returns false if the near end wrote nothing for `patience_ms`.
  bool wait(int patience_ms) const {
    pollfd far{far_, POLLIN, 0};
    return ::poll(&far, 1, patience_ms) > 0;
  }
  std::vector<std::uint8_t> read() const {
    std::uint8_t buffer[4096];
    const ssize_t n = ::read(far_, buffer, sizeof buffer);
    return {buffer, buffer + (n > 0 ? n : 0)};
  }
  void write(std::span<const std::uint8_t> bytes) const {
    while (!bytes.empty()) {
      const ssize_t n = ::write(far_, bytes.data(), bytes.size());
      if (n <= 0) return;
      bytes = bytes.subspan(static_cast<std::size_t>(n));
    }
  }

 private:
  int far_ = -1;
  int keeper_ = -1;
  std::string near_;
};

}  // namespace tp100
