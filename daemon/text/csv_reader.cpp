#include "text/csv_reader.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <optional>

#include "text/toml_document.h"

namespace tp100::text {
namespace {

std::string_view trimmed(std::string_view text) {
  const std::size_t first = text.find_first_not_of(" \t");
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(" \t") - first + 1);
}

/// A number in the C locale, whatever the user's locale is.
std::optional<double> number_of(std::string_view text) {
  text = trimmed(text);
  if (text.starts_with('+') && !text.starts_with("+-")) text.remove_prefix(1);
  double value = 0.0;
  const char* const end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, value);
  if (stop != end || text.empty()) return std::nullopt;
  if (error == std::errc::result_out_of_range) {
    // Underflow is zero; overflow is no valid number. Only the sign of the exponent distinguishes
    // them.
    const std::size_t e = text.find_first_of("eE");
    const bool small =
        e != std::string_view::npos && text.substr(e).find('-') != std::string_view::npos;
    return small ? 0.0 : HUGE_VAL;
  }
  if (error != std::errc()) return std::nullopt;
  return value;
}

}  // namespace

bool CsvTable::has(std::string_view column) const {
  return columns_.find(column) != columns_.end();
}

const std::vector<double>& CsvTable::operator[](std::string_view column) const {
  return columns_.find(column)->second;
}

std::string CsvTable::where(std::size_t row) const {
  return file_ + ":" + std::to_string(lines_[row]);
}

class CsvReader {
 public:
  CsvReader(std::string_view text, const std::string& file, const CsvColumns& columns)
      : text_(text), wanted_(columns) {
    table_.file_ = file;
    if (text_.starts_with("\xef\xbb\xbf")) text_.remove_prefix(3);
  }

  CsvTable read() {
    if (!next_row()) fail(1, "the file is empty; expected a header with " + required_names());
    read_header();
    while (next_row()) {
      if (cells_.size() == 1 && trimmed(cells_[0]).empty() && only_blank_lines_follow()) break;
      read_row();
    }
    if (table_.rows() == 0) fail(2, "no rows after the header");
    return std::move(table_);
  }

 private:
  [[noreturn]] void fail(std::size_t line, const std::string& what) const {
    throw UserError(table_.file_ + ":" + std::to_string(line) + ": " + what);
  }

  std::string required_names() const {
    std::string names;
    for (const std::string_view name : wanted_.required)
      names += (names.empty() ? "" : ",") + std::string(name);
    return names;
  }

  bool only_blank_lines_follow() const {
    return text_.find_first_not_of(" \t\r\n", at_) == std::string_view::npos;
  }

  /// Splits the next row into cells. False at the end of the text.
  bool next_row() {
    if (at_ >= text_.size()) return false;
    cells_.clear();
    line_ = next_line_;
    do cells_.push_back(next_cell());
    while (at_ < text_.size() && text_[at_++] == ',');
    return true;
  }

  /// Stops at the separator, after skipping a carriage return before a line feed.
  std::string next_cell() {
    std::string cell;
    if (at_ < text_.size() && text_[at_] == '"') {
      cell = quoted();
      if (at_ < text_.size() && text_[at_] != ',' && text_[at_] != '\r' && text_[at_] != '\n')
        fail(line_, "characters after a closing quote");
    }
    while (at_ < text_.size() && text_[at_] != ',' && text_[at_] != '\n') cell += text_[at_++];
    if (at_ >= text_.size() || text_[at_] == '\n') {
      if (cell.ends_with('\r')) cell.pop_back();
      ++next_line_;
    } else if (at_ + 1 == text_.size()) {
      fail(line_, "the last row is unfinished");
    }
    return cell;
  }

  std::string quoted() {
    std::string cell;
    for (++at_; at_ < text_.size(); ++at_) {
      if (text_[at_] == '"') {
        if (++at_ >= text_.size() || text_[at_] != '"') return cell;
      } else if (text_[at_] == '\n') {
        ++next_line_;
      }
      cell += text_[at_];
    }
    fail(line_, "a quote is never closed");
  }

  void read_header() {
    const auto wanted = [this](std::string_view name) {
      return std::count(wanted_.required.begin(), wanted_.required.end(), name) +
                 std::count(wanted_.optional.begin(), wanted_.optional.end(), name) >
             0;
    };
    for (const std::string& cell : cells_) {
      const std::string name(trimmed(cell));
      if (wanted(name)) {
        if (table_.has(name)) fail(1, "column '" + name + "' appears twice");
        targets_.push_back(&table_.columns_[name]);
        names_.push_back(name);
        gap_allowed_.push_back(std::count(wanted_.gaps.begin(), wanted_.gaps.end(), name) > 0);
      } else {
        gap_allowed_.push_back(false);
        targets_.push_back(nullptr);
        names_.push_back(one_line(name));
      }
    }
    for (const std::string_view name : wanted_.required)
      if (!table_.has(name))
        fail(1, "column '" + std::string(name) + "' is missing; expected a header with " +
                    required_names());
  }

  void read_row() {
    if (cells_.size() != targets_.size())
      fail(line_, std::to_string(cells_.size()) + " values, but the header has " +
                      std::to_string(targets_.size()) + " columns");
    for (std::size_t i = 0; i < cells_.size(); ++i) {
      if (targets_[i] == nullptr) continue;
      if (gap_allowed_[i] && trimmed(cells_[i]).empty()) {
        targets_[i]->push_back(std::nan(""));
        continue;
      }
      const std::optional<double> value = number_of(cells_[i]);
      if (!value)
        fail(line_, names_[i] + " is '" + one_line(cells_[i], 40) + "', expected a number");
      if (!std::isfinite(*value))
        fail(line_, names_[i] + " is '" + one_line(cells_[i], 40) + "', expected a finite number");
      targets_[i]->push_back(*value);
    }
    table_.lines_.push_back(line_);
    if (!wanted_.by_time) return;
    const std::string_view time = wanted_.required.front();
    const std::vector<double>& times = table_[time];
    if (times.size() > 1 && times.back() <= times[times.size() - 2])
      fail(line_, std::string(time) + " is " + number_text(times.back()) +
                      ", not after the row before (" + number_text(times[times.size() - 2]) + ")");
  }

  std::string_view text_;
  const CsvColumns& wanted_;
  CsvTable table_;
  std::size_t at_ = 0;
  std::size_t line_ = 1, next_line_ = 1;
  std::vector<std::string> cells_;
  std::vector<std::vector<double>*> targets_;  // null: an unused column
  std::vector<bool> gap_allowed_;
  std::vector<std::string> names_;
};

CsvTable parse_csv(std::string_view text, const std::string& file, const CsvColumns& columns) {
  return CsvReader(text, file, columns).read();
}

}  // namespace tp100::text
