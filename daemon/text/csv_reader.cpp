#include "text/csv_reader.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <optional>
#include <utility>

#include "text/column_name.h"
#include "text/format.h"
#include "text/toml_document.h"

namespace tp100::text {
namespace {

constexpr std::size_t kMaxShown = 40;

bool contains(const std::vector<std::string_view>& names, std::string_view name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

/// What programs write where there is no value.
bool is_gap(std::string_view cell) {
  constexpr std::array<std::string_view, 8> kGaps = {"",     "nan", "na", "n/a",
                                                     "null", "-",   "--", "none"};
  const std::string text = lower(cell);
  return std::find(kGaps.begin(), kGaps.end(), text) != kGaps.end();
}

/// A number in the C locale, whatever the user's locale is.
std::optional<double> number_of(std::string_view text) {
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

bool CsvTable::has(std::string_view column) const { return columns_.contains(column); }

const std::vector<double>& CsvTable::operator[](std::string_view column) const {
  return columns_.find(column)->second;
}

const std::vector<std::string>& CsvTable::texts(std::string_view column) const {
  return texts_.find(column)->second;
}

std::string CsvTable::where(std::size_t row) const {
  return file_ + ":" + std::to_string(lines_[row]);
}

class CsvReader {
 public:
  CsvReader(std::string_view text, const std::string& file, const CsvColumns& columns)
      : text_(text), wanted_(columns), names_(columns.required) {
    table_.file_ = file;
    // Line ends of an old Macintosh, which spreadsheets still offer.
    if (text.find('\n') == text.npos) std::replace(text_.begin(), text_.end(), '\r', '\n');
    names_.insert(names_.end(), columns.optional.begin(), columns.optional.end());
  }

  CsvTable read() {
    read_head();
    while (next_row()) read_row();
    if (table_.rows() == 0) fail(2, "no rows after the header");
    return std::move(table_);
  }

 private:
  struct Column {
    std::string name;              // as the file writes it
    std::string_view wanted;       // empty: unused
    double size = 1.0;             // of the file's unit
    std::vector<double>* numbers;  // null: text, or unused
  };

  [[noreturn]] void fail(std::size_t line, const std::string& what) const {
    throw UserError(table_.file_ + ":" + std::to_string(line) + ": " + what);
  }

  static std::string list(const std::vector<std::string_view>& names) {
    std::string text;
    for (const std::string_view name : names) text += (text.empty() ? "" : ",") + std::string(name);
    return text;
  }

  /// The first of the possible separators in the first line that is no comment, outside of quotes.
  char separator() const {
    bool quoted = false;
    std::string_view rest(text_), line;
    do {
      rest.remove_prefix(std::min(rest.find_first_not_of(kBlank), rest.size()));
      line = rest.substr(0, rest.find('\n'));
      rest.remove_prefix(line.size());
    } while (line.starts_with('#') && !trimmed(rest).empty());
    std::string seen;
    for (const char c : trimmed(line)) {
      quoted = quoted != (c == '"');
      if (!quoted) seen += c;
    }
    for (const char c : {';', '\t', ',', ' '})
      if (seen.find(c) != seen.npos) return c;
    return ',';
  }

  void read_head() {
    if (trimmed(text_).empty())
      fail(1, "the file is empty; expected a header with " + list(wanted_.required));
    separator_ = separator();
    while (next_row()) {
      // What Excel writes before the table, and the '#' before names in files for numpy.
      if (cells_.front().starts_with("sep=")) continue;
      if (!wanted_.header) {
        if (is_comment()) continue;
        const bool named = std::none_of(cells_.begin(), cells_.end(), [](const std::string& cell) {
          return cell.find_first_of("+-.0123456789") == 0;
        });
        if (named && has_required(true)) return set_columns(cells_);
        set_columns({wanted_.required.begin(), wanted_.required.end()});
        if (!named) read_row();
        return;
      }
      const bool marked = cells_.front().starts_with('#');
      if (marked || cells_.front().starts_with('%')) cells_.front().erase(0, 1);
      if (cells_.front().empty()) cells_.erase(cells_.begin());
      if (marked && !has_required(false)) continue;
      return set_columns(cells_);
    }
    fail(1, "no header; expected one with " + list(wanted_.required));
  }

  /// Unlike a row that begins with #N/A, as spreadsheets write it.
  bool is_comment() const {
    const std::string& first = cells_.front();
    return first.starts_with('#') &&
           (separator_ == ' ' || first.starts_with("# ") ||
            std::all_of(cells_.begin() + 1, cells_.end(),
                        [](const std::string& cell) { return cell.empty(); }));
  }

  /// Whether all columns are named that must be; `units`: with a unit, if they have one.
  bool has_required(bool units) const {
    return std::all_of(
        wanted_.required.begin(), wanted_.required.end(), [&](std::string_view name) {
          return std::any_of(cells_.begin(), cells_.end(), [&](const std::string& cell) {
            const ColumnName is = name_in(cell), like = name_in(name);
            return is.stem == like.stem && (!units || is.unit.empty() == like.unit.empty());
          });
        });
  }

  /// Splits the next row that is not empty into cells. False at the end of the text.
  bool next_row() {
    while (at_ < text_.size()) {
      cells_.clear();
      line_ = next_line_;
      do cells_.emplace_back(trimmed(next_cell()));
      while (at_ < text_.size() && text_[at_++] != '\n');
      while (separator_ == ' ' && cells_.size() > 1 && cells_.back().empty()) cells_.pop_back();
      if (std::any_of(cells_.begin(), cells_.end(), [](auto& cell) { return !cell.empty(); }))
        return true;
    }
    return false;
  }

  /// Stops at the separator or the line end.
  std::string next_cell() {
    const auto more = [this](std::string_view any) {
      return at_ < text_.size() && any.find(text_[at_]) != any.npos;
    };
    while (more(separator_ == '\t' ? " " : " \t")) ++at_;
    std::string cell;
    const bool quotes = more("\"");
    if (quotes) cell = quoted();
    for (; at_ < text_.size() && text_[at_] != separator_ && text_[at_] != '\n'; ++at_) {
      if (quotes && kBlank.find(text_[at_]) == kBlank.npos)
        fail(line_, "characters after a closing quote");
      if (separator_ == ' ' && text_[at_] == '\t') break;
      if (!quotes) cell += text_[at_];
    }
    // Several spaces separate as one does.
    while (separator_ == ' ' && at_ + 1 < text_.size() && more(" \t") &&
           std::string_view(" \t\r").find(text_[at_ + 1]) != std::string_view::npos)
      ++at_;
    if (at_ >= text_.size() || text_[at_] == '\n') ++next_line_;
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

  void set_columns(std::vector<std::string> names) {
    while (names.size() > 1 && names.back().empty()) names.pop_back();
    for (const std::string& name : names) columns_.push_back({name, {}, 1.0, nullptr});
    for (Column& column : columns_)
      for (const std::string_view wanted : names_) find(column, wanted);
    for (const Column& column : columns_)
      if (column.wanted.empty() && !column.name.empty()) refuse_misspelt(column);
    for (const std::string_view name : wanted_.required)
      if (!found(name))
        fail(line_, "column '" + std::string(name) + "' is missing; expected a header with " +
                        list(wanted_.required));
  }

  bool found(std::string_view name) const {
    return std::any_of(columns_.begin(), columns_.end(),
                       [&](const Column& column) { return column.wanted == name; });
  }

  void find(Column& column, std::string_view wanted) {
    const ColumnName is = name_in(column.name), like = name_in(wanted);
    const Unit *unit = unit_named(is.unit), *into = unit_named(like.unit);
    const bool convertible = unit != nullptr && into != nullptr && unit->base == into->base;
    if (column.name != wanted && (is.stem != like.stem || (is.unit != like.unit && !convertible)))
      return;
    if (found(wanted)) fail(line_, "column '" + std::string(wanted) + "' appears twice");
    column.wanted = wanted;
    if (convertible && unit->size != into->size) column.size = unit->size / into->size;
    if (contains(wanted_.texts, wanted))
      table_.texts_[std::string(wanted)];
    else
      column.numbers = &table_.columns_[std::string(wanted)];
  }

  void refuse_misspelt(const Column& column) const {
    const ColumnName is = name_in(column.name);
    const std::string head = "column '" + one_line(column.name, kMaxShown) + "' ";
    std::vector<std::string_view> open;
    for (const std::string_view name : names_) {
      if (found(name)) continue;
      open.push_back(name);
      const ColumnName like = name_in(name);
      if (is.stem != like.stem) continue;
      if (is.unit.empty())
        fail(line_, head + "has no unit; name it '" + std::string(name) + "' or '" + like.stem +
                        " (" + like.unit + ")'");
      fail(line_, head + "has a unit that does not fit; give it in " + like.unit);
    }
    const std::string meant = suggestion(lower(column.name), open);
    if (!meant.empty() || !wanted_.others)
      fail(line_,
           head + "is unknown" + (meant.empty() ? "; columns may be " + list(names_) : meant));
  }

  double number_at(std::size_t i) {
    std::string cell = cells_[i];
    const std::string shown = columns_[i].name + " is '" + one_line(cell, kMaxShown) + "'";
    // The minus of word processors.
    if (cell.starts_with("\xe2\x88\x92")) cell.replace(0, 3, "-");
    const std::size_t comma = cell.find(',');
    if (const std::size_t mark = cell.find_first_of(".,"); mark != cell.npos) {
      if (point_ == 0) {
        point_ = cell[mark];
        point_line_ = line_;
      }
      if (point_ != cell[mark] || (comma != cell.npos && cell.find_last_of(".,") != mark))
        fail(line_, shown + ", but line " + std::to_string(point_line_) + " has a decimal " +
                        (point_ == ',' ? "comma" : "point") +
                        "; use one of them, and nothing between thousands");
    }
    if (comma != cell.npos) cell[comma] = '.';
    const std::optional<double> value = number_of(cell);
    if (!value) fail(line_, shown + ", expected a number");
    if (!std::isfinite(*value)) fail(line_, shown + ", expected a finite number");
    return *value * columns_[i].size;
  }

  void read_row() {
    if (is_comment()) return;
    while (cells_.size() > columns_.size() && cells_.back().empty()) cells_.pop_back();
    if (cells_.size() != columns_.size())
      fail(line_, std::to_string(cells_.size()) + " values in " + std::to_string(columns_.size()) +
                      " columns" +
                      (separator_ == ',' && cells_.size() > columns_.size()
                           ? "; with decimal commas, separate the columns by ;"
                           : ""));
    for (std::size_t i = 0; i < cells_.size(); ++i) {
      const Column& column = columns_[i];
      if (column.numbers == nullptr) {
        if (!column.wanted.empty()) table_.texts_[std::string(column.wanted)].push_back(cells_[i]);
      } else if (contains(wanted_.gaps, column.wanted) && is_gap(cells_[i])) {
        column.numbers->push_back(std::nan(""));
      } else {
        column.numbers->push_back(number_at(i));
      }
    }
    table_.lines_.push_back(line_);
    if (!wanted_.by_time) return;
    const std::string_view time = wanted_.required.front();
    const std::vector<double>& times = table_[time];
    if (times.size() > 1 && times.back() <= times[times.size() - 2])
      fail(line_, std::string(time) + " is " + number_text(times.back()) +
                      ", not after the row before (" + number_text(times[times.size() - 2]) + ")");
  }

  std::string text_;
  const CsvColumns& wanted_;
  std::vector<std::string_view> names_;  // that may be there
  CsvTable table_;
  char separator_ = ',';
  std::size_t at_ = 0;
  std::size_t line_ = 1, next_line_ = 1;
  char point_ = 0;  // in the first number with one
  std::size_t point_line_ = 0;
  std::vector<std::string> cells_;
  std::vector<Column> columns_;
};

CsvTable parse_csv(std::string_view text, const std::string& file, const CsvColumns& columns) {
  return CsvReader(text, file, columns).read();
}

}  // namespace tp100::text
