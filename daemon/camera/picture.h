#pragma once
// One picture and when it was taken.

#include <opencv2/core.hpp>

#include "core/time.h"

namespace tp100::camera {

struct Picture {
  cv::Mat grey;         ///< 8 bits
  HostNs taken_ns = 0;  ///< recordings: since their beginning; devices: monotonic clock
};

}  // namespace tp100::camera
