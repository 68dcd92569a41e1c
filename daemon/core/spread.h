#pragma once
// Median and percentiles of a few numbers.

#include <vector>

namespace tp100 {

/// Value below which `share` (0..1) of the values lie, linear between neighbours; not-a-number if
/// there are none. Values that are not finite count as the largest.
double percentile(std::vector<double> values, double share);

/// What ten runs say of one figure.
struct Spread {
  double median = 0.0;
  double p95 = 0.0;
  std::size_t count = 0;
};
Spread spread(const std::vector<double>& values);

}  // namespace tp100
