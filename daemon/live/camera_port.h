#pragma once
// The socket on which an overhead camera is heard, in the thread of the context. Asio stays in the
// source file.

#include <functional>
#include <memory>

#include "config/configuration.h"
#include "core/camera_sample.h"
#include "link/camera_intake.h"

namespace boost::asio {
class io_context;
}

namespace tp100::live {

class CameraPort {
 public:
  /// Gives a sample to the step; false if it has no room.
  using Give = std::function<bool(const CameraSample&)>;

  /// Listens at settings.listen, "udp:[HOST:]PORT"; without a host only this machine is heard.
  /// Throws SetupError: no address, or a port that is busy.
  CameraPort(boost::asio::io_context& context, const config::CameraSettings& settings, Give give);
  ~CameraPort();
  /// Stops listening.
  void stop();
  const link::CameraCounters& counters() const;

 private:
  struct State;
  std::shared_ptr<State> state_;
};

}  // namespace tp100::live
