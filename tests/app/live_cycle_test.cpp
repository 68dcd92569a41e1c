#include "app/live_cycle.h"

#include <gtest/gtest.h>

#include "../link/scripted_robot.h"

namespace tp100::app {
namespace {

class LiveBench {
 public:
  LiveBench() { cycle.opened(now); }
  void step() {
    now += 5 * kNsPerMs;
    robot.tick(now);
    cycle.received(robot.take(), now);
    cycle.step(now);
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
  HostNs now = kNsPerS;
  ScriptedRobot robot;
  LiveCycle cycle{session_settings({}), {}, nullptr, false};
};

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
