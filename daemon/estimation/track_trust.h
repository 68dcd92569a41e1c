#pragma once
// How far the yaw rate by the tracks is to be trusted, from its innovations against the gyro.

#include <array>
#include <cstddef>

namespace tp100::estimation {

/// The tracks err by a slip difference that varies along the floor and by a turn gain that varies
/// from turn to turn. How much either varies is one of a few scales, each pair with its likelihood
/// given the innovations seen; old ones are forgotten over some 30 windows. On an even floor and
/// with an identified robot the tracks then correct the gyro; where they slip, the gyro is left
/// alone. No allocation.
class TrackTrust {
 public:
  static constexpr std::size_t kScales = 6;
  static constexpr std::size_t kCandidates = kScales * kScales;
  using LogLikelihoods = std::array<double, kCandidates>;

  /// Nothing is known.
  TrackTrust() { weigh(); }
  explicit TrackTrust(const LogLikelihoods& logs) : logs_(logs) { weigh(); }
  const LogLikelihoods& log_likelihoods() const { return logs_; }

  /// What a window showed: tracks against gyro.
  struct Seen {
    double innovation;
    double variance;          ///< of the innovation, if the tracks did not err in this window
    double by_slip, by_gain;  ///< derivatives by slip difference and turn gain
  };
  /// Returns the variance that the tracks' errors of this window add to that of a measurement.
  double add(const Seen& seen);

  /// Variance of the slip difference along the floor.
  double slip_variance() const { return slip_variance_; }
  /// Information (1 / variance) in the knowledge that what lasts of the slip difference and of the
  /// turn gain is near 0.
  double slip_information() const;
  double gain_information() const;

 private:
  void weigh();

  LogLikelihoods logs_{}, weights_{};
  double slip_variance_ = 0.0, gain_variance_ = 0.0;
};

}  // namespace tp100::estimation
