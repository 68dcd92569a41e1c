#include "core/statistics.h"

#include <algorithm>
#include <boost/math/distributions/binomial.hpp>
#include <boost/math/distributions/students_t.hpp>
#include <cmath>
#include <limits>

namespace tp100 {

double percentile(std::vector<double> values, double share) {
  if (values.empty()) return std::numeric_limits<double>::quiet_NaN();
  for (double& value : values)
    if (!std::isfinite(value)) value = std::numeric_limits<double>::infinity();
  std::sort(values.begin(), values.end());
  const double at = std::clamp(share, 0.0, 1.0) * static_cast<double>(values.size() - 1);
  const auto below = static_cast<std::size_t>(at);
  const auto above = std::min(below + 1, values.size() - 1);
  const double share_above = at - static_cast<double>(below);
  if (share_above == 0.0 || values[below] == values[above]) return values[below];
  return std::lerp(values[below], values[above], share_above);
}

namespace math = boost::math;

double student_t(double tail, double degrees) {
  return math::quantile(math::complement(math::students_t(degrees), tail));
}

double binomial_at_most(double k, double n, double share) {
  return math::cdf(math::binomial(n, share), k);
}

std::pair<double, double> binomial_shares(double k, double n, double tail) {
  return {math::binomial::find_lower_bound_on_p(n, k, tail),
          math::binomial::find_upper_bound_on_p(n, k, tail)};
}

}  // namespace tp100
