#include "text/toml_document.h"

#include <algorithm>
#include <sstream>
#include <utility>

#include "text/toml_advice.h"
#include "text/toml_depth.h"
#include "toml++/toml.h"

namespace tp100::text {
namespace {

std::string at(const std::string& file, toml::source_position where) {
  return file + ":" + std::to_string(where.line) + ":" + std::to_string(where.column) + ": ";
}

std::string in_quotes(std::string_view name) { return "'" + one_line(name) + "'"; }

std::string type_name(const toml::node& node) {
  switch (node.type()) {
    case toml::node_type::table:
      return "a table";
    case toml::node_type::array:
      return node.is_array_of_tables() ? "an array of tables" : "an array";
    case toml::node_type::string:
      return "a string";
    case toml::node_type::integer:
      return "an integer";
    case toml::node_type::floating_point:
      return "a number";
    case toml::node_type::boolean:
      return "a boolean";
    default:
      return "a date or time";
  }
}

}  // namespace

std::string range_and_unit(std::string_view key, Range range) {
  const std::string_view unit = unit_of(key);
  return number_text(range.min) + " to " + number_text(range.max) +
         (unit.empty() ? std::string() : " " + std::string(unit));
}

struct TomlTable::State {
  std::shared_ptr<const toml::table> document;
  std::string file;
  std::string path;                    // with a trailing dot, "drive."; empty for the root
  const toml::table* table = nullptr;  // null: absent
  toml::source_position where{1, 1};
  std::vector<std::string> asked;
  std::vector<std::shared_ptr<State>> children;
  std::weak_ptr<State> parent;
  std::string own_name;  // name within the parent

  std::string full(std::string_view key) const { return in_quotes(path + std::string(key)); }

  const toml::node* ask(std::string_view key) {
    if (std::find(asked.begin(), asked.end(), key) == asked.end()) asked.emplace_back(key);
    return table ? table->get(key) : nullptr;
  }

  std::vector<std::string_view> unasked() const {
    std::vector<std::string_view> names;
    if (table)
      for (const auto& [key, node] : *table)
        if (std::find(asked.begin(), asked.end(), key.str()) == asked.end())
          names.push_back(key.str());
    return names;
  }

  toml::source_position position_of_key(std::string_view key) const {
    const auto found = table->find(key);
    return found->first.source().begin ? found->first.source().begin : found->second.source().begin;
  }

  [[noreturn]] void unknown(std::string_view key, std::string_view meant) const {
    std::string what = at(file, position_of_key(key)) + "unknown key " + full(key);
    if (!meant.empty()) {
      what += "; did you mean " + full(meant) + "?";
    } else if (asked.empty()) {
      what += "; this table has no keys";
    } else {
      what += "; valid here: ";
      for (std::size_t i = 0; i < asked.size(); ++i)
        what += (i ? ", " : "") + (i < 12 ? asked[i] : std::string("..."));
    }
    throw UserError(what);
  }

  [[noreturn]] void missing(std::string_view key) const {
    // If a required key is missing, a misspelled key is the better error to report.
    for (const std::string_view other : unasked())
      if (nearest_name(other, {key}) == key) unknown(other, key);
    if (const auto above = parent.lock(); above && !table)
      for (const std::string_view other : above->unasked())
        if (nearest_name(other, {own_name}) == own_name) above->unknown(other, own_name);
    throw UserError(at(file, where) + "missing key " + full(key) + "; it has no default");
  }

  const toml::node& need(std::string_view key) {
    const toml::node* node = ask(key);
    if (!node) missing(key);
    return *node;
  }

  [[noreturn]] void wrong_type(std::string_view key, const toml::node& node,
                               std::string_view expected) const {
    throw UserError(at(file, node.source().begin) + full(key) + " is " + type_name(node) +
                    ", expected " + std::string(expected));
  }

  void check_range(std::string_view key, const toml::node& node, double value, Range range) const {
    if (value >= range.min && value <= range.max) return;
    throw UserError(at(file, node.source().begin) + full(key) + " is " + number_text(value) +
                    ", allowed " + range_and_unit(key, range));
  }

  double number(std::string_view key, const toml::node& node, Range range) const {
    if (!node.is_number()) wrong_type(key, node, "a number");
    const double value = *node.value<double>();
    check_range(key, node, value, range);
    return value;
  }

