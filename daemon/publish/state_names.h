#pragma once
// Names of small enumerations as messages show them.

#include "core/sample.h"
#include "core/slope.h"

namespace tp100::publish {

inline const char* name_of(RobotState state) {
  switch (state) {
    case RobotState::kHello:
      return "hello";
    case RobotState::kParameters:
      return "parameters";
    case RobotState::kDisarmed:
      return "disarmed";
    case RobotState::kArmed:
      return "armed";
    case RobotState::kRunning:
      return "running";
    case RobotState::kFaulted:
      return "faulted";
  }
  return "unknown";
}

inline const char* name_of(Slope slope) {
  switch (slope) {
    case Slope::kFlat:
      return "flat";
    case Slope::kUp:
      return "up";
    case Slope::kDown:
      return "down";
  }
  return "unknown";
}

}  // namespace tp100::publish
