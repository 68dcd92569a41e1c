#pragma once
// The interfaces of a run to an external world: world/1 and text files.

#include <memory>
#include <optional>
#include <string>

#include "config/world_settings.h"
#include "live/udp_ports.h"
#include "live/world_files.h"
#include "messages/sink.h"

namespace tp100::live {

/// Figures of a run; unused interfaces are absent.
struct WorldFigures {
  std::string name;  ///< name of the kind
  std::optional<worlds::PeerCounters> udp;
  std::uint64_t strangers = 0;
  std::optional<WorldFileCounters> files;
};

class LiveWorld : public messages::Sink {
 public:
  /// Opens the configured interfaces, if any. Throws SetupError.
  LiveWorld(boost::asio::io_context& context, const config::WorldRun& run,
            const config::GiveWorld& give);

  void take(const StepRecord& record) override;
  void stop();
  /// Waits until no file is being written; false: `deadline` passed first.
  bool ended_by(std::chrono::steady_clock::time_point deadline);
  /// A line to log since the last call, or empty.
  std::string take_note();
  WorldFigures figures() const;

 private:
  std::string kind_;
  std::unique_ptr<WorldPort> port_;
  std::unique_ptr<WorldFiles> files_;
};

}  // namespace tp100::live
