#pragma once
// A nameless file for data that would fill the memory; it disappears with the process, however that
// ends. One thread.

#include <cstdint>
#include <span>
#include <string>

#include "core/descriptor.h"

namespace tp100::record {

class AnonymousFile {
 public:
  /// On the disk of `folder`. Throws SetupError.
  explicit AnonymousFile(const std::string& folder);

  /// Appends all of `bytes`, or nothing. 0 or an errno.
  int append(std::span<const std::uint8_t> bytes);
  /// Fills `into` with the bytes from `from` on. 0 or an errno; EIO: too few.
  int read(std::uint64_t from, std::span<std::uint8_t> into) const;
  std::uint64_t size() const { return size_; }

 private:
  Descriptor file_;
  std::uint64_t size_ = 0;
};

}  // namespace tp100::record
