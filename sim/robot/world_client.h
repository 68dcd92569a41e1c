#pragma once
// The external world of a run in virtual time: the run waits for the answer to every pose, so that
// the numbers are the same however slow the world is.

#include <netinet/in.h>

#include <array>
#include <chrono>
#include <cstdint>
#include <functional>

#include "config/world_settings.h"
#include "core/descriptor.h"
#include "core/step_record.h"
#include "worlds/peer.h"

namespace tp100::sim {

class WorldClient {
 public:
  using Take = std::function<void(const WorldSample&)>;

  /// Finds the world at run.settings.address and waits for its welcome, five seconds at most.
  /// `session` is the first session number. Throws UserError.
  WorldClient(const config::WorldRun& run, std::uint32_t session);

  /// After a step at virtual time `now`: sends the pose, if one is due, and waits for the matching
  /// answer. If the world takes more than five seconds of real time, later answers are not awaited.
  void exchange(const StepRecord& record, HostNs now, const Take& take);

  /// True if the world once failed to answer in time; later answers were not awaited.
  bool silent() const { return !waits_; }
  const worlds::PeerCounters& counters() const { return peer_.counters(); }

 private:
  using Clock = std::chrono::steady_clock;

  void greet();
  void send(const std::string& datagram);
  /// Receives one datagram of the world. False: none arrived before `deadline`.
  bool receive(HostNs now, Clock::time_point deadline, const Take& take);

  worlds::Peer peer_;
  sockaddr_in world_{};
  Descriptor socket_;
  bool waits_ = true;
  // One byte more than a datagram may have, so that a longer one is detected.
  std::array<char, worlds::kMaxWorldDatagram + 1> buffer_{};
};

}  // namespace tp100::sim
