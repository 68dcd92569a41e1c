#include "estimation/track_trust.h"

#include <algorithm>
#include <cmath>

#include "core/arithmetic.h"

namespace tp100::estimation {
namespace {

constexpr double kKept = 0.97;  // share of the likelihoods kept from window to window
// From an even floor to gravel, and from an identified wheelbase to a guessed one.
constexpr std::array<double, TrackTrust::kScales> kSlips{1e-4, 3e-4, 1e-3, 3e-3, 1e-2, 3e-2};
constexpr std::array<double, TrackTrust::kScales> kGains{3e-4, 1e-3, 3e-3, 1e-2, 3e-2, 1e-1};
// What lasts of an error, relative to what varies: tension and payload against the floor.
constexpr double kLasting = 0.5;
// A floor varies slowly: so many windows show as much of it as one that is independent would.
constexpr double kAlike = 8.0;

double slip_of(std::size_t candidate) { return kSlips[candidate / TrackTrust::kScales]; }
double gain_of(std::size_t candidate) { return kGains[candidate % TrackTrust::kScales]; }

}  // namespace

double TrackTrust::add(const Seen& seen) {
  std::array<double, kCandidates> errors{};
  for (std::size_t i = 0; i < kCandidates; ++i) {
    errors[i] = square(seen.by_slip * slip_of(i)) + square(seen.by_gain * gain_of(i));
    const double variance = seen.variance + errors[i];
    logs_[i] = logs_[i] * kKept - (std::log(variance) + square(seen.innovation) / variance) / 2.0;
  }
  const double highest = *std::max_element(logs_.begin(), logs_.end());
  for (double& log : logs_) log -= highest;
  weigh();
  // The gain of a Kalman filter is the mean over the candidates.
  double gain = 0.0;
  for (std::size_t i = 0; i < kCandidates; ++i)
    gain += weights_[i] / (seen.variance + kAlike * errors[i]);
  return 1.0 / gain - seen.variance;
}

void TrackTrust::weigh() {
  double sum = 0.0;
  for (std::size_t i = 0; i < kCandidates; ++i) sum += weights_[i] = std::exp(logs_[i]);
  slip_variance_ = gain_variance_ = 0.0;
  for (std::size_t i = 0; i < kCandidates; ++i) {
    weights_[i] /= sum;
    slip_variance_ += weights_[i] * square(slip_of(i));
    gain_variance_ += weights_[i] * square(gain_of(i));
  }
}

double TrackTrust::slip_information() const { return 1.0 / (square(kLasting) * slip_variance_); }
double TrackTrust::gain_information() const { return 1.0 / (square(kLasting) * gain_variance_); }

}  // namespace tp100::estimation
