#pragma once
// Quantiles of Student's t and of the binomial distribution. Boost.Math stays in the source file:
// its headers take longer to compile than everything that uses them.

#include <utility>

namespace tp100 {

/// Exceeded with probability `tail` by Student's t of `degrees` > 0 degrees of freedom.
double student_t(double tail, double degrees);

/// Probability of at most `k` successes in `n` trials of `share` each. 0 <= k <= n, both whole.
double binomial_at_most(double k, double n, double share);

/// The shares between which `k` successes of `n` > 0 lie in both tails with probability `tail`
/// (Clopper-Pearson).
std::pair<double, double> binomial_shares(double k, double n, double tail);

}  // namespace tp100
