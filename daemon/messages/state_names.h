#pragma once
// Names of small enumerations as messages show them.

#include "core/sample.h"
#include "core/slope.h"
#include "core/underfoot.h"

namespace tp100::messages {

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

inline const char* name_of(PitchSource source) {
  switch (source) {
    case PitchSource::kVirtual:
      return "virtual";
    case PitchSource::kImu:
      return "imu";
    case PitchSource::kExternal:
      return "external";
  }
  return "unknown";
}

inline const char* name_of(Obstacle obstacle) {
  switch (obstacle) {
    case Obstacle::kNone:
      return "none";
    case Obstacle::kRamp:
      return "ramp";
    case Obstacle::kBlock:
      return "block";
  }
  return "unknown";
}

inline const char* name_of(Traction traction) {
  switch (traction) {
    case Traction::kGripping:
      return "gripping";
    case Traction::kSlipping:
      return "slipping";
    case Traction::kImmobilised:
      return "immobilised";
  }
  return "unknown";
}

}  // namespace tp100::messages
