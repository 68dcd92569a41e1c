#pragma once
// A camera device (Video4Linux).

#include <opencv2/videoio.hpp>
#include <string>

#include "camera/source.h"

namespace tp100::camera {

/// When a picture was taken, monotonic clock: the driver's stamp where it is one (a monotonic time
/// within the last second before `grabbed_ns`), else the time at which it was grabbed; less the
/// configured delay. Pure.
HostNs picture_time(double driver_ms, HostNs grabbed_ns, HostNs delay_ns);

class DeviceSource : public Source {
 public:
  /// Throws SetupError: no such device, or busy, or it cannot give this size.
  DeviceSource(const std::string& device, const SourceOptions& options);
  /// False: the device is gone.
  bool next(Picture& picture) override;
  bool live() const override { return true; }

 private:
  std::string device_;
  cv::VideoCapture capture_;
  cv::Mat frame_;
  HostNs delay_ns_;
};

}  // namespace tp100::camera
