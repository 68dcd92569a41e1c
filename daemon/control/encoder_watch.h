#pragma once
// Encoders against what else tells of the motion: each track's duty, and the gyro. Both add up what
// cannot be explained, so that a small share shows over a distance and a moment of it never does.
// And counts that no track can make.

#include "core/angle.h"
#include "core/sample.h"

namespace tp100::control {

/// What a duty means, by the robot's file.
struct MotorModel {
  double dead_band = 0.15;    ///< duty at which a track just moves
  double feed_forward = 4.0;  ///< duty per m/s above it; 0: a duty means nothing
};

/// What may take duty without speed. A track that spins free has none of it.
struct Load {
  double turning = 0.0;      ///< speed of a track by the turn alone, in parts of the mean speed
  double pitch_rad = 0.0;    ///< of the floor under the robot
  bool on_obstacle = false;  ///< a ramp or block that is really there
};

/// One track: does it move as its duty says? The robot's file is trusted to a factor only; how much
/// duty this track takes is learnt while it runs straight on, so that a change shows. No
/// allocation; safe in the real-time thread.
class DutyWatch {
 public:
  /// Distance that the duty means beyond what was counted. [m]
  static constexpr double kMissingM = 0.04;
  /// A held track takes as long as this at least, whatever its duty. [s]
  static constexpr double kSoonestS = 0.7;

  explicit DutyWatch(const MotorModel& motor) : motor_(motor) {}

  /// A run begins.
  void restart() { *this = DutyWatch(motor_); }
  /// Duty (-1..1) and measured speed, forward positive, over `dt_s`. True: too much is missing.
  bool update(double duty, double track_mps, const Load& load, double dt_s);
  double missing_m() const { return missing_m_; }

 private:
  void learn(double above_dead_band, double track_mps, const Load& load, double dt_s);

  // More than the robot's file says by this factor is not learnt, and is what a run begins with.
  static constexpr double kMostGain = 1.4;

  MotorModel motor_;
  double gain_ = kMostGain;  ///< duty that the track takes, over what the file says
  double slow_mps_ = 0.0;
  double turning_ = 0.0;     ///< most of the last moments
  double obstacle_s_ = 0.0;  ///< until the last obstacle is forgotten
  double missing_m_ = 0.0;
};

/// Turn of the gyro less that of the tracks, but for what slip explains. No allocation; safe in the
/// real-time thread.
class TurnBalance {
 public:
  /// Whatever it was: more than a push that the robot recovers from. [rad]
  static constexpr double kMostRad = 17.0 * kRadPerDeg;
  /// What does not come at once, as a push does. [rad]
  static constexpr double kMostSlowRad = 6.0 * kRadPerDeg;

  /// `slip_share`: part of the turn that slip may take; see Parameters.
  TurnBalance(double wheelbase_m, double slip_share)
      : wheelbase_m_(wheelbase_m), slip_share_(slip_share) {}

  /// A run begins.
  void restart() { all_rad_ = slow_rad_ = 0.0; }
  /// Yaw rates by gyro and by encoders, and the mean of both tracks' speeds without sign, over
  /// `dt_s`. True: they disagree.
  bool update(double gyro_radps, double encoder_radps, double track_mps, bool on_obstacle,
              double dt_s);

 private:
  double wheelbase_m_;
  double slip_share_;
  double all_rad_ = 0.0;
  double slow_rad_ = 0.0;  ///< of rates up to a limit
};

/// Counts of both tracks that jump. A jump that comes alone is not in the samples. No allocation;
/// safe in the real-time thread.
class JumpWatch {
 public:
  /// Counts a second that a track may reach; 0: any.
  explicit JumpWatch(double max_per_s) : max_per_s_(max_per_s) {}

  /// A run begins.
  void restart() { known_ = false; }
  /// The newest sample, new or not. True: it cannot follow the one before.
  bool update(const Sample& sample);

 private:
  double max_per_s_;
  bool known_ = false;
  DeviceUs device_us_ = 0;
  std::int64_t left_counts_ = 0, right_counts_ = 0;
};

}  // namespace tp100::control
