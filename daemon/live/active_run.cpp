#include "live/active_run.h"

#include <algorithm>
#include <string_view>
#include <utility>

#include "bridge/parameters.h"
#include "config/parameter_file.h"
#include "course/robot_file.h"
#include "text/key.h"

namespace tp100::live {
namespace {

using messages::ParameterText;

/// Nothing if the key is not live.
std::optional<LiveParameter> live_parameter(std::string_view name) {
  const auto key = std::ranges::find(bridge::kLiveKeys, name, &bridge::LiveKey::name);
  if (key == bridge::kLiveKeys.end()) return std::nullopt;
  return static_cast<LiveParameter>(key - bridge::kLiveKeys.begin());
}

std::vector<ParameterText> parameters_of(const config::RunSetup& run) {
  std::vector<ParameterText> out;
  for (text::KeyText& key : config::configuration_keys(run.configuration)) {
    const std::optional<LiveParameter> live = live_parameter(key.name);
    const bool only_at_standstill = live == LiveParameter::kSteering;
    const bool may_save = config::may_save(key);
    out.push_back({std::move(key), live.has_value(), only_at_standstill, may_save});
  }
  for (text::KeyText& key : course::robot_keys(run.robot)) out.push_back({std::move(key)});
  return out;
}

}  // namespace

ActiveRun::ActiveRun(config::LoadedRun run)
    : loaded(std::move(run)),
      context(config::run_context_of(loaded.setup)),
      parameters(parameters_of(loaded.setup)) {}

std::optional<ParameterChange> change_for(const ParameterText& parameter,
                                          const messages::ParameterValue& value) {
  const std::optional<LiveParameter> live = live_parameter(parameter.name);
  if (!live) return std::nullopt;
  if (const double* number = std::get_if<double>(&value))
    return ParameterChange{*live, *number * bridge::kLiveKeys[static_cast<std::size_t>(*live)].si};
  const std::string* name = std::get_if<std::string>(&value);
  const auto choice = name == nullptr
                          ? parameter.choices.end()
                          : std::find(parameter.choices.begin(), parameter.choices.end(), *name);
  if (choice == parameter.choices.end()) return std::nullopt;
  return ParameterChange{*live, static_cast<double>(choice - parameter.choices.begin())};
}

}  // namespace tp100::live
