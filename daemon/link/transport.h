#pragma once
// Opening and closing a port: a real one through libserialport, a pty directly. Both give a raw,
// exclusive, non-blocking descriptor. Set-up thread only: closing a port may block.

#include <string>
#include <utility>

namespace tp100::link {

/// How to open a port.
struct PortOptions {
  int baud = 500000;
  bool hang_up = false;  ///< HUPCL: closing drops DTR, so that the next open resets a Mega
};

/// An open port. Move-only; closes when destroyed.
class Port {
 public:
  Port() = default;
  Port(int fd, std::string path, bool physical)
      : fd_(fd), path_(std::move(path)), physical_(physical) {}
  Port(Port&& other) noexcept;
  Port& operator=(Port&& other) noexcept;
  ~Port();

  bool is_open() const { return fd_ >= 0; }
  int fd() const { return fd_; }
  const std::string& path() const { return path_; }
  /// A robot may hang on it; false for a pty.
  bool physical() const { return physical_; }
  /// Discards what is not sent yet, so that closing does not wait for a peer that reads nothing.
  void close();

 private:
  int fd_ = -1;
  std::string path_;
  bool physical_ = false;
};

/// Opens `path` raw, exclusive, non-blocking and close-on-exec. Throws SetupError that
/// says whether it is missing, busy (and who holds it), forbidden or no serial port, and what to
/// do.
Port open_port(const std::string& path, const PortOptions& options);

/// Same test as open_port uses: does the kernel know `path` as a terminal device of its own (not a
/// pty)?
bool is_physical_port(const std::string& path);

}  // namespace tp100::link
