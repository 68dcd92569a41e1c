#pragma once
// The reader of tables: measurements as people, spreadsheets and other programs write them.

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
  /// Texts of a column of CsvColumns::texts.
  const std::vector<std::string>& texts(std::string_view column) const;
  /// "file:line" of a row, for messages.
  std::string where(std::size_t row) const;

 private:
  friend class CsvReader;
  std::string file_;
  std::vector<std::size_t> lines_;
  std::map<std::string, std::vector<double>, std::less<>> columns_;
  std::map<std::string, std::vector<std::string>, std::less<>> texts_;
};

/// Required and optional columns, each named with its unit ("turned_deg"). If `by_time`, the first
/// required column is the time and must increase.
struct CsvColumns {
  std::vector<std::string_view> required;
  std::vector<std::string_view> optional{};
  std::vector<std::string_view> gaps{};  ///< columns in which an empty cell reads as not-a-number
  bool by_time = true;
  bool others = true;                     ///< ignores further columns, or else refuses them
  bool header = true;                     ///< if not, the columns are `required`, in that order
  std::vector<std::string_view> texts{};  ///< columns of text, not of numbers
};

/// Parses a table: a header, unless it needs none, and rows. Columns are separated by ';', tabs,
/// commas or spaces, the first of these in its first line, and quoted as in RFC 4180. Accepts any
/// line ends, empty rows, comments after '#', decimal commas, and in the header upper case and
/// other units than those of the columns, which are converted: "Distance (cm)" for distance_m.
/// Rejects a missing, misspelt or repeated column, one without its unit, a row of another width, a
/// value that is not a finite number, decimal points and commas in one file, time that does not
/// increase, an open quote and a file without rows. Throws UserError "file:line: what". Pure.
CsvTable parse_csv(std::string_view text, const std::string& file, const CsvColumns& columns);

}  // namespace tp100::text
