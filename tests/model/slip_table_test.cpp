#include <gtest/gtest.h>

#include <limits>

#include "core/arithmetic.h"
#include "model/track_model.h"

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

TEST(SlipTable, TheFitIsTheLeastSquaresLineThroughTheTable) {
  const double slopes[] = {0, 8, 12, 16, 20, 24, 28};
  double n = 0, sx = 0, sxx = 0, sl = 0, sxl = 0, sr = 0, sxr = 0;
  for (const double deg : slopes) {
    const SlipPair row = slip_at_slope(deg * kRadPerDeg);
    n += 1, sx += deg, sxx += deg * deg;
    sl += row.left, sxl += deg * row.left, sr += row.right, sxr += deg * row.right;
  }
  const double det = n * sxx - sx * sx;
  for (const double deg : {0.0, 5.0, 28.0}) {
    const SlipPair fit = slip_at_slope(deg * kRadPerDeg, SlipCurve::kFit);
    EXPECT_NEAR(fit.left, (sl * sxx - sx * sxl + deg * (n * sxl - sx * sl)) / det, 2e-4);
    EXPECT_NEAR(fit.right, (sr * sxx - sx * sxr + deg * (n * sxr - sx * sr)) / det, 2e-4);
    EXPECT_FALSE(fit.outside);
  }
}

TEST(SlipTable, TheFitHoldsItsEndsAndSaysSo) {
  const SlipPair steep = slip_at_slope(0.8, SlipCurve::kFit);
  EXPECT_TRUE(steep.outside);
  EXPECT_NEAR(steep.left, 0.1557 + 0.00222 * 28, 1e-12);
  const SlipPair downhill = slip_at_slope(-0.2, SlipCurve::kFit);
  EXPECT_TRUE(downhill.outside);
  EXPECT_NEAR(downhill.right, 0.1534, 1e-12);
}

TEST(SlipTable, DownhillTheContinuedFitFallsAndIsMarkedAsNotMeasured) {
  const SlipPair steep = slip_at_slope(-28 * kRadPerDeg, SlipCurve::kFitDownhill);
  EXPECT_TRUE(steep.outside);
  EXPECT_NEAR(steep.left, 0.092, 0.005);
  EXPECT_DOUBLE_EQ(slip_at_slope(-1.0, SlipCurve::kFitDownhill).left, steep.left);
  const SlipPair uphill = slip_at_slope(0.3, SlipCurve::kFitDownhill);
  EXPECT_DOUBLE_EQ(uphill.left, slip_at_slope(0.3, SlipCurve::kFit).left);
}

TEST(SlipTable, AnglesThatAreNoneGiveTheLevelValueMarked) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const SlipCurve curve : {SlipCurve::kTable, SlipCurve::kFit, SlipCurve::kFitDownhill}) {
    const SlipPair slip = slip_at_slope(nan, curve);
    EXPECT_TRUE(slip.outside);
    EXPECT_DOUBLE_EQ(slip.left, slip_at_slope(0.0, curve).left);
  }
}

}  // namespace
}  // namespace tp100::model
