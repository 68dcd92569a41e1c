#include "camera/device_source.h"

#include <opencv2/imgproc.hpp>

#include "camera/quiet.h"
#include "core/clock.h"
#include "core/error.h"

namespace tp100::camera {

HostNs picture_time(double driver_ms, HostNs grabbed_ns, HostNs delay_ns) {
  const double age_ms = static_cast<double>(grabbed_ns) * 1e-6 - driver_ms;
  const bool plausible = driver_ms > 0.0 && age_ms >= 0.0 && age_ms < 1000.0;
  return (plausible ? from_s(driver_ms * 1e-3) : grabbed_ns) - delay_ns;
}

DeviceSource::DeviceSource(const std::string& device, const SourceOptions& options)
    : device_(device), delay_ns_(from_s(options.delay_s)) {
  bool open = false;
  try {
    const Quiet quiet;
    open = capture_.open(device, cv::CAP_V4L2);
  } catch (const cv::Exception&) {
  }
  if (!open)
    throw SetupError(device +
                     ": cannot be opened as a camera; check that it is there, that you may read it "
                     "(group video) and that no other program has it");
  // Uncompressed pictures of this size do not fit through USB 2 at 30 a second.
  capture_.set(cv::CAP_PROP_FOURCC, cv::VideoWriter::fourcc('M', 'J', 'P', 'G'));
  if (options.width_px > 0) {
    capture_.set(cv::CAP_PROP_FRAME_WIDTH, options.width_px);
    capture_.set(cv::CAP_PROP_FRAME_HEIGHT, options.height_px);
  }
  if (options.fps) capture_.set(cv::CAP_PROP_FPS, *options.fps);
}

bool DeviceSource::next(Picture& picture) {
  try {
    if (!capture_.grab()) return false;
    const HostNs grabbed_ns = monotonic_now();
    const double driver_ms = capture_.get(cv::CAP_PROP_POS_MSEC);
    if (!capture_.retrieve(frame_) || frame_.empty()) return false;
    if (frame_.channels() != 1)
      cv::cvtColor(frame_, picture.grey, cv::COLOR_BGR2GRAY);
    else
      picture.grey = frame_;
    picture.taken_ns = picture_time(driver_ms, grabbed_ns, delay_ns_);
  } catch (const cv::Exception&) {
    return false;
  }
  return true;
}

}  // namespace tp100::camera
