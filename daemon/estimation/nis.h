#pragma once
// Normalized innovation squared: gates of a camera sample, and the check that noise is as assumed.

#include <cmath>
#include <cstdint>

namespace tp100::estimation {

/// Chi-squared with 3 degrees of freedom: one good sample in a hundred is beyond the gate, one in a
/// thousand beyond the trigger.
inline constexpr double kNisGate = 11.3;
inline constexpr double kNisTrigger = 16.3;

/// Mean over many updates, and the band in which it lies 95 times of a hundred.
class NisMean {
 public:
  void add(double nis) {
    ++count_;
    sum_ += nis;
  }
  std::uint32_t count() const { return count_; }
  double mean() const { return count_ == 0 ? 0.0 : sum_ / static_cast<double>(count_); }
  /// Half width of the band around `degrees` (the sum of many chi-squared values is nearly normal).
  double half_band(double degrees) const {
    return 1.96 * std::sqrt(2.0 * degrees / static_cast<double>(count_));
  }

 private:
  std::uint32_t count_ = 0;
  double sum_ = 0.0;
};

}  // namespace tp100::estimation
