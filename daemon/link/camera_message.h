#pragma once
// The datagrams of a camera: where it saw the robot, and images to be shown to people. The only
// definition of them, for tp100-camera and the emulated camera, which send them, and for tp100d,
// which takes them. No OpenCV, no socket, no clock.
//
// A detection is one JSON object of at most kMaxCameraDatagram bytes, UTF-8, no line end needed:
//
//   {"format":"tp100-camera/1","stream":193755201,"clock":"6b0c...","sequence":412,
//    "stamp_us":81234567890,"age_us":41250,"marker":0,"x_m":1.203411,"y_m":-0.418220,
//    "yaw_rad":0.310552}
//
//   format    text     kCameraFormat; another number is another format
//   stream    integer  0 to 2^32-1, random, chosen when the sender starts: a restart is seen
//   clock     text     1 to 64 characters; names the clock of stamp_us. Clocks of one name are the
//                      same clock. On Linux: CLOCK_MONOTONIC of the boot with this
//                      /proc/sys/kernel/random/boot_id
//   sequence  integer  0 to 2^32-1, number of the image; grows. A gap is images that were
//                      dropped or that do not show the marker
//   stamp_us  integer  0 to 2^53, when the image was taken (the middle of its exposure) on that
//                      clock. Microseconds, so that readers with doubles lose nothing
//   age_us    integer  0 to 10^7, from that instant to the sending, on the same clock. A receiver
//                      on another machine subtracts it, so that only the transit time is unknown
//   marker    integer  0 to 10^6, id of the marker
//   x_m, y_m  number   -1000 to 1000, middle of the marker in the world frame (REP-103: z up), seen
//                      in the plane at the marker's height over a flat floor: see CameraSample
//   yaw_rad   number   -100 to 100, any branch: direction of the marker's top edge side, as seen in
//                      that plane; from the world's x, counterclockwise from above
//
// Every key is required; unknown ones are ignored.
//
// An image is one line of JSON, a line feed, and the image as JPEG, together at most
// kMaxImageDatagram bytes:
//
//   {"format":"tp100-image/1","stream":193755201,"clock":"6b0c...","sequence":412,
//    "stamp_us":81234567890,"age_us":41250}
//
// with these keys in the same ranges. `stream` and `sequence` count images alone: a camera that
// sends both has two streams. The JPEG is checked for its beginning, its end and at most
// kMaxImageSide pixels a side, so that no viewer decodes a huge one.

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace tp100::link {

inline constexpr std::string_view kCameraFormat = "tp100-camera/1";
inline constexpr std::string_view kImageFormat = "tp100-image/1";
inline constexpr std::size_t kMaxCameraDatagram = 1024;
/// One UDP datagram carries 65507 bytes at most.
inline constexpr std::size_t kMaxImageDatagram = 60'000;
inline constexpr int kMaxImageSide = 4096;
/// Default port to which a camera sends and on which the daemon listens.
inline constexpr std::uint16_t kCameraPort = 47100;

/// A detection. Values as above, in range.
struct CameraMessage {
  std::uint32_t stream = 0;
  std::string clock;
  std::uint32_t sequence = 0;
  std::int64_t stamp_us = 0;
  std::int64_t age_us = 0;
  std::uint32_t marker = 0;
  double x_m = 0.0;
  double y_m = 0.0;
  double yaw_rad = 0.0;
};

/// An image. `jpeg` refers to the datagram's bytes.
struct ImageMessage {
  std::uint32_t stream = 0;
  std::string clock;
  std::uint32_t sequence = 0;
  std::int64_t stamp_us = 0;
  std::int64_t age_us = 0;
  std::string_view jpeg;
};

/// Whether a datagram claims to be an image and not a detection. Accepts any bytes.
bool is_image(std::string_view datagram);

/// Encodes a datagram. Positions are rounded to a micrometre and angles to a microradian.
std::string encode(const CameraMessage& message);
std::string encode(const ImageMessage& message);

/// Decodes a datagram. Nothing if it is invalid: too long, not such JSON, with a key missing, of
/// another type or out of range, or without such a JPEG. Accepts any bytes. Allocates: not for the
/// real-time thread.
std::optional<CameraMessage> decode_camera(std::string_view datagram);
std::optional<ImageMessage> decode_image(std::string_view datagram);

}  // namespace tp100::link
