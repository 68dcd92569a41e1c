#pragma once
// The shape of a turn, and its effect on wheelbase, turning centre and slip. Our extension: the
// paper fits one wheelbase and one pair of slip ratios to all turns, but the forces with which the
// tracks work against each other grow with the turn until friction saturates.

namespace tp100::model {

// Equivalent wheelbase of a tracked robot, eq 7.

/// Geometry used by eq 7; the paper's table prints all but gamma.
struct WheelbaseGeometry {
  double length_m = 0.133;       ///< a, axle spacing
  double width_m = 0.160;        ///< b, distance between the tracks
  double offset_x_m = 0.00174;   ///< centre of mass ahead of the middle
  double offset_y_m = -0.00137;  ///< centre of mass left of the middle
  double gamma = 8.049;          ///< ours: the value that gives the printed 0.2742 m
};

/// L = 2 ((b/2 - gamma dy)^2 + (a/2 - dx)^2) / (b/2 - gamma dy). [m]
double equivalent_wheelbase_m(const WheelbaseGeometry& geometry);

/// A turn described by the ratio of the two tracks' speeds, on which friction depends, rather than
/// by the speeds. Friction saturates at much the same ratio for uneven robots.
/// Unevenly creeping tracks lose or gain distance only until friction saturates (`wide`, `tight`).
/// Wheelbase and turning centre drift on as more of the track ends slip, until the slower track
/// stands still: `arc` and `spin` lead from their values in wide turns over those in tight arcs to
/// those on the spot.
struct TurnShape {
  double wide = 0.0;   ///< -1..1, left positive: grows with the turn until the slower track makes
                       ///< 0.55 of the faster one's speed, then stays
  double tight = 0.0;  ///< 0..1: 0 up to there, 1 from 0.35 of the faster one's speed on to spins
  double arc = 0.0;    ///< 0..1: 0 up to 0.65 of the faster one's speed, 1 from 0.4 on to spins
  double spin = 0.0;   ///< 0..1: 0 up to there, 1 from -0.1 of the faster one's speed on to spins
};

/// Shape for tracks whose ground sides move at these speeds (slip removed). Pure.
TurnShape turn_shape(double left_mps, double right_mps);

/// The same from encoders that give a few edges per interval: speeds are low-pass filtered with a
/// lag of 0.1 s. No allocation; safe in the real-time thread.
class TurnMonitor {
 public:
  /// One interval; returns the shape at its end.
  TurnShape update(double left_mps, double right_mps, double dt_s);
  void restart() { started_ = false; }

 private:
  double left_mps_ = 0.0, right_mps_ = 0.0;
  bool started_ = false;
};

}  // namespace tp100::model
