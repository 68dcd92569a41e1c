#include "bridge/parameters.h"

#include <cmath>

namespace tp100::bridge {
namespace {

double* field(LiveParameter parameter, control::Parameters& control) {
  switch (parameter) {
    case LiveParameter::kPreview:
      return &control.preview_s;
    case LiveParameter::kCrossTrackGain:
      return &control.cross_track_gain_1ps;
    case LiveParameter::kMaxApproach:
      return &control.max_approach_rad;
    case LiveParameter::kAcceleration:
      return &control.acceleration_mps2;
    case LiveParameter::kMinSpeed:
      return &control.min_speed_mps;
    case LiveParameter::kPivotRate:
      return &control.pivot_rate_radps;
    case LiveParameter::kPivotAcceleration:
      return &control.pivot_acceleration_radps2;
    case LiveParameter::kSteering:
      break;
  }
  return nullptr;
}

}  // namespace

bool apply(const ParameterChange& change, bool under_way, Parameters& parameters) {
  if (!std::isfinite(change.value) || change.value < 0.0) return false;
  if (change.parameter == LiveParameter::kSteering) {
    for (const PoseSource steering : kPoseSources) {
      if (under_way || change.value != static_cast<double>(steering)) continue;
      parameters.steering = steering;
      return true;
    }
    return false;
  }
  double* const value = field(change.parameter, parameters.control);
  if (value == nullptr) return false;
  *value = change.value;
  return true;
}

StepInputs::Changes live_values(const Parameters& parameters) {
  control::Parameters control = parameters.control;
  StepInputs::Changes values;
  for (std::size_t i = 0; i < kLiveParameters; ++i) {
    const auto parameter = static_cast<LiveParameter>(i);
    const double* const value = field(parameter, control);
    values.push({parameter, value == nullptr ? static_cast<double>(parameters.steering) : *value});
  }
  return values;
}

}  // namespace tp100::bridge
