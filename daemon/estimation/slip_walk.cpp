#include "estimation/slip_walk.h"

#include <algorithm>
#include <cmath>

#include "core/arithmetic.h"

namespace tp100::estimation {
namespace {

constexpr double kKept = 0.97;  // of what was learned, from window to window

}  // namespace

SlipWalk::SlipWalk(const LogLikelihoods& logs) : logs_(logs) { weigh(); }

void SlipWalk::add(double change, double noise_sd, double distance_m) {
  for (std::size_t i = 0; i < kCandidates; ++i) {
    // The means of a random walk over two adjacent windows differ by 2/3 of its step over one.
    const double variance = square(noise_sd) + square(kStepsRtm[i]) * distance_m * 2.0 / 3.0;
    logs_[i] = logs_[i] * kKept - (std::log(variance) + square(change) / variance) / 2.0;
  }
  const double highest = *std::max_element(logs_.begin(), logs_.end());
  for (double& log : logs_) log -= highest;
  weigh();
}

void SlipWalk::weigh() {
  double weights = 0.0, squares = 0.0;
  for (std::size_t i = 0; i < kCandidates; ++i) {
    const double weight = std::exp(logs_[i]);
    weights += weight;
    squares += weight * square(kStepsRtm[i]);
  }
  step_rtm_ = std::sqrt(squares / weights);
}

}  // namespace tp100::estimation
