#pragma once
// Writes JSON text straight into a string, for the step channels at 200 messages a second. JSON has
// no NaN and no infinity: such a field is left out, such an element is null. Writes valid UTF-8
// only.

#include <charconv>
#include <cmath>
#include <concepts>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace tp100::text {

/// Appends to `out`. The caller keeps objects and arrays balanced.
class JsonWriter {
 public:
  explicit JsonWriter(std::string& out) : out_(out) {}

  JsonWriter& begin_object() { return begin('{'); }
  JsonWriter& end_object() { return end('}'); }
  JsonWriter& begin_array() { return begin('['); }
  JsonWriter& end_array() { return end(']'); }

  JsonWriter& key(std::string_view name) {
    separate();
    quote(name);
    out_ += ':';
    comma_ = false;
    return *this;
  }

  JsonWriter& value(double number) {
    if (!std::isfinite(number)) return null();
    separate();
    char digits[32];
    const auto end = std::to_chars(digits, digits + sizeof digits, number).ptr;
    out_.append(digits, end);
    return done();
  }
  template <std::integral T>
  requires(!std::same_as<T, bool>) JsonWriter& value(T number) {
    separate();
    char digits[24];
    const auto end = std::to_chars(digits, digits + sizeof digits, number).ptr;
    out_.append(digits, end);
    return done();
  }
  template <std::same_as<bool> T>
  JsonWriter& value(T flag) {
    separate();
    out_ += flag ? "true" : "false";
    return done();
  }
  JsonWriter& value(std::string_view text) {
    separate();
    quote(text);
    return done();
  }
  JsonWriter& value(const char* text) { return value(std::string_view(text)); }
  JsonWriter& null() {
    separate();
    out_ += "null";
    return done();
  }

  /// One value that is already JSON.
  JsonWriter& raw(std::string_view json) {
    separate();
    out_ += json;
    return done();
  }

  /// An entry of an object that is an object; `write` adds its entries.
  template <class Write>
  JsonWriter& object(std::string_view name, const Write& write) {
    key(name).begin_object();
    write();
    return end_object();
  }
  /// An entry that is an array of objects; write(element) adds the entries of each.
  template <class Elements, class Write>
  JsonWriter& objects(std::string_view name, const Elements& elements, const Write& write) {
    key(name).begin_array();
    for (const auto& element : elements) {
      begin_object();
      write(element);
      end_object();
    }
    return end_array();
  }
  /// An entry that is an array of values.
  template <class Values>
  JsonWriter& values(std::string_view name, const Values& values) {
    key(name).begin_array();
    for (const auto& one : values) value(one);
    return end_array();
  }

  /// One entry of an object.
  template <class T>
  JsonWriter& field(std::string_view name, const T& content) {
    if constexpr (std::floating_point<T>) {
      if (!std::isfinite(content)) return *this;
    }
    return key(name).value(content);
  }
  /// Left out if there is no content.
  template <class T>
  JsonWriter& field(std::string_view name, const std::optional<T>& content) {
    return content ? field(name, *content) : *this;
  }
  /// The fields of a pose on the floor: x_m, y_m and yaw_rad.
  template <class P>
  JsonWriter& floor_pose(const P& at) {
    return field("x_m", at.x_m).field("y_m", at.y_m).field("yaw_rad", at.yaw_rad);
  }
  /// The fields of a structure that has a list of them (core/fields.h); those of a structure within
  /// it stand in its place.
  template <class Values>
  JsonWriter& fields(const Values& values) {
    visit_fields(
        [this](std::string_view name, const auto& value) {
          if constexpr (requires { visit_fields([](auto, const auto&) {}, value); }) {
            this->fields(value);
          } else {
            this->field(name, value);
          }
        },
        values);
    return *this;
  }

 private:
  JsonWriter& begin(char bracket) {
    separate();
    out_ += bracket;
    comma_ = false;
    return *this;
  }
  JsonWriter& end(char bracket) {
    out_ += bracket;
    return done();
  }
  void separate() {
    if (comma_) out_ += ',';
  }
  JsonWriter& done() {
    comma_ = true;
    return *this;
  }
  void quote(std::string_view text);

  std::string& out_;
  bool comma_ = false;
};

/// The text of one object; write(JsonWriter&) adds its entries.
template <class Write>
std::string json_object(const Write& write) {
  std::string text;
  text.reserve(256);
  JsonWriter json(text);
  json.begin_object();
  write(json);
  json.end_object();
  return text;
}

/// Bytes of the UTF-8 character at the beginning of `text`; 0 if there is none.
std::size_t utf8_length(std::string_view text);

}  // namespace tp100::text
