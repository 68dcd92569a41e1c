#pragma once
// tp100-camera SOURCE: detects the robot in every image, sends its pose, and some of the images.

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>

#include "camera/source.h"
#include "core/time.h"

namespace tp100::camera {

/// Numbers images, including those that a camera dropped. Detects dropped images by their times:
/// the usual interval is the median of the last ones, and an interval near a multiple of it has
/// images missing. Detects none before kKnown intervals.
class ImageGaps {
 public:
  static constexpr std::size_t kKnown = 4;

  /// Number of the image taken at `taken_ns`, from 1, counting the missing ones before it. Nothing
  /// for an image that is not newer than the previous one.
  std::optional<std::uint32_t> number(HostNs taken_ns);
  std::uint64_t missing() const { return missing_; }

 private:
  HostNs usual_ns() const;

  static constexpr std::size_t kRemembered = 15;
  std::array<HostNs, kRemembered> intervals_{};
  std::size_t count_ = 0;
  HostNs last_ns_ = 0;
  std::uint32_t number_ = 0;
  std::uint64_t missing_ = 0;
};

struct WatchOptions {
  std::string source;
  std::string view;  ///< view file; empty: images are sent, no poses
  std::string send;  ///< "udp:[HOST:]PORT"; empty: send nothing
  std::string tum;   ///< file; empty: none
  SourceOptions images{};
};

/// Runs to the end of a recording, or until SIGINT or SIGTERM. With `send`, a recording is played
/// in real time, beginning now. Returns the exit status: 0, or 1 if no image shows the marker or
/// the device is gone. Throws UserError; the TUM file then has the poses found so far.
int watch(const WatchOptions& options);

}  // namespace tp100::camera
