// Monitors of the encoders that robot and host run alike: each track by its duty, both together by
// the gyro. Each integrates the unexplained difference: a small share shows over a distance, a
// short moment never does. C++11 without libstdc++; no allocation; safe in the real-time thread.
#ifndef TP100_SHARED_MONITORS_H
#define TP100_SHARED_MONITORS_H

#include "number.h"

namespace tp100 {
namespace shared {

// Limits that differ: X(name, robot's, host's). The host acts first and the robot only where the
// host did not, or is not tp100d; and the robot, which knows no course, takes every bump of its
// accelerometer for an obstacle.
#define TP100_MONITOR_LIMITS(X)                                                                \
  /* Shortest time until a blocked track is reported, as a share of its stall time. */         \
  X(soonest_share, 0.75, 0.7)                                                                  \
  /* Duty that a turn on the spot may take. The robot judges the mean of both tracks, too, */  \
  /* which no turn changes. */                                                                 \
  X(turn_duty, 0.3, 0.4)                                                                       \
  /* A load decays more slowly than it rises. The robot sees it only every 40 ms. [1/s] */     \
  X(turn_fall_per_s, 0.3, 0.5)                                                                 \
  /* Duty of a slope. The robot cannot tell one from an obstacle, whose duty the host adds. */ \
  X(duty_per_slope_rad, 3.0, 0.8)                                                              \
  /* Load below which a track runs freely: the host's includes the noise of its pitch. */      \
  X(free_duty, 0.05, 0.1)                                                                      \
  /* Share of a turn that slip may take on an obstacle, where one track may slip while the */  \
  /* other grips: at least this (the robot may as well be on a slope), and so much more. */    \
  X(obstacle_slip_share, 0.8, 0.0)                                                             \
  X(obstacle_slip_more, 0.0, 0.25)                                                             \
  /* Slip of one track: as a fraction of the distance, which a host of another make cannot */  \
  /* switch off, and as a fraction of its share of a turn. */                                  \
  X(distance_share, 0.1, 0.0)                                                                  \
  X(distance_slip_share, 0.0, 0.8)                                                             \
  /* Limit of all differences between gyro and tracks: more than a disturbance from which */   \
  /* the robot recovers. [rad] */                                                              \
  X(max_turn_rad, 0.35, 0.2967)                                                                \
  /* Limit of slow differences, without sudden ones such as a disturbance. [rad] */            \
  X(max_slow_turn_rad, 0.175, 0.1047)                                                          \
  /* Counts that jump are beyond this multiple of a track's top speed. The host removes a */   \
  /* single jump from its odometry; the robot only counts them. */                             \
  X(jump_speeds, 2.0, 3.0)

template <class Real>
struct RobotLimits {
#define TP100_ROBOT_LIMIT(name, robot, host) \
  static constexpr Real name() { return Real(robot); }
  TP100_MONITOR_LIMITS(TP100_ROBOT_LIMIT)
#undef TP100_ROBOT_LIMIT
};
template <class Real>
struct HostLimits {
#define TP100_HOST_LIMIT(name, robot, host) \
  static constexpr Real name() { return Real(host); }
  TP100_MONITOR_LIMITS(TP100_HOST_LIMIT)
#undef TP100_HOST_LIMIT
};

/// Greatest duty of an obstacle or a slope.
template <class Real>
constexpr Real obstacle_duty() {
  return Real(0.4);
}

/// Duty that scrubbing over the floor in a turn takes from one track and may give the other.
/// Rises at once, decays slowly.
template <class Real, class Limits>
class TurnDuty {
 public:
  TurnDuty() : duty_(0) {}
  /// `turning`: track speed due to the turn alone, as a fraction of the mean speed. Half of the
  /// duty is taken from 0.12 on, all from 0.4 on: the resistance against turning falls slowly with
  /// the radius.
  Real update(Real turning, Real dt_s) {
    const Real half = Real(0.12), full = Real(0.4);
    const Real share =
        turning < half
            ? turning * (Real(0.5) / half)
            : smaller(Real(1), Real(0.5) + (turning - half) * (Real(0.5) / (full - half)));
    duty_ = larger(Limits::turn_duty() * share, duty_ - Limits::turn_fall_per_s() * dt_s);
    return duty_;
  }
  Real duty() const { return duty_; }

