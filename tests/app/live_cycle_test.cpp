#include "app/live_cycle.h"

#include <gtest/gtest.h>

#include "../link/scripted_robot.h"
#include "support/duty_watch.h"

namespace tp100::app {
namespace {

class LiveBench {
 public:
  LiveBench() { cycle.opened(now); }
  void step() {
    now += 5 * kNsPerMs;
    robot.tick(now);
    const std::vector<std::uint8_t> bytes = robot.take();
    {
      const test::DutyWatch watch(duty);
      cycle.received(bytes, now);
      cycle.step(now);
      cycle.settle(now);
    }
    robot.hear(cycle.output(), now);
    cycle.written(cycle.output().size());
    LiveEvent event;
    while (cycle.take_event(event)) {
    }
  }
  // Number of the oldest waiting record; 0: none.
  std::uint64_t front() const {
    const StepRecord* record = cycle.front_record();
    return record == nullptr ? 0 : record->step;
  }
  test::DutyCount duty;
  HostNs now = kNsPerS;
  ScriptedRobot robot;
  LiveCycle cycle{session_settings({}), {}, nullptr, false};
};

TEST(LiveCycle, ATurnNeitherCallsTheSystemNorLocksNorAllocates) {
  LiveBench bench;
  for (int i = 0; i < 400; ++i) {
    if (i % 50 == 20) bench.cycle.request(OperatorRequest::kHold);
    bench.step();
    while (bench.cycle.front_record() != nullptr) bench.cycle.release_record();
  }
  EXPECT_EQ(bench.duty.heap, 0u);
  EXPECT_EQ(bench.duty.locks, 0u);
  EXPECT_EQ(bench.duty.first_system_call, -1);
  if (!test::watches_system_calls())
    GTEST_SKIP() << "this kernel does not tell of system calls; heap and locks: none";
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
  EXPECT_GT(bench.robot.heard.commands.size(), 300u);
  EXPECT_EQ(bench.front(), 1u);
  while (bench.front() != 0) bench.cycle.release_record();
  bench.step();
  EXPECT_EQ(bench.front(), LiveCycle::kWaitingRecords + 31);
}

}  // namespace
}  // namespace tp100::app
