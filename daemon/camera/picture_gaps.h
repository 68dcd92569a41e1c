#pragma once
// Numbers of pictures, with those that a camera dropped.

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>

#include "core/time.h"

namespace tp100::camera {

/// Finds dropped pictures by their times: the usual interval is the median of the last ones, and an
/// interval near a multiple of it has pictures missing. Nothing is known before kKnown intervals.
class PictureGaps {
 public:
  static constexpr std::size_t kKnown = 4;

  /// Number of the picture taken at `taken_ns`, from 1, counting the missing ones before it.
  /// Nothing for a picture that is not newer than the one before.
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

}  // namespace tp100::camera
