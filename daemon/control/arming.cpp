#include "control/arming.h"

#include <utility>

namespace tp100::control {
namespace {

// The robot refuses to arm until a fresh command is there; let a few arrive first.
constexpr double kCommandsFirstS = 0.05;
constexpr double kConfirmS = 1.0;

bool enabled(const Sample& sample) {
  return sample.state == RobotState::kArmed || sample.state == RobotState::kRunning;
}

}  // namespace

void Arming::start() {
  if (state_ == RunState::kArming || state_ == RunState::kRunning) return;
  state_ = RunState::kArming;
  faults_ = 0;
  arm_sent_ = false;
  waited_s_ = 0.0;
}

void Arming::hold() {
  pending_ = RobotRequest::kDisarm;
  if (state_ == RunState::kArming || state_ == RunState::kRunning) state_ = RunState::kIdle;
}

void Arming::stop() {
  pending_ = RobotRequest::kStop;
  faults_ |= fault_bit(Fault::stop_requested);
  state_ = RunState::kAborted;
}

RobotRequest Arming::end(RunState state) {
  state_ = state;
  return RobotRequest::kDisarm;
}

RobotRequest Arming::update(const ArmingInputs& in, double dt_s) {
  just_began_ = false;
  if (pending_ != RobotRequest::kNone) return std::exchange(pending_, RobotRequest::kNone);
  switch (state_) {
    case RunState::kArming:
      return arm(in, dt_s);
    case RunState::kRunning:
      return run(in);
    default:
      return RobotRequest::kNone;
  }
}

RobotRequest Arming::arm(const ArmingInputs& in, double dt_s) {
  if (in.session != SessionState::kReady || in.sample == nullptr || !in.ready_to_run) {
    // A start that the robot has not seen waits; one that was under way when the link went is void.
    if (arm_sent_) {
      faults_ |= in.aborts != 0 ? in.aborts : fault_bit(Fault::link_lost);
      return end(RunState::kAborted);
    }
    waited_s_ = 0.0;
    return RobotRequest::kNone;
  }
  waited_s_ += dt_s;
  if (!arm_sent_) {
    if (waited_s_ < kCommandsFirstS) return RobotRequest::kNone;
    arm_sent_ = true;
    waited_s_ = 0.0;
    return RobotRequest::kArm;
  }
  if (enabled(*in.sample)) {
    state_ = RunState::kRunning;
    just_began_ = true;
    return RobotRequest::kNone;
  }
  if (in.request_refused || in.rebooted || waited_s_ > kConfirmS) {
    faults_ |= fault_bit(in.rebooted ? Fault::robot_rebooted : Fault::not_acknowledged);
    return end(RunState::kAborted);
  }
  return RobotRequest::kNone;
}

RobotRequest Arming::run(const ArmingInputs& in) {
  if (in.rebooted) {
    faults_ |= fault_bit(Fault::robot_rebooted);
  } else if (in.session != SessionState::kReady || in.new_session || in.sample == nullptr) {
    faults_ |= fault_bit(Fault::link_lost);
  } else if (!enabled(*in.sample)) {
    // The robot switched itself off; its own latched fault says why.
    faults_ |= in.sample->faults != 0 ? in.sample->faults : fault_bit(Fault::not_acknowledged);
  }
  faults_ |= in.aborts;
  if (faults_ != 0) return end(RunState::kAborted);
  if (in.path_done) return end(RunState::kFinished);
  return RobotRequest::kNone;
}

}  // namespace tp100::control
