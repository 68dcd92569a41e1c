// Monitors of the tracks and their encoders: each track by its duty, both together by the gyro.
#ifndef TP100_FIRMWARE_TRACK_MONITOR_H
#define TP100_FIRMWARE_TRACK_MONITOR_H

#include "shared/monitors.h"
#include "wire/messages.h"
#include "yaw_loop.h"

namespace tp100 {
namespace firmware {

/// What follows from the parameters of a session, computed once: per sample the monitors compute
/// with integers, since a float operation takes an AVR a hundred cycles.
struct MonitorValues {
  MonitorValues() = default;
  explicit MonitorValues(const wire::Parameters& parameters);

  float metres_per_count = 0.0f;
  float turn_per_count = 0.0f;    ///< of both tracks in opposite directions, in wide turns [rad]
  int16_t dead_band = 0;          ///< [thousandths]
  int32_t run_on_counts = 0;      ///< a braking track may run on this far against its duty
  int32_t jump_counts = 0;        ///< beyond what a track may move, a glitch
  int32_t counts_per_ms_q8 = 0;   ///< twice the top speed, in 256ths
  int32_t standing_counts = 0;    ///< a track that moves less stands
  int32_t accel_x_per_count = 0;  ///< sum of accel_x over a step of the turn for a change of the
                                  ///< distance by a count from step to step
};

/// Compares the duty of a track, or the mean of both, with its distance, in steps of 16 samples.
class DutySteps {
 public:
  /// Samples of the first step. Steps that end in different samples share the load.
  explicit DutySteps(uint8_t first) : first_(first) { restart(); }
  /// Call once per sample. `duty`: applied during the last `dt_ms` [thousandths]. `counts`: now.
  /// `load`: duty that slopes and turns may take now, beyond straight level driving [thousandths].
  /// `free`: the robot drives straight on level ground, so that the duty of a speed can be learned.
  /// True: much less motion than the duty implies.
  bool update(int16_t duty, int32_t counts, uint8_t dt_ms, int16_t load, bool free,
              const MonitorValues& values, const wire::Parameters& parameters);
  /// A run begins: forgets what was learned about the track.
  void restart();
  /// Distance that the duty implies beyond what was counted and what the load explains. [m]
  float missing_m() const { return monitor_.missing_m(); }

 private:
  shared::DutyMonitor<float> monitor_;
  uint8_t first_;
  uint8_t left_;  // samples until the step ends
  bool known_;
  int32_t from_counts_;
  int32_t duty_ms_;
  uint16_t ms_;
};

/// Monitors one track for what only wiring or a blocked track can cause: standstill under power,
/// much less motion than the duty implies, motion against the duty, or counts that jump.
class TrackMonitor {
 public:
  enum Verdict : uint8_t { kGood, kStalled, kReversed };

  /// See DutySteps.
  explicit TrackMonitor(uint8_t first);
  /// Call once per sample, see DutySteps::update.
  Verdict update(int16_t duty, int32_t counts, uint8_t dt_ms, int16_t load, bool free,
                 const MonitorValues& values, const wire::Parameters& parameters);
  /// A run begins: forgets what was learned about the track.
  void restart();
  float missing_m() const { return steps_.missing_m(); }

 private:
  bool jumps_again(int32_t counts, uint8_t dt_ms, const MonitorValues& values);
  bool goes_back_again(int16_t size, int32_t counts, int32_t back, int16_t load,
                       const MonitorValues& values);

  DutySteps steps_;
  bool known_;
  int32_t last_counts_;
  shared::JumpMemory<uint16_t, 1> jumps_;  // in milliseconds
  int8_t sign_;
  int32_t start_counts_;  // where the standstill began
  uint16_t standing_ms_;
  int32_t first_counts_;  // when the duty last changed its sign
  int32_t best_counts_;   // furthest position in the direction of the duty
  bool went_back_;        // by a jump, since best_counts_ was reached
};

/// Compares the rotation by the gyro with the rotation by the tracks, and finds the loads that both
/// and the accelerometer show.
class TurnMonitor {
 public:
  /// Which track counts too little.
  enum Verdict : uint8_t { kGood, kLeftShort, kRightShort };

  TurnMonitor();
  /// Call once per sample at rest, before the first motion of a run: the robot is level as it
  /// stands then. `accel_x` is the raw IMU value.
  void rest(int16_t accel_x);
  /// Call once per sample while the robot runs and the gyro may be used; every eighth call judges.
  /// `bias_radps`: of the gyro.
  Verdict update(const TurnMark& now, int16_t accel_x, float bias_radps,
                 const MonitorValues& values, const wire::Parameters& parameters);
  /// Forgets everything before this call but the level.
  void restart();
  /// No call of update() since restart().
  bool idle() const { return samples_ == 0; }
  /// Duty that one track may take for a slope or an obstacle, now or shortly before. [thousandths]
  int16_t slope_load() const { return slope_load_; }
  /// The same, and for scrubbing in a turn; the other track needs that much less if it runs in the
  /// same direction.
  int16_t load() const { return load_; }
  /// No load acts on the tracks.
  bool free() const;

 private:
  void weigh(float turn_rad, float driven_rad, float elapsed_s, int32_t speeding_up_x);

  TurnMark then_;
  shared::TurnBalance<float, shared::RobotLimits<float>> balance_;
  shared::TurnDuty<float, shared::RobotLimits<float>> turn_duty_;
  int32_t level_q4_ = 0;  // mean accel_x at rest, in 16ths
  bool level_known_;
  int32_t slope_x_;  // mean of the last steps' sums of accel_x beyond the level and the speeding up
  int16_t slope_load_;
  int16_t load_;
  float left_;  // counts per step, less slip, averaged over some steps
  float right_;
  int32_t accel_x_;      // sum over the step
  int32_t both_counts_;  // of both tracks in the last step
  uint8_t samples_;
};

}  // namespace firmware
}  // namespace tp100

#endif