  TomlValue value(std::string_view key, const toml::node& node) const {
    if (node.is_boolean()) return node.as_boolean()->get();
    if (node.is_integer()) return static_cast<long long>(node.as_integer()->get());
    if (node.is_floating_point()) return node.as_floating_point()->get();
    if (!node.is_string()) wrong_type(key, node, "true, false, a number or a string");
    return node.as_string()->get();
  }

  std::string choice(std::string_view key, const toml::node& node,
                     const std::vector<std::string_view>& choices) const {
    std::string names;
    for (const std::string_view name : choices)
      names += (names.empty() ? "'" : ", '") + std::string(name) + "'";
    if (!node.is_string()) wrong_type(key, node, "one of " + names);
    const std::string& value = node.as_string()->get();
    if (std::find(choices.begin(), choices.end(), value) != choices.end()) return value;
    const std::string_view meant = nearest_name(value, choices);
    throw UserError(
        at(file, node.source().begin) + full(key) + " is " + in_quotes(value) +
        (meant.empty() ? "; allowed: " : "; did you mean " + in_quotes(meant) + "? Allowed: ") +
        names);
  }

  static std::shared_ptr<State> child(const std::shared_ptr<State>& of_state, std::string_view key,
                                      const toml::table* of) {
    auto state = std::make_shared<State>();
    state->document = of_state->document;
    state->file = of_state->file;
    state->path = of_state->path + std::string(key) + ".";
    state->table = of;
    state->where = of ? of->source().begin : of_state->where;
    state->parent = of_state;
    state->own_name = key;
    of_state->children.push_back(state);
    return state;
  }

