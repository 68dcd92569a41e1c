#include "sim/robot/camera_stream.h"

#include <unistd.h>

#include <algorithm>

namespace tp100::sim {

CameraStream::CameraStream(const OverheadCamera& camera, const link::UdpAddress& to,
                           std::uint64_t seed)
    : camera_(camera), sender_(to) {
  // Two robots of one seed are two streams.
  message_.stream =
      static_cast<std::uint32_t>(seed * 0x9E3779B1U) ^ static_cast<std::uint32_t>(::getpid());
  message_.clock = link::monotonic_clock_name();
}

void CameraStream::look(const Pose& truth, std::int64_t virtual_ns, std::int64_t begin_ns,
                        std::int64_t monotonic_ns) {
  camera_.look(truth, virtual_ns);
  while (const auto seen = camera_.take(virtual_ns)) {
    const std::int64_t stamp_ns = begin_ns + seen->measured_ns;
    message_.sequence = seen->sequence;
    message_.stamp_us = stamp_ns / kNsPerUs;
    message_.age_us = std::max<std::int64_t>(0, (monotonic_ns - stamp_ns) / kNsPerUs);
    message_.x_m = seen->x_m;
    message_.y_m = seen->y_m;
    message_.yaw_rad = seen->yaw_rad;
    sender_.send(link::encode(message_));
  }
}

}  // namespace tp100::sim
