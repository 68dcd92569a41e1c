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

/// Bytes of the UTF-8 character at the beginning of `text`; 0 if there is none.
std::size_t utf8_length(std::string_view text);

}  // namespace tp100::text
