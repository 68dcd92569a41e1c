#pragma once
// A parameter as published to viewers.

#include <array>
#include <string>
#include <vector>

#include "core/enum_names.h"
#include "text/key.h"

namespace tp100::messages {

/// Value of a parameter, in the unit of its file.
using ParameterValue = text::KeyText::Value;

/// One parameter: a key of a file.
struct ParameterText : text::KeyText {
  bool live = false;                ///< can be set while the daemon runs
  bool only_at_standstill = false;  ///< ... but not during a run
  bool may_save = false;            ///< a viewer may save it into the configuration file
};

/// Names as in /parameter.
inline constexpr std::array<EnumName<ParameterText::Type>, 5> kParameterTypeNames = {{
    {ParameterText::Type::kNumber, "number"},
    {ParameterText::Type::kInteger, "integer"},
    {ParameterText::Type::kBoolean, "boolean"},
    {ParameterText::Type::kText, "text"},
    {ParameterText::Type::kChoice, "choice"},
}};

/// Why `value` is not allowed for that parameter; empty if it is: right type, finite, in range.
std::string why_not(const ParameterText& parameter, const ParameterValue& value);

/// The /parameter message.
std::string parameters_message(const std::vector<ParameterText>& parameters);

}  // namespace tp100::messages
