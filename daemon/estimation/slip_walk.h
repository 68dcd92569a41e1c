#pragma once
// How much the slip difference changes along the floor, judged by tracks and gyro.

#include <array>
#include <cstddef>

namespace tp100::estimation {

/// The slip difference is taken for a random walk over the distance driven. On an even floor it is
/// nearly constant, and tracks then show a drift of the gyro; on an uneven one they do not. Its
/// step per root metre is one of a few candidates, each with its likelihood given the changes seen;
/// old changes are forgotten over some 30 windows. No allocation.
class SlipWalk {
 public:
  static constexpr std::size_t kCandidates = 8;
  /// Per root metre: from an even floor to gravel.
  static constexpr std::array<double, kCandidates> kStepsRtm{3e-5, 1e-4, 3e-4, 1e-3,
                                                             3e-3, 1e-2, 3e-2, 1e-1};
  using LogLikelihoods = std::array<double, kCandidates>;

  /// Nothing is known.
  SlipWalk() { weigh(); }
  explicit SlipWalk(const LogLikelihoods& logs);
  const LogLikelihoods& log_likelihoods() const { return logs_; }

  /// From one window to the next of `distance_m` each, the slip difference seen changed by
  /// `change`, of which measurement noise explains `noise_sd` (> 0).
  void add(double change, double noise_sd, double distance_m);
  /// Root of the mean square of the step by all candidates. [1 / sqrt(m)]
  double step_rtm() const { return step_rtm_; }

 private:
  void weigh();

  LogLikelihoods logs_{};
  double step_rtm_ = 0.0;
};

}  // namespace tp100::estimation
