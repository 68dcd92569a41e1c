// The image built with FAKE_ROBOT on an emulated Mega with nothing attached, and the daemon's cycle
// over bytes.
#include <gtest/gtest.h>

#include <algorithm>
#include <memory>

#include "bridge/cycle.h"
#include "core/board.h"
#include "sim/board/avr_board.h"
#include "sim/robot/options.h"
#include "support/paths.h"

namespace tp100::sim {
namespace {

constexpr std::int64_t kStepNs = 1'000'000;
constexpr std::int64_t kPeriodNs = 5'000'000;
constexpr std::int64_t kByteNs = 20'000;

class BareMega {
 public:
  explicit BareMega(const std::string& course)
      : loaded_(load({})),
        course_(std::make_shared<const course::Course>(load_course(course))),
        parameters_(config::bridge_parameters(loaded_.configuration, loaded_.robot)),
        cycle_(bridge::session_settings(parameters_, course_.get()), parameters_, course_),
        board_({.image = build_path("firmware/tp100_fake.elf")}, nullptr) {
    board_.reset(PowerUp::kPowerOn, 0);
    cycle_.session().open(0);
  }

  /// Runs a millisecond, and in every fifth the daemon's cycle.
  void advance() {
    const auto late = std::ranges::find_if(
        to_board_, [&](const TimedByte& byte) { return byte.at_ns > now_ns_ + kStepNs; });
    const std::vector<TimedByte> due(to_board_.begin(), late);
    to_board_.erase(to_board_.begin(), late);
    now_ns_ += kStepNs;
    board_.advance(now_ns_, {}, due);
    for (const TimedByte& byte : board_.take_sent())
      cycle_.session().receive(std::span(&byte.value, 1), byte.at_ns);
    EXPECT_EQ(board_.motor_duty().left, 0.0) << "a motor's pin is driven";
    EXPECT_EQ(board_.motor_duty().right, 0.0) << "a motor's pin is driven";
    if (now_ns_ % kPeriodNs != 0) return;
    cycle_.step(now_ns_);
    std::int64_t free_ns = to_board_.empty() ? now_ns_ : to_board_.back().at_ns;
    for (const std::uint8_t byte : cycle_.session().output())
      to_board_.push_back({free_ns += kByteNs, byte});
    cycle_.session().written(cycle_.session().output().size());
    for (const Sample& sample : cycle_.inputs().samples) {
      if (last_us_ >= 0)
        longest_us_ = std::max(longest_us_, static_cast<std::int64_t>(sample.device_us) - last_us_);
      last_us_ = static_cast<std::int64_t>(sample.device_us);
    }
  }
  bool run_until(auto&& done, double limit_s) {
    const std::int64_t end_ns = now_ns_ + static_cast<std::int64_t>(limit_s * 1e9);
    while (!done() && now_ns_ < end_ns) advance();
    return done();
  }
  RunState run_state() { return cycle_.outputs().snapshot.run_state; }

  Loaded loaded_;
  std::shared_ptr<const course::Course> course_;
  bridge::Parameters parameters_;
  bridge::Cycle cycle_;
  AvrBoard board_;
  std::vector<TimedByte> to_board_;
  std::int64_t now_ns_ = 0;
  std::int64_t last_us_ = -1;
  std::int64_t longest_us_ = 0;
};

class FakeRobotCourse : public testing::TestWithParam<const char*> {};

TEST_P(FakeRobotCourse, IsDrivenToItsEndByABareMega) {
  BareMega mega(GetParam());
  ASSERT_TRUE(
      mega.run_until([&] { return mega.cycle_.session().state() == SessionState::kReady; }, 5.0));
  EXPECT_EQ(robot_kind(false, mega.cycle_.session().hello().board), RobotKind::kSimulated);
  // Long enough to estimate the gyro's bias.
  mega.run_until([] { return false; }, 2.0);
  mega.cycle_.request(OperatorRequest::kStart);
  ASSERT_TRUE(mega.run_until([&] { return mega.run_state() == RunState::kRunning; }, 3.0));
  const auto over = [&] {
    return mega.run_state() == RunState::kFinished || mega.run_state() == RunState::kAborted;
  };
  ASSERT_TRUE(mega.run_until(over, 60.0));
  const Snapshot& end = mega.cycle_.outputs().snapshot;
  EXPECT_EQ(mega.run_state(), RunState::kFinished)
      << (first_fault(end.faults) ? describe(*first_fault(end.faults)).name : "");
  // The firmware meets its deadlines: a sample every 5 ms, none lost, no byte overrun.
  EXPECT_LT(mega.longest_us_, 6000);
  EXPECT_EQ(mega.cycle_.session().counters().lost, 0U);
  EXPECT_EQ(mega.board_.counters().rx_overruns, 0U);
  const course::Path path(*mega.course_);
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
