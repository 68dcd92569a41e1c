#pragma once
// Strict reading of TOML: the reader requests every key by name with its range. An unknown key, a
// wrong type or a value out of range is reported in one line with file:line:column and the nearest
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
#include "text/format.h"

namespace tp100::text {

/// Inclusive bounds of a number.
struct Range {
  double min;
  double max;
};

/// "0.1 to 0.3 m/s"; the unit is that of the key, if it has one.
std::string range_and_unit(std::string_view key, Range range);

/// Size limit of a TOML file, bytes. Ours are below 20 kB.
inline constexpr std::size_t kMaxTomlSize = 1 << 18;

/// A value of any of the simple types.
using TomlValue = std::variant<bool, long long, double, std::string>;

class TomlDocument;

/// One table of a document. Cheap to copy; keeps its document alive. An absent table reads as
/// empty.
class TomlTable {
 public:
  /// The value of `key`, or `fallback` if absent. `range` in the key's own unit. Throws UserError.
  double number(std::string_view key, double fallback, Range range);
  /// Same, but the key is required.
  double required_number(std::string_view key, Range range);
  /// Same for keys with similar names, so that none is reported as a misspelling of another.
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
  /// Same, but the key is required.
  std::string required_choice(std::string_view key, const std::vector<std::string_view>& choices);
  /// A boolean, a number or a string; the key is required.
  TomlValue required_value(std::string_view key);
  /// An array of them; absent reads as empty.
  std::vector<TomlValue> values(std::string_view key);
  /// An array of pairs of numbers, [[x, y], ...]; absent reads as empty.
  std::vector<std::array<double, 2>> pairs(std::string_view key, Range range);
  /// Whether the value of `key` is a table. Does not mark the key as known.
  bool holds_table(std::string_view key) const;
  /// Sub-table; an absent one reads as empty.
  TomlTable table(std::string_view key);
  /// Array of tables; absent reads as empty.
  std::vector<TomlTable> tables(std::string_view key);
  bool has(std::string_view key) const;
  /// Names of all keys, known or not, sorted.
  std::vector<std::string> keys() const;

  /// Throws UserError at `key` (or at the table if absent): "file:line:column: what".
  [[noreturn]] void fail(std::string_view key, const std::string& what) const;

  /// Throws UserError for the first key of this table, or of a table taken from it, that was never
  /// requested.
  void finish() const;

 private:
  friend class TomlDocument;
  struct State;
  std::shared_ptr<State> state_;
};

/// Values by their full names ("drive.speed_kp").
using NamedValues = std::vector<std::pair<std::string, TomlValue>>;

/// `text` with these values replaced or added; comments are lost. Throws UserError: text that is
/// not TOML, or a name that leads through a value that is not a table.
std::string with_values(const std::string& text, const std::string& file,
                        const NamedValues& values);

/// Same as a person does it: everything else, comments, order and line ends included, stays byte
/// for byte. A key that is absent is added behind the last key of its table; a table that is
/// absent, at the end. Names are bare keys joined by dots, without repetition. Also throws
/// UserError for a name of a table, and for a table that is written on one line and lacks the key.
/// Pure.
std::string with_values_in_place(const std::string& text, const std::string& file,
                                 const NamedValues& values);

/// `text` without these keys of its root, tables among them; comments are lost. Throws UserError:
/// text that is not TOML.
std::string without_keys(const std::string& text, const std::string& file,
                         const std::vector<std::string_view>& names);

/// A parsed file.
class TomlDocument {
 public:
  /// Throws UserError for text that is not TOML, or larger than kMaxTomlSize. `file` is only used
  /// in messages.
  TomlDocument(const std::string& text, const std::string& file);
  TomlTable root() const { return root_; }

 private:
  TomlTable root_;
};

}  // namespace tp100::text