 private:
  Real duty_;
};

/// Checks that one track, or the mean of both, moves according to its duty. The robot's file is
/// trusted only within a factor: the gain (duty that the track takes, relative to the file) is
/// learned while it runs freely and evenly, so that a change is detected.
template <class Real>
class DutyMonitor {
 public:
  /// Limit of the distance that the duty implies beyond the counted one. [m]
  static constexpr Real missing_limit_m() { return Real(0.04); }

  DutyMonitor() { restart(); }
  /// A run begins.
  void restart() {
    gain_ = max_gain();
    learned_duty_ = slow_duty_ = missing_m_ = Real(0);
  }
  /// Takes duty (-1..1) and measured speed, forward positive, over `dt_s`. `load_duty`: what slope,
  /// turn and obstacles may take now, 0..1. `free`: no load acts, so that the gain can be learned.
  /// `dead_band`, `feed_forward`: the robot's duty at which a track just moves, and per m/s above
  /// it (0: unknown, never judged). `soonest_s`: shortest time until a blocked track is reported.
  /// True: too much is missing.
  bool update(Real duty, Real track_mps, Real load_duty, bool free, Real dt_s, Real dead_band,
              Real feed_forward, Real soonest_s) {
    const Real size = magnitude(duty);
    const Real speed_duty = feed_forward * larger(Real(0), duty < 0 ? -track_mps : track_mps);
    slow_duty_ += (speed_duty - slow_duty_) * smaller(Real(1), dt_s * Real(4));
    const Real most_m = missing_limit_m() * dt_s / soonest_s;
    if (size <= dead_band || feed_forward <= 0) {
      missing_m_ = drained(missing_m_, most_m);
      return false;
    }
    const Real above = size - dead_band;
    const Real beyond = larger(Real(0), speed_duty - gain_holds() * learned_duty_);
    const Real usual = gain_ * (speed_duty - beyond) + max_gain() * beyond;
    const Real margin = Real(0.02) + Real(0.1) * usual + load_duty;
    const Real missing_m = smaller((above - usual - margin) * dt_s / feed_forward, most_m);
    if (missing_m < 0)
      missing_m_ = drained(missing_m_, -missing_m);
    else
      missing_m_ += duty < 0 ? -missing_m : missing_m;
    if (free) learn(above, speed_duty, load_duty, dt_s, feed_forward);
    return magnitude(missing_m_) > missing_limit_m();
  }
  /// Forward positive, so that dithering to and fro cancels out. [m]
  Real missing_m() const { return missing_m_; }

 private:
  // A run begins with the greatest gain that can be learned.
  static constexpr Real min_gain() { return Real(0.7); }
  static constexpr Real max_gain() { return Real(1.4); }
  // Friction takes a smaller share of the duty at a higher speed: the gain holds up to this
  // multiple of the speed at which it was learned.
  static constexpr Real gain_holds() { return Real(1.25); }

