#pragma once
// What a run hears from other programs: an overhead camera's datagrams and an external world, over
// world/1 or in the paper's text files. Sockets are read in the thread of the context.

#include <chrono>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "config/configuration.h"
#include "config/world_settings.h"
#include "core/fields.h"
#include "core/sample.h"
#include "link/camera_intake.h"
#include "messages/event_queue.h"
#include "messages/sink.h"
#include "worlds/peer.h"

namespace boost::asio {
class io_context;
}

namespace tp100::live {

struct CameraFigures {
  link::CameraCounters detections{}, images{};
};

class CameraPort {
 public:
  /// Gives a sample to the step; false if it has no room.
  using Give = std::function<bool(const CameraSample&)>;
  /// Shows and records an image (JPEG) that was taken at host time `at`; must not block.
  using Show = std::function<void(HostNs at, std::string jpeg)>;

  /// Listens at settings.listen, "udp:[HOST:]PORT"; without a host, only datagrams of this machine
  /// are received. Throws UserError: a bad address, or a port that is in use. The context runs no
  /// handler while or after this is destroyed.
  CameraPort(boost::asio::io_context& context, const config::CameraSettings& settings, Give give,
             Show show);
  ~CameraPort();
  /// Stops listening.
  void stop();
  CameraFigures figures() const;

 private:
  class Socket;
  std::unique_ptr<Socket> socket_;
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

/// A run's interface to an external world.
class WorldLink : public messages::Sink {
 public:
  /// Receives nothing more; does not wait.
  virtual void stop() = 0;
  /// Waits until no file is being written; false: `deadline` passed first.
  virtual bool ended_by(std::chrono::steady_clock::time_point deadline) = 0;
  virtual WorldFigures figures() const = 0;
};

/// Opens the configured interface; null: the world is internal. `events` must outlive it; the
/// context runs no handler while or after it is destroyed. Throws UserError: a bad address, an
/// unknown host, a port that is in use, or as open_world_files().
std::unique_ptr<WorldLink> open_world(boost::asio::io_context& context, const config::WorldRun& run,
                                      const config::GiveWorld& give, messages::EventQueue& events);

/// The paper's Encoder.txt and Orientation.txt, in a thread of their own, which calls `give`; the
/// files stay. Throws UserError: a bad template, or a folder that is not writable.
std::unique_ptr<WorldLink> open_world_files(const config::WorldRun& run, config::GiveWorld give,
                                            messages::EventQueue& events);

}  // namespace tp100::live
