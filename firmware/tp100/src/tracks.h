// The two tracks: encoder counts in, duties out, and the monitors between them.
#ifndef TP100_FIRMWARE_TRACKS_H
#define TP100_FIRMWARE_TRACKS_H

#include "fail_safe.h"
#include "speed_loop.h"
#include "track_monitor.h"
#include "yaw_loop.h"

namespace tp100 {
namespace firmware {

/// Left and right are the robot's own, however it is wired. Once per sample, in this order:
/// read(), then in a session measure(), then on an enabled robot check() and drive().
class Tracks {
 public:
  struct Track {
    explicit Track(uint8_t first) : monitor(first) {}
    SpeedLoop loop;
    TrackMonitor monitor;
    int32_t counts = 0;
    int16_t duty = 0;  ///< applied, forward positive [thousandths]
  };
  /// What the monitors found.
  struct Verdicts {
    TrackMonitor::Verdict left;
    TrackMonitor::Verdict right;
  };

  /// `parameters` are those of the session.
  Tracks(Hal& hal, FailSafe& fail_safe, const wire::Parameters& parameters);

  const Track& left() const { return left_; }
  const Track& right() const { return right_; }

  /// The parameters have changed.
  void restart();
  /// A run begins: as stop(), and forgets the targets and what the monitors learned.
  void begin();
  /// Motors off at once, integrators cleared.
  void stop();

  /// Reads both counts. Returns their device time. [us]
  uint32_t read();
  /// Updates the tracks' speeds.
  void measure(const TurnHistory& history);
  /// Judges each track and their mean by the duty of the last `dt_ms`.
  Verdicts check(uint8_t dt_ms);
  /// The robot rests, see TurnMonitor::rest.
  void rest(int16_t accel_x) { turn_monitor_.rest(accel_x); }
  /// Judges both by the gyro, while it may be used; see TurnMonitor::update.
  Verdicts check_turn(const TurnMark& now, int16_t accel_x, float bias_radps);
  /// Restarts the check by the gyro; call while the gyro may not be used.
  void forget_turn() { turn_monitor_.restart(); }
  /// Moves the tracks' targets towards this ground speed and turn rate, within their limits, and
  /// applies the duties.
  void drive(float speed_mps, float turn_radps, uint16_t dt_us);

 private:
  bool has(wire::ParameterFlag flag) const { return (parameters_.flags & flag) != 0; }
  void apply(int16_t left, int16_t right);

  Hal& hal_;
  FailSafe& fail_safe_;
  const wire::Parameters& parameters_;
  MonitorValues values_;
  SpeedGains gains_;
  shared::SkidSteer<float> skid_steer_;
  Track left_;
  Track right_;
  DutySteps mean_steps_;
  TurnMonitor turn_monitor_;
  uint8_t phase_ = 0;  // of the samples, modulo those of the turn monitor
  TrackSpeeds target_ = {};
};

}  // namespace firmware
}  // namespace tp100

#endif
