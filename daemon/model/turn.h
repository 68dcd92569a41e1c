#pragma once
// What kind of turn the belts make, and what that does to wheelbase, turning centre and slip. Ours,
// not the paper's: it fits one wheelbase and one pair of slip ratios to all turns, but the forces
// with which the belts work against each other grow with the turn until friction saturates.

namespace tp100::model {

/// A turn by the ratio of the two belts' speeds, which is what friction follows, not the speeds.
/// Where friction saturates is much the same for uneven robots.
///
/// Unevenly creeping belts lose or gain way only until friction saturates (`wide`, `tight`).
/// Wheelbase and turning centre drift on as the slipping ends take over, until the slower belt
/// stands still: `arc` and `spin` lead from their values in wide turns over those in tight arcs to
/// those on the spot.
struct TurnShape {
  double wide = 0.0;   ///< -1..1, left positive: grows with the turn until the slower belt makes
                       ///< 0.55 of the faster one's speed, then stays
  double tight = 0.0;  ///< 0..1: 0 up to there, 1 from 0.35 of the faster one's speed on to spins
  double arc = 0.0;    ///< 0..1: 0 up to 0.65 of the faster one's speed, 1 from 0.4 on to spins
  double spin = 0.0;   ///< 0..1: 0 up to there, 1 from -0.1 of the faster one's speed on to spins
};

/// For belts whose ground sides move at these speeds (slip taken out). Pure.
TurnShape turn_shape(double left_mps, double right_mps);

/// The same of encoders that give a few edges per interval: speeds are followed with a lag of 0.1
/// s. No allocation; safe in the real-time thread.
class TurnWatch {
 public:
  /// One interval; returns the shape at its end.
  TurnShape update(double left_mps, double right_mps, double dt_s);
  void restart() { started_ = false; }

 private:
  double left_mps_ = 0.0, right_mps_ = 0.0;
  bool started_ = false;
};

}  // namespace tp100::model
