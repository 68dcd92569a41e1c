#pragma once
// Sends images to be shown to people, beside the poses (link/camera_message.h).

#include <cstdint>
#include <opencv2/core.hpp>
#include <string>

#include "camera/view.h"
#include "core/time.h"
#include "link/udp.h"

namespace tp100::camera {

class ImageSender {
 public:
  /// Throws UserError.
  ImageSender(const link::UdpAddress& to, const ImageStream& settings);

  /// Sends an image that was taken at `taken_ns` (monotonic clock), unless the last one is too
  /// recent. It is reduced and compressed until it fits into a datagram.
  void send(const cv::Mat& shown, HostNs taken_ns);
  std::uint64_t sent() const { return sent_; }

 private:
  link::UdpSender sender_;
  ImageStream settings_;
  std::string clock_;
  std::uint32_t stream_;
  std::uint32_t sent_ = 0;
  HostNs due_ns_ = 0;
};

}  // namespace tp100::camera
