#pragma once
// Little-endian numbers and length-prefixed text to and from bytes.

#include <bit>
#include <concepts>
#include <cstdint>
#include <cstring>
#include <span>
#include <string_view>
#include <vector>

namespace tp100 {

using Bytes = std::vector<std::uint8_t>;

static_assert(std::endian::native == std::endian::little, "numbers are copied as they are");

inline std::span<const std::uint8_t> bytes_of(std::string_view text) {
  return {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()};
}

/// Appends to `out`.
class ByteWriter {
 public:
  explicit ByteWriter(Bytes& out) : out_(out) {}

  template <class T>
  requires std::integral<T> || std::floating_point<T>
  void number(T value) {
    const std::size_t at = out_.size();
    out_.resize(at + sizeof value);
    std::memcpy(out_.data() + at, &value, sizeof value);
  }
  void bytes(std::span<const std::uint8_t> content) {
    out_.insert(out_.end(), content.begin(), content.end());
  }
  /// u32 length and the text.
  void text(std::string_view content) {
    number(static_cast<std::uint32_t>(content.size()));
    out_.insert(out_.end(), content.begin(), content.end());
  }
  std::size_t size() const { return out_.size(); }
  /// Overwrites the value written at `at`.
  template <class T>
  void patch(std::size_t at, T value) {
    std::memcpy(out_.data() + at, &value, sizeof value);
  }

 private:
  Bytes& out_;
};

/// Reads from `in`. Beyond its end every value is zero and ok() is false.
class ByteReader {
 public:
  explicit ByteReader(std::span<const std::uint8_t> in) : in_(in) {}

  template <class T>
  requires std::integral<T> || std::floating_point<T> T number() {
    T value{};
    const std::span<const std::uint8_t> from = bytes(sizeof value);
    if (!from.empty()) std::memcpy(&value, from.data(), sizeof value);
    return value;
  }
  /// `size` bytes, or none if there are fewer.
  std::span<const std::uint8_t> bytes(std::uint64_t size) {
    if (size > in_.size()) {
      ok_ = false;
      in_ = {};
      return {};
    }
    const auto taken = in_.first(static_cast<std::size_t>(size));
    in_ = in_.subspan(static_cast<std::size_t>(size));
    return taken;
  }
  /// u32 length and the text.
  std::string_view text() {
    const auto taken = bytes(number<std::uint32_t>());
    return {reinterpret_cast<const char*>(taken.data()), taken.size()};
  }
  std::size_t left() const { return in_.size(); }
  bool ok() const { return ok_; }

 private:
  std::span<const std::uint8_t> in_;
  bool ok_ = true;
};

}  // namespace tp100
