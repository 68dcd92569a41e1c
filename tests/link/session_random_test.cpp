// Rules that a session keeps with a robot that restarts, is silent, refuses and changes at random.
#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <set>

#include "session_rig.h"
#include "support/sequence.h"

namespace tp100::link {
namespace {

class RandomSession : public testing::TestWithParam<int> {
 protected:
  /// Something happens to the robot, to the port, or is asked for.
  void disturb() {
    ScriptedRobot& robot = rig_.robot;
    const bool on = random_.chance(0.7);
    const auto result = [&] {
      return on ? wire::Result::kAccepted : wire::Result(random_.below(6));
    };
    const std::function<void()> happens[] = {
        [&] { robot.reboot(rig_.now); },
        [&] { robot.state = wire::State::kHello; },
        [&] { robot.silent = !on; },
        [&] { robot.answers_parameters = on; },
        [&] { robot.answers_sync = on; },
        [&] { robot.answers_requests = on; },
        [&] { robot.protocol = on ? wire::kProtocolVersion : 7; },
        [&] { robot.parameters_result = result(); },
        [&] { robot.arm_result = result(); },
        [&] { on ? rig_.session.open(rig_.now) : rig_.session.close(rig_.now); },
        [&] { rig_.session.use(SessionRig::settings().parameters, rig_.now); },
        [&] {
          robot.send(wire::FaultReport{1, 2, 0, 3});
        },
        [&] { ask(on ? RobotRequest::kArm : RobotRequest::kDisarm); },
        [&] { ask(on ? RobotRequest::kArm : RobotRequest::kStop); }};
    happens[random_.below(14)]();
  }
  void ask(RobotRequest request) {
    rig_.session.request(request, rig_.now);
    const bool under_way = rig_.session.take_answer() == RequestAnswer::kNone;
    asked_arm_ = request == RobotRequest::kArm && under_way;
    asked_ns_ = rig_.now;
  }

  void step() {
    const bool quiet = nothing_is_sent();
    const ScriptedRobot::Received before = std::exchange(rig_.robot.received, {});
    rig_.step();
    const ScriptedRobot::Received& got = rig_.robot.received;
    EXPECT_TRUE(got.types.empty() || !quiet || !nothing_is_sent()) << "nobody knows who hears it";
    EXPECT_EQ(got.bad_frames, 0);
    for (const auto& stop : got.stops) expect_token(stop.token);
    for (const auto& disarm : got.disarms) expect_token(disarm.token);
    for (const auto& arm : got.arms) {
      expect_token(arm.token);
      EXPECT_EQ(arm.boot_nonce, rig_.robot.boot_nonce);
      EXPECT_LE(rig_.now - asked_ns_, 200 * kNsPerMs) << "a person asked for it just now";
    }
    if (got.commands.empty()) rig_.robot.received.commands = before.commands;
    if (rig_.session.take_answer() != RequestAnswer::kNone) asked_arm_ = false;
    EXPECT_FALSE(asked_arm_ && rig_.now - asked_ns_ > 201 * kNsPerMs) << "no answer to an arm";
    expect_samples_in_order();
  }
  bool nothing_is_sent() const {
    const SessionState state = rig_.session.state();
    return state == SessionState::kClosed || state == SessionState::kListening ||
           state == SessionState::kRefused;
  }
  /// A token is a repetition, or above all earlier ones.
  void expect_token(std::uint32_t token) {
    EXPECT_TRUE(tokens_.contains(token) || tokens_.empty() || token > *tokens_.rbegin());
    tokens_.insert(token);
  }
  void expect_samples_in_order() {
    for (const Sample& sample : rig_.samples) {
      EXPECT_LE(sample.measured_ns, rig_.now + kNsPerMs);
      EXPECT_GT(sample.measured_ns, rig_.now - 20 * kNsPerMs);
      EXPECT_TRUE(sample.device_us > newest_us_ || boot_ != rig_.robot.boot_nonce);
      newest_us_ = sample.device_us;
      boot_ = rig_.robot.boot_nonce;
    }
    rig_.samples.clear();
  }

  SessionRig rig_;
  test::Sequence random_{static_cast<std::uint64_t>(GetParam())};
  bool asked_arm_ = false;
  HostNs asked_ns_ = 0;
  std::set<std::uint32_t> tokens_;
  DeviceUs newest_us_ = 0;
  std::uint32_t boot_ = 0;
};
INSTANTIATE_TEST_SUITE_P(Seeds, RandomSession, testing::Range(1, 41));

TEST_P(RandomSession, KeepsItsRulesAndRecovers) {
  rig_.commands = true;
  rig_.session.open(rig_.now);
  for (int ms = 0; ms < 20'000; ++ms) {
    if (random_.chance(0.006)) disturb();
    step();
    ASSERT_FALSE(HasFailure()) << ms << ": " << rig_.states;
  }
  SessionState from = SessionState::kClosed;
  for (const SessionEvent& event : rig_.events) {
    const StateChanged* changed = as<StateChanged>(event);
    if (changed == nullptr) continue;
    EXPECT_EQ(changed->from, from);
    if (changed->to == SessionState::kSyncing) {
      EXPECT_EQ(from, SessionState::kParameters);
    }
    if (changed->to == SessionState::kReady) {
      EXPECT_EQ(from, SessionState::kSyncing);
    }
    from = changed->to;
  }
  const LinkCounters& counters = rig_.session.counters();
  const auto counted = [](std::uint64_t counter) { return static_cast<int>(counter); };
  EXPECT_EQ(rig_.count<Silence>(), counted(counters.silences));
  EXPECT_EQ(rig_.count<Rebooted>(), counted(counters.reboots));
  EXPECT_EQ(rig_.count<Unanswered>(), counted(counters.unanswered));
  EXPECT_EQ(rig_.count<RobotFault>(), counted(counters.robot_faults));
  EXPECT_EQ(counters.reconnects + 1, std::max(1U, rig_.session.session_number()));
  EXPECT_EQ(counters.crc_errors + counters.cobs_errors, 0U);

  ScriptedRobot good(rig_.now);
  good.boot_nonce = rig_.robot.boot_nonce + 1;
  rig_.robot = good;
  rig_.session.open(rig_.now);
  rig_.run(5000);
  EXPECT_EQ(rig_.session.state(), SessionState::kReady);
  rig_.session.request(RobotRequest::kStop, rig_.now);
  rig_.run(10);
  EXPECT_FALSE(rig_.session.request_pending());
  EXPECT_EQ(rig_.robot.state, wire::State::kFaulted);
}

}  // namespace
}  // namespace tp100::link
