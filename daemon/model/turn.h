#pragma once
// How tight a turn is, and what that does to the wheelbase and to the turning centre. Ours, not the
// paper's: it fits one wheelbase to all turns, but belts that saturate in tight turns have another
// one there.

namespace tp100::model {

/// Where a turn lies between a wide one (0: the inner belt keeps at least 0.55 of the outer one's
/// speed) and one on the spot (1: the inner belt stands still or runs backwards), for belts whose
/// ground sides move at these speeds (slip taken out). A belt's friction saturates with the ratio
/// of the two speeds, not with the speeds; where it begins to is much the same for uneven robots.
/// Pure.
double tightness(double left_mps, double right_mps);

/// The same of encoders that give a few edges per interval: speeds are followed with a lag of 0.1
/// s. No allocation; safe in the real-time thread.
class Tightness {
 public:
  /// One interval; returns the value at its end.
  double update(double left_mps, double right_mps, double dt_s);
  void restart() { started_ = false; }

 private:
  double left_mps_ = 0.0, right_mps_ = 0.0;
  bool started_ = false;
};

}  // namespace tp100::model