  void finish() const {
    if (const auto names = unasked(); !names.empty()) {
      // The first one in the file, so that the user works from top to bottom.
      const auto first = std::min_element(
          names.begin(), names.end(), [this](std::string_view a, std::string_view b) {
            const auto pa = position_of_key(a), pb = position_of_key(b);
            return std::pair(pa.line, pa.column) < std::pair(pb.line, pb.column);
          });
      unknown(*first, nearest_name(*first, {asked.begin(), asked.end()}));
    }
    for (const auto& one : children) one->finish();
  }
};

namespace {

toml::table parse(const std::string& text, const std::string& file) {
  if (text.size() > kMaxTomlSize)
    throw UserError(file + ": larger than " + std::to_string(kMaxTomlSize / 1024) +
                    " kB, too large for a file of this program");
  refuse_deep_keys(text, file);
  try {
    return toml::parse(text, file);
  } catch (const toml::parse_error& error) {
    const toml::source_position begin = error.source().begin;
    throw UserError(at(file, begin) +
                    "not TOML: " + toml_advice(text, begin.line, error.description()) + " (" +
                    one_line(error.description(), 200) + ")");
  }
}

std::string written(const toml::table& root) {
  std::ostringstream out;
  out << root << "\n";
  return out.str();
}

/// The table that contains the last part of `name`; created if absent.
toml::table& holder_of(toml::table& root, std::string_view& name, const std::string& file) {
  toml::table* table = &root;
  for (std::size_t dot = name.find('.'); dot != std::string_view::npos; dot = name.find('.')) {
    const std::string_view part = name.substr(0, dot);
    name.remove_prefix(dot + 1);
    const auto [place, made] = table->emplace<toml::table>(part);
    if (!place->second.is_table())
      throw UserError(file + ": " + in_quotes(part) + " is not a table, so it has no " +
                      in_quotes(name));
    table = place->second.as_table();
  }
  return *table;
}

}  // namespace

std::string with_values(const std::string& text, const std::string& file,
                        const NamedValues& values) {
  toml::table root = parse(text, file);
  for (const auto& [full_name, value] : values) {
    std::string_view name = full_name;
    toml::table& table = holder_of(root, name, file);
    std::visit([&](const auto& one) { table.insert_or_assign(name, one); }, value);
  }
  return written(root);
}

std::string without_keys(const std::string& text, const std::string& file,
                         const std::vector<std::string_view>& names) {
  toml::table root = parse(text, file);
  for (const std::string_view name : names) root.erase(name);
  return written(root);
}

TomlDocument::TomlDocument(const std::string& text, const std::string& file) {
  auto document = std::make_shared<const toml::table>(parse(text, file));
  root_.state_ = std::make_shared<TomlTable::State>();
  root_.state_->document = document;
  root_.state_->file = file;
  root_.state_->table = document.get();
}

double TomlTable::number(std::string_view key, double fallback, Range range) {
  const toml::node* node = state_->ask(key);
  return node ? state_->number(key, *node, range) : fallback;
}

double TomlTable::required_number(std::string_view key, Range range) {
  return state_->number(key, state_->need(key), range);
}

long long TomlTable::integer(std::string_view key, long long fallback, Range range) {
  const toml::node* node = state_->ask(key);
  if (!node) return fallback;
  if (!node->is_integer()) state_->wrong_type(key, *node, "an integer");
  const std::int64_t value = *node->value<std::int64_t>();
  state_->check_range(key, *node, static_cast<double>(value), range);
  return value;
}

bool TomlTable::boolean(std::string_view key, bool fallback) {
  const toml::node* node = state_->ask(key);
  if (!node) return fallback;
  if (!node->is_boolean()) state_->wrong_type(key, *node, "true or false");
  return node->as_boolean()->get();
}

std::string TomlTable::text(std::string_view key, std::string_view fallback) {
  const toml::node* node = state_->ask(key);
  if (!node) return std::string(fallback);
  if (!node->is_string()) state_->wrong_type(key, *node, "a string");
  return node->as_string()->get();
}

std::string TomlTable::choice(std::string_view key, std::string_view fallback,
                              const std::vector<std::string_view>& choices) {
  const toml::node* node = state_->ask(key);
  return node ? state_->choice(key, *node, choices) : std::string(fallback);
}

std::string TomlTable::required_choice(std::string_view key,
                                       const std::vector<std::string_view>& choices) {
  return state_->choice(key, state_->need(key), choices);
}

TomlValue TomlTable::required_value(std::string_view key) {
  return state_->value(key, state_->need(key));
}

std::vector<TomlValue> TomlTable::values(std::string_view key) {
  std::vector<TomlValue> values;
  const toml::node* node = state_->ask(key);
  if (!node) return values;
  if (!node->is_array()) state_->wrong_type(key, *node, "an array");
  for (const toml::node& one : *node->as_array()) values.push_back(state_->value(key, one));
  return values;
}

std::vector<std::array<double, 2>> TomlTable::pairs(std::string_view key, Range range) {
  std::vector<std::array<double, 2>> pairs;
  const toml::node* node = state_->ask(key);
  if (!node) return pairs;
  if (!node->is_array()) state_->wrong_type(key, *node, "an array of pairs, [[x, y], ...]");
  for (const toml::node& one : *node->as_array()) {
    const toml::array* pair = one.as_array();
    if (pair == nullptr || pair->size() != 2)
      state_->wrong_type(key, one, "a pair of numbers, [x, y]");
    pairs.push_back(
        {state_->number(key, (*pair)[0], range), state_->number(key, (*pair)[1], range)});
  }
  return pairs;
}

bool TomlTable::holds_table(std::string_view key) const {
  const toml::node* node = state_->table ? state_->table->get(key) : nullptr;
  return node && node->is_table();
}

TomlTable TomlTable::table(std::string_view key) {
  const toml::node* node = state_->ask(key);
  if (node && !node->is_table()) state_->wrong_type(key, *node, "a table");
  TomlTable result;
  result.state_ = State::child(state_, key, node ? node->as_table() : nullptr);
  return result;
}

std::vector<TomlTable> TomlTable::tables(std::string_view key) {
  std::vector<TomlTable> result;
  const toml::node* node = state_->ask(key);
  if (!node) return result;
  const toml::array* array = node->as_array();
  if (!array || (!array->empty() && !array->is_array_of_tables()))
    state_->wrong_type(key, *node, "an array of tables, each headed [[" + std::string(key) + "]]");
  for (const toml::node& one : *array) {
    result.emplace_back();
    result.back().state_ = State::child(state_, key, one.as_table());
  }
  return result;
}

bool TomlTable::has(std::string_view key) const {
  return state_->table && state_->table->contains(key);
}

std::vector<std::string> TomlTable::keys() const {
  std::vector<std::string> names;
  if (state_->table)
    for (const auto& [key, node] : *state_->table) names.emplace_back(key.str());
  return names;
}

void TomlTable::fail(std::string_view key, const std::string& what) const {
  const toml::node* node = state_->table ? state_->table->get(key) : nullptr;
  throw UserError(at(state_->file, node ? node->source().begin : state_->where) + what);
}

void TomlTable::finish() const { state_->finish(); }

}  // namespace tp100::text
