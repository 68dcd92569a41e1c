#pragma once
// A ROS 2 message type, and a message of it as bytes.

#include <array>
#include <concepts>
#include <cstddef>
#include <string>
#include <string_view>
#include <tuple>
#include <vector>

#include "core/bytes.h"

namespace tp100::ros2 {

/// What other programs are told about a message type.
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

}  // namespace tp100::ros2
