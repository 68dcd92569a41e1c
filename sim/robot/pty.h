#pragma once
// A pseudo-terminal that stands in for the USB serial port of a Mega.

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>

#include "core/descriptor.h"

namespace tp100::sim {

/// The robot's end of a pty, with a symbolic link to the client's end. Raw, non-blocking.
class Pty {
 public:
  /// Creates the pty and a symbolic link to it (none if `link` is empty). Replaces a dangling link
  /// of that name, but no existing file or live link. Throws UserError.
  explicit Pty(const std::string& link);
  /// Removes the link if it still points here.
  ~Pty();
  Pty(const Pty&) = delete;
  Pty& operator=(const Pty&) = delete;

  /// Path of the client's end, e.g. /dev/pts/3.
  const std::string& device() const { return device_; }
  /// True while some client has the port open.
  bool open();
  /// Reads what the client wrote; at most `buffer.size()` bytes.
  std::size_t read(std::span<std::uint8_t> buffer);
  /// Writes bytes for the client; returns how many the pty accepted.
  std::size_t write(std::span<const std::uint8_t> bytes);
  /// Discards bytes left by an earlier client.
  void flush();
  int descriptor() const { return master_.get(); }

 private:
  Descriptor master_;
  std::string device_;
  std::string link_;
};

}  // namespace tp100::sim
