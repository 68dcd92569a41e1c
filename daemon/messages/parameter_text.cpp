#include "messages/parameter_text.h"

#include <algorithm>
#include <cmath>

#include "text/format.h"
#include "text/json_writer.h"

namespace tp100::messages {
namespace {

using Type = ParameterText::Type;

bool is_number(Type type) { return type == Type::kNumber || type == Type::kInteger; }

void write_value(text::JsonWriter& json, std::string_view name, const ParameterValue& value) {
  json.key(name);
  std::visit([&](const auto& content) { json.value(content); }, value);
}

}  // namespace

std::string why_not(const ParameterText& parameter, const ParameterValue& value) {
  if (is_number(parameter.type)) {
    const double* number = std::get_if<double>(&value);
    if (number == nullptr || !std::isfinite(*number)) return parameter.name + " takes a number";
    if (parameter.type == Type::kInteger && *number != std::floor(*number))
      return parameter.name + " takes a whole number";
    if (*number < parameter.range.min || *number > parameter.range.max)
      return parameter.name + " ranges from " + text::shortest(parameter.range.min) + " to " +
             text::shortest(parameter.range.max) +
             (parameter.unit.empty() ? "" : " " + parameter.unit);
    return {};
  }
  if (parameter.type == Type::kBoolean)
    return std::holds_alternative<bool>(value) ? "" : parameter.name + " takes true or false";
  const std::string* text = std::get_if<std::string>(&value);
  if (text == nullptr) return parameter.name + " takes a text";
  if (parameter.type == Type::kChoice &&
      std::find(parameter.choices.begin(), parameter.choices.end(), *text) ==
          parameter.choices.end()) {
    std::string names;
    for (const std::string& choice : parameter.choices)
      names += (names.empty() ? "" : ", ") + choice;
    return parameter.name + " is one of " + names;
  }
  return {};
}

std::string parameters_message(const std::vector<ParameterText>& parameters) {
  return text::json_object([&](text::JsonWriter& json) {
    json.objects("parameters", parameters, [&](const ParameterText& parameter) {
      json.field("name", parameter.name);
      write_value(json, "value", parameter.value);
      write_value(json, "default", parameter.standard);
      json.field("type", name_in(kParameterTypeNames, parameter.type))
          .field("unit", parameter.unit);
      if (is_number(parameter.type))
        json.field("min", parameter.range.min).field("max", parameter.range.max);
      json.values("choices", parameter.choices)
          .field("meaning", parameter.meaning)
          .field("live", parameter.live)
          .field("when", parameter.only_at_standstill ? "not running" : "always")
          .field("may_save", parameter.may_save);
    });
  });
}

}  // namespace tp100::messages
