#pragma once
// Strict reader for CSV files of numbers: one header line, then rows, mostly with increasing time.

#include <cstddef>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "core/error.h"

namespace tp100::text {

/// Columns by name; all of one length.
class CsvTable {
 public:
  std::size_t rows() const { return lines_.size(); }
  bool has(std::string_view column) const;
  /// Values of a column that exists.
  const std::vector<double>& operator[](std::string_view column) const;
  /// "file:line" of a row, for messages.
  std::string where(std::size_t row) const;

 private:
  friend class CsvReader;
  std::string file_;
  std::vector<std::size_t> lines_;
  std::map<std::string, std::vector<double>, std::less<>> columns_;
};

/// Required and optional columns. If `by_time`, the first required column is the time and must
/// increase.
struct CsvColumns {
  std::vector<std::string_view> required;
  std::vector<std::string_view> optional;
  std::vector<std::string_view> gaps{};  ///< columns in which an empty cell reads as not-a-number
  bool by_time = true;
};

/// Parses the text of a CSV file (RFC 4180: commas, optional quotes). Accepts CRLF, a byte-order
/// mark, other columns, blank lines at the end and a missing final line break; rejects a missing or
/// repeated column, a row of another width, a value that is not a finite number, time that does not
/// increase, an open quote and a file without rows. Throws UserError "file:line: what"; the header
/// is line 1. Pure.
CsvTable parse_csv(std::string_view text, const std::string& file, const CsvColumns& columns);

}  // namespace tp100::text
