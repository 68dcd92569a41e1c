#include "camera/pose_stream.h"

#include <algorithm>
#include <random>

namespace tp100::camera {

PoseStream::PoseStream(const link::UdpAddress& to, int marker_id) : sender_(to) {
  message_.stream = std::random_device{}();
  message_.clock = link::monotonic_clock_name();
  message_.marker = static_cast<std::uint32_t>(marker_id);
}

void PoseStream::send(const MarkerPose& pose, std::uint32_t number, HostNs taken_ns, HostNs now) {
  message_.sequence = number;
  message_.stamp_us = std::max<HostNs>(0, taken_ns / kNsPerUs);
  message_.age_us = std::max<HostNs>(0, (now - taken_ns) / kNsPerUs);
  message_.x_m = pose.x_m;
  message_.y_m = pose.y_m;
  message_.yaw_rad = pose.yaw_rad;
  if (sender_.send(link::encode(message_))) ++sent_;
}

}  // namespace tp100::camera
