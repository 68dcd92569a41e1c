#pragma once
// A parameter that changes while the bridge runs: an input of the step like any other, so that a
// recording replays it.

#include <cstdint>

namespace tp100 {

/// What can change. The values stay as they are: recordings hold them.
enum class LiveParameter : std::uint8_t {
  kSteering = 0,  ///< a Steering; ignored during a run
  kPreview = 1,
  kCrossTrackGain = 2,
  kMaxApproach = 3,
  kAcceleration = 4,
  kMinSpeed = 5,
  kPivotRate = 6,
  kPivotAcceleration = 7,
};

struct ParameterChange {
  LiveParameter parameter = LiveParameter::kSteering;
  double value = 0.0;  ///< SI
};

}  // namespace tp100