  static Real within_gains(Real gain) { return smaller(max_gain(), larger(min_gain(), gain)); }
  // The gain may fall quickly, but rise only as fast as a battery sags: otherwise a fault would be
  // learned as normal.
  void learn(Real above, Real speed_duty, Real load_duty, Real dt_s, Real feed_forward) {
    // At very low speed, duty and speed consist mostly of noise and of corrections of lag.
    const bool even = speed_duty > Real(0.028) * feed_forward &&
                      speed_duty > Real(0.95) * slow_duty_ && speed_duty < Real(1.1) * slow_duty_;
    if (!even) return;
    // A small load acts on this track or on the other, so that a sample yields only a range: a gain
    // within it is kept.
    const Real least = within_gains((above - load_duty) / speed_duty);
    const Real most = within_gains((above + load_duty) / speed_duty);
    const Real gain = most < gain_ ? most : larger(least, gain_);
    const Real towards = smaller(Real(1), dt_s * Real(3));
    if (gain < gain_) {
      gain_ += (gain - gain_) * towards;
      learned_duty_ += (speed_duty - learned_duty_) * towards;
    } else if (speed_duty > gain_holds() * learned_duty_) {
      const Real before = learned_duty_;
      learned_duty_ += (speed_duty - learned_duty_) * towards;
      gain_ = gain + (gain_ - gain) * before / learned_duty_;
    } else {
      gain_ += smaller(gain - gain_, dt_s * Real(0.005));
    }
  }

  Real gain_;
  Real learned_duty_;  // duty by the robot's file for the speed at which gain_ was learned
  Real slow_duty_;     // the same for its speed, low-pass filtered
  Real missing_m_;
};

/// What slip explains of the difference between a rotation by the gyro and one by the tracks. [rad]
/// `share`: of a turn. `driven_rad`: mean distance of the tracks without sign over the wheelbase.
template <class Real, class Limits>
Real slip_of_turn(Real share, bool on_obstacle, Real gyro_rad, Real driven_rad) {
  if (on_obstacle)
    share = larger(share + Limits::obstacle_slip_more(), Limits::obstacle_slip_share());
  Real of_distance = Limits::distance_share();
  if (Limits::distance_slip_share() > 0) of_distance += share * Limits::distance_slip_share();
  return share * magnitude(gyro_rad) + of_distance * driven_rad;
}

/// Rotation by the gyro minus rotation by the tracks, except what slip explains. It finds an
/// encoder that loses counts: a yaw loop compensates for it, so that no duty shows it.
template <class Real, class Limits>
class TurnBalance {
 public:
  TurnBalance() { restart(); }
  /// A run begins.
  void restart() { all_rad_ = slow_rad_ = Real(0); }
  /// Takes the rotations by gyro and by tracks over `dt_s`. `slip_rad`: what slip explains of their
  /// difference. True: they disagree.
  bool update(Real gyro_rad, Real track_rad, Real slip_rad, Real dt_s) {
    const Real difference = gyro_rad - track_rad;
    all_rad_ = drained(all_rad_ + difference, slip_rad);
    // A disturbance turns the robot faster than 10 deg/s.
    slow_rad_ = drained(slow_rad_ + clamp(difference, Real(0.1745) * dt_s), slip_rad);
    return all_disagrees() || magnitude(slow_rad_) > Limits::max_slow_turn_rad();
  }
  /// After a disagreement: the gyro turned further to the left than the tracks.
  bool leftward() const { return (all_disagrees() ? all_rad_ : slow_rad_) > 0; }

 private:
  bool all_disagrees() const { return magnitude(all_rad_) > Limits::max_turn_rad(); }

  Real all_rad_;
  Real slow_rad_;  // of differences up to a rate
};

/// Jumps of one encoder's counts. A single glitch is tolerated, and with what follows it within a
/// moment it is one jump; another one within a second is a fault. `Ticks`: unsigned integer.
template <class Ticks, Ticks kPerMs>
class JumpMemory {
 public:
  JumpMemory() : left_(0) {}
  void pass(Ticks elapsed) { left_ = left_ > elapsed ? static_cast<Ticks>(left_ - elapsed) : 0; }
  /// The counts have jumped. True: not for the first time.
  bool again() {
    if (left_ == 0) left_ = kRemembered;
    return left_ < kRemembered - kOneJump;
  }

 private:
  static const Ticks kRemembered = 1000 * kPerMs;
  static const Ticks kOneJump = 100 * kPerMs;

  Ticks left_;  // until the first jump is forgotten
};

}  // namespace shared
}  // namespace tp100

#endif
