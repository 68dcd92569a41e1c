#pragma once
// The socket over which world/1 is spoken, in the thread of the context. Asio stays in the source
// file.

#include <memory>
#include <string>

#include "config/world_run.h"
#include "messages/sink.h"

namespace boost::asio {
class io_context;
}

namespace tp100::live {

class WorldPort : public messages::Sink {
 public:
  /// Begins with hello at the first step. Throws SetupError: no address, a host that is not known,
  /// a port that is busy.
  WorldPort(boost::asio::io_context& context, const config::WorldRun& run, config::GiveWorld give);
  ~WorldPort() override;

  void take(const StepRecord& record) override;
  /// Stops listening.
  void stop();
  /// Something to log since the last call, or empty.
  std::string take_note();
  const worlds::PeerCounters& counters() const;
  /// Datagrams from other machines than the world's.
  std::uint64_t strangers() const;

 private:
  struct State;
  std::shared_ptr<State> state_;
};

}  // namespace tp100::live
