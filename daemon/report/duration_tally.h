#pragma once
// Durations of any number in fixed memory: mean and maximum exact, percentiles to 5 %.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

#include "messages/figures.h"

namespace tp100::report {

class DurationTally {
 public:
  void add(double us) {
    if (!(us >= 0.0 && us <= 1e15)) return;
    ++buckets_[bucket(us)];
    const auto* const edges = messages::kLatenessEdgesUs.data();
    std::size_t above = 0;
    while (above < messages::kLatenessEdgesUs.size() && us >= edges[above]) ++above;
    ++counts_[above];
    ++count_;
    sum_ += us;
    max_ = std::max(max_, us);
  }
  messages::Durations result() const {
    return {.count = count_,
            .mean_us = count_ == 0 ? 0.0 : sum_ / static_cast<double>(count_),
            .p50_us = percentile(0.5),
            .p99_us = percentile(0.99),
            .p999_us = percentile(0.999),
            .max_us = max_};
  }
  /// By messages::kLatenessEdgesUs.
  const auto& counts() const { return counts_; }

 private:
  static constexpr double kPerOctave = 16.0;

  // The first bucket is what is below a nanosecond.
  static std::size_t bucket(double us) {
    if (us < 1e-3) return 0;
    return std::min(kSize - 1, 1 + static_cast<std::size_t>(kPerOctave * std::log2(us * 1e3)));
  }
  double percentile(double share) const {
    const double wanted = share * static_cast<double>(count_);
    std::uint64_t seen = 0;
    for (std::size_t i = 0; i < kSize; ++i) {
      seen += buckets_[i];
      if (count_ > 0 && static_cast<double>(seen) >= wanted)
        return i == 0 ? 0.0 : std::min(max_, 1e-3 * std::exp2(static_cast<double>(i) / kPerOctave));
    }
    return 0.0;
  }

  static constexpr std::size_t kSize = 1024;
  std::array<std::uint64_t, kSize> buckets_{};
  std::array<std::uint64_t, messages::kLatenessEdgesUs.size() + 1> counts_{};
  std::uint64_t count_ = 0;
  double sum_ = 0.0, max_ = 0.0;
};

}  // namespace tp100::report
