// The daemon's cycle over the bytes of an emulated Mega with nothing attached, whose image was
// built with FAKE_ROBOT.
#include <gtest/gtest.h>

#include <algorithm>
#include <memory>
#include <string>

#include "bridge/cycle.h"
#include "core/board.h"
#include "sim/board/avr_board.h"
#include "sim/robot/emulated_robot.h"
#include "sim/robot/options.h"
#include "support/paths.h"

namespace tp100::sim {
namespace {

constexpr HostNs kPeriodNs = 5 * kNsPerMs;  // of the daemon's cycle

/// A bare Mega with the image built with FAKE_ROBOT, and the daemon's cycle.
class BareMega {
 public:
  explicit BareMega(const std::string& course_name, bool bootloader = false)
      : course(std::make_shared<const course::Course>(load_course(course_name))),
        board({.image = build_path("firmware/tp100_fake.elf"), .bootloader = bootloader}, nullptr) {
    cycle.session().open(0);
    board.reset(PowerUp::kPowerOn, 0);
  }

  bool run_until(auto&& done, double limit_s) {
    const HostNs end_ns = now_ns + from_s(limit_s);
    while (!done() && now_ns < end_ns) step();
    return done();
  }
  bool run_until(RunState wanted, double limit_s) {
    return run_until([&] { return state() == wanted; }, limit_s);
  }
  void run(double s) {
    run_until([] { return false; }, s);
  }
  RunState state() { return cycle.outputs().snapshot.run_state; }
  void start() { cycle.request(OperatorRequest::kStart); }

  Loaded loaded = load({});
  std::shared_ptr<const course::Course> course;
  bridge::Parameters parameters = config::bridge_parameters(loaded.configuration, loaded.robot);
  bridge::Cycle cycle{bridge::session_settings(parameters, course.get()), parameters, course};
  AvrBoard board;
  HostNs now_ns = 0;
  std::int64_t longest_us = 0;  ///< between two samples

 private:
  void step() {
    now_ns += kNsPerMs;
    board.advance(now_ns, {}, to_board_.take(now_ns));
    EXPECT_EQ(board.motor_duty().left, 0.0) << "a motor's pin is driven";
    EXPECT_EQ(board.motor_duty().right, 0.0) << "a motor's pin is driven";
    for (const TimedByte& byte : board.take_sent())
      cycle.session().receive(std::span(&byte.value, 1), byte.at_ns);
    if (now_ns % kPeriodNs != 0) return;
    cycle.step(now_ns);
    cycle.session().take_events();
    to_board_.send(cycle.session().output(), now_ns);
    cycle.session().written(cycle.session().output().size());
    for (const Sample& sample : cycle.inputs().samples) {
      if (last_us_ >= 0) longest_us = std::max(longest_us, sample.device_us - last_us_);
      last_us_ = sample.device_us;
    }
  }

  UartLine to_board_{wire::kBaud};
  std::int64_t last_us_ = -1;
};

// The silence of the bootloader ends the link, and a new link begins without a detected reboot.
TEST(BareMegaThroughItsBootloader, AResetEndsTheRunAndANewOneCanBegin) {
  BareMega mega("1-straight", true);
  mega.start();
  ASSERT_TRUE(mega.run_until(RunState::kRunning, 5.0));
  mega.run(0.5);
  mega.board.reset(PowerUp::kExternal, mega.now_ns);
  ASSERT_TRUE(mega.run_until(RunState::kAborted, 1.0));
  EXPECT_FALSE(mega.run_until([&] { return mega.state() != RunState::kAborted; }, 3.0));
  EXPECT_EQ(mega.cycle.session().counters().reboots, 0U);
  mega.start();
  EXPECT_TRUE(mega.run_until(RunState::kRunning, 5.0));
}

class FakeRobotCourse : public testing::TestWithParam<const char*> {};

TEST_P(FakeRobotCourse, IsDrivenToItsEndByABareMega) {
  BareMega mega(GetParam());
  const link::Session& session = mega.cycle.session();
  ASSERT_TRUE(mega.run_until([&] { return session.state() == SessionState::kReady; }, 5.0));
  EXPECT_EQ(robot_kind(false, session.hello().board), RobotKind::kSimulated);
  // Long enough to estimate the gyro's bias.
  mega.run(2.0);
  mega.start();
  ASSERT_TRUE(mega.run_until(RunState::kRunning, 3.0));
  ASSERT_TRUE(mega.run_until([&] { return mega.state() != RunState::kRunning; }, 60.0));
  const Snapshot& end = mega.cycle.outputs().snapshot;
  EXPECT_EQ(mega.state(), RunState::kFinished)
      << (first_fault(end.faults) ? describe(*first_fault(end.faults)).name : "");
  // The firmware meets its deadlines: a sample every 5 ms, none lost, no byte overrun.
  EXPECT_LT(mega.longest_us, 6000);
  EXPECT_EQ(session.counters().lost, 0U);
  EXPECT_EQ(mega.board.counters().rx_overruns, 0U);
  const course::Path path(*mega.course);
  const course::PathPoint goal = path.at(path.segments().size() - 1, path.length_m());
  const Pose& pose = end.estimates[PoseSource::kModel].pose;
  EXPECT_LT(std::hypot(pose.x_m - goal.x_m, pose.y_m - goal.y_m), 0.05);
}
INSTANTIATE_TEST_SUITE_P(OfThePaper, FakeRobotCourse,
                         testing::Values("1-straight", "1-curve", "1-sharp"), [](const auto& test) {
                           std::string name = test.param;
                           std::erase(name, '-');
                           return "Course" + name;
                         });

}  // namespace
}  // namespace tp100::sim
