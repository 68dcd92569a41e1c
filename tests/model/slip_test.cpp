// Slip on slopes and surfaces: the paper's table, its fits, and a robot's own values.

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "core/arithmetic.h"
#include "model/track_model.h"

namespace tp100::model {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

SlipPair at_deg(double deg, SlipCurve curve) { return slip_at_slope(deg * kRadPerDeg, curve); }

TEST(SlipTable, GivesThePrintedRowsAndIsLinearBetweenThem) {
  const SlipRow printed[] = {{0, 0.16, 0.162},  {8, 0.17, 0.176},  {12, 0.18, 0.197},
                             {16, 0.19, 0.204}, {20, 0.20, 0.218}, {24, 0.21, 0.247},
                             {28, 0.22, 0.260}};
  for (const SlipCurve curve : {SlipCurve::kTable, SlipCurve::kTableDownhill}) {
    for (std::size_t i = 0; i + 1 < std::size(printed); ++i) {
      const SlipRow &low = printed[i], &high = printed[i + 1];
      for (const double share : {0.001, 0.25, 0.999}) {
        const SlipPair slip = at_deg(std::lerp(low.slope_deg, high.slope_deg, share), curve);
        EXPECT_NEAR(slip.left, std::lerp(low.left, high.left, share), 1e-12);
        EXPECT_NEAR(slip.right, std::lerp(low.right, high.right, share), 1e-12);
        EXPECT_FALSE(slip.outside);
      }
    }
  }
}

// Outside the table each curve is held at its ends, or falls downhill like the fit to -28 deg.
TEST(SlipTable, OutsideItsRowsEachCurveSaysSoAndIsHeldOrFallsLikeTheFit) {
  const struct {
    SlipCurve curve;
    double deg, left, right;
  } cases[] = {{SlipCurve::kTable, -0.1, 0.16, 0.162},
               {SlipCurve::kTable, -40, 0.16, 0.162},
               {SlipCurve::kTable, 29, 0.22, 0.260},
               {SlipCurve::kTableDownhill, 40, 0.22, 0.260},
               {SlipCurve::kTableDownhill, -10, 0.16 - 0.0222, 0.162 - 0.0362},
               {SlipCurve::kTableDownhill, -40, 0.16 - 0.06216, 0.162 - 0.10136},
               {SlipCurve::kFit, -10, 0.1557, 0.1534},
               {SlipCurve::kFit, 40, 0.1557 + 0.06216, 0.1534 + 0.10136},
               {SlipCurve::kFitDownhill, -10, 0.1557 - 0.0222, 0.1534 - 0.0362},
               {SlipCurve::kFitDownhill, -40, 0.1557 - 0.06216, 0.1534 - 0.10136}};
  for (const auto& of : cases) {
    const SlipPair slip = at_deg(of.deg, of.curve);
    EXPECT_NEAR(slip.left, of.left, 1e-9) << of.deg;
    EXPECT_NEAR(slip.right, of.right, 1e-9) << of.deg;
    EXPECT_TRUE(slip.outside);
    EXPECT_EQ(at_deg(kNan, of.curve).left, at_deg(0.0, of.curve).left) << "of no angle";
    EXPECT_TRUE(at_deg(kNan, of.curve).outside);
  }
}

TrackParameters board(SlipCurve curve) {
  TrackParameters parameters;
  parameters.slip_left = 0.05;
  parameters.slip_right = 0.07;
  parameters.slip_curve = curve;
  return parameters;
}

TEST(Incline, AddsWhatSlopeAndSurfaceAddToEveryRobotsOwnSlip) {
  for (const SlipCurve curve :
       {SlipCurve::kTable, SlipCurve::kFit, SlipCurve::kTableDownhill, SlipCurve::kFitDownhill}) {
    for (const double deg : {0.0, 4.0, 20.0, -15.0}) {
      for (const double surface : {0.0, 0.1}) {
        Incline incline = inclined(deg * kRadPerDeg);
        incline.slip_offset = surface;
        const Slip slip = slip_on(board(curve), Mode::kExtended, incline);
        const SlipPair here = at_deg(deg, curve), level = at_deg(0.0, curve);
        EXPECT_NEAR(slip.left, 0.05 + here.left - level.left + surface, 1e-12);
        EXPECT_NEAR(slip.right, 0.07 + here.right - level.right + surface, 1e-12);
        EXPECT_EQ(slip_on(board(curve), Mode::kPaper, incline).left, 0.05);
        EXPECT_NEAR(incline.horizontal_fraction, std::cos(deg * kRadPerDeg), 1e-12);
      }
    }
  }
}

TEST(Incline, SlipStaysBelowOneOnIce) {
  TrackParameters ice;
  ice.slip_left = ice.slip_right = 0.9;
  EXPECT_EQ(slip_on(ice, Mode::kExtended, inclined(28 * kRadPerDeg)).left, 0.95);
  EXPECT_EQ(slip_on(ice, Mode::kExtended, {.slip_offset = 0.9}).right, 0.95);
}

TEST(Incline, TheRobotsOwnSlopesReplaceTheTable) {
  TrackParameters p;
  p.added_slips = {{{8 * kRadPerDeg, 0.02, 0.03}, {28 * kRadPerDeg, 0.20, 0.25}}};
  const auto added = [&](double deg) {
    const AddedSlip slip = added_slip(p, deg * kRadPerDeg);
    EXPECT_TRUE(slip.slope_rad == deg * kRadPerDeg || std::isnan(deg));
    return slip;
  };
  p.slopes = 2;
  const struct {
    double deg, left, right;
  } uphill[] = {{0, 0.0, 0.0},    {4, 0.01, 0.015}, {8, 0.02, 0.03}, {18, 0.11, 0.14},
                {28, 0.20, 0.25}, {40, 0.20, 0.25}, {kNan, 0.0, 0.0}};
  for (const auto& of : uphill) {
    EXPECT_NEAR(added(of.deg).left, of.left, 1e-12) << of.deg;
    EXPECT_NEAR(added(of.deg).right, of.right, 1e-12) << of.deg;
    EXPECT_NEAR(added(-of.deg).left, -of.left, 1e-12) << "downhill as uphill, less";
    EXPECT_NEAR(added(-of.deg).right, -of.right, 1e-12);
  }
  const Slip slip = slip_on(p, Mode::kExtended, inclined(8 * kRadPerDeg));
  EXPECT_NEAR(slip.left, p.slip_left + 0.02, 1e-12);
  EXPECT_NEAR(slip.right, p.slip_right + 0.03, 1e-12);

  p.added_slips = {{{-16 * kRadPerDeg, -0.04, -0.05}, {28 * kRadPerDeg, 0.20, 0.25}}};
  EXPECT_NEAR(added(-8.0).left, -0.02, 1e-12);
  EXPECT_NEAR(added(-28.0).right, -0.05, 1e-12);
  EXPECT_NEAR(added(14.0).left, 0.10, 1e-12);
  p.slopes = 1;
  EXPECT_NEAR(added(16.0).right, 0.05, 1e-12) << "nothing of uphill";
  EXPECT_NEAR(added(-8.0).right, -0.025, 1e-12);
}

}  // namespace
}  // namespace tp100::model
