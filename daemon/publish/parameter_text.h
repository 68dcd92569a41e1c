#pragma once
// A parameter as viewers see it.

#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace tp100::publish {

/// Value of a parameter, in the unit of its file.
using ParameterValue = std::variant<double, bool, std::string>;

/// One parameter.
struct ParameterText {
  enum class Type : std::uint8_t { kNumber, kInteger, kBoolean, kText, kChoice };
  std::string name{};  ///< dotted, e.g. "control.preview_s"
  Type type = Type::kNumber;
  ParameterValue value{};
  ParameterValue standard{};  ///< the default
  std::string unit{};         ///< numbers
  double min = 0.0, max = 0.0;
  std::vector<std::string> choices{};
  std::string meaning{};
  bool live = false;          ///< can be set while the daemon runs
  bool only_at_rest = false;  ///< ... but not during a run
};

/// Why `value` cannot be that parameter's value; empty if it can: right type, finite, in range.
std::string why_not(const ParameterText& parameter, const ParameterValue& value);

/// The /parameter message.
std::string parameters_message(const std::vector<ParameterText>& parameters);

}  // namespace tp100::publish
