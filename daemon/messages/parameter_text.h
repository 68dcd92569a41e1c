#pragma once
// A parameter as published to viewers.

#include <string>
#include <vector>

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

/// Why `value` is not allowed for that parameter; empty if it is: right type, finite, in range.
std::string why_not(const ParameterText& parameter, const ParameterValue& value);

/// The /parameter message.
std::string parameters_message(const std::vector<ParameterText>& parameters);

}  // namespace tp100::messages
