#include "control/arming.h"

#include <algorithm>
#include <utility>

#include "core/consent.h"

namespace tp100::control {
namespace {

// The robot refuses to arm before it has a fresh command; let a few arrive first.
constexpr double kCommandsFirstS = 0.05;

bool lost(const ArmingInputs& in) {
  return in.session != SessionState::kReady || in.new_session || in.sample == nullptr;
}

}  // namespace

void Arming::start() { begin(RunState::kRunning); }

void Arming::drive() { begin(RunState::kDriving); }

void Arming::begin(RunState to) {
  if (under_way(state_)) return;
  state_ = RunState::kArming;
  to_ = to;
  faults_ = 0;
  arm_sent_ = false;
  disarming_ = false;
  begin_s_ = 0.0;
  begin_session_ = false;
  waited_s_ = 0.0;
}

void Arming::hold() {
  pending_ = RobotRequest::kDisarm;
  if (!under_way(state_)) return;
  state_ = RunState::kIdle;
  begin_disarm();
}

void Arming::stop() {
  pending_ = RobotRequest::kStop;
  off_due_s_ = to_s(kAnswerNs);
  // A finished run stays finished; a later STOP does not change that.
  if (state_ == RunState::kFinished) {
    faults_ |= fault_bit(Fault::stop_requested);
  } else {
    abort(fault_bit(Fault::stop_requested));
  }
}

void Arming::abort(FaultMask faults) {
  faults_ |= faults;
  state_ = RunState::kAborted;
}

void Arming::begin_disarm() {
  disarming_ = true;
  acknowledged_ = false;
  off_s_ = 0.0;
  off_due_s_ = to_s(kAnswerNs);
}

bool Arming::at_rest() const {
  return !under_way(state_) && !disarming_ && !moves_unasked_ && !on_since_ &&
         pending_ == RobotRequest::kNone && off_due_s_ == 0.0;
}

void Arming::resume(RunState state, FaultMask faults) {
  *this = Arming{};
  state_ = state;
  faults_ = faults;
}

RobotRequest Arming::end(RunState state, const ArmingInputs& in) {
  state_ = state;
  begin_disarm();
  if (lost(in) || in.rebooted) disarming_ = false;  // there is no robot left to confirm it
  return RobotRequest::kDisarm;
}

RobotRequest Arming::update(const ArmingInputs& in, double dt_s) {
  just_began_ = false;
  refused_ = StartRefusal::kNone;
  if (disarming_) confirm_off(in, dt_s);
  moves_unasked_ = unasked(in, dt_s);
  if (moves_unasked_) {
    disarming_ = false;
    abort(fault_bit(Fault::moves_unasked));
    stop_again_s_ -= dt_s;
    if (stop_again_s_ <= 0.0) {
      stop_again_s_ = to_s(kStopAgainNs);
      pending_ = RobotRequest::kStop;
    }
  } else {
    stop_again_s_ = 0.0;
  }
  if (pending_ != RobotRequest::kNone) return std::exchange(pending_, RobotRequest::kNone);
  switch (state_) {
    case RunState::kArming:
      return arm(in, dt_s);
    case RunState::kRunning:
    case RunState::kDriving:
      return run(in);
    default:
      return RobotRequest::kNone;
  }
}

RobotRequest Arming::arm(const ArmingInputs& in, double dt_s) {
  if (!arm_sent_) {
    // A request made before a reconnect must not start motion after it.
    const bool ready = in.session == SessionState::kReady;
    if (begin_session_ && (in.rebooted || in.new_session || !ready)) {
      faults_ |= fault_bit(in.rebooted ? Fault::robot_rebooted : Fault::link_lost);
      return end(RunState::kAborted, in);
    }
    begin_session_ = ready;
    begin_s_ += dt_s;
    waited_s_ = in.refusal == StartRefusal::kNone ? waited_s_ + dt_s : 0.0;
    if (waited_s_ >= kCommandsFirstS) {
      arm_sent_ = true;
      acknowledged_ = false;
      waited_s_ = 0.0;
      return RobotRequest::kArm;
    }
    if (in.refusal != StartRefusal::kNone && begin_s_ > to_s(Consent::kLifeNs)) {
      refused_ = in.refusal;
      state_ = RunState::kIdle;
    }
    return RobotRequest::kNone;
  }
  waited_s_ += dt_s;
  if (in.rebooted) {
    faults_ |= fault_bit(Fault::robot_rebooted);
  } else if (in.aborts != 0) {
    faults_ |= in.aborts;
  } else if (lost(in)) {
    faults_ |= fault_bit(Fault::link_lost);
  } else if (in.answer == RequestAnswer::kFailed || waited_s_ > kOnWithinS) {
    faults_ |= fault_bit(Fault::not_acknowledged);
  }
  if (faults_ != 0) return end(RunState::kAborted, in);
  acknowledged_ = acknowledged_ || in.answer == RequestAnswer::kAcknowledged;
  // If only its samples show that it is armed, another host may have armed it, or it may yet
  // refuse.
  if (acknowledged_ && enabled(*in.sample)) {
    state_ = to_;
    just_began_ = true;
  }
  return RobotRequest::kNone;
}

RobotRequest Arming::run(const ArmingInputs& in) {
  faults_ |= in.aborts;
  if (in.rebooted) {
    faults_ |= fault_bit(Fault::robot_rebooted);
  } else if (lost(in)) {
    // Samples that arrive too late are another cause, reported by `aborts`.
    if (in.aborts == 0) faults_ |= fault_bit(Fault::link_lost);
  } else if (in.sample->faults != 0) {
    faults_ |= in.sample->faults;
  } else if (!enabled(*in.sample)) {
    faults_ |= fault_bit(Fault::not_acknowledged);
  }
  if (faults_ != 0) return end(RunState::kAborted, in);
  if (in.done) return end(state_ == RunState::kRunning ? RunState::kFinished : RunState::kIdle, in);
  return RobotRequest::kNone;
}

void Arming::confirm_off(const ArmingInputs& in, double dt_s) {
  off_s_ += dt_s;
  if (lost(in) || in.rebooted) {
    disarming_ = false;
    if (state_ != RunState::kFinished) return;
    return abort(fault_bit(in.rebooted ? Fault::robot_rebooted : Fault::link_lost));
  }
  acknowledged_ = acknowledged_ || in.answer == RequestAnswer::kAcknowledged;
  // From here on, motors that are on are unintended.
  if (acknowledged_) off_due_s_ = 0.0;
  if (acknowledged_ && !motors_on(*in.sample)) {
    disarming_ = false;
  } else if (in.answer == RequestAnswer::kFailed || off_s_ > kOffWithinS) {
    disarming_ = false;
    abort(fault_bit(Fault::not_acknowledged));
  }
}

// Uses the samples' own times: without a new sample nothing is known.
bool Arming::unasked(const ArmingInputs& in, double dt_s) {
  off_due_s_ = std::max(0.0, off_due_s_ - dt_s);
  const bool asked =
      armed(state_) || (state_ == RunState::kArming && arm_sent_) || off_due_s_ > 0.0;
  if (asked || in.sample == nullptr || !motors_on(*in.sample)) {
    on_since_.reset();
    return false;
  }
  if (!on_since_) on_since_ = in.sample->measured_ns;
  return in.sample->measured_ns - *on_since_ >= kUnaskedNs;
}

}  // namespace tp100::control
