#pragma once
// Every key of configuration and robot as viewers see it.

#include <optional>
#include <vector>

#include "app/configuration.h"
#include "core/parameter_change.h"
#include "publish/parameter_text.h"

namespace tp100::app {

std::vector<publish::ParameterText> parameter_list(const Configuration& configuration,
                                                   const course::Robot& robot);

/// The change of the step that gives a live parameter this value; nothing if it is not live.
std::optional<ParameterChange> change_for(const publish::ParameterText& parameter,
                                          const publish::ParameterValue& value);

}  // namespace tp100::app
