#pragma once
// Everything of a run that talks to an external world: world/1, text files, Live Link.

#include <memory>
#include <optional>
#include <string>

#include "config/world_run.h"
#include "live/world_files.h"
#include "live/world_port.h"
#include "messages/sink.h"

namespace tp100::live {

/// For the figures of a run; what is not in use is absent.
struct WorldFigures {
  std::string name;  ///< of the kind
  std::optional<worlds::PeerCounters> udp;
  std::uint64_t strangers = 0;
  std::optional<WorldFileCounters> files;
};

class LiveWorld : public messages::Sink {
 public:
  /// Opens what the run asks for, which may be nothing. Throws SetupError.
  LiveWorld(boost::asio::io_context& context, const config::WorldRun& run,
            const config::GiveWorld& give);
  ~LiveWorld() override;

  void take(const StepRecord& record) override;
  void stop();
  /// Waits until no file is written any more; false: not before `deadline`.
  bool ended_by(std::chrono::steady_clock::time_point deadline);
  /// Something to log since the last call, or empty.
  std::string take_note();
  WorldFigures figures() const;

 private:
  struct LiveLink;
  std::string kind_;
  std::unique_ptr<WorldPort> port_;
  std::unique_ptr<WorldFiles> files_;
  std::unique_ptr<LiveLink> live_link_;
};

}  // namespace tp100::live
