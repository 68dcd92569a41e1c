// Tracks of a skid-steer robot: eqs 1 and 5, and both inverted within the limit of the tracks.
// Robot and host compute them alike, so that the host commands nothing that the robot would have to
// limit. C++11 without libstdc++; pure; no allocation.
#ifndef TP100_SHARED_SKID_STEER_H
#define TP100_SHARED_SKID_STEER_H

#include "number.h"

namespace tp100 {
namespace shared {

/// Speeds or distances of both tracks, forward positive. [m/s, m]
template <class Real>
struct TrackPair {
  Real left;
  Real right;
};

/// Eq 1: speeds or distances of both tracks over the ground.
template <class Real>
TrackPair<Real> over_ground(Real left, Real right, Real slip_left, Real slip_right) {
  const TrackPair<Real> ground = {left * (1 - slip_left), right * (1 - slip_right)};
  return ground;
}
/// Eq 5: turn rate, or turn, of the robot whose tracks move so over the ground.
template <class Real>
Real turn_of(const TrackPair<Real>& ground, Real wheelbase_m) {
  return (ground.right - ground.left) / wheelbase_m;
}

/// One robot; what follows from its values is computed once.
template <class Real>
class SkidSteer {
 public:
  SkidSteer()
      : half_wheelbase_m_(0),
        left_limit_mps_(0),
        right_limit_mps_(0),
        arc_limit_mps_(0),
        left_per_ground_(0),
        right_per_ground_(0),
        max_track_mps_(0) {}
  /// Equivalent wheelbase of eq 5, slip ratios of eq 1 (below 1), limit of a track's speed.
  SkidSteer(Real wheelbase_m, Real slip_left, Real slip_right, Real max_track_mps)
      : half_wheelbase_m_(wheelbase_m / 2),
        left_limit_mps_(max_track_mps * (1 - slip_left)),
        right_limit_mps_(max_track_mps * (1 - slip_right)),
        arc_limit_mps_(max_track_mps * (2 - slip_left - slip_right) / 2),
        left_per_ground_(1 / (1 - slip_left)),
        right_per_ground_(1 / (1 - slip_right)),
        max_track_mps_(max_track_mps) {}

  /// Ground speed nearest to `speed_mps` at which both tracks stay within their limit while the
  /// robot turns: the speed is reduced and the turn rate kept, since a robot that cannot keep up
  /// still steers. A turn rate that is too great even on the spot counts as the greatest possible.
  Real speed_within(Real speed_mps, Real turn_radps) const {
    return speed_with(speed_mps, arc_of(turn_radps));
  }
  /// Track speeds for a ground speed and a turn rate, within the limit. NaN is a standstill.
  TrackPair<Real> tracks_for(Real speed_mps, Real turn_radps) const {
    const Real arc = arc_of(turn_radps);
    const Real speed = speed_with(speed_mps, arc);
    const TrackPair<Real> result = {clamp((speed - arc) * left_per_ground_, max_track_mps_),
                                    clamp((speed + arc) * right_per_ground_, max_track_mps_)};
    return result;
  }

 private:
  /// Half the difference of the tracks' ground speeds. [m/s]
  Real arc_of(Real turn_radps) const {
    return clamp(turn_radps * half_wheelbase_m_, arc_limit_mps_);
  }
  Real speed_with(Real speed_mps, Real arc) const {
    const Real slowest = larger(arc - left_limit_mps_, -arc - right_limit_mps_);
    const Real fastest = smaller(arc + left_limit_mps_, -arc + right_limit_mps_);
    return larger(slowest, smaller(fastest, speed_mps));
  }

  Real half_wheelbase_m_;
  Real left_limit_mps_;  // over the ground
  Real right_limit_mps_;
  Real arc_limit_mps_;
  Real left_per_ground_;  // track speed per ground speed
  Real right_per_ground_;
  Real max_track_mps_;
};

}  // namespace shared
}  // namespace tp100

#endif
