#include "live/live_cycle.h"

#include <gtest/gtest.h>

#include <optional>

#include "../link/scripted_robot.h"
#include "course/course.h"
#include "support/real_time_monitor.h"

namespace tp100::live {
namespace {

class LiveBench {
 public:
  explicit LiveBench(std::shared_ptr<const course::Course> course = nullptr)
      : cycle(bridge::session_settings({}), {}, std::move(course), false) {
    cycle.opened(now);
  }
  void step() {
    now += 5 * kNsPerMs;
    robot.tick(now);
    const std::vector<std::uint8_t> bytes = robot.take();
    {
      // A sanitizer may make system calls when it meets a type for the first time: the monitor
      // covers only these calls.
      std::optional<test::RealTimeMonitor> watch;
      if (watched) watch.emplace(duty);
      cycle.received(bytes, now);
      cycle.step(now);
      cycle.wrote(now);
      cycle.after_write(now);
    }
    robot.hear(cycle.output(), now);
    cycle.written(cycle.output().size());
    LiveEvent event;
    while (cycle.take_event(event)) {
    }
  }
  // Number of the oldest waiting record; 0 if there is none.
  std::uint64_t front() const {
    const StepRecord* record = cycle.front_record();
    return record == nullptr ? 0 : record->step;
  }
  bool watched = false;
  test::RealTimeViolations duty;
  HostNs now = kNsPerS;
  ScriptedRobot robot;
  void steps(int count) {
    for (int i = 0; i < count; ++i) {
      step();
      while (cycle.front_record() != nullptr) cycle.release_record();
    }
  }
  std::size_t arms() const { return robot.received.arms.size(); }
  LiveCycle cycle;
};

std::shared_ptr<const course::Course> line() {
  return std::make_shared<const course::Course>(
      course::parse_course("speed_mps = 0.1\n[[segment]]\ntype = \"line\"\nlength_m = 1.0\n"
                           "[fence]\nmin_x_m = -1\nmax_x_m = 2\nmin_y_m = -1\nmax_y_m = 1\n",
                           "line.toml"));
}

TEST(LiveCycle, ATurnNeitherCallsTheSystemNorLocksNorAllocates) {
  LiveBench bench;
  loop::SlotRing<StepRecord> first(8);
  bench.cycle.record_first(first);
  bench.watched = true;
  for (int i = 0; i < 400; ++i) {
    if (i % 50 == 20) bench.cycle.request(OperatorRequest::kHold);
    bench.step();
    while (bench.cycle.front_record() != nullptr) bench.cycle.release_record();
    // Full for most of the time.
    if (i % 50 == 0 && first.front() != nullptr) first.release();
  }
  EXPECT_NE(first.front(), nullptr);
  EXPECT_EQ(bench.duty.heap, 0u);
  EXPECT_EQ(bench.duty.locks, 0u);
  EXPECT_EQ(bench.duty.first_system_call, -1);
  if (!test::watches_system_calls())
    GTEST_SKIP() << "this kernel does not tell of system calls; heap and locks: none";
}

TEST(LiveCycle, AFirstStartIsCarriedOutUnlessSomethingHasRun) {
  LiveBench bench(line());
  bench.steps(400);
  EXPECT_FALSE(bench.cycle.has_run());
  bench.cycle.request(OperatorRequest::kHold);
  bench.steps(20);
  EXPECT_FALSE(bench.cycle.has_run()) << "there was no run to hold";
  bench.cycle.request_first_start();
  bench.steps(100);
  EXPECT_TRUE(bench.cycle.has_run());
  const std::size_t arms = bench.arms();
  EXPECT_GT(arms, 0u);
  bench.cycle.request(OperatorRequest::kStop);
  bench.steps(20);
  for (int i = 0; i < 200; ++i) {
    bench.cycle.request_first_start();
    bench.steps(1 + i % 7);
  }
  EXPECT_EQ(bench.arms(), arms);
  bench.cycle.request(OperatorRequest::kStart);
  bench.steps(100);
  EXPECT_GT(bench.arms(), arms);
}

// Enter is sent as a first start while the operator does not know of the STOP yet.
TEST(LiveCycle, AStopAndAFirstStartAtOnceEndWithoutARunInEitherOrder) {
  for (int i = 0; i < 200; ++i) {
    LiveBench bench(line());
    bench.steps(400);
    const bool stop_first = i % 2 == 0;
    const int apart = i / 2 % 40;
    const auto stop = [&] { bench.cycle.request(OperatorRequest::kStop); };
    if (stop_first) stop();
    if (!stop_first) bench.cycle.request_first_start();
    bench.steps(apart);
    if (stop_first) bench.cycle.request_first_start();
    if (!stop_first) stop();
    bench.steps(1);
    // A start that came first may have been executed before the STOP.
    const std::size_t arms = bench.arms();
    EXPECT_TRUE(arms == 0u || !stop_first) << "repetition " << i;
    bench.steps(100);
    EXPECT_EQ(bench.arms(), arms) << "repetition " << i;
    EXPECT_TRUE(bench.cycle.has_run());
  }
}

TEST(LiveCycle, HandsOutEveryStepOnceAndInOrder) {
  LiveBench bench;
  for (std::uint64_t step = 1; step <= 2000; ++step) {
    bench.step();
    ASSERT_EQ(bench.front(), step);
    bench.cycle.release_record();
    ASSERT_EQ(bench.front(), 0u);
  }
  EXPECT_EQ(bench.cycle.lost_records(), 0u);
}

TEST(LiveCycle, ASlowReaderCostsRecordsAndNothingElse) {
  LiveBench bench;
  for (std::size_t i = 0; i < LiveCycle::kWaitingRecords + 30; ++i) bench.step();
  EXPECT_EQ(bench.cycle.lost_records(), 30u);
  EXPECT_GT(bench.robot.received.commands.size(), 300u);
  EXPECT_EQ(bench.front(), 1u);
  while (bench.front() != 0) bench.cycle.release_record();
  bench.step();
  EXPECT_EQ(bench.front(), LiveCycle::kWaitingRecords + 31);
}

TEST(LiveCycle, TheFirstReaderHasAStepBeforeTheOtherOneAndMayMissSome) {
  LiveBench bench;
  loop::SlotRing<StepRecord> first(4);
  bench.cycle.record_first(first);
  for (int i = 0; i < 10; ++i) bench.step();
  bench.cycle.step(bench.now + 1);
  for (std::uint64_t step = 1; step <= 4; ++step, first.release())
    ASSERT_EQ(first.front()->step, step);
  EXPECT_EQ(first.front(), nullptr);
  bench.cycle.wrote(bench.now + 1);
  ASSERT_NE(first.front(), nullptr);
  EXPECT_EQ(first.front()->step, 11u);
  EXPECT_EQ(bench.cycle.lost_records(), 0u);
  for (std::uint64_t step = 1; step <= 10; ++step, bench.cycle.release_record())
    ASSERT_EQ(bench.front(), step);
  EXPECT_EQ(bench.front(), 0u);
}

TEST(LiveCycle, AChangeOfTheCourseNeitherLocksNorAllocates) {
  LiveBench bench(line());
  bench.steps(400);
  for (int i = 0; i < 4; ++i) {
    // A sanitizer looks into a type that it meets for the first time, by calls of the system.
    bench.watched = i > 0;
    SetupRequest request{.until_ns = bench.now + kNsPerS};
    request.change.step.emplace(bridge::Parameters{}, line());
    request.change.parameters = bridge::session_settings({}).parameters;
    bench.cycle.change_setup(request);
    bench.steps(300);
    ASSERT_EQ(bench.cycle.setup_done(), &request);
    EXPECT_TRUE(request.made);
    bench.cycle.release_setup();
  }
  EXPECT_EQ(bench.duty.heap, 0u);
  EXPECT_EQ(bench.duty.locks, 0u);
  EXPECT_EQ(bench.duty.first_system_call, -1);
}

TEST(LiveCycle, AChangeIsReturnedBeforeTheRecordOfItsFirstStep) {
  LiveBench bench(line());
  bench.steps(400);
  SetupRequest request{.until_ns = bench.now + kNsPerS};
  request.change.step.emplace(bridge::Parameters{}, line());
  bench.cycle.change_setup(request);
  bench.step();
  ASSERT_EQ(bench.cycle.setup_done(), &request);
  const StepRecord* record = bench.cycle.front_record();
  ASSERT_NE(record, nullptr);
  EXPECT_EQ(record->step, request.step);
  EXPECT_EQ(record->inputs.restart.size(), 1u);
}

// Pressed for the old course, it must not begin the new one.
TEST(LiveCycle, AStartBeforeAChangeBeginsTheOldCourseAndTheChangeIsNotMade) {
  LiveBench bench(line());
  bench.steps(400);
  SetupRequest request{.until_ns = bench.now + kNsPerS};
  request.change.step.emplace(bridge::Parameters{}, nullptr);
  bench.cycle.request(OperatorRequest::kStart);
  bench.cycle.change_setup(request);
  bench.steps(100);
  EXPECT_EQ(bench.cycle.setup_done(), &request);
  EXPECT_FALSE(request.made);
  EXPECT_EQ(bench.arms(), 1u);
}

TEST(LiveCycle, AChangeIsGivenUpIfTheRobotDoesNotComeToRest) {
  LiveBench bench(line());
  bench.steps(400);
  bench.robot.metres_per_s = 0.1;
  bench.steps(100);
  SetupRequest request{.until_ns = bench.now + kNsPerS};
  request.change.place = Pose{};
  bench.cycle.change_setup(request);
  bench.steps(150);
  EXPECT_EQ(bench.cycle.setup_done(), nullptr);
  bench.steps(100);
  EXPECT_EQ(bench.cycle.setup_done(), &request);
  EXPECT_FALSE(request.made);
}

TEST(LiveCycle, AfterAChangeOfTheCourseNothingStartsByItself) {
  LiveBench bench;
  bench.steps(400);
  SetupRequest request{.until_ns = bench.now + kNsPerS};
  request.change.step.emplace(bridge::Parameters{}, line());
  bench.cycle.change_setup(request);
  bench.steps(100);
  ASSERT_TRUE(request.made);
  bench.cycle.request_first_start();
  bench.steps(200);
  EXPECT_EQ(bench.arms(), 0u);
  bench.cycle.request(OperatorRequest::kStart);
  bench.steps(200);
  EXPECT_EQ(bench.arms(), 1u);
}

TEST(LiveCycle, GivesUpThePortOfARobotAtRestAndNothingStartsByItselfAfterwards) {
  LiveBench bench(line());
  bench.steps(400);
  EXPECT_FALSE(bench.cycle.take_port_drop());
  bench.cycle.give_up_port();
  EXPECT_TRUE(bench.cycle.take_port_drop());
  EXPECT_FALSE(bench.cycle.take_port_drop()) << "once";
  bench.cycle.request_first_start();
  bench.steps(200);
  EXPECT_EQ(bench.arms(), 0u);
  bench.cycle.request(OperatorRequest::kStart);
  bench.steps(20);
  ASSERT_EQ(bench.arms(), 1u);
  bench.cycle.give_up_port();
  EXPECT_FALSE(bench.cycle.take_port_drop()) << "a run is under way";
  bench.cycle.request(OperatorRequest::kHold);
  bench.steps(400);
  EXPECT_FALSE(bench.cycle.take_port_drop()) << "what was refused is not kept";
}

}  // namespace
}  // namespace tp100::live
