#pragma once
// What the parts that talk to an external world need to know of a run.

#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "config/configuration.h"
#include "core/world_sample.h"
#include "worlds/peer.h"

namespace tp100::config {

struct WorldRun {
  bridge::WorldParameters parameters{};
  WorldSettings settings{};
  std::string version;  ///< of this program
  std::string course;
  std::string setup;
  std::vector<std::pair<std::string, double>> surfaces;  ///< of the course, with their slip
};

/// Settings of the conversation. `session`: a number that nobody can guess. Pure.
worlds::PeerSettings peer_settings(const WorldRun& run, std::uint32_t session, bool lockstep);

/// Gives what a world said to the step; false if it has no room.
using GiveWorld = std::function<bool(const WorldSample&)>;

}  // namespace tp100::config
