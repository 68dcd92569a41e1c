#pragma once
// The interface of a run to an external world: world/1 or text files.

#include <chrono>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>

#include "config/world_settings.h"
#include "core/fields.h"
#include "messages/event_queue.h"
#include "messages/sink.h"
#include "worlds/peer.h"

namespace boost::asio {
class io_context;
}

namespace tp100::live {

/// What happened to the files since the start.
struct WorldFileCounters {
  std::uint64_t written = 0;
  std::uint64_t write_errors = 0;
  std::uint64_t read = 0;      ///< changed and valid: passed to the step
  std::uint64_t rejected = 0;  ///< changed, but incomplete, not numeric or out of range
  std::uint64_t dropped = 0;   ///< valid, but the step's queue was full
};
TP100_FIELDS(WorldFileCounters, written, write_errors, read, rejected, dropped)

/// Figures of a run; those of the interface that is not in use are absent.
struct WorldFigures {
  std::optional<worlds::PeerCounters> udp{};
  std::uint64_t strangers = 0;  ///< datagrams from other machines than the world's
  std::optional<WorldFileCounters> files{};
};

class WorldLink : public messages::Sink {
 public:
  /// Receives nothing more; does not wait.
  virtual void stop() = 0;
  /// Waits until no file is being written; false: `deadline` passed first.
  virtual bool ended_by(std::chrono::steady_clock::time_point deadline) = 0;
  virtual WorldFigures figures() const = 0;
};

/// Opens the configured interface; null: the world is internal. `events` must outlive it. Throws
/// UserError.
std::unique_ptr<WorldLink> open_world(boost::asio::io_context& context, const config::WorldRun& run,
                                      const config::GiveWorld& give, messages::EventQueue& events);

}  // namespace tp100::live
