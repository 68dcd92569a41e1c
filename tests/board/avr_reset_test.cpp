// Tests the daemon and the image when the board restarts in the middle of a run.

#include <gtest/gtest.h>

#include <memory>
#include <string>
#include <tuple>
#include <vector>

#include "bridge/cycle.h"
#include "sim/robot/emulated_robot.h"
#include "sim/robot/options.h"

namespace tp100::sim {
namespace {

constexpr std::int64_t kHostPeriodNs = 10 * kNsPerMs;

Options avr_options() {
  Options options;
  options.board = "avr";
  return options;
}

/// The daemon and the emulated robot, connected in virtual time.
class RobotAndDaemon {
 public:
  explicit RobotAndDaemon(bool bootloader)
      : loaded_(load(avr_options())),
        parameters_(config::bridge_parameters(loaded_.configuration, loaded_.robot)),
        cycle_(bridge::session_settings(parameters_), parameters_,
               std::make_shared<const course::Course>(load_course("1-straight"))),
        robot_({.values = loaded_.robot.emulated,
                .board = BoardKind::kAvr,
                .bootloader = bootloader}) {
    robot_.reset(PowerUp::kPowerOn);
    cycle_.session().open(0);
  }

  void run(int ms) {
    for (int i = 0; i < ms; ++i) {
      for (const TimedByte& byte : robot_.advance()) {
        cycle_.session().receive(std::span(&byte.value, 1), byte.at_ns);
      }
      if (robot_.now_ns() % kHostPeriodNs != 0) continue;
      cycle_.step(robot_.now_ns());
      cycle_.session().take_events();
      robot_.receive(cycle_.session().output(), robot_.now_ns());
      cycle_.session().written(cycle_.session().output().size());
    }
  }
  bool run_until(RunState state, int limit_ms) {
    for (int ms = 0; ms < limit_ms && this->state() != state; ms += 10) run(10);
    return this->state() == state;
  }
  RunState state() const { return cycle_.outputs().snapshot.run_state; }
  bool moves() const { return robot_.motor_duty().left != 0.0 || robot_.motor_duty().right != 0.0; }
  void start() { cycle_.request(OperatorRequest::kStart); }
  void reset(PowerUp cause) { robot_.reset(cause); }
  std::uint64_t reboots() const { return cycle_.session().counters().reboots; }

 private:
  Loaded loaded_;
  bridge::Parameters parameters_;
  bridge::Cycle cycle_;
  EmulatedRobot robot_;
};

class AvrReset : public ::testing::TestWithParam<std::tuple<PowerUp, bool>> {};

TEST_P(AvrReset, EndsTheRunAndANewOneCanBegin) {
  const auto [cause, bootloader] = GetParam();
  RobotAndDaemon desk(bootloader);
  desk.start();
  ASSERT_TRUE(desk.run_until(RunState::kRunning, 5000));
  desk.run(500);
  ASSERT_TRUE(desk.moves());

  desk.reset(cause);
  EXPECT_FALSE(desk.moves());
  for (int ms = 0; ms < 3000; ++ms) {
    desk.run(1);
    ASSERT_FALSE(desk.moves()) << ms << " ms after the reset";
  }
  EXPECT_EQ(desk.state(), RunState::kAborted);
  // The silence of the bootloader ends the link, and a new link begins without a detected reboot.
  EXPECT_EQ(desk.reboots(), bootloader ? 0U : 1U);

  desk.start();
  EXPECT_TRUE(desk.run_until(RunState::kRunning, 5000));
  desk.run(500);
  EXPECT_TRUE(desk.moves());
}

std::string name_of(const ::testing::TestParamInfo<std::tuple<PowerUp, bool>>& test) {
  const char* const causes[] = {"PowerOn", "External", "BrownOut", "Watchdog"};
  return std::string(causes[static_cast<std::size_t>(std::get<0>(test.param))]) +
         (std::get<1>(test.param) ? "ThroughTheBootloader" : "");
}

INSTANTIATE_TEST_SUITE_P(Causes, AvrReset,
                         ::testing::Combine(::testing::Values(PowerUp::kPowerOn, PowerUp::kExternal,
                                                              PowerUp::kBrownOut,
                                                              PowerUp::kWatchdog),
                                            ::testing::Bool()),
                         name_of);

}  // namespace
}  // namespace tp100::sim
