#include "link/belt_count.h"

#include <cmath>

namespace tp100::link {
namespace {

// Edges of one sample that an interrupt put into the next.
constexpr double kSlackCounts = 4.0;
// After a longer gap nobody knows whether the belt went on.
constexpr double kLongestHoldS = 0.1;

}  // namespace

bool BeltCount::update(std::int32_t value, double dt_s) {
  if (!known_) {
    known_ = true;
    counts_ = last_ = value;
    per_s_ = 0.0;
    held_in_row_ = 0;
    return true;
  }
  const auto step = static_cast<std::int32_t>(static_cast<std::uint32_t>(value) -
                                              static_cast<std::uint32_t>(last_));
  last_ = value;
  const bool possible = max_per_s_ <= 0.0 || dt_s <= 0.0 ||
                        std::abs(static_cast<double>(step)) <= max_per_s_ * dt_s + kSlackCounts;
  if (possible) held_in_row_ = 0;
  if (!possible && held_in_row_ < kHeldInRow) {
    ++held_in_row_;
    if (dt_s <= kLongestHoldS) counts_ += std::llround(per_s_ * dt_s);
    return false;
  }
  counts_ += step;
  if (dt_s > 0.0) per_s_ = static_cast<double>(step) / dt_s;
  return true;
}

}  // namespace tp100::link
