#pragma once
// Climbing a block and coming down behind it, eq 6 and its missing continuation: a state machine
// over track travel, and over time where the body falls.

#include "model/climb_curve.h"

namespace tp100::model {

/// Phase of the climb. The paper's phases are kRiser to kFlat; the rest leaves the block.
enum class ClimbPhase {
  kApproach,  ///< flat, the riser not yet touched
  kRiser,     ///< 1: the front track rolls up the riser; skipped if the step is below the radius
  kWrap,      ///< 2: the edge passes around the front of the track (alpha to 90 degrees)
  kCross,     ///< 3: the flat of the track slides over the edge, the rear on the ground (L_D)
  kTip,       ///< 4: the body falls forward about the near edge
  kFlat,      ///< 5: flat on the block
  kTipOff,    ///< the body falls forward about the far edge
  kNose,      ///< the nose has touched the ground, the track still runs over the far edge
  kSlideOff,  ///< the rear end comes around the far edge and down the far face
  kDown,      ///< flat behind the block; further travel goes ahead, the block is behind
};

/// The climb as seen from its plane: x ahead of the near edge, z above the ground, both in m.
struct ClimbState {
  ClimbPhase phase = ClimbPhase::kApproach;
  double travel_m = 0.0;      ///< track travel since first touch; negative before it
  double pitch_rad = 0.0;     ///< REP-103: nose-up is negative
  PlaneVector reference_m{};  ///< centre of the tracks' footprint plane, the pose's point
};

/// One robot, one block, driven straight at it. Quasi-static except for the two falls. The track
/// holds at one contact and slips at the other: it holds on the riser, then on the edge, and on the
/// ground in front while sliding off. Phase 4 begins where the rear contact carries no load: at
/// standstill where the centre of mass is over the edge, as published (40.1 deg at 136.9 mm for the
/// TP100 on 37 mm), in motion some millimetres earlier. Landings do not bounce. Driving back undoes
/// a phase, except that a robot behind the block does not climb it again. Meant for speeds up to
/// about 0.2 m/s at the TP100's size: above, the edge leaves the flat of the track before the body
/// has landed (modelled as a longer flat), and gravity is too slow for kSlideOff. Real-time safe:
/// no allocation after construction; bounded time for any input.
class StepClimb {
 public:
  /// Throws UserError as check_climb does; starts at first touch.
  StepClimb(const ClimbGeometry& geometry, const BlockShape& block);

  /// Flat on the ground, `distance_m` >= 0 of travel in front of first touch.
  void begin(double distance_m);
  /// Advances by track travel `travel_m` at constant speed over `dt_s`. Travel is ground travel:
  /// the caller has subtracted the slip. dt_s <= 0 and values that are not finite change nothing.
  const ClimbState& advance(double travel_m, double dt_s);

  const ClimbState& state() const { return state_; }
  const ClimbCurve& curve() const { return curve_; }
  /// The reference point's x at first touch. [m]
  double touch_x_m() const;

 private:
  enum class Edge { kNear, kFar };
  struct Fall {
    double angle, rate;
  };
  double follow(double speed, double time, double begin, double end, ClimbPhase before,
                ClimbPhase after);
  bool lifts_off(double travel_m, double speed) const;
  double cross_end_m(double speed, double time) const;
  double fall(double speed, double time, Edge edge);
  double run(double speed, double time);
  double arm_m(Edge edge) const;
  Fall fallen(const Fall& from, double arm_m, double speed, double time) const;
  ClimbPhase landed(const Fall& fall, double travel_m, Edge edge) const;
  Fall held_up(const Fall& fall, double travel_m, double speed, Edge edge) const;
  void land(ClimbPhase phase);
  Lean lean() const;
  void publish();

  ClimbCurve curve_;
  double gyration_squared_m2_;
  ClimbPhase phase_ = ClimbPhase::kApproach;
  double travel_m_ = 0.0;
  Fall fall_{0.0, 0.0};
  ClimbState state_{};
};

}  // namespace tp100::model
