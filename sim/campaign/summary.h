#pragma once
// Statistics of one figure over many runs.

#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace tp100::sim {

/// A 95 % confidence interval; none: too few runs.
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

/// Values that are not finite count as the largest and make mean and sd not finite, too. Without
/// values, only the count (0) is set.
Summary summarise(std::vector<double> values);

/// Clopper-Pearson interval of the share of successes; `of` at least 1.
std::pair<double, double> share_interval(std::size_t successes, std::size_t of);

/// Spearman's rank correlation; none if there are fewer than three pairs or a variable is constant.
std::optional<double> rank_correlation(const std::vector<double>& a, const std::vector<double>& b);

}  // namespace tp100::sim
