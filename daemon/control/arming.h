#pragma once
// The run's state machine: turns operator requests and the robot's state into robot requests and a
// run state; and its pause.

#include <algorithm>
#include <optional>

#include "core/command.h"
#include "core/faults.h"
#include "core/limits.h"
#include "core/link_state.h"
#include "core/run_state.h"
#include "core/sample.h"

namespace tp100::control {

/// The pause of a run: the robot stands on its path, armed. No allocation; safe in the real-time
/// thread.
class Pause {
 public:
  /// A run begins.
  void restart() { *this = Pause{}; }
  void begin() {
    if (!active()) left_s_ = kLongestPauseS;
  }
  void end() { left_s_ = 0.0; }
  /// One step. True once the pause has lasted too long: it is over, and the run must end.
  bool update(double dt_s) {
    if (!active()) return false;
    left_s_ = std::max(0.0, left_s_ - dt_s);
    total_s_ += dt_s;
    return !active();
  }

  bool active() const { return left_s_ > 0.0; }
  /// Time until the pause is too long; 0 without a pause.
  double left_s() const { return left_s_; }
  /// Duration of all pauses of the run.
  double total_s() const { return total_s_; }

 private:
  double left_s_ = 0.0;
  double total_s_ = 0.0;
};

/// Inputs of arming in one step.
struct ArmingInputs {
  SessionState session = SessionState::kClosed;
  const Sample* sample = nullptr;  ///< newest sample of this session; null: none is fresh
  StartRefusal refusal = StartRefusal::kNone;  ///< reason that refuses a start now
  bool new_session = false;                    ///< another session became ready since the last step
  bool rebooted = false;
  RequestAnswer answer = RequestAnswer::kNone;  ///< to the last arm or disarm
  FaultMask aborts = 0;                         ///< faults that end a run, or one that is about to
                                                ///< begin
  bool done = false;  ///< the path is completed, or nobody drives by hand any more
};

/// Nothing moves before start() or drive(); after an abort, a stop or a lost session nothing moves
/// until the next one. A start that cannot begin within a consent's life is refused. Motors that
/// are on without a request are stopped in every state. No allocation; safe in the real-time
/// thread.
class Arming {
 public:
  /// The operator's start: arms as soon as no reason refuses it.
  void start();
  /// The same for driving by hand.
  void drive();
  /// The operator's hold: ends the run, disarms.
  void hold();
  /// The operator's stop: ends the run and latches STOP on the robot.
  void stop();

  /// One step of `dt_s`. Returns the request to send to the robot, if any.
  RobotRequest update(const ArmingInputs& in, double dt_s);

  /// No run, and no request to the robot is under way.
  bool at_rest() const;
  /// As after construction, in this state with these faults.
  void resume(RunState state, FaultMask faults);

  RunState state() const { return state_; }
  /// True in the step in which a run or a drive by hand began. What restarts then depends on how it
  /// began: see Step::State::begin() in bridge/step.cpp.
  bool just_began() const { return just_began_; }
  /// Why a start was refused in this step.
  StartRefusal refused() const { return refused_; }
  /// True if a run has ended and the robot has not confirmed yet that its motors are off (for at
  /// most kOffWithinS), or if they are on without a request.
  bool disarming() const { return disarming_ || moves_unasked_; }
  /// Faults that ended a run, the robot's own included, and those since: STOP, motors on without a
  /// request, a disarm that was not confirmed. Latched until the next start() or drive().
  FaultMask faults() const { return faults_; }

 private:
  void begin(RunState to);
  void begin_disarm();
  void abort(FaultMask faults);
  RobotRequest end(RunState state, const ArmingInputs& in);
  RobotRequest arm(const ArmingInputs& in, double dt_s);
  RobotRequest run(const ArmingInputs& in);
  void confirm_off(const ArmingInputs& in, double dt_s);
  bool unasked(const ArmingInputs& in, double dt_s);

  RunState state_ = RunState::kIdle;
  RunState to_ = RunState::kRunning;  // state that follows kArming
  RobotRequest pending_ = RobotRequest::kNone;
  FaultMask faults_ = 0;
  StartRefusal refused_ = StartRefusal::kNone;
  bool arm_sent_ = false;
  bool just_began_ = false;
  bool disarming_ = false;
  bool moves_unasked_ = false;
  bool acknowledged_ = false;   // the last arm or disarm request
  double begin_s_ = 0.0;        // since the start
  bool begin_session_ = false;  // a session was ready since the start
  double waited_s_ = 0.0;
  double off_s_ = 0.0;              // since the disarm
  double off_due_s_ = 0.0;          // how long motors may have been on
  std::optional<HostNs> on_since_;  // when motors came on without a request
  double stop_again_s_ = 0.0;
};

}  // namespace tp100::control
