#include "camera/picture_gaps.h"

#include <algorithm>
#include <cmath>

namespace tp100::camera {
namespace {

// A pause is a pause; the number stays far from its end.
constexpr double kMostAtOnce = 1e5;

}  // namespace

HostNs PictureGaps::usual_ns() const {
  if (count_ < kKnown) return 0;
  std::array<HostNs, kRemembered> sorted = intervals_;
  const auto end = sorted.begin() + static_cast<std::ptrdiff_t>(std::min(count_, kRemembered));
  const auto half = sorted.begin() + (end - sorted.begin()) / 2;
  std::nth_element(sorted.begin(), half, end);
  return *half;
}

std::optional<std::uint32_t> PictureGaps::number(HostNs taken_ns) {
  if (number_ == 0) {
    last_ns_ = taken_ns;
    return ++number_;
  }
  const HostNs interval_ns = taken_ns - last_ns_;
  if (interval_ns <= 0) return {};
  const HostNs usual = usual_ns();
  if (usual > 0) {
    const double periods = static_cast<double>(interval_ns) / static_cast<double>(usual);
    const double dropped = std::clamp(std::round(periods) - 1.0, 0.0, kMostAtOnce);
    number_ += static_cast<std::uint32_t>(dropped);
    missing_ += static_cast<std::uint64_t>(dropped);
  }
  intervals_[count_ % kRemembered] = interval_ns;
  ++count_;
  last_ns_ = taken_ns;
  return ++number_;
}

}  // namespace tp100::camera
