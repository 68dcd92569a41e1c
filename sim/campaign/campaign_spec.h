#pragma once
// A campaign as its file says it: how many runs, and what differs between them.

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "sim/campaign/variable.h"
#include "sim/robot/options.h"

namespace tp100::sim {

/// One run, everything decided.
struct PlannedRun {
  std::uint64_t index = 0;
  Options options{};
  std::string course;
  std::string camera;               ///< empty: nobody looks on
  std::vector<std::string> faults;  ///< as --fault has them
  text::NamedValues drawn;          ///< what differs from run to run
};

/// The file: config/campaigns/course-3.toml is one, with every key explained.
struct CampaignSpec {
  std::uint64_t runs = 0;
  std::uint64_t seed = 1;         ///< run i has the seed `seed` + i
  std::string config;             ///< configuration that the values are changed in; empty: defaults
  std::vector<Variable> choices;  ///< board, camera, course, faults, robot, setup
  std::vector<Variable> configuration;  ///< keys of tp100.toml
  std::vector<Variable> robot;          ///< keys of the robot's file
};

/// Throws SetupError (file:line:column). Pure.
CampaignSpec parse_campaign(const std::string& text, const std::string& file);

/// Run `index` of the campaign. Lists are crossed: the first in alphabetical order changes with
/// every run, the next when it has been through, and so on. Pure.
PlannedRun plan(const CampaignSpec& spec, std::uint64_t index);

}  // namespace tp100::sim
