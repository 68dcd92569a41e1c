#include "model/surface.h"

#include <gtest/gtest.h>

#include "core/angle.h"
#include "model/track_model.h"

namespace tp100::model {
namespace {

constexpr SlipCurve kCurves[] = {SlipCurve::kTable, SlipCurve::kFit, SlipCurve::kFitDownhill};

TEST(Surface, LevelSlipIsItsOwnWhateverTheCurve) {
  for (const SlipCurve curve : kCurves) {
    const SlipPair slip = slip_on_surface({"felt", 0.05, 0.07}, 0.0, curve);
    EXPECT_DOUBLE_EQ(slip.left, 0.05);
    EXPECT_DOUBLE_EQ(slip.right, 0.07);
    EXPECT_FALSE(slip.outside);
  }
}

TEST(Surface, TheBoardOfThePaperReturnsThePaperTable) {
  const Surface board{"ramp board", 0.16, 0.162};
  for (double deg = 0; deg <= 28; deg += 0.5) {
    const SlipPair table = slip_at_slope(deg * kRadPerDeg);
    const SlipPair slip = slip_on_surface(board, deg * kRadPerDeg);
    EXPECT_NEAR(slip.left, table.left, 1e-15);
    EXPECT_NEAR(slip.right, table.right, 1e-15);
  }
}

TEST(Surface, TheSlopeAddsTheSameOnEverySurface) {
  for (const SlipCurve curve : kCurves) {
    const SlipPair a = slip_on_surface({"a", 0.02, 0.03}, 20 * kRadPerDeg, curve);
    const SlipPair b = slip_on_surface({"b", 0.22, 0.33}, 20 * kRadPerDeg, curve);
    EXPECT_NEAR(b.left - a.left, 0.20, 1e-12);
    EXPECT_NEAR(b.right - a.right, 0.30, 1e-12);
  }
}

TEST(Surface, AgreesWithTheTrackModelOnTheDefaultSurface) {
  const TrackParameters parameters;
  for (const double deg : {-10.0, 0.0, 4.0, 17.0, 28.0, 35.0}) {
    const Slip model = slip_on_slope(parameters, Mode::kExtended, deg * kRadPerDeg);
    const SlipPair slip = slip_on_surface({}, deg * kRadPerDeg);
    EXPECT_NEAR(slip.left, model.left, 1e-15);
    EXPECT_NEAR(slip.right, model.right, 1e-15);
  }
}

TEST(Surface, SlipStaysBelowOneOnIce) {
  const SlipPair slip = slip_on_surface({"ice", 0.9, 0.9}, 28 * kRadPerDeg);
  EXPECT_DOUBLE_EQ(slip.left, kMostSlip);
  EXPECT_DOUBLE_EQ(slip.right, kMostSlip);
}

}  // namespace
}  // namespace tp100::model
