// Fuzzes what nodes of ROS 2 send: the first byte chooses the topic, the rest is the message.

#include <cmath>

#include "byte_source.h"
#include "ros2/inputs.h"

using namespace tp100;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  fuzz::ByteSource source(data, size);
  ros2::Received received;
  received.input = static_cast<ros2::Input>(source.u8() % ros2::kInputCount);
  received.written_ns = kNsPerS;
  received.cdr = source.bytes(size);
  std::string why;
  if (const auto wanted = ros2::read_velocity(received, why))
    fuzz::require(std::abs(wanted->speed_mps) <= 100.0 &&
                      std::abs(wanted->yaw_rate_radps) <= 100.0 && wanted->stamp_ns > 0,
                  "a velocity is finite and dated");
  if (const auto at = ros2::read_pose(received, why))
    fuzz::require(
        std::abs(at->x_m) <= 100.0 && std::abs(at->y_m) <= 100.0 && std::isfinite(at->yaw_rad),
        "a pose is finite");
  if (const auto course = ros2::read_course(received, why))
    fuzz::require(!course->name.empty() && course->name.size() <= 64,
                  "a name is no longer than a file's");
  ros2::read_drive(received, why);
  return 0;
}
