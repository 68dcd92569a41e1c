#include <gtest/gtest.h>

#include "report/recorded_run.h"

namespace tp100::report {
namespace {

TEST(DurationTally, PercentilesAreWithinFivePercentAndTheRestExact) {
  DurationTally tally;
  for (int i = 1; i <= 10000; ++i) tally.add(i);
  const messages::Durations result = tally.result();
  EXPECT_EQ(result.count, 10000u);
  EXPECT_DOUBLE_EQ(result.mean_us, 5000.5);
  EXPECT_EQ(result.max_us, 10000.0);
  EXPECT_NEAR(result.p50_us, 5000.0, 250.0);
  EXPECT_NEAR(result.p99_us, 9900.0, 495.0);
  EXPECT_EQ(tally.counts().front(), 0u);
  EXPECT_EQ(tally.counts()[1], 1u);
  EXPECT_EQ(tally.counts().back(), 1u);
}

TEST(DurationTally, NothingGivesZerosAndNonsenseIsLeftOut) {
  DurationTally tally;
  tally.add(-1.0);
  tally.add(std::nan(""));
  tally.add(HUGE_VAL);
  EXPECT_EQ(tally.result().count, 0u);
  EXPECT_EQ(tally.result().p99_us, 0.0);
  tally.add(0.0);
  EXPECT_EQ(tally.result().p50_us, 0.0);
  tally.add(1e15);
  EXPECT_EQ(tally.result().max_us, 1e15);
}

}  // namespace
}  // namespace tp100::report
