#pragma once
// Connection to an external world. Whether there is one, and which side owns the pose, is in
// bridge::WorldParameters.

#include <functional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "bridge/parameters.h"
#include "core/sample.h"
#include "text/key.h"
#include "worlds/frame.h"
#include "worlds/message.h"
#include "worlds/peer.h"

namespace tp100::config {

struct WorldSettings {
  worlds::Frame frame = worlds::Frame::kRos;   ///< of every message and file
  double rate_hz = 100.0;                      ///< poses and files per second
  std::string address = "udp:127.0.0.1:9760";  ///< udp: where the world listens
  std::string listen;                          ///< "udp:[HOST:]PORT"; empty: any free port
  std::string encoder_file = "Encoder.txt";    ///< files: written
  std::string encoder_template = "{seq} {t_s} {left} {right}";
  std::string orientation_file = "Orientation.txt";  ///< files: read
};

// Data of a run for the interfaces to an external world.

struct WorldRun {
  bridge::WorldParameters parameters{};
  WorldSettings settings{};
  std::string version;  ///< of this program
  std::string course;
  std::string setup;
  std::vector<std::pair<std::string, double>> surfaces;  ///< of the course, with their slip
};

/// Settings of the protocol. `session`: an unguessable number. Pure.
worlds::PeerSettings peer_settings(const WorldRun& run, std::uint32_t session, bool lockstep);

/// Passes a world's sample to the step; false if its queue is full.
using GiveWorld = std::function<bool(const WorldSample&)>;

// The keys of the configuration's [world].

std::span<const text::Key<bridge::WorldParameters>> world_keys();
std::span<const text::Key<WorldSettings>> world_stream_keys();

}  // namespace tp100::config
