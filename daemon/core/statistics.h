#pragma once
// Medians, percentiles, and quantiles of distributions. Boost.Math stays in the source file: its
// headers take longer to compile than everything that uses them.

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace tp100 {

/// Median, the upper one of an even number of values; 0 of none.
inline double median(std::vector<double> values) {
  if (values.empty()) return 0.0;
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

/// Value below which `share` (0..1) of the values lie, linear between neighbours; not-a-number if
/// there are none. Values that are not finite count as the largest.
double percentile(std::vector<double> values, double share);

/// Value that Student's t of `degrees` > 0 degrees of freedom exceeds with probability `tail`.
double student_t(double tail, double degrees);

/// Probability of at most `k` successes in `n` trials of `share` each. 0 <= k <= n, both whole.
double binomial_at_most(double k, double n, double share);

/// Clopper-Pearson limits of the share of successes after `k` of `n` > 0 trials, with probability
/// `tail` beyond each.
std::pair<double, double> binomial_shares(double k, double n, double tail);

}  // namespace tp100
