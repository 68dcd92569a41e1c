
#include <gtest/gtest.h>

#include <cmath>

#include "core/arithmetic.h"
#include "model/track_model.h"

namespace tp100::model {
namespace {

constexpr SlipCurve kCurves[] = {SlipCurve::kTable, SlipCurve::kFit, SlipCurve::kFitDownhill};

Slip slip(double left, double right, const Incline& incline, SlipCurve curve = SlipCurve::kTable) {
  TrackParameters parameters;
  parameters.slip_left = left;
  parameters.slip_right = right;
  parameters.slip_curve = curve;
  return slip_on(parameters, Mode::kExtended, incline);
}

TEST(Incline, LevelSlipIsTheRobotsOwnWhateverTheCurve) {
  for (const SlipCurve curve : kCurves) {
    EXPECT_DOUBLE_EQ(slip(0.05, 0.07, inclined(0.0), curve).left, 0.05);
    EXPECT_DOUBLE_EQ(slip(0.05, 0.07, inclined(0.0), curve).right, 0.07);
  }
}

TEST(Incline, TheBoardOfThePaperReturnsThePaperTable) {
  for (double deg = 0; deg <= 28; deg += 0.5) {
    const SlipPair table = slip_at_slope(deg * kRadPerDeg);
    const Slip here = slip(0.16, 0.162, inclined(deg * kRadPerDeg));
    EXPECT_NEAR(here.left, table.left, 1e-15);
    EXPECT_NEAR(here.right, table.right, 1e-15);
  }
}

TEST(Incline, SlopeAndSurfaceAddTheSameToEveryRobot) {
  for (const SlipCurve curve : kCurves) {
    Incline incline = inclined(20 * kRadPerDeg);
    const Slip a = slip(0.02, 0.03, incline, curve);
    incline.slip_offset = 0.1;
    const Slip b = slip(0.22, 0.33, incline, curve);
    EXPECT_NEAR(b.left - a.left, 0.30, 1e-12);
    EXPECT_NEAR(b.right - a.right, 0.40, 1e-12);
  }
}

TEST(Incline, TheRobotsOwnSlopesReplaceTheTable) {
  TrackParameters parameters;
  parameters.added_slips = {{{8 * kRadPerDeg, 0.02, 0.03}, {28 * kRadPerDeg, 0.20, 0.25}}};
  parameters.slopes = 2;
  const auto added = [&](double deg) { return added_slip(parameters, deg * kRadPerDeg); };
  EXPECT_NEAR(added(8.0).left, 0.02, 1e-12);
  EXPECT_NEAR(added(28.0).right, 0.25, 1e-12);
  EXPECT_NEAR(added(4.0).left, 0.01, 1e-12);
  EXPECT_NEAR(added(18.0).right, 0.14, 1e-12);
  EXPECT_NEAR(added(40.0).left, 0.20, 1e-12) << "held";
  EXPECT_EQ(added(0.0).left, 0.0);
  EXPECT_NEAR(added(-18.0).right, -0.14, 1e-12) << "nothing of downhill: as uphill, less";
  EXPECT_EQ(added(std::nan("")).left, 0.0);
  const Slip slip = slip_on(parameters, Mode::kExtended, inclined(8 * kRadPerDeg));
  EXPECT_NEAR(slip.left, parameters.slip_left + 0.02, 1e-12);
  EXPECT_NEAR(slip.right, parameters.slip_right + 0.03, 1e-12);

  parameters.added_slips = {{{-16 * kRadPerDeg, -0.04, -0.05}, {28 * kRadPerDeg, 0.20, 0.25}}};
  EXPECT_NEAR(added(-8.0).left, -0.02, 1e-12);
  EXPECT_NEAR(added(-28.0).right, -0.05, 1e-12);
  EXPECT_NEAR(added(14.0).left, 0.10, 1e-12);
  parameters.slopes = 1;
  EXPECT_NEAR(added(16.0).right, 0.05, 1e-12) << "nothing of uphill";
}

TEST(Incline, SlipStaysBelowOneOnIce) {
  EXPECT_DOUBLE_EQ(slip(0.9, 0.9, inclined(28 * kRadPerDeg)).left, kMaxSlip);
  EXPECT_DOUBLE_EQ(slip(0.3, 0.3, {.slip_offset = 0.9}).right, kMaxSlip);
}

TEST(Incline, PaperModeKnowsNeitherSlopeNorSurface) {
  const TrackParameters parameters;
  Incline incline = inclined(20 * kRadPerDeg);
  incline.slip_offset = 0.1;
  EXPECT_EQ(slip_on(parameters, Mode::kPaper, incline).left, parameters.slip_left);
}

}  // namespace
}  // namespace tp100::model
