// The golden frames are text lines `name | field=value ... | frame in hex`, which are checked in
// both directions. C++11 without exceptions, so that the same check also runs in the firmware's
// dialect.
#ifndef TP100_TESTS_WIRE_GOLDEN_H
#define TP100_TESTS_WIRE_GOLDEN_H

#include <stdlib.h>
#include <string.h>

#include <fstream>
#include <map>
#include <string>
#include <vector>

#include "wire/frame.h"
#include "wire/messages.h"

namespace tp100 {
namespace golden {

/// One line of the file.
struct Line {
  std::string name;
  std::map<std::string, std::string> values;  ///< field -> text; array elements by commas
  std::string hex;                            ///< upper case, without spaces
};

inline std::string trim(const std::string& text) {
  const size_t first = text.find_first_not_of(" \t\r\n");
  if (first == std::string::npos) return "";
  return text.substr(first, text.find_last_not_of(" \t\r\n") - first + 1);
}

inline std::vector<std::string> split(const std::string& text, char separator) {
  std::vector<std::string> parts;
  size_t from = 0;
  while (from <= text.size()) {
    size_t to = text.find(separator, from);
    if (to == std::string::npos) to = text.size();
    parts.push_back(trim(text.substr(from, to - from)));
    from = to + 1;
  }
  return parts;
}

/// Reads the lines of a golden file; comments start with #.
inline std::vector<Line> read_lines(const std::string& path) {
  std::vector<Line> lines;
  std::ifstream file(path.c_str());
  std::string text;
  while (std::getline(file, text)) {
    if (trim(text).empty() || text[0] == '#') continue;
    const std::vector<std::string> parts = split(text, '|');
    Line line;
    line.name = parts[0];
    if (parts.size() == 3) {
      const std::vector<std::string> fields = split(parts[1], ' ');
      for (size_t i = 0; i < fields.size(); ++i) {
        const size_t equals = fields[i].find('=');
        if (equals == std::string::npos) continue;
        line.values[fields[i].substr(0, equals)] = fields[i].substr(equals + 1);
      }
      line.hex = parts[2];
    }
    lines.push_back(line);
  }
  return lines;
}

/// Fills the fields of a message from the text of a line.
class FromText {
 public:
  explicit FromText(const std::map<std::string, std::string>& values) : values_(values) {}
  template <class T>
  void field(const char* name, T& value) {
    value = number<T>(text(name));
  }
  template <class T, size_t N>
  void field(const char* name, T (&values)[N]) {
    const std::vector<std::string> parts = split(text(name), ',');
    for (size_t i = 0; i < N; ++i) values[i] = i < parts.size() ? number<T>(parts[i]) : T(0);
  }
  const std::string& missing() const { return missing_; }

 private:
  std::string text(const char* name) {
    const std::map<std::string, std::string>::const_iterator found = values_.find(name);
    if (found != values_.end()) return found->second;
    missing_ = name;
    return "0";
  }
  template <class T>
  static T number(const std::string& text) {
    return static_cast<T>(strtoll(text.c_str(), nullptr, 0));
  }
  const std::map<std::string, std::string>& values_;
  std::string missing_;
};
template <>
inline float FromText::number<float>(const std::string& text) {
  return strtof(text.c_str(), nullptr);
}

inline std::string to_hex(const uint8_t* bytes, size_t size) {
  static const char digits[] = "0123456789ABCDEF";
  std::string hex;
  for (size_t i = 0; i < size; ++i) {
    hex += digits[bytes[i] >> 4];
    hex += digits[bytes[i] & 15];
  }
  return hex;
}

inline std::vector<uint8_t> from_hex(const std::string& hex) {
  std::vector<uint8_t> bytes;
  for (size_t i = 0; i + 1 < hex.size(); i += 2) {
    bytes.push_back(static_cast<uint8_t>(strtol(hex.substr(i, 2).c_str(), nullptr, 16)));
  }
  return bytes;
}

/// Checks one line as a `Message`. Returns an empty string if the values encode to the hex and the
/// hex decodes to the values; otherwise the error.
template <class Message>
std::string check(const Line& line) {
  Message message;
  FromText from(line.values);
  message.visit(from);
  if (!from.missing().empty()) return line.name + ": no value for " + from.missing();
  uint8_t payload[wire::kMaxPayload];
  uint8_t frame[wire::kMaxFrame];
  const size_t size = wire::write_payload(message, payload);
  const size_t length =
      wire::encode_frame(static_cast<uint8_t>(Message::kType), payload, size, frame);
  if (to_hex(frame, length) != line.hex) {
    return line.name + ": the values code to\n" + to_hex(frame, length) + ", not to\n" + line.hex;
  }

  wire::FrameDecoder decoder;
  const std::vector<uint8_t> bytes = from_hex(line.hex);
  wire::DecodeResult last = wire::DecodeResult::kNothing;
  for (size_t i = 0; i < bytes.size(); ++i) last = decoder.push(bytes[i]);
  if (last != wire::DecodeResult::kFrame) return line.name + ": the hex is no good frame";
  if (decoder.type() != static_cast<uint8_t>(Message::kType)) return line.name + ": wrong type";
  Message decoded;
  if (!wire::read_payload(decoder.payload(), decoder.size(), decoded)) {
    return line.name + ": wrong size";
  }
  // The payload was compared with the values above.
  uint8_t again[wire::kMaxPayload];
  wire::write_payload(decoded, again);
  if (memcmp(again, payload, size) != 0) return line.name + ": it is read as another message";
  return "";
}

inline std::string check(const Line& line) {
  if (line.name == "Hello") return check<wire::Hello>(line);
  if (line.name == "Sample") return check<wire::Sample>(line);
  if (line.name == "Acknowledge") return check<wire::Acknowledge>(line);
  if (line.name == "SyncReply") return check<wire::SyncReply>(line);
  if (line.name == "FaultReport") return check<wire::FaultReport>(line);
  if (line.name == "Log") return check<wire::Log>(line);
  if (line.name == "HelloRequest") return check<wire::HelloRequest>(line);
  if (line.name == "Parameters") return check<wire::Parameters>(line);
  if (line.name == "Command") return check<wire::Command>(line);
  if (line.name == "Arm") return check<wire::Arm>(line);
  if (line.name == "Disarm") return check<wire::Disarm>(line);
  if (line.name == "Stop") return check<wire::Stop>(line);
  if (line.name == "SyncRequest") return check<wire::SyncRequest>(line);
  return "unknown message " + line.name;
}

}  // namespace golden
}  // namespace tp100

#endif
