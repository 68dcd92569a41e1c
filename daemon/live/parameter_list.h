#pragma once
// Every key of configuration and robot as viewers see it.

#include <optional>
#include <vector>

#include "config/configuration.h"
#include "core/parameter_change.h"
#include "messages/parameter_text.h"

namespace tp100::live {

std::vector<messages::ParameterText> parameter_list(const config::Configuration& configuration,
                                                    const course::Robot& robot);

/// The change of the step that gives a live parameter this value; nothing if it is not live.
std::optional<ParameterChange> change_for(const messages::ParameterText& parameter,
                                          const messages::ParameterValue& value);

}  // namespace tp100::live
