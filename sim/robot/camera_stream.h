#pragma once
// The emulated overhead camera on the network: the datagrams that tp100-camera would send.

#include <cstdint>
#include <string>

#include "link/camera_message.h"
#include "link/udp.h"
#include "sim/sensors/overhead_camera.h"

namespace tp100::sim {

class CameraStream {
 public:
  /// Throws SetupError.
  CameraStream(const OverheadCamera& camera, const link::UdpAddress& to, std::uint64_t seed);

  /// Call once per physics step with the body's exact pose. `virtual_ns` is the camera's time,
  /// which began at `begin_ns` of the monotonic clock. Never waits.
  void look(const Pose& truth, std::int64_t virtual_ns, std::int64_t begin_ns,
            std::int64_t monotonic_ns);

 private:
  OverheadCamera camera_;
  link::UdpSender sender_;
  link::CameraMessage message_{};
};

}  // namespace tp100::sim
