
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "model/track_model.h"

namespace tp100::model {
namespace {

TEST(Turn, GrowsFromStraightOverWideToTight) {
  EXPECT_EQ(turn_shape(0.0, 0.0).wide, 0.0);
  EXPECT_EQ(turn_shape(0.1, 0.1).wide, 0.0);
  EXPECT_NEAR(turn_shape(0.0775, 0.1).wide, 0.5, 1e-12);
  EXPECT_EQ(turn_shape(0.0775, 0.1).tight, 0.0);
  EXPECT_NEAR(turn_shape(0.055, 0.1).wide, 1.0, 1e-12);
  EXPECT_NEAR(turn_shape(0.045, 0.1).tight, 0.5, 1e-12);
  for (const double slower : {0.029, 0.0, -0.05, -0.1}) {
    EXPECT_EQ(turn_shape(slower, 0.1).wide, 1.0);
    EXPECT_EQ(turn_shape(slower, 0.1).tight, 1.0);
    EXPECT_EQ(turn_shape(0.1, slower).wide, -1.0);
  }
}

TEST(Turn, LeadsFromWideArcsOverMediumAndTightOnesToTheSpot) {
  EXPECT_EQ(turn_shape(0.091, 0.1).medium, 0.0);
  EXPECT_NEAR(turn_shape(0.0775, 0.1).medium, 0.5, 1e-12);
  EXPECT_EQ(turn_shape(0.066, 0.1).arc, 0.0);
  EXPECT_NEAR(turn_shape(0.05, 0.1).arc, 0.5, 1e-12);
  EXPECT_EQ(turn_shape(0.05, 0.1).medium, 1.0);
  EXPECT_EQ(turn_shape(0.036, 0.1).spin, 0.0);
  EXPECT_EQ(turn_shape(0.0025, 0.1).arc, 1.0);
  EXPECT_NEAR(turn_shape(0.0025, 0.1).spin, 0.5, 1e-12);
  EXPECT_NEAR(turn_shape(0.1, 0.0025).spin, 0.5, 1e-12);
  EXPECT_EQ(turn_shape(-0.031, 0.1).spin, 1.0);
}

TEST(Turn, CurvesWithThePathUntilTheSlowerTrackStandsStill) {
  EXPECT_EQ(turn_shape(0.1, 0.1).curved, 0.0);
  EXPECT_NEAR(turn_shape(0.09, 0.1).curved, 0.1 / 1.9, 1e-12);
  EXPECT_NEAR(turn_shape(0.05, 0.1).curved, 1.0 / 3.0, 1e-12);
  EXPECT_NEAR(turn_shape(0.1, 0.05).curved, 1.0 / 3.0, 1e-12);
  EXPECT_NEAR(turn_shape(-0.05, -0.1).curved, 1.0 / 3.0, 1e-12);
  for (const double slower : {0.0, -0.03, -0.1}) {
    EXPECT_NEAR(turn_shape(slower, 0.1).curved, 1.0, 1e-12);
    EXPECT_NEAR(turn_shape(0.1, slower).curved, 1.0, 1e-12);
  }
}

TEST(Turn, LosesAsMuchDistanceToEitherSideAndTurnsAsBefore) {
  TrackParameters p, without;
  p.turn_loss = 0.06;
  const auto twist = [](const TrackParameters& of, Mode mode, double left, double right) {
    return body_twist(of, mode, left / (1.0 - of.slip_left), right / (1.0 - of.slip_right));
  };
  for (const auto& [left, right] : {std::pair{0.05, 0.1}, std::pair{0.1, 0.05}}) {
    const Twist with = twist(p, Mode::kExtended, left, right);
    const Twist plain = twist(without, Mode::kExtended, left, right);
    EXPECT_NEAR(with.vx_mps, plain.vx_mps * 0.98, 1e-12);
    EXPECT_EQ(with.yaw_rate_radps, plain.yaw_rate_radps);
    EXPECT_EQ(twist(p, Mode::kPaper, left, right).vx_mps, plain.vx_mps);
  }
  EXPECT_NEAR(twist(p, Mode::kExtended, 0.1, 0.1).vx_mps, 0.1, 1e-12);
  EXPECT_NEAR(twist(p, Mode::kExtended, -0.1, 0.1).vx_mps, 0.0, 1e-12);
}

TEST(Turn, OnlyTheRatioOfTheSpeedsCounts) {
  for (const double ratio : {-1.0, -0.3, 0.1, 0.35, 0.5, 0.9}) {
    const TurnShape shape = turn_shape(ratio, 1.0);
    EXPECT_NEAR(turn_shape(ratio * 0.01, 0.01).tight, shape.tight, 1e-12);
    EXPECT_NEAR(turn_shape(0.2, ratio * 0.2).wide, -shape.wide, 1e-12);
    EXPECT_NEAR(turn_shape(0.2, ratio * 0.2).tight, shape.tight, 1e-12);
    EXPECT_NEAR(turn_shape(0.2, ratio * 0.2).medium, shape.medium, 1e-12);
    EXPECT_NEAR(turn_shape(0.2, ratio * 0.2).arc, shape.arc, 1e-12);
    EXPECT_NEAR(turn_shape(0.2, ratio * 0.2).spin, shape.spin, 1e-12);
  }
}

TEST(Turn, FewEdgesPerIntervalDoNotLookLikeTurns) {
  TurnShapeFilter watch;
  double most = 0.0;
  for (int i = 0; i < 400; ++i) {
    // A speed of 1.5 edges per interval gives one and two edges in turn.
    const TurnShape shape = watch.update(i % 2 == 0 ? 0.1 : 0.2, i % 2 == 0 ? 0.2 : 0.1, 0.005);
    if (i > 100) most = std::max({most, shape.tight, std::abs(shape.wide)});
  }
  EXPECT_LT(most, 0.1);
}

TEST(Turn, WheelbaseTurningCentreAndSlipGoFromTheirWideToTheirTightValues) {
  TrackParameters p;
  p.wheelbase_m = 0.2;
  p.x_icr_m = 0.01;
  const TurnShape straight{}, wide{.wide = 1.0}, medium{.wide = 1.0, .medium = 1.0},
      between{.wide = -1.0, .tight = 0.5, .medium = 1.0, .arc = 0.5},
      spin{.wide = 1.0, .tight = 1.0, .medium = 1.0, .arc = 1.0, .spin = 1.0};
  EXPECT_EQ(turn_of(p, Mode::kExtended, spin).wheelbase_m, 0.2);
  p.wheelbase_spin_m = 0.3;
  p.x_icr_spin_shift_m = -0.02;
  p.turn_slip = 0.04;
  p.turn_slip_tight = 0.02;
  EXPECT_EQ(turn_of(p, Mode::kExtended, wide).wheelbase_m, 0.2);
  EXPECT_EQ(turn_of(p, Mode::kExtended, wide).x_icr_m, 0.01);
  EXPECT_EQ(turn_of(p, Mode::kExtended, medium).wheelbase_m, 0.2);
  EXPECT_NEAR(turn_of(p, Mode::kExtended, between).wheelbase_m, 0.25, 1e-12);
  EXPECT_NEAR(turn_of(p, Mode::kExtended, spin).x_icr_m, -0.01, 1e-12);
  p.wheelbase_tight_m = 0.22;
  p.x_icr_tight_shift_m = 0.006;
  const TurnShape tight{.wide = 1.0, .tight = 1.0, .medium = 1.0, .arc = 1.0},
      past_it{.wide = 1.0, .tight = 1.0, .medium = 1.0, .arc = 1.0, .spin = 0.5};
  EXPECT_NEAR(turn_of(p, Mode::kExtended, between).wheelbase_m, 0.21, 1e-12);
  EXPECT_NEAR(turn_of(p, Mode::kExtended, tight).wheelbase_m, 0.22, 1e-12);
  EXPECT_NEAR(turn_of(p, Mode::kExtended, past_it).wheelbase_m, 0.26, 1e-12);
  EXPECT_NEAR(turn_of(p, Mode::kExtended, between).x_icr_m, 0.013, 1e-12);
  EXPECT_NEAR(turn_of(p, Mode::kExtended, past_it).x_icr_m, 0.01 + (0.006 - 0.02) / 2.0, 1e-12);
  p.wheelbase_medium_m = 0.21;
  const TurnShape less{.wide = 1.0, .medium = 0.5};
  EXPECT_EQ(turn_of(p, Mode::kExtended, wide).wheelbase_m, 0.2);
  EXPECT_NEAR(turn_of(p, Mode::kExtended, less).wheelbase_m, 0.205, 1e-12);
  EXPECT_NEAR(turn_of(p, Mode::kExtended, medium).wheelbase_m, 0.21, 1e-12);
  EXPECT_NEAR(turn_of(p, Mode::kExtended, between).wheelbase_m, 0.215, 1e-12);
  EXPECT_NEAR(turn_of(p, Mode::kExtended, tight).wheelbase_m, 0.22, 1e-12);
  EXPECT_EQ(turn_of(p, Mode::kExtended, medium).x_icr_m, 0.01);
  EXPECT_EQ(turn_of(p, Mode::kExtended, spin).wheelbase_m, 0.3);
  EXPECT_EQ(turn_of(p, Mode::kExtended, straight).slip, 0.0);
  EXPECT_NEAR(turn_of(p, Mode::kExtended, wide).slip, 0.04, 1e-12);
  EXPECT_NEAR(turn_of(p, Mode::kExtended, between).slip, -0.03, 1e-12);
  EXPECT_EQ(turn_of(p, Mode::kPaper, spin).wheelbase_m, 0.2);
  EXPECT_EQ(turn_of(p, Mode::kPaper, spin).x_icr_m, 0.0);
  EXPECT_EQ(turn_of(p, Mode::kPaper, wide).slip, 0.0);

  TrackModel spinning(p, Mode::kExtended);
  const double slip = 1.0 - (p.slip_left + p.slip_right) / 2.0;
  EXPECT_NEAR(spinning.advance(-0.1, 0.1, 0.01).yaw_rate_radps, 0.2 * slip / 0.3, 1e-12);
}

}  // namespace
}  // namespace tp100::model
