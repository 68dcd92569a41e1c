#pragma once
// tp100-camera SOURCE: looks for the robot in every picture and passes its pose on.

#include <string>

#include "camera/source.h"

namespace tp100::camera {

struct WatchOptions {
  std::string source;
  std::string view;  ///< view file
  std::string send;  ///< "udp:[HOST:]PORT"; empty: send nothing
  std::string tum;   ///< file; empty: none
  SourceOptions pictures{};
};

/// Runs to the end of a recording, or until SIGINT or SIGTERM. A recording that is sent is played
/// in real time: its beginning is now. Returns the exit status: 0, or 1 if no picture shows the
/// marker or the device is gone. Throws SetupError; what was found until then is in the TUM file.
int watch(const WatchOptions& options);

}  // namespace tp100::camera
