#pragma once
// Text for messages to the user: numbers, and the name that was probably meant.

#include <charconv>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <system_error>
#include <vector>

namespace tp100::text {

/// A number in messages: at most ten significant digits.
std::string number_text(double value);

/// The shortest text that reads back as the same value.
std::string shortest(double value);

/// The number that is all of `text`, as the C locale writes it; nothing if it is none, or none that
/// Number can hold.
template <class Number>
std::optional<Number> number_in(std::string_view text) {
  Number value{};
  const char* const end = text.data() + text.size();
  const auto [at, error] = std::from_chars(text.data(), end, value);
  if (error != std::errc() || at != end) return std::nullopt;
  return value;
}

/// As printf prints it, however long. Throws std::runtime_error if printf cannot.
[[gnu::format(printf, 1, 2)]] std::string format(const char* pattern, ...);

/// With the letters of ASCII in lower case.
std::string lower(std::string_view text);

/// "1 run", "2 runs"; `noun` is one whose plural ends in s.
std::string counted(std::uint64_t count, std::string_view noun);

/// Seconds since 1970 as "2026-05-31 14:05 UTC".
std::string utc_minute(std::int64_t unix_s);

/// The name that the user probably meant: the candidate with the smallest edit distance to `name`
/// (insert, delete, replace, swap neighbours); empty if none is near enough to be a typing error,
/// as for all long names.
std::string_view nearest_name(std::string_view name,
                              const std::vector<std::string_view>& candidates);

/// Unit of a key or column, by the suffix of its name (speed_mps: "m/s"); empty if it has none.
std::string_view unit_of(std::string_view key);

/// "; did you mean 'worn'?" with the nearest_name(), or nothing.
std::string suggestion(std::string_view name, const std::vector<std::string_view>& candidates);

}  // namespace tp100::text
