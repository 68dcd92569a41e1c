// Fuzzes the decoders for datagrams of a camera: detections and images.

#include <cmath>

#include "byte_source.h"
#include "link/camera_intake.h"
#include "link/camera_message.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using tp100::fuzz::require;
  const std::string_view datagram(reinterpret_cast<const char*>(data), size);
  if (const auto image = tp100::link::decode_image(datagram)) {
    require(image->jpeg.size() < datagram.size(), "an image is part of its datagram");
    const std::string again = tp100::link::encode(*image);
    require(tp100::link::decode_image(again).has_value(), "an image comes back as it was");
  }
  const auto message = tp100::link::decode_camera(datagram);
  if (!message) return 0;
  require(
      std::isfinite(message->x_m) && std::isfinite(message->y_m) && std::isfinite(message->yaw_rad),
      "poses are finite");
  const std::string again = tp100::link::encode(*message);
  const auto reread = tp100::link::decode_camera(again);
  require(reread.has_value() && tp100::link::encode(*reread) == again,
          "a datagram comes back as it was");
  return 0;
}
