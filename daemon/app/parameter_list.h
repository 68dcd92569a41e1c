#pragma once
// Every key of configuration and robot as viewers see it.

#include <vector>

#include "app/configuration.h"
#include "publish/parameter_text.h"

namespace tp100::app {

std::vector<publish::ParameterText> parameter_list(const Configuration& configuration,
                                                   const course::Robot& robot);

}  // namespace tp100::app
