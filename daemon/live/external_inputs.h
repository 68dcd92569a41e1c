#pragma once
// What a run hears from other programs: an overhead camera's datagrams and an external world, over
// world/1 or in the paper's text files. Sockets are read in the thread of the context.

#include <chrono>
#include <cstdint>
#include <memory>
#include <optional>

#include "config/run_setup.h"
#include "core/fields.h"
#include "link/camera_intake.h"
#include "live/live_cycle.h"
#include "messages/event_queue.h"
#include "messages/sink.h"
#include "worlds/peer.h"

namespace boost::asio {
class io_context;
}
namespace tp100::server {
class Server;
}

namespace tp100::live {

struct CameraFigures {
  link::CameraCounters detections{}, images{};
};

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

struct InputFigures {
  std::optional<CameraFigures> camera{};  ///< nothing: none is configured
  WorldFigures world{};
};

/// A run's interface to an external world.
class WorldLink : public messages::Sink {
 public:
  /// Receives nothing more; does not wait.
  virtual void stop() = 0;
  /// Waits until no file is being written; false: `deadline` passed first.
  virtual bool ended_by(std::chrono::steady_clock::time_point deadline) = 0;
  virtual WorldFigures figures() const = 0;
};

/// The paper's Encoder.txt and Orientation.txt, in a thread of their own, which calls `give`; the
/// files stay. Throws UserError: a bad template, or a folder that is not writable.
std::unique_ptr<WorldLink> open_world_files(const config::WorldRun& run, config::GiveWorld give,
                                            messages::EventQueue& events);

/// Both: samples go to `cycle`, a camera's images to `server`. One thread.
class ExternalInputs : public messages::Sink {
 public:
  /// Opens what is configured. All must outlive it; the context runs no handler while or after it
  /// is destroyed. Throws UserError: a bad address, an unknown host, a port that is in use, or as
  /// open_world_files().
  ExternalInputs(boost::asio::io_context& context, const config::RunSetup& run, LiveCycle& cycle,
                 server::Server& server, messages::EventQueue& events);
  ~ExternalInputs() override;

  void take(const StepRecord& record) override {
    if (world_ != nullptr) world_->take(record);
  }
  /// Receives nothing more; does not wait.
  void stop();
  /// As WorldLink::ended_by().
  bool ended_by(std::chrono::steady_clock::time_point deadline) {
    return world_ == nullptr || world_->ended_by(deadline);
  }
  InputFigures figures() const;

 private:
  class CameraPort;
  std::unique_ptr<CameraPort> camera_;
  std::unique_ptr<WorldLink> world_;  // null: internal
};

}  // namespace tp100::live
