#pragma once
// Strict reading of TOML: every key is asked for by name with its range, and a key that nobody asked for,
// a wrong type or a value out of range is one line with file:line:column and the nearest valid name.
// toml++ stays in the source file.

#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/error.h"

namespace tp100::course {

/// Inclusive bounds of a number.
struct Range {
  double min;
  double max;
};

class TomlDocument;

/// One table of a document. Cheap to copy; valid while its document lives.
class TomlTable {
 public:
  /// The value of `key`, or `fallback` if absent. `range` in the key's own unit. Throws SetupError.
  double number(std::string_view key, double fallback, Range range);
  /// Same, but the key must be there.
  double required_number(std::string_view key, Range range);
  long long integer(std::string_view key, long long fallback, Range range);
  bool boolean(std::string_view key, bool fallback);
  std::string text(std::string_view key, std::string_view fallback);
  /// One of `choices`; anything else is an error that names the nearest.
  std::string choice(std::string_view key, std::string_view fallback,
                     const std::vector<std::string_view>& choices);
  /// Sub-table; an absent one reads as empty.
  TomlTable table(std::string_view key);
  /// Array of tables; absent reads as empty.
  std::vector<TomlTable> tables(std::string_view key);
  bool has(std::string_view key) const;

  /// Throws SetupError at `key` (or at the table if absent): "file:line:column: what".
  [[noreturn]] void fail(std::string_view key, const std::string& what) const;

  /// Throws SetupError for the first key of this table that was never asked for.
  void finish() const;

 private:
  friend class TomlDocument;
  struct State;
  std::shared_ptr<State> state_;
};

/// A parsed file.
class TomlDocument {
 public:
  /// Throws SetupError for text that is not TOML. `file` is only used in messages.
  TomlDocument(const std::string& text, const std::string& file);
  TomlTable root() const { return root_; }

 private:
  TomlTable root_;
};

}  // namespace tp100::course
