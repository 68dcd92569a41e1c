#include "link/belt_count.h"

#include <algorithm>
#include <cmath>

#include "core/belt_speed.h"
#include "core/time.h"

namespace tp100::link {
namespace {

// After a longer gap nobody knows whether the belt went on.
constexpr double kLongestHoldS = 0.1;
// A glitch and its return are one jump.
constexpr double kOneJumpS = 0.1;

}  // namespace

bool BeltCount::update(std::int32_t value, double dt_s) {
  if (!known_) {
    known_ = true;
    counts_ = last_ = value;
    per_s_ = 0.0;
    held_in_row_ = 0;
    since_jump_s_ = kForgottenS;
    return true;
  }
  const std::int32_t step =
      wrapped_difference(static_cast<std::uint32_t>(value), static_cast<std::uint32_t>(last_));
  last_ = value;
  const bool possible = counts_possible(step, max_per_s_, dt_s);
  since_jump_s_ += std::max(dt_s, 0.0);
  if (possible) held_in_row_ = 0;
  const bool again = since_jump_s_ >= kOneJumpS && since_jump_s_ < kForgottenS;
  if (!possible && !again && held_in_row_ < kHeldInRow) {
    if (since_jump_s_ >= kForgottenS) since_jump_s_ = 0.0;
    ++held_in_row_;
    if (dt_s <= kLongestHoldS) counts_ += std::llround(per_s_ * dt_s);
    return false;
  }
  counts_ += step;
  if (dt_s > 0.0) per_s_ = static_cast<double>(step) / dt_s;
  return true;
}

}  // namespace tp100::link
