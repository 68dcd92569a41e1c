#include "core/distributions.h"

#include <boost/math/distributions/binomial.hpp>
#include <boost/math/distributions/students_t.hpp>

namespace tp100 {

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
