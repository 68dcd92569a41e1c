#include "text/format.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cstdarg>
#include <cstddef>
#include <cstdio>
#include <ctime>
#include <stdexcept>
#include <utility>

namespace tp100::text {
namespace {

constexpr std::size_t kLongestName = 64;

std::size_t edit_distance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> before(b.size() + 1), last(b.size() + 1), now(b.size() + 1);
  for (std::size_t j = 0; j <= b.size(); ++j) last[j] = j;
  for (std::size_t i = 1; i <= a.size(); ++i) {
    now[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t replaced = last[j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1);
      now[j] = std::min({replaced, last[j] + 1, now[j - 1] + 1});
      if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1])
        now[j] = std::min(now[j], before[j - 2] + 1);
    }
    before.swap(last);
    last.swap(now);
  }
  return last[b.size()];
}

}  // namespace

std::string shortest(double value) {
  std::array<char, 32> digits{};
  return {digits.data(), std::to_chars(digits.data(), digits.data() + digits.size(), value).ptr};
}

std::string number_text(double value) {
  std::array<char, 32> buffer{};
  std::snprintf(buffer.data(), buffer.size(), "%.10g", value);
  return buffer.data();
}

std::string format(const char* pattern, ...) {
  va_list arguments, again;
  va_start(arguments, pattern);
  va_copy(again, arguments);
  const int size = std::vsnprintf(nullptr, 0, pattern, arguments);
  std::string text(size < 0 ? 0 : static_cast<std::size_t>(size), '\0');
  // The closing zero goes where the string keeps its own.
  if (size >= 0) std::vsnprintf(text.data(), text.size() + 1, pattern, again);
  va_end(again);
  va_end(arguments);
  if (size < 0) throw std::runtime_error(std::string("cannot be formatted: ") + pattern);
  return text;
}

std::string lower(std::string_view text) {
  std::string out(text);
  for (char& c : out)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  return out;
}

std::string counted(std::uint64_t count, std::string_view noun) {
  return std::to_string(count) + " " + std::string(noun) + (count == 1 ? "" : "s");
}

std::string utc_minute(std::int64_t unix_s) {
  const auto seconds = static_cast<std::time_t>(unix_s);
  std::tm day{};
  if (::gmtime_r(&seconds, &day) == nullptr) return "unknown";
  return format("%04d-%02d-%02d %02d:%02d UTC", day.tm_year + 1900, day.tm_mon + 1, day.tm_mday,
                day.tm_hour, day.tm_min);
}

std::string_view nearest_name(std::string_view name,
                              const std::vector<std::string_view>& candidates) {
  if (name.size() > kLongestName) return {};
  std::string_view best;
  std::size_t best_distance = std::max<std::size_t>(2, name.size() / 3) + 1;
  for (const std::string_view candidate : candidates) {
    std::size_t distance = edit_distance(name, candidate);
    // A name without its unit: rate for rate_hz.
    if (name.size() >= 2 && candidate.starts_with(std::string(name) + "_"))
      distance = std::min<std::size_t>(distance, 1);
    if (distance < best_distance && distance < std::max(name.size(), candidate.size())) {
      best = candidate;
      best_distance = distance;
    }
  }
  return best;
}

std::string suggestion(std::string_view name, const std::vector<std::string_view>& candidates) {
  const std::string meant(nearest_name(name, candidates));
  return meant.empty() ? std::string() : "; did you mean '" + meant + "'?";
}

std::string_view unit_of(std::string_view key) {
  static constexpr std::array<std::pair<std::string_view, std::string_view>, 36> kUnits = {{
      {"_radps_rts", "rad/s/sqrt(s)"},
      {"_radps_rthz", "rad/s/sqrt(Hz)"},
      {"_mps2_rthz", "m/s^2/sqrt(Hz)"},
      {"_radps_per_lsb", "rad/s"},
      {"_mps_per_v", "m/s/V"},
      {"_bias_per_degc", "rad/s/K"},
      {"_radps_per_degc", "rad/s/K"},
      {"counts_per_metre", "1/m"},
      {"_amps_per_n", "A/N"},
      {"amps_per_n", "A/N"},
      {"_n_per_v", "N/V"},
      {"_radps2", "rad/s^2"},
      {"_radps", "rad/s"},
      {"_mps2", "m/s^2"},
      {"_degc", "degC"},
      {"_mps", "m/s"},
      {"_1pm", "1/m"},
      {"_1ps", "1/s"},
      {"_deg", "deg"},
      {"_rad", "rad"},
      {"_ohm", "ohm"},
      {"_ppm", "ppm"},
      {"_hz", "Hz"},
      {"_ms", "ms"},
      {"_us", "us"},
      {"_kg", "kg"},
      {"_mb", "MB"},
      {"_as", "A s"},
      {"baud", "baud"},
      {"_pa", "Pa"},
      {"_m", "m"},
      {"_s", "s"},
      {"_v", "V"},
      {"_n", "N"},
      {"_a", "A"},
      {"_bytes", "B"},
  }};
  for (const auto& [suffix, unit] : kUnits)
    if (key.ends_with(suffix)) return unit;
  return {};
}

}  // namespace tp100::text
