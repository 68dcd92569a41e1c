#pragma once
// Statistics of one figure over many runs.

#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace tp100::sim {

/// Bounds that contain the true value in 95 of 100 campaigns; none: too few runs.
using Interval = std::optional<std::pair<double, double>>;

struct Percentile {
  double share = 0.5;
  double value = 0.0;
  Interval interval{};  ///< by order statistics: no distribution is assumed
};

struct Summary {
  std::size_t count = 0;
  double mean = 0.0, sd = 0.0, least = 0.0, most = 0.0;
  Interval mean_interval{};               ///< Student's t
  std::vector<Percentile> percentiles{};  ///< 0.05, 0.5, 0.95, 0.99
};

/// Values that are not finite count as the largest; with one of them mean and sd are not finite
/// either. No values: count 0 and nothing else.
Summary summarise(std::vector<double> values);

/// Share of successes, `of` at least 1; Clopper and Pearson.
std::pair<double, double> share_interval(std::size_t successes, std::size_t of);

/// Spearman's rank correlation; none: fewer than three pairs, or one of the two never changes.
std::optional<double> rank_correlation(const std::vector<double>& a, const std::vector<double>& b);

}  // namespace tp100::sim
