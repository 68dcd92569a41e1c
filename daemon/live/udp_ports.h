#pragma once
// The sockets on which a run receives datagrams, in the thread of the context: a camera's
// and an external world's (world/1). Asio stays in the source file.

#include <functional>
#include <memory>
#include <string>

#include "config/configuration.h"
#include "config/world_settings.h"
#include "core/sample.h"
#include "link/camera_intake.h"
#include "live/world_link.h"

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
  /// are received. Throws UserError: a bad address, or a port that is in use.
  CameraPort(boost::asio::io_context& context, const config::CameraSettings& settings, Give give,
             Show show);
  ~CameraPort();
  /// Stops listening.
  void stop();
  CameraFigures figures() const;

 private:
  struct State;
  std::shared_ptr<State> state_;
};

class WorldPort : public WorldLink {
 public:
  /// Sends hello at the first step; `events` must outlive it. Throws UserError: a bad address, an
  /// unknown host, or a port that is in use.
  WorldPort(boost::asio::io_context& context, const config::WorldRun& run, config::GiveWorld give,
            messages::EventQueue& events);
  ~WorldPort() override;

  void take(const StepRecord& record) override;
  void stop() override;
  bool ended_by(std::chrono::steady_clock::time_point) override { return true; }
  WorldFigures figures() const override;

 private:
  struct State;
  std::shared_ptr<State> state_;
};

}  // namespace tp100::live
