// How a recorded run went, as lists of runs show it.
#include "runs/run_result.h"

#include <gtest/gtest.h>

#include "core/faults.h"

namespace tp100::runs {
namespace {

StepRecord step(HostNs now, RunState state, double cross_track_m = 0.0, FaultMask faults = 0) {
  StepRecord record;
  record.now_ns = now;
  record.snapshot.run_state = state;
  record.snapshot.cross_track_m = cross_track_m;
  record.snapshot.progress_m = 0.1 * to_s(now);
  record.snapshot.faults = faults;
  return record;
}

RunResult after(std::initializer_list<StepRecord> steps) {
  RunSummary summary;
  for (const StepRecord& each : steps) summary.take(each);
  return result_of(summary, "3", "lab");
}

constexpr HostNs kSecond = kNsPerS;

// A list of dates would not tell which of five runs failed.
TEST(RunResult, TellsHowARunEndedAndHowFarItWasOff) {
  const StepRecord idle = step(0, RunState::kIdle, 9.0);
  const StepRecord arms = step(kSecond, RunState::kArming, 9.0);
  const StepRecord runs = step(2 * kSecond, RunState::kRunning, -0.03);
  const RunResult done = after({idle, arms, runs, step(5 * kSecond, RunState::kFinished, 0.01),
                                step(9 * kSecond, RunState::kFinished, 9.0)});
  EXPECT_EQ(done.outcome, "completed");
  EXPECT_DOUBLE_EQ(done.duration_s, 4.0);
  EXPECT_DOUBLE_EQ(done.largest_m, 0.03);
  EXPECT_DOUBLE_EQ(done.distance_m, 0.5);
  EXPECT_FALSE(done.by_hand);
  const FaultMask stop = fault_bit(Fault::stop_requested), lost = fault_bit(Fault::link_lost);
  const auto aborted = [&](FaultMask faults) {
    return after({arms, runs, step(3 * kSecond, RunState::kAborted, 0.0, faults)});
  };
  EXPECT_EQ(aborted(stop).outcome, "stopped");
  EXPECT_EQ(aborted(stop | lost).outcome, "aborted");
  EXPECT_EQ(aborted(stop | lost).cause, describe(Fault::link_lost).cause);
  EXPECT_TRUE(after({arms, step(2 * kSecond, RunState::kDriving), idle}).by_hand);
  EXPECT_EQ(after({arms, runs}).outcome, "ended");
  EXPECT_EQ(after({idle}).outcome, "");
  // Of several runs in a recording, the last one.
  EXPECT_EQ(after({arms, runs, idle, arms, step(2 * kSecond, RunState::kFinished)}).largest_m, 0.0);
}

TEST(RunResult, IsReadBackAndNothingElseIs) {
  const RunResult written =
      after({step(kSecond, RunState::kArming), step(2 * kSecond, RunState::kRunning, 0.25)});
  const auto read = parse_run_result(write_run_result(written));
  ASSERT_TRUE(read);
  EXPECT_EQ(read->outcome, written.outcome);
  EXPECT_DOUBLE_EQ(read->largest_m, 0.25);
  EXPECT_EQ(read->course, "3");
  for (const char* text : {"outcome = 3", "largest_m = -1.0", "duration_s = nan", "[", "\xff"})
    EXPECT_FALSE(parse_run_result(text)) << text;
}

}  // namespace
}  // namespace tp100::runs
