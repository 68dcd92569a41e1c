#pragma once
// Detections as datagrams (link/camera_message.h).

#include "camera/marker_pose.h"
#include "core/time.h"
#include "link/camera_message.h"
#include "link/udp.h"

namespace tp100::camera {

class PoseStream {
 public:
  /// Throws SetupError.
  PoseStream(const link::UdpAddress& to, int marker_id);

  /// Sends the pose of picture `number`, taken at `taken_ns`, now: both monotonic clock.
  void send(const MarkerPose& pose, std::uint32_t number, HostNs taken_ns, HostNs now);
  std::uint64_t sent() const { return sent_; }

 private:
  link::UdpSender sender_;
  link::CameraMessage message_{};
  std::uint64_t sent_ = 0;
};

}  // namespace tp100::camera
