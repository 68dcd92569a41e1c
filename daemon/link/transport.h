#pragma once
// Opening and closing a port: a real one through libserialport; a pty, or a port whose name that
// library does not know, directly. Every port is a raw, exclusive, non-blocking descriptor. Set-up
// thread only: closing a port may block.

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
  /// By the kernel's device number, whatever the port's name. It may belong to an emulator, or lead
  /// to a robot: see core/board.h.
  bool pseudo_terminal() const { return pseudo_terminal_; }
  /// Discards unsent bytes, so that closing does not wait for a peer that does not read.
  void close();

 private:
  int fd_ = -1;
  std::string path_;
  bool pseudo_terminal_ = false;
};

/// Opens `path` raw, exclusive, non-blocking and close-on-exec. Throws a UserError that says
/// whether the port is missing, busy (and which process holds it), forbidden or no serial port, and
/// what to do.
Port open_port(const std::string& path, const PortOptions& options);

/// True for the slave end of a pseudo-terminal, by the device number: a name proves nothing.
bool is_pseudo_terminal(mode_t mode, dev_t number);

}  // namespace tp100::link
