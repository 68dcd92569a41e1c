#pragma once
// Opening and closing a port: a real one through libserialport, a pty and what that library does
// not know by its name directly. All give a raw, exclusive, non-blocking descriptor. Set-up thread
// only: closing a port may block.

#include <sys/stat.h>

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
  Port(int fd, std::string path, bool pseudo_terminal)
      : fd_(fd), path_(std::move(path)), pseudo_terminal_(pseudo_terminal) {}
  Port(Port&& other) noexcept;
  Port& operator=(Port&& other) noexcept;
  ~Port();

  bool is_open() const { return fd_ >= 0; }
  int fd() const { return fd_; }
  const std::string& path() const { return path_; }
  /// As the kernel says of the open device, whatever its name. It may be an emulator's, or have a
  /// robot behind it: see core/start_rule.h.
  bool pseudo_terminal() const { return pseudo_terminal_; }
  /// Discards what is not sent yet, so that closing does not wait for a peer that reads nothing.
  void close();

 private:
  int fd_ = -1;
  std::string path_;
  bool pseudo_terminal_ = false;
};

/// Opens `path` raw, exclusive, non-blocking and close-on-exec. Throws SetupError that
/// says whether it is missing, busy (and who holds it), forbidden or no serial port, and what to
/// do.
Port open_port(const std::string& path, const PortOptions& options);

/// Is it the near end of a pseudo-terminal? By its device number: a name proves nothing.
bool is_pseudo_terminal(mode_t mode, dev_t number);

}  // namespace tp100::link
