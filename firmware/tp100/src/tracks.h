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
  Tracks(Hal& hal, FailSafe& fail_safe, const wire::Parameters& parameters)
      : hal_(hal), fail_safe_(fail_safe), parameters_(parameters) {}

  const Track& left() const { return left_; }
  const Track& right() const { return right_; }

  /// New parameters: forgets where the tracks were.
  void restart();
  /// A run begins: as stop(), and forgets the targets and what the monitors learned.
  void begin();
  /// Motors off at once, integrators cleared.
  void stop();

  /// Reads both counts. Returns their device time. [us]
  uint32_t read();
  /// Updates the tracks' speeds, `dt_us` after the last call.
  void measure(uint16_t dt_us);
  /// Judges each track and their mean by the duty of the last `dt_ms`.
  Verdicts check(uint16_t dt_ms);
  /// Judges both by the gyro, while it may be used; see TurnMonitor::update.
  Verdicts check_turn(const TurnMark& now, int16_t accel_x, float bias_radps);
  /// Restarts the check by the gyro; call while the gyro may not be used.
  void forget_turn() { turn_monitor_.reset(); }
  /// Moves the tracks' targets towards `wanted` and applies the duties.
  void drive(const TrackSpeeds& wanted, uint16_t dt_us);

 private:
  bool has(wire::ParameterFlag flag) const { return (parameters_.flags & flag) != 0; }
  void apply(int16_t left, int16_t right);

  Hal& hal_;
  FailSafe& fail_safe_;
  const wire::Parameters& parameters_;
  Track left_;
  Track right_;
  TrackMonitor mean_monitor_;
  TurnMonitor turn_monitor_;
  TrackSpeeds target_ = {};
};

}  // namespace firmware
}  // namespace tp100

#endif
