#pragma once
// The bytes of one fuzz input, taken from the front; after the end everything reads as zero.

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <span>
#include <string>

namespace tp100::fuzz {

class ByteSource {
 public:
  ByteSource(const std::uint8_t* data, std::size_t size) : rest_(data, size) {}

  bool empty() const { return rest_.empty(); }
  std::uint8_t u8() {
    const std::span<const std::uint8_t> one = bytes(1);
    return one.empty() ? std::uint8_t{0} : one[0];
  }
  /// At most `count` bytes.
  std::span<const std::uint8_t> bytes(std::size_t count) {
    const std::span<const std::uint8_t> out = rest_.first(std::min(count, rest_.size()));
    rest_ = rest_.subspan(out.size());
    return out;
  }
  /// All remaining bytes, as text.
  std::string text() {
    std::string out(rest_.begin(), rest_.end());
    rest_ = {};
    return out;
  }

 private:
  std::span<const std::uint8_t> rest_;
};

/// Aborts if a property does not hold that every input must keep.
inline void require(bool holds, const char* what) {
  if (holds) return;
  std::fprintf(stderr, "fuzz: broken: %s\n", what);
  std::abort();
}

/// Checks the error message for a bad file: it must be one non-empty line.
inline void require_message(const std::string& message) {
  require(!message.empty() && message.size() < 2000, "a message of a sensible length");
  require(message.find('\n') == std::string::npos, "a message of one line");
}

}  // namespace tp100::fuzz
