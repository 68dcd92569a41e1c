#include "camera/image_sender.h"

#include <algorithm>
#include <cmath>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>
#include <random>
#include <vector>

#include "core/clock.h"
#include "link/camera_message.h"

namespace tp100::camera {
namespace {

constexpr int kMaxHeight = 1080;
// JPEG qualities, from good to hardly useful.
constexpr int kQualities[] = {80, 60, 40, 20};
constexpr std::size_t kHeadBytes = 512;

cv::Mat reduced(const cv::Mat& image, int width_px) {
  const double scale = std::min({1.0, static_cast<double>(width_px) / image.cols,
                                 static_cast<double>(kMaxHeight) / image.rows});
  if (scale == 1.0) return image;
  const auto side = [scale](int px) {
    return std::max(1, static_cast<int>(std::lround(px * scale)));
  };
  cv::Mat out;
  cv::resize(image, out, {side(image.cols), side(image.rows)}, 0.0, 0.0, cv::INTER_AREA);
  return out;
}

}  // namespace

ImageSender::ImageSender(const link::UdpAddress& to, const ImageStream& settings)
    : sender_(to),
      settings_(settings),
      clock_(link::monotonic_clock_name()),
      stream_(std::random_device{}()) {}

void ImageSender::send(const cv::Mat& shown, HostNs taken_ns) {
  if (taken_ns < due_ns_) return;
  // Less than the period, because a camera's times jitter and a due image may come a little early.
  due_ns_ = taken_ns + from_s(0.9 / settings_.rate_hz);
  const cv::Mat image = reduced(shown, settings_.width_px);
  std::vector<unsigned char> jpeg;
  for (const int quality : kQualities) {
    cv::imencode(".jpg", image, jpeg, {cv::IMWRITE_JPEG_QUALITY, quality});
    if (jpeg.size() + kHeadBytes <= link::kMaxImageDatagram) break;
  }
  if (jpeg.size() + kHeadBytes > link::kMaxImageDatagram) return;
  sender_.send(link::encode(
      link::ImageMessage{.stream = stream_,
                         .clock = clock_,
                         .sequence = ++sent_,
                         .stamp_us = std::max<HostNs>(0, taken_ns / kNsPerUs),
                         .age_us = std::max<HostNs>(0, (monotonic_now() - taken_ns) / kNsPerUs),
                         .jpeg = {reinterpret_cast<const char*>(jpeg.data()), jpeg.size()}}));
}

}  // namespace tp100::camera
