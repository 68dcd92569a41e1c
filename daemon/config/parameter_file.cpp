#include "config/parameter_file.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "config/configuration.h"
#include "core/error.h"
#include "text/toml_document.h"

namespace tp100::config {
namespace {

using text::KeyText;
using Type = KeyText::Type;

std::vector<KeyText> keys_of(const course::TextFile& file) {
  return configuration_keys(parse_configuration(file.text, file.path));
}

/// Nothing: not of the key's type.
std::optional<text::TomlValue> written(const KeyText& key, const KeyText::Value& value) {
  if (value.index() != key.value.index()) return std::nullopt;
  if (const double* number = std::get_if<double>(&value)) {
    if (key.type == Type::kNumber) return *number;
    // This also rejects values that are not finite.
    if (!(std::abs(*number) < 1e15) || *number != std::floor(*number)) return std::nullopt;
    return static_cast<long long>(*number);
  }
  if (const bool* flag = std::get_if<bool>(&value)) return *flag;
  return std::get<std::string>(value);
}

std::string shown(const KeyText& key) {
  const auto value = written(key, key.value);
  return value ? text::toml_value(*value) : std::string();
}

}  // namespace

bool may_save(const KeyText& key) {
  if (key.name.starts_with("server.") || key.name.starts_with("ros2.")) return false;
  return key.type != Type::kText || key.name == "robot" || key.name == "course";
}

std::string with_parameters(const course::TextFile& file, const ParameterValues& values) {
  std::vector<KeyText> expected = keys_of(file);
  text::NamedValues changes;
  for (const auto& [name, value] : values) {
    const auto key = std::ranges::find(expected, name, &KeyText::name);
    if (key == expected.end()) throw UserError("the configuration has no '" + one_line(name) + "'");
    const auto change = written(*key, value);
    if (!change) throw UserError(name + " takes no value of that type");
    key->value = value;
    changes.emplace_back(name, *change);
  }
  course::TextFile next{file.path, text::with_values_in_place(file.text, file.path, changes)};
  const std::vector<KeyText> got = keys_of(next);
  for (std::size_t i = 0; i < got.size(); ++i)
    if (shown(got[i]) != shown(expected[i]))
      throw UserError(file.path + ": " + got[i].name +
                      " cannot be changed automatically; change it with a text editor");
  return next.text;
}

std::vector<ParameterDifference> parameter_differences(const course::TextFile& before,
                                                       const course::TextFile& after) {
  const std::vector<KeyText> old = keys_of(before), next = keys_of(after);
  std::vector<ParameterDifference> out;
  for (std::size_t i = 0; i < next.size(); ++i)
    if (shown(old[i]) != shown(next[i]))
      out.push_back({next[i].name, shown(old[i]), shown(next[i])});
  return out;
}

}  // namespace tp100::config
