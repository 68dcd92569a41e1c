#include "sim/campaign/summary.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include "core/statistics.h"

namespace tp100::sim {
namespace {

constexpr double kTail = 0.025;
constexpr std::array<double, 4> kShares = {0.05, 0.5, 0.95, 0.99};

// Interval between two order statistics; by the binomial distribution of the rank, the percentile
// lies below it, and above it, with a probability of at most kTail.
Interval percentile_interval(const std::vector<double>& sorted, double share) {
  const auto n = static_cast<double>(sorted.size());
  const auto at_most = [&](double k) { return binomial_at_most(k, n, share); };
  if (at_most(0.0) > kTail || at_most(n - 1.0) < 1.0 - kTail) return {};
  double low = 0.0, high = n;
  while (at_most(low) <= kTail) ++low;
  while (at_most(high - 1.0) >= 1.0 - kTail) --high;
  const auto at = [&](double rank) { return sorted[static_cast<std::size_t>(rank) - 1]; };
  return std::pair(at(low), at(std::min(high + 1.0, n)));
}

/// Ranks; equal values get the mean of their ranks.
std::vector<double> ranks(const std::vector<double>& values) {
  std::vector<std::size_t> order(values.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::sort(order.begin(), order.end(),
            [&](std::size_t a, std::size_t b) { return values[a] < values[b]; });
  std::vector<double> ranks(values.size());
  for (std::size_t begin = 0; begin < order.size();) {
    std::size_t end = begin + 1;
    while (end < order.size() && values[order[end]] == values[order[begin]]) ++end;
    const double rank = static_cast<double>(begin + end - 1) / 2.0;
    for (std::size_t i = begin; i < end; ++i) ranks[order[i]] = rank;
    begin = end;
  }
  return ranks;
}

double mean_of(const std::vector<double>& values) {
  return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

}  // namespace

Summary summarise(std::vector<double> values) {
  Summary summary;
  if (values.empty()) return summary;
  for (double& value : values)
    if (!std::isfinite(value)) value = HUGE_VAL;
  std::sort(values.begin(), values.end());
  summary.count = values.size();
  summary.least = values.front();
  summary.most = values.back();
  summary.mean = mean_of(values);
  for (const double share : kShares)
    summary.percentiles.push_back(
        {share, percentile(values, share), percentile_interval(values, share)});
  if (values.size() < 2) return summary;
  const auto n = static_cast<double>(values.size());
  double squares = 0.0;
  for (const double value : values) squares += (value - summary.mean) * (value - summary.mean);
  summary.sd = std::sqrt(squares / (n - 1.0));
  const double half = student_t(kTail, n - 1.0) * summary.sd / std::sqrt(n);
  if (std::isfinite(half)) summary.mean_interval = {summary.mean - half, summary.mean + half};
  return summary;
}

std::pair<double, double> share_interval(std::size_t successes, std::size_t of) {
  return binomial_shares(static_cast<double>(successes), static_cast<double>(of), kTail);
}

std::optional<double> rank_correlation(const std::vector<double>& a, const std::vector<double>& b) {
  if (a.size() != b.size() || a.size() < 3) return {};
  const std::vector<double> x = ranks(a), y = ranks(b);
  const double middle = mean_of(x);
  double xy = 0.0, xx = 0.0, yy = 0.0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    xy += (x[i] - middle) * (y[i] - middle);
    xx += (x[i] - middle) * (x[i] - middle);
    yy += (y[i] - middle) * (y[i] - middle);
  }
  if (xx == 0.0 || yy == 0.0) return {};
  return xy / std::sqrt(xx * yy);
}

}  // namespace tp100::sim
