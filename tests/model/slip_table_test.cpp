#include "model/slip_table.h"

#include <gtest/gtest.h>

#include "core/angle.h"

namespace tp100::model {
namespace {

TEST(SlipTable, ReturnsThePrintedRows) {
  const SlipPair row = slip_at_slope(16 * kRadPerDeg);
  EXPECT_NEAR(row.left, 0.19, 1e-12);
  EXPECT_NEAR(row.right, 0.204, 1e-12);
  EXPECT_FALSE(row.outside);
}

TEST(SlipTable, InterpolatesLinearlyBetweenRows) {
  const SlipPair row = slip_at_slope(4 * kRadPerDeg);
  EXPECT_NEAR(row.left, 0.165, 1e-12);
  EXPECT_NEAR(row.right, 0.169, 1e-12);
}

TEST(SlipTable, HoldsItsEndsAndSaysSo) {
  EXPECT_TRUE(slip_at_slope(-0.1).outside);
  EXPECT_DOUBLE_EQ(slip_at_slope(-0.1).left, 0.16);
  EXPECT_TRUE(slip_at_slope(0.6).outside);
  EXPECT_DOUBLE_EQ(slip_at_slope(0.6).right, 0.260);
}

}  // namespace
}  // namespace tp100::model
