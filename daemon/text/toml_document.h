#pragma once
// Strict reading of TOML: every key is asked for by name with its range, and a key that nobody
// asked for, a wrong type or a value out of range is one line with file:line:column and the nearest
// valid name. toml++ stays in the source file.

#include <array>
#include <cstddef>
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "core/error.h"

namespace tp100::text {

/// Inclusive bounds of a number.
struct Range {
  double min;
  double max;
};

/// Largest file that is read as TOML, bytes. Ours are below 20 kB.
inline constexpr std::size_t kMaxTomlSize = 1 << 18;

/// Unit of a key, by the end of its name (speed_mps: "m/s"); empty if it has none.
std::string_view unit_of(std::string_view key);

/// `text` on one line: control characters and bytes outside ASCII replaced by '?', cut at `most`
/// characters.
std::string one_line(std::string_view text, std::size_t most = 80);

/// A number in messages: at most ten significant digits.
std::string number_text(double value);

/// A value of any of the simple types.
using TomlValue = std::variant<bool, long long, double, std::string>;

class TomlDocument;

/// One table of a document. Cheap to copy; keeps its document alive. An absent table reads as
/// empty.
class TomlTable {
 public:
  /// The value of `key`, or `fallback` if absent. `range` in the key's own unit. Throws SetupError.
  double number(std::string_view key, double fallback, Range range);
  /// Same, but the key must be there.
  double required_number(std::string_view key, Range range);
  /// Same for keys with similar names, so that none is mistaken for another one mistyped.
  template <std::size_t N>
  std::array<double, N> required_numbers(const std::string_view (&keys)[N], Range range) {
    for (const std::string_view key : keys) number(key, 0.0, range);
    std::array<double, N> values{};
    for (std::size_t i = 0; i < N; ++i) values[i] = required_number(keys[i], range);
    return values;
  }
  long long integer(std::string_view key, long long fallback, Range range);
  bool boolean(std::string_view key, bool fallback);
  std::string text(std::string_view key, std::string_view fallback);
  /// One of `choices`; anything else is an error that names the nearest.
  std::string choice(std::string_view key, std::string_view fallback,
                     const std::vector<std::string_view>& choices);
  /// Same, but the key must be there.
  std::string required_choice(std::string_view key, const std::vector<std::string_view>& choices);
  /// A boolean, a number or a string; the key must be there.
  TomlValue required_value(std::string_view key);
  /// An array of them; absent reads as empty.
  std::vector<TomlValue> values(std::string_view key);
  /// Whether the value of `key` is a table. Does not count as asking for it.
  bool holds_table(std::string_view key) const;
  /// Sub-table; an absent one reads as empty.
  TomlTable table(std::string_view key);
  /// Array of tables; absent reads as empty.
  std::vector<TomlTable> tables(std::string_view key);
  bool has(std::string_view key) const;
  /// Names of all keys, asked for or not, sorted.
  std::vector<std::string> keys() const;

  /// Throws SetupError at `key` (or at the table if absent): "file:line:column: what".
  [[noreturn]] void fail(std::string_view key, const std::string& what) const;

  /// Throws SetupError for the first key of this table, or of a table taken from it, that was never
  /// asked for.
  void finish() const;

 private:
  friend class TomlDocument;
  struct State;
  std::shared_ptr<State> state_;
};

/// Values by their full names ("drive.speed_kp").
using NamedValues = std::vector<std::pair<std::string, TomlValue>>;

/// `text` with other values, in place of those that are there or besides them; comments are lost.
/// Throws SetupError: text that is not TOML, or a name through something that is no table.
std::string with_values(const std::string& text, const std::string& file,
                        const NamedValues& values);

/// A parsed file.
class TomlDocument {
 public:
  /// Throws SetupError for text that is not TOML, or larger than kMaxTomlSize. `file` is only used
  /// in messages.
  TomlDocument(const std::string& text, const std::string& file);
  TomlTable root() const { return root_; }

 private:
  TomlTable root_;
};

}  // namespace tp100::text
