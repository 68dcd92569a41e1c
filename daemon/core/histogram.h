#pragma once
// Distribution of durations in constant memory. One thread adds, any thread reads.

#include <array>
#include <atomic>
#include <bit>
#include <cstddef>
#include <cstdint>

namespace tp100 {

/// Log-linear histogram: 16 buckets per factor of two, so that a percentile is at most 6.25 % too
/// high. Values below 16 ns are exact, values above 2^40 ns (18 min) are clamped.
class Histogram {
 public:
  /// Adds one value [ns]; a negative one counts as 0. No allocation or lock.
  void add(std::int64_t ns) {
    const std::uint64_t value = ns < 0 ? 0 : static_cast<std::uint64_t>(ns);
    bump(buckets_[index(value)]);
    bump(count_);
    sum_.store(sum_.load(std::memory_order_relaxed) + value, std::memory_order_relaxed);
    if (value > max_.load(std::memory_order_relaxed)) max_.store(value, std::memory_order_relaxed);
  }

  std::uint64_t count() const { return count_.load(std::memory_order_relaxed); }
  std::uint64_t max() const { return max_.load(std::memory_order_relaxed); }
  double mean() const {
    return count() == 0 ? 0.0
                        : static_cast<double>(sum_.load(std::memory_order_relaxed)) /
                              static_cast<double>(count());
  }
  /// How many values lie below `ns`, to within a bucket's width.
  std::uint64_t count_below(std::uint64_t ns) const {
    std::uint64_t seen = 0;
    for (std::size_t i = 0; i < kBuckets && upper(i) < ns; ++i)
      seen += buckets_[i].load(std::memory_order_relaxed);
    return seen;
  }
  /// Upper bound of the bucket that holds the value below which `fraction` (0..1) of all lie [ns].
  std::uint64_t percentile(double fraction) const {
    const auto wanted = static_cast<std::uint64_t>(fraction * static_cast<double>(count()));
    std::uint64_t seen = 0;
    for (std::size_t i = 0; i < kBuckets; ++i) {
      seen += buckets_[i].load(std::memory_order_relaxed);
      if (seen > wanted || (seen == wanted && seen == count())) {
        const std::uint64_t bound = upper(i);
        return bound < max() ? bound : max();
      }
    }
    return max();
  }
  /// percentile() and max() in microseconds.
  double percentile_us(double fraction) const {
    return static_cast<double>(percentile(fraction)) * 1e-3;
  }
  double max_us() const { return static_cast<double>(max()) * 1e-3; }

 private:
  static constexpr unsigned kSubBits = 4;
  static constexpr unsigned kSub = 1U << kSubBits;
  static constexpr unsigned kLargestPower = 40;
  static constexpr std::size_t kBuckets = (kLargestPower - kSubBits + 1) * kSub;

  static std::size_t index(std::uint64_t value) {
    if (value < kSub) return static_cast<std::size_t>(value);
    const auto power = static_cast<unsigned>(std::bit_width(value)) - 1;
    if (power >= kLargestPower) return kBuckets - 1;
    const auto within = static_cast<unsigned>(value >> (power - kSubBits)) & (kSub - 1);
    return (power - kSubBits + 1) * kSub + within;
  }
  static std::uint64_t upper(std::size_t at) {
    if (at < kSub) return at;
    const std::uint64_t within = at & (kSub - 1);
    const auto power = static_cast<unsigned>(at >> kSubBits) + kSubBits - 1;
    return ((kSub + within + 1) << (power - kSubBits)) - 1;
  }
  static void bump(std::atomic<std::uint64_t>& counter) {
    counter.store(counter.load(std::memory_order_relaxed) + 1, std::memory_order_relaxed);
  }

  std::array<std::atomic<std::uint64_t>, kBuckets> buckets_{};
  std::atomic<std::uint64_t> count_{0};
  std::atomic<std::uint64_t> sum_{0};
  std::atomic<std::uint64_t> max_{0};
};

}  // namespace tp100
