#include <algorithm>
#include <cstddef>
#include <map>
#include <string_view>
#include <utility>

#include "text/key.h"
#include "text/toml_document.h"
#include "toml++/toml.h"

namespace tp100::text {
namespace {

/// The text of one file and what is to be changed in it.
class Editor {
 public:
  Editor(const std::string& text, const std::string& file)
      : text_(text), file_(file), line_end_(text.find("\r\n") == text.npos ? "\n" : "\r\n") {
    // Throws the same errors as every other reader.
    const TomlDocument checked(text, file);
    root_ = toml::parse(text);
  }

  void put(std::string_view name, const TomlValue& value) {
    const std::size_t dot = name.rfind('.');
    const std::string_view holder = dot == name.npos ? std::string_view() : name.substr(0, dot);
    const std::string_view key = dot == name.npos ? name : name.substr(dot + 1);
    const toml::table* table = find_table(holder);
    const toml::node* node = table == nullptr ? nullptr : table->get(key);
    const std::string line = " = " + toml_value(value) + line_end_;
    if (node != nullptr) {
      if (node->is_table()) fail(name, "is a table");
      const std::size_t from = offset(node->source().begin);
      replaced_[from] = {offset(node->source().end) - from, toml_value(value)};
    } else if (table == nullptr) {
      new_tables_[std::string(holder)] += std::string(key) + line;
    } else if (table->is_inline()) {
      fail(holder, "is written on one line");
    } else {
      // The keys of a table without a header of its own are dotted.
      const bool headed =
          table == &root_ || text_.compare(offset(table->source().begin), 1, "[") == 0;
      added_[end_of(*table)] += std::string(headed ? key : name) + line;
    }
  }

  std::string result() const {
    std::string out = text_, end;
    // From the end, so that the other places stay valid.
    auto added = added_.rbegin();
    const auto add_from = [&](std::size_t least) {
      for (; added != added_.rend() && added->first >= least; ++added) {
        if (added->first == text_.size())
          end = added->second;
        else
          out.insert(added->first, added->second);
      }
    };
    for (auto each = replaced_.rbegin(); each != replaced_.rend(); ++each) {
      add_from(each->first);
      out.replace(each->first, each->second.first, each->second.second);
    }
    add_from(0);
    for (const auto& [name, lines] : new_tables_)
      end += (out.empty() && end.empty() ? "" : line_end_) + "[" + name + "]" + line_end_ + lines;
    if (!end.empty() && !out.empty() && !out.ends_with('\n')) out += line_end_;
    return out + end;
  }

 private:
  [[noreturn]] void fail(std::string_view name, const char* what) const {
    throw UserError(file_ + ": '" + one_line(name) + "' " + what +
                    "; change it with a text editor");
  }

  /// Null: absent.
  const toml::table* find_table(std::string_view name) const {
    const toml::table* table = &root_;
    while (!name.empty() && table != nullptr) {
      const std::size_t dot = std::min(name.find('.'), name.size());
      const toml::node* node = table->get(name.substr(0, dot));
      if (node != nullptr && !node->is_table()) fail(name.substr(0, dot), "is not a table");
      table = node == nullptr ? nullptr : node->as_table();
      name.remove_prefix(std::min(dot + 1, name.size()));
    }
    return table;
  }

  /// The byte of a place; columns count characters.
  std::size_t offset(toml::source_position place) const {
    std::size_t at = 0;
    for (toml::source_index line = 1; line < place.line; ++line) at = text_.find('\n', at) + 1;
    for (toml::source_index column = 1; column < place.column && at < text_.size(); ++column) {
      ++at;
      while (at < text_.size() && (static_cast<unsigned char>(text_[at]) & 0xc0) == 0x80) ++at;
    }
    return at;
  }

  /// Behind the line of the last value of a table, or of its header.
  std::size_t end_of(const toml::table& table) const {
    toml::source_position last{};
    if (&table != &root_) last = table.source().end;
    for (const auto& [key, node] : table)
      if (!node.is_table() && !node.is_array_of_tables()) last = std::max(last, node.source().end);
    if (!last) return 0;
    const std::size_t end = text_.find('\n', offset(last));
    return end == text_.npos ? text_.size() : end + 1;
  }

  const std::string& text_;
  const std::string& file_;
  std::string line_end_;
  toml::table root_;
  std::map<std::size_t, std::pair<std::size_t, std::string>>
      replaced_;                                   // length and value, by place
  std::map<std::size_t, std::string> added_;       // lines, by place
  std::map<std::string, std::string> new_tables_;  // lines, by table
};

}  // namespace

std::string with_values_in_place(const std::string& text, const std::string& file,
                                 const NamedValues& values) {
  Editor editor(text, file);
  for (const auto& [name, value] : values) editor.put(name, value);
  return editor.result();
}

}  // namespace tp100::text
