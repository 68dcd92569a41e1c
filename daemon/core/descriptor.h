#pragma once
// Open files, and complete reads and writes of them. Any thread.

#include <sys/types.h>
#include <unistd.h>

#include <cerrno>
#include <cstddef>
#include <utility>

namespace tp100 {

/// A file descriptor that closes itself; none is -1.
class Descriptor {
 public:
  explicit Descriptor(int fd = -1) : fd_(fd) {}
  ~Descriptor() {
    if (fd_ >= 0) ::close(fd_);
  }
  Descriptor(Descriptor&& other) noexcept : fd_(other.release()) {}
  Descriptor& operator=(Descriptor&& other) noexcept {
    std::swap(fd_, other.fd_);
    return *this;
  }
  int get() const { return fd_; }
  explicit operator bool() const { return fd_ >= 0; }
  /// The descriptor, which the caller closes.
  int release() { return std::exchange(fd_, -1); }

 private:
  int fd_;
};

/// Calls `move(at, left)`, which reads or writes up to `left` bytes from the byte `at` on, until
/// `size` bytes are moved. Zero or an errno; EIO: the file has fewer. `done`: how many were moved.
template <class Move>
int move_all(std::size_t size, std::size_t& done, Move move) {
  for (done = 0; done < size;) {
    const ssize_t n = move(done, size - done);
    if (n < 0 && errno == EINTR) continue;
    if (n <= 0) return n < 0 ? errno : EIO;
    done += static_cast<std::size_t>(n);
  }
  return 0;
}

}  // namespace tp100
