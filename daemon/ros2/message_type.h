#pragma once
// A ROS 2 message type, and a message of it as bytes.

#include <array>
#include <concepts>
#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <tuple>
#include <utility>
#include <vector>

#include "core/bytes.h"

namespace tp100::ros2 {

/// The description of a message type for other programs.
struct MessageType {
  std::string_view name;      ///< as ROS 2 prints it: nav_msgs/msg/Odometry
  std::string_view dds_name;  ///< the same for DDS: nav_msgs::msg::dds_::Odometry_
  std::string_view hash;      ///< RIHS01_..., as REP-2016 defines it
  std::string_view schema;    ///< the definition, in the format `ros2msg`
};

/// Appends fields as CDR (XCDR version 1, little-endian): each number is aligned to its own size,
/// counted from the end of the encapsulation header.
class CdrWriter {
 public:
  explicit CdrWriter(Bytes& out) : out_(out), begin_(out.size()) {}

  template <class Number>
  requires std::integral<Number> || std::floating_point<Number>
  void put(Number value) {
    out_.resize(out_.size() +
                (sizeof value - (out_.size() - begin_) % sizeof value) % sizeof value);
    ByteWriter(out_).number(value);
  }
  void put(const std::string& text) {
    put(static_cast<std::uint32_t>(text.size() + 1));
    ByteWriter(out_).bytes(bytes_of({text.c_str(), text.size() + 1}));
  }
  template <class T, std::size_t size>
  void put(const std::array<T, size>& values) {
    for (const T& value : values) put(value);
  }
  template <class T>
  void put(const std::vector<T>& values) {
    put(static_cast<std::uint32_t>(values.size()));
    for (const T& value : values) put(value);
  }
  template <class Message>
  requires requires(const Message& message) { message.fields(); }
  void put(const Message& message) {
    std::apply([this](const auto&... fields) { (this->put(fields), ...); }, message.fields());
  }

 private:
  Bytes& out_;
  std::size_t begin_;
};

/// A whole message: encapsulation header and fields.
template <class Message>
Bytes serialized(const Message& message) {
  Bytes out = {0, 1, 0, 0};  // CDR, little-endian
  CdrWriter(out).put(message);
  return out;
}

/// Reads fields as CdrWriter appends them. Treats the bytes as hostile: after the first field that
/// does not fit, ok() is false and nothing more is read. No length allocates more than the bytes
/// that follow it.
class CdrReader {
 public:
  explicit CdrReader(std::span<const std::uint8_t> in) : in_(in), size_(in.size()) {}

  template <class Number>
  requires std::integral<Number> || std::floating_point<Number>
  void get(Number& value) {
    const std::size_t at = size_ - in_.left();
    in_.bytes((sizeof value - at % sizeof value) % sizeof value);
    value = in_.number<Number>();
  }
  void get(bool& value) {
    std::uint8_t byte = 0;
    get(byte);
    value = byte == 1;
    ok_ = ok_ && byte <= 1;
  }
  void get(std::string& text) {
    std::uint32_t size = 0;
    get(size);
    const std::span<const std::uint8_t> bytes = in_.bytes(size);
    // Its final zero is counted; an empty text may have none.
    ok_ = ok_ && (bytes.empty() || bytes.back() == 0);
    if (!bytes.empty()) text.assign(bytes.begin(), bytes.end() - 1);
  }
  template <class T, std::size_t size>
  void get(std::array<T, size>& values) {
    for (T& value : values) get(value);
  }
  template <class T>
  void get(std::vector<T>& values) {
    std::uint32_t size = 0;
    get(size);
    ok_ = ok_ && size <= in_.left();
    for (std::uint32_t i = 0; i < size && ok(); ++i) get(values.emplace_back());
  }
  template <class Message>
  requires requires(Message& message) { message.fields(); }
  void get(Message& message) {
    std::apply([this](auto&... fields) { (this->get(fields), ...); }, message.fields());
  }

  std::size_t left() const { return in_.left(); }
  bool ok() const { return ok_ && in_.ok(); }

 private:
  ByteReader in_;
  std::size_t size_;
  bool ok_ = true;
};

/// The message in these bytes; nothing unless they are a complete one of that type, little-endian.
template <class Message>
std::optional<Message> deserialized(std::span<const std::uint8_t> bytes) {
  constexpr std::size_t kHeader = 4, kPadding = 3;
  // The last two bytes of the header may give the size of the padding.
  if (bytes.size() < kHeader || bytes[0] != 0 || bytes[1] != 1) return std::nullopt;
  CdrReader reader(bytes.subspan(kHeader));
  Message message{};
  reader.get(message);
  if (!reader.ok() || reader.left() > kPadding) return std::nullopt;
  return message;
}

}  // namespace tp100::ros2
