#pragma once
// How far a belt can have gone between two samples.

#include <cmath>

namespace tp100 {

/// A belt's limit, be it driven, pushed or going down a ramp, in limits of the drive.
inline constexpr double kFastestBelt = 3.0;

/// Counts of one belt in `dt_s` that can be true; `max_per_s` 0: all of them.
inline bool counts_possible(double counts, double max_per_s, double dt_s) {
  // Edges of one sample that an interrupt put into the next.
  constexpr double kSlackCounts = 4.0;
  return max_per_s <= 0.0 || dt_s <= 0.0 || std::abs(counts) <= max_per_s * dt_s + kSlackCounts;
}

}  // namespace tp100
