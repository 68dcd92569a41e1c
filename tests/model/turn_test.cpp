#include "model/turn.h"

#include <gtest/gtest.h>

#include <cmath>

#include "model/track_model.h"

namespace tp100::model {
namespace {

TEST(Turn, WideTurnsAreNotTightAndTurnsOnTheSpotAreWhollySo) {
  EXPECT_EQ(tightness(0.1, 0.1), 0.0);
  EXPECT_EQ(tightness(0.0, 0.0), 0.0);
  EXPECT_EQ(tightness(0.06, 0.1), 0.0);
  EXPECT_EQ(tightness(0.1, 0.0), 1.0);
  EXPECT_EQ(tightness(-0.1, 0.1), 1.0);
  EXPECT_EQ(tightness(0.1, -0.02), 1.0);
  EXPECT_NEAR(tightness(0.1 * (1.0 - 0.725), 0.1), 0.5, 1e-12);
}

TEST(Turn, OnlyTheRatioOfTheSpeedsCounts) {
  for (const double ratio : {-1.0, -0.3, 0.1, 0.3, 0.5, 0.9}) {
    const double tight = tightness(ratio, 1.0);
    EXPECT_NEAR(tightness(ratio * 0.01, 0.01), tight, 1e-12);
    EXPECT_NEAR(tightness(0.2, ratio * 0.2), tight, 1e-12);
    EXPECT_NEAR(tightness(-ratio * 0.1, -0.1), tight, 1e-12);
  }
}

TEST(Turn, FewEdgesPerIntervalDoNotLookLikeTurns) {
  Tightness tight;
  double most = 0.0;
  for (int i = 0; i < 400; ++i) {
    // One edge or two, by turns, as 1.5 edges an interval look.
    const double value = tight.update(i % 2 == 0 ? 0.1 : 0.2, i % 2 == 0 ? 0.2 : 0.1, 0.005);
    if (i > 100) most = std::max(most, value);
  }
  EXPECT_EQ(most, 0.0);
}

TEST(Turn, WheelbaseAndTurningCentreGoFromTheirWideToTheirSpinValues) {
  TrackParameters p;
  p.wheelbase_m = 0.2;
  p.x_icr_m = 0.01;
  EXPECT_EQ(turn_of(p, Mode::kExtended, 1.0).wheelbase_m, 0.2);
  p.wheelbase_spin_m = 0.3;
  p.x_icr_spin_shift_m = -0.02;
  EXPECT_EQ(turn_of(p, Mode::kExtended, 0.0).wheelbase_m, 0.2);
  EXPECT_EQ(turn_of(p, Mode::kExtended, 0.0).x_icr_m, 0.01);
  EXPECT_NEAR(turn_of(p, Mode::kExtended, 0.5).wheelbase_m, 0.25, 1e-12);
  EXPECT_NEAR(turn_of(p, Mode::kExtended, 1.0).x_icr_m, -0.01, 1e-12);
  EXPECT_EQ(turn_of(p, Mode::kPaper, 1.0).wheelbase_m, 0.2);
  EXPECT_EQ(turn_of(p, Mode::kPaper, 1.0).x_icr_m, 0.0);

  TrackModel spinning(p, Mode::kExtended);
  const double slip = 1.0 - (p.slip_left + p.slip_right) / 2.0;
  EXPECT_NEAR(spinning.advance(-0.1, 0.1, 0.01).yaw_rate_radps, 0.2 * slip / 0.3, 1e-12);
}

}  // namespace
}  // namespace tp100::model
