#include <gtest/gtest.h>

#include <optional>
#include <vector>

#include "control/arming.h"
#include "support/golden_trace.h"
#include "support/sequence.h"

namespace tp100::control {
namespace {

/// An operator and a robot that mostly do what they should.
class ArmingScript {
 public:
  explicit ArmingScript(std::uint64_t seed) : any_(seed) {}

  /// A row whenever something has changed.
  void run(test::GoldenTrace& trace, int steps) {
    std::vector<double> last;
    for (int step = 0; step < steps; ++step) {
      operate();
      const RobotRequest request = arming_.update(inputs(), 0.0049);
      robot(request);
      std::vector<double> row = {
          static_cast<double>(request),
          static_cast<double>(arming_.state()),
          arming_.just_began() ? 1.0 : 0.0,
          static_cast<double>(arming_.refused()),
          arming_.disarming() ? 1.0 : 0.0,
          arming_.at_rest() ? 1.0 : 0.0,
          static_cast<double>(arming_.faults() & 0xFFFFU),
          static_cast<double>(arming_.faults() >> 16U),
      };
      if (row != last) {
        last = row;
        row.insert(row.begin(), step);
        trace.row(row);
      }
    }
  }

 private:
  /// Things happen every half a second.
  void operate() {
    sample_.measured_ns += any_.chance(0.02) ? 0 : 4900000;
    in_.new_session = in_.rebooted = in_.done = false;
    in_.aborts = 0;
    if (held_ > 0) {
      --held_;
      return;
    }
    held_ = any_.chance(0.4) ? any_.below(12) : any_.below(90);
    in_.refusal = StartRefusal::kNone;
    in_.session = SessionState::kReady;
    fresh_ = true;
    switch (any_.below(30)) {
      case 0:
      case 1:
      case 2:
      case 3:
      case 4:
        arming_.start();
        break;
      case 5:
      case 6:
      case 7:
        arming_.drive();
        break;
      case 8:
      case 9:
        arming_.hold();
        break;
      case 10:
        arming_.stop();
        break;
      case 11:
      case 12:
      case 13:
        in_.done = true;
        break;
      case 14:
        in_.aborts = fault_bit(any_.chance(0.5) ? Fault::tilt : Fault::fence);
        break;
      case 15:
        in_.rebooted = true;
        set(RobotState::kDisarmed);
        break;
      case 16:
        in_.new_session = true;
        break;
      case 17:
        in_.session = SessionState::kSyncing;
        held_ += 20;
        break;
      case 18:
        fresh_ = false;
        break;
      case 19:
        set(RobotState::kArmed);
        break;
      case 20:
        set(RobotState::kDisarmed);
        sample_.left_duty = any_.chance(0.5) ? 0.2 : 0.0;
        break;
      case 21:
        sample_.faults = fault_bit(Fault::stalled_left);
        set(RobotState::kFaulted);
        break;
      case 22:
        in_.refusal = StartRefusal::kNotStill;
        arming_.start();
        held_ = any_.chance(0.5) ? 700 : 100;
        break;
      case 23:
        obeys_ = any_.chance(0.6);
        break;
      case 24:
        delay_ = any_.chance(0.3) ? any_.below(260) : any_.below(60);
        break;
      case 25:
        refuses_ = any_.chance(0.5);
        break;
      case 26:
        sample_.right_duty = 0.0;
        sample_.left_duty = 0.0;
        sample_.faults = 0;
        set(RobotState::kDisarmed);
        break;
      case 27:
        if (any_.chance(0.3))
          arming_.resume(any_.chance(0.5) ? RunState::kFinished : RunState::kAborted,
                         fault_bit(Fault::cross_track));
        break;
      case 28:
        // Whatever the robot has been told, it has obeyed.
        obeys_ = true;
        refuses_ = false;
        delay_ = 6;
        break;
      default:
        set(RobotState::kRunning);
        break;
    }
  }

  ArmingInputs inputs() {
    ArmingInputs in = in_;
    in.sample = fresh_ ? &sample_ : nullptr;
    in.answer = RequestAnswer::kNone;
    if (answer_in_ && --*answer_in_ <= 0) {
      answer_in_.reset();
      in.answer = refuses_ ? RequestAnswer::kFailed : RequestAnswer::kAcknowledged;
      if (obeys_ && !refuses_) {
        sample_.faults = told_ == RobotRequest::kArm ? 0 : sample_.faults;
        sample_.left_duty = sample_.right_duty = 0.0;
        set(told_ == RobotRequest::kArm ? RobotState::kArmed : RobotState::kDisarmed);
      }
    }
    return in;
  }

  void robot(RobotRequest request) {
    if (request == RobotRequest::kNone) return;
    told_ = request;
    if (request == RobotRequest::kStop) {
      if (obeys_) set(RobotState::kFaulted);
    } else {
      answer_in_ = delay_;
    }
  }

  void set(RobotState state) { sample_.state = state; }

  test::Sequence any_;
  Arming arming_;
  ArmingInputs in_{};
  Sample sample_{};
  std::optional<int> answer_in_;
  RobotRequest told_ = RobotRequest::kNone;
  int held_ = 30;
  int delay_ = 6;
  bool fresh_ = true, obeys_ = true, refuses_ = false;
};

std::vector<std::string> arming_columns() {
  return {"step",      "request", "state",        "just_began",   "refused",
          "disarming", "at_rest", "robot_faults", "daemon_faults"};
}

TEST(ArmingTrace, EverythingThatMayHappenToARun) {
  test::GoldenTrace trace("control/arming.csv", arming_columns());
  ArmingScript(1).run(trace, 60000);
  EXPECT_EQ(trace.difference(), "");
}

TEST(ArmingTrace, AStartWaitsForASessionThoughAnEarlierOneHadOne) {
  Arming arming;
  Sample sample;
  ArmingInputs in;
  in.session = SessionState::kReady;
  in.sample = &sample;
  in.refusal = StartRefusal::kNotStill;
  arming.start();
  EXPECT_EQ(arming.update(in, 0.005), RobotRequest::kNone);
  arming.hold();
  EXPECT_EQ(arming.update(in, 0.005), RobotRequest::kDisarm);
  in.session = SessionState::kSyncing;
  arming.update(in, 0.005);
  arming.start();
  EXPECT_EQ(arming.update(in, 0.005), RobotRequest::kNone);
  EXPECT_EQ(arming.state(), RunState::kArming);
}

TEST(ArmingTrace, APauseLastsSoLongAndNoLonger) {
  test::GoldenTrace trace("control/pause.csv", {"step", "over", "active", "left_s", "total_s"});
  Pause pause;
  for (int step = 0; step < 700; ++step) {
    if (step == 10 || step == 40 || step == 130 || step == 330) pause.begin();
    if (step == 70 || step == 75) pause.end();
    if (step == 600) pause.restart();
    const bool over = pause.update(0.83);
    if (step % 3 == 0 || over)
      trace.row({static_cast<double>(step), over ? 1.0 : 0.0, pause.active() ? 1.0 : 0.0,
                 pause.left_s(), pause.total_s()});
  }
  EXPECT_EQ(trace.difference(), "");
}

}  // namespace
}  // namespace tp100::control
