#pragma once
// The run's state machine: operator's wish and robot's state to requests and run state.

#include "core/command.h"
#include "core/faults.h"
#include "core/link_state.h"
#include "core/run_state.h"
#include "core/sample.h"

namespace tp100::control {

/// What arming needs to know in one step.
struct ArmingInputs {
  SessionState session = SessionState::kClosed;
  const Sample* sample = nullptr;  ///< newest sample of this session, or null
  bool ready_to_run = false;  ///< there is a course and the estimators are ready (gyro bias known)
  bool new_session = false;   ///< another session became ready since the last step
  bool rebooted = false;
  bool request_refused = false;  ///< the robot refused, or never confirmed, arm
  FaultMask aborts = 0;          ///< what ends a run, or one that is about to begin
  bool path_done = false;
};

/// Nothing moves before start(); nothing moves again after an abort, a stop or a lost session until
/// the next start(). No allocation; safe in the real-time thread.
class Arming {
 public:
  /// The operator's start: begins arming as soon as session and estimators are ready.
  void start();
  /// The operator's hold: ends the run, disarms.
  void hold();
  /// The operator's stop: ends the run and latches STOP on the robot.
  void stop();

  /// One step of `dt_s`. Returns the request to hand to the link, if any.
  RobotRequest update(const ArmingInputs& in, double dt_s);

  RunState state() const { return state_; }
  /// True in the step in which the run began: estimators and tracker start anew.
  bool just_began() const { return just_began_; }
  /// Daemon's faults, latched until the next start().
  FaultMask faults() const { return faults_; }

 private:
  RobotRequest end(RunState state);
  RobotRequest arm(const ArmingInputs& in, double dt_s);
  RobotRequest run(const ArmingInputs& in);

  RunState state_ = RunState::kIdle;
  RobotRequest pending_ = RobotRequest::kNone;
  FaultMask faults_ = 0;
  bool arm_sent_ = false;
  bool just_began_ = false;
  double waited_s_ = 0.0;
};

}  // namespace tp100::control
