#include "messages/figures.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

namespace tp100::messages {
namespace {

// Longest duration; as nanoseconds it fits into 64 bits.
constexpr double kLongestUs = 1e15;

}  // namespace

void add_us(Histogram& histogram, double us) {
  if (us >= 0.0 && us <= kLongestUs) histogram.add(std::llround(us * 1e3));
}

Durations durations_of(const Histogram& histogram) {
  return {.count = histogram.count(),
          .mean_us = histogram.mean() * 1e-3,
          .p50_us = histogram.percentile_us(0.5),
          .p99_us = histogram.percentile_us(0.99),
          .p999_us = histogram.percentile_us(0.999),
          .max_us = histogram.max_us()};
}

LatenessCounts lateness_counts_of(const Histogram& histogram) {
  LatenessCounts counts{};
  // Another thread may add values meanwhile; no difference may become negative because of that.
  std::uint64_t below = 0;
  for (std::size_t i = 0; i < kLatenessEdgesUs.size(); ++i) {
    const auto edge_ns = static_cast<std::uint64_t>(kLatenessEdgesUs[i]) * 1000U;
    const std::uint64_t upto = std::max(below, histogram.count_below(edge_ns));
    counts[i] = upto - std::exchange(below, upto);
  }
  const std::uint64_t all = histogram.count();
  counts.back() = all > below ? all - below : 0;
  return counts;
}

}  // namespace tp100::messages
