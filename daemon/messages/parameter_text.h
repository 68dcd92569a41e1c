#pragma once
// A parameter as viewers see it.

#include <string>
#include <vector>

#include "text/key.h"

namespace tp100::messages {

/// Value of a parameter, in the unit of its file.
using ParameterValue = text::KeyText::Value;

/// One parameter: a key of a file.
struct ParameterText : text::KeyText {
  bool live = false;          ///< can be set while the daemon runs
  bool only_at_rest = false;  ///< ... but not during a run
};

/// Why `value` cannot be that parameter's value; empty if it can: right type, finite, in range.
std::string why_not(const ParameterText& parameter, const ParameterValue& value);

/// The /parameter message.
std::string parameters_message(const std::vector<ParameterText>& parameters);

}  // namespace tp100::messages
