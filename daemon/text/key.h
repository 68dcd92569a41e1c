#pragma once
// Keys of a file as a table: name, field, range and documentation in one place. The same table
// reads the file and writes it with comments, so that the two cannot differ.

#include <cstddef>
#include <map>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "text/toml_document.h"

namespace tp100::text {

/// A key whose values are a few names, converted to and from an index into `names`.
template <class T>
struct Choice {
  std::vector<std::string_view> names;
  std::size_t (*get)(const T&);
  void (*set)(T&, std::size_t);
};

/// The choice of the enum `Member` of T by the table of its names, beside the enum.
template <class T, auto Member, const auto& Names>
Choice<T> enum_choice() {
  Choice<T> choice{{},
                   [](const T& from) {
                     std::size_t i = 0;
                     while (i + 1 < Names.size() && Names[i].value != from.*Member) ++i;
                     return i;
                   },
                   [](T& to, std::size_t i) { to.*Member = Names[i].value; }};
  for (const auto& one : Names) choice.names.emplace_back(one.name);
  return choice;
}

/// One key that fills a field of T.
template <class T>
struct Key {
  std::string_view name;  ///< its suffix gives the unit, see unit_of
  std::variant<double T::*, int T::*, bool T::*, std::string T::*, Choice<T>> field;
  Range range{0.0, 0.0};     ///< of numbers, in the file's unit
  std::string_view meaning;  ///< one sentence, no unit and no range
  double si = 1.0;           ///< SI value of one file unit (kRadPerDeg for _deg)
};

/// A number as written in a file: ten significant digits, read back as written.
std::string toml_number(double value);
/// A quoted TOML string.
std::string toml_string(std::string_view value);
/// A value as it is written in a file: numbers as by toml_number.
std::string toml_value(const TomlValue& value);
/// `text` as comment lines of at most 100 columns.
std::string toml_comment(std::string_view text);

/// Reads every key of `keys`; absent ones keep their value. Throws UserError.
template <class T>
void read_keys(TomlTable& table, std::span<const Key<T>> keys, T& values) {
  for (const Key<T>& key : keys) {
    if (const auto* field = std::get_if<double T::*>(&key.field)) {
      if (table.has(key.name))
        values.** field = table.number(key.name, 0.0, key.range) * key.si;
      else
        table.number(key.name, 0.0, key.range);
    } else if (const auto* number = std::get_if<int T::*>(&key.field)) {
      values.** number = static_cast<int>(table.integer(key.name, values.**number, key.range));
    } else if (const auto* flag = std::get_if<bool T::*>(&key.field)) {
      values.** flag = table.boolean(key.name, values.**flag);
    } else if (const auto* text = std::get_if<std::string T::*>(&key.field)) {
      values.** text = table.text(key.name, values.**text);
    } else {
      const auto& choice = std::get<Choice<T>>(key.field);
      const std::string name =
          table.choice(key.name, choice.names[choice.get(values)], choice.names);
      for (std::size_t i = 0; i < choice.names.size(); ++i)
        if (choice.names[i] == name) choice.set(values, i);
    }
  }
}

/// Value of one key, in the file's unit.
template <class T>
TomlValue value_of(const Key<T>& key, const T& values) {
  if (const auto* field = std::get_if<double T::*>(&key.field)) return values.**field / key.si;
  if (const auto* number = std::get_if<int T::*>(&key.field))
    return static_cast<long long>(values.**number);
  if (const auto* flag = std::get_if<bool T::*>(&key.field)) return values.**flag;
  if (const auto* text = std::get_if<std::string T::*>(&key.field)) return values.**text;
  const auto& choice = std::get<Choice<T>>(key.field);
  return std::string(choice.names[choice.get(values)]);
}

/// A key with its value and documentation, for display.
struct KeyText {
  /// In the order of Key::field.
  enum class Type { kNumber, kInteger, kBoolean, kText, kChoice };
  using Value = std::variant<double, bool, std::string>;

  std::string name{};  ///< with the names of its tables: "control.preview_s"
  Type type = Type::kNumber;
  Value value{}, standard{};  ///< numbers in the file's unit
  std::string unit{};         ///< numbers; may be empty
  Range range{0.0, 0.0};      ///< numbers
  std::vector<std::string> choices{};
  std::string meaning{};
};

/// A value as a KeyText has it.
KeyText::Value shown_value(const TomlValue& value);

/// The keys of one table, named with `prefix` ("control.").
template <class T>
void describe_keys(const std::string& prefix, std::span<const Key<T>> keys, const T& values,
                   std::vector<KeyText>& out) {
  for (const Key<T>& key : keys) {
    out.push_back({.name = prefix + std::string(key.name),
                   .type = static_cast<KeyText::Type>(key.field.index()),
                   .value = shown_value(value_of(key, values)),
                   .standard = shown_value(value_of(key, T{})),
                   .unit = std::string(unit_of(key.name)),
                   .range = key.range,
                   .meaning = std::string(key.meaning)});
    if (const auto* choice = std::get_if<Choice<T>>(&key.field))
      out.back().choices.assign(choice->names.begin(), choice->names.end());
  }
}

/// Origin of values, by key: one sentence each, without its first word "From" and its full stop.
using Origins = std::map<std::string, std::string, std::less<>>;

/// Reads the origins of the keys of `[table]` from a file written by write_keys.
Origins read_origins(std::string_view text, std::string_view table);

/// The keys with meaning, unit, default, range and origin as comments: the body of one table of a
/// file.
template <class T>
std::string write_keys(std::span<const Key<T>> keys, const T& values, const Origins& origins = {}) {
  std::string text;
  for (const Key<T>& key : keys) {
    std::string comment = std::string(key.meaning) + ". Default " + toml_value(value_of(key, T{}));
    if (const auto* choice = std::get_if<Choice<T>>(&key.field)) {
      comment += ", one of";
      for (const std::string_view name : choice->names) comment += " " + toml_string(name);
    } else if (std::holds_alternative<double T::*>(key.field) ||
               std::holds_alternative<int T::*>(key.field)) {
      comment += ", range " + range_and_unit(key.name, key.range);
    } else if (std::holds_alternative<bool T::*>(key.field)) {
      comment += ", true or false";
    }
    text += toml_comment(comment + ".");
    if (const auto origin = origins.find(key.name); origin != origins.end())
      text += toml_comment("From " + origin->second + ".");
    text += std::string(key.name) + " = " + toml_value(value_of(key, values)) + "\n";
  }
  return text;
}

}  // namespace tp100::text
