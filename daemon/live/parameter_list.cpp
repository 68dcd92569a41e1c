#include "live/parameter_list.h"

#include <algorithm>
#include <array>
#include <string_view>
#include <utility>

#include "core/angle.h"
#include "course/robot_keys.h"

namespace tp100::live {
namespace {

using messages::ParameterText;

struct LiveKey {
  std::string_view name;
  LiveParameter parameter;
  double si = 1.0;
};
// The safety limits are not among them.
constexpr std::array<LiveKey, 8> kLiveKeys = {{
    {"estimation.steering", LiveParameter::kSteering},
    {"control.preview_s", LiveParameter::kPreview},
    {"control.cross_track_gain_1ps", LiveParameter::kCrossTrackGain},
    {"control.max_approach_deg", LiveParameter::kMaxApproach, kRadPerDeg},
    {"control.acceleration_mps2", LiveParameter::kAcceleration},
    {"control.min_speed_mps", LiveParameter::kMinSpeed},
    {"control.pivot_rate_radps", LiveParameter::kPivotRate},
    {"control.pivot_acceleration_radps2", LiveParameter::kPivotAcceleration},
}};

const LiveKey* live_key(std::string_view name) {
  for (const LiveKey& key : kLiveKeys)
    if (key.name == name) return &key;
  return nullptr;
}

}  // namespace

std::optional<ParameterChange> change_for(const ParameterText& parameter,
                                          const messages::ParameterValue& value) {
  const LiveKey* key = live_key(parameter.name);
  if (key == nullptr) return std::nullopt;
  if (const double* number = std::get_if<double>(&value))
    return ParameterChange{key->parameter, *number * key->si};
  const std::string* name = std::get_if<std::string>(&value);
  const auto choice = name == nullptr
                          ? parameter.choices.end()
                          : std::find(parameter.choices.begin(), parameter.choices.end(), *name);
  if (choice == parameter.choices.end()) return std::nullopt;
  return ParameterChange{key->parameter, static_cast<double>(choice - parameter.choices.begin())};
}

std::vector<ParameterText> parameter_list(const config::Configuration& configuration,
                                          const course::Robot& robot) {
  std::vector<text::KeyText> keys = config::configuration_keys(configuration);
  for (text::KeyText& key : course::robot_keys(robot)) keys.push_back(std::move(key));
  std::vector<ParameterText> out;
  for (text::KeyText& key : keys) {
    const LiveKey* live = live_key(key.name);
    const bool only_at_rest = live != nullptr && live->parameter == LiveParameter::kSteering;
    out.push_back({std::move(key), live != nullptr, only_at_rest});
  }
  return out;
}

}  // namespace tp100::live
