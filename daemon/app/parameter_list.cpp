#include "app/parameter_list.h"

#include <algorithm>
#include <array>
#include <string_view>
#include <utility>

#include "core/angle.h"
#include "course/robot_keys.h"

namespace tp100::app {
namespace {

using publish::ParameterText;

ParameterText::Type type_of(course::KeyText::Type type) {
  switch (type) {
    case course::KeyText::Type::kNumber:
      return ParameterText::Type::kNumber;
    case course::KeyText::Type::kInteger:
      return ParameterText::Type::kInteger;
    case course::KeyText::Type::kBoolean:
      return ParameterText::Type::kBoolean;
    case course::KeyText::Type::kText:
      return ParameterText::Type::kText;
    case course::KeyText::Type::kChoice:
      break;
  }
  return ParameterText::Type::kChoice;
}

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
                                          const publish::ParameterValue& value) {
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

std::vector<ParameterText> parameter_list(const Configuration& configuration,
                                          const course::Robot& robot) {
  std::vector<course::KeyText> keys = configuration_keys(configuration);
  for (course::KeyText& key : course::robot_keys(robot)) keys.push_back(std::move(key));
  std::vector<ParameterText> out;
  for (course::KeyText& key : keys) {
    ParameterText text;
    text.name = std::move(key.name);
    text.type = type_of(key.type);
    text.value = std::move(key.value);
    text.standard = std::move(key.standard);
    text.unit = std::move(key.unit);
    text.min = key.range.min;
    text.max = key.range.max;
    text.choices = std::move(key.choices);
    text.meaning = std::move(key.meaning);
    const LiveKey* live = live_key(text.name);
    text.live = live != nullptr;
    text.only_at_rest = text.live && live->parameter == LiveParameter::kSteering;
    out.push_back(std::move(text));
  }
  return out;
}

}  // namespace tp100::app
