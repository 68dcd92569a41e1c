#pragma once
// Reads the keys that detections and images of a camera have in common. For their source files.

#include <cstdint>
#include <limits>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>

namespace tp100::link {

/// An integer of 0 to `max`; false: there is none.
template <class Integer>
bool read(const nlohmann::ordered_json& json, const char* key, std::int64_t max, Integer& out) {
  const auto found = json.find(key);
  if (found == json.end() || !found->is_number_integer()) return false;
  // Above the signed range the parser keeps the value as unsigned.
  if (found->is_number_unsigned() &&
      found->get<std::uint64_t>() > static_cast<std::uint64_t>(max)) {
    return false;
  }
  const auto value = found->get<std::int64_t>();
  if (value < 0) return false;
  out = static_cast<Integer>(value);
  return true;
}

/// Reads `format`, which must be that one, stream, clock, sequence, stamp_us and age_us; false: not
/// all of them are there and in range.
template <class Message>
bool read_head(const nlohmann::ordered_json& json, std::string_view format, Message& out) {
  constexpr std::int64_t kMaxU32 = std::numeric_limits<std::uint32_t>::max();
  constexpr std::int64_t kMaxStampUs = std::int64_t{1} << 53;
  constexpr std::int64_t kMaxAgeUs = 10'000'000;
  constexpr std::size_t kMaxClock = 64;
  const auto text = [&](const char* key) {
    const auto found = json.find(key);
    return found == json.end() ? nullptr : found->template get_ptr<const std::string*>();
  };
  if (!json.is_object()) return false;
  const std::string* named = text("format");
  const std::string* clock = text("clock");
  if (named == nullptr || *named != format) return false;
  if (clock == nullptr || clock->empty() || clock->size() > kMaxClock) return false;
  out.clock = *clock;
  return read(json, "stream", kMaxU32, out.stream) &&
         read(json, "sequence", kMaxU32, out.sequence) &&
         read(json, "stamp_us", kMaxStampUs, out.stamp_us) &&
         read(json, "age_us", kMaxAgeUs, out.age_us);
}

}  // namespace tp100::link
