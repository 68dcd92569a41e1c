// Eqs 1-5, the extended model and simpler forms: slip, turns and the motion that follows.

#include "model/track_model.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include "core/arithmetic.h"
#include "model/model_form.h"
#include "support/sequence.h"
#include "uneven_tracks.h"

namespace tp100::model {
namespace {

// Eqs 1-5 written independently and integrated with fourth-order Runge-Kutta in very small steps.
Pose reference(double left, double right, double duration_s, int steps) {
  const double al = 0.1, ar = 0.1188, wheelbase = 0.2742;
  const double vx = (right * (1 - ar) + left * (1 - al)) / 2;
  const double rate = (right * (1 - ar) - left * (1 - al)) / wheelbase;
  const double beta = std::abs(rate) > 0.05 ? 0.0 : 0.404 * std::acos(-1.0) / 180.0;
  const double vy = vx * std::tan(beta);
  const auto flow = [&](double yaw) {
    return std::array{vx * std::cos(yaw) - vy * std::sin(yaw),
                      vx * std::sin(yaw) + vy * std::cos(yaw)};
  };
  Pose pose;
  const double h = duration_s / steps;
  for (int i = 0; i < steps; ++i) {
    const double yaw = rate * h * i;
    const auto a = flow(yaw), b = flow(yaw + rate * h / 2), c = flow(yaw + rate * h);
    pose.x_m += h / 6 * (a[0] + 4 * b[0] + c[0]);
    pose.y_m += h / 6 * (a[1] + 4 * b[1] + c[1]);
  }
  pose.yaw_rad = rate * duration_s;
  return pose;
}

// Whatever the step size, on any slope, which eqs 1-5 do not know.
TEST(TrackModel, PaperModeAgreesWithAnIndependentIntegration) {
  constexpr double kDurationS = 12.0;
  for (const auto& [left, right] : {std::pair{0.1, 0.1},
                                    {0.1, 0.1 * 0.9 / 0.8812},
                                    {0.05, 0.15},
                                    {-0.1, 0.1},
                                    {0.1, -0.1},
                                    {-0.12, -0.08},
                                    {0.0, 0.0},
                                    {0.0, 0.2},
                                    {0.1, 0.117}}) {
    const Pose expected = reference(left, right, kDurationS, 20000);
    for (const int steps : {1, 7, 240, 12000}) {
      SCOPED_TRACE(testing::Message() << left << ' ' << right << ' ' << steps);
      TrackModel model(TrackParameters{}, Mode::kPaper);
      for (int i = 0; i < steps; ++i)
        model.advance(left, right, kDurationS / steps, {0.3, 0.2, 0.7});
      EXPECT_NEAR(model.pose().x_m, expected.x_m, 1e-9);
      EXPECT_NEAR(model.pose().y_m, expected.y_m, 1e-9);
      EXPECT_NEAR(model.pose().yaw_rad, expected.yaw_rad, 1e-9) << "not wrapped";
      EXPECT_EQ(model.pose().z_m, 0.0);
      EXPECT_EQ(model.pose().pitch_rad, 0.0);
    }
  }
}

// The equations of the extended model, integrated in small steps; the shape of the turn is that of
// track speeds that a low-pass of 0.13 s smooths.
TEST(TrackModel, ExtendedModeIsItsEquationsInAnyTurnOnAnyGround) {
  const TrackParameters p = uneven_tracks();
  test::Sequence any(4);
  TrackModel model(p, Mode::kExtended, 0.13);
  Pose pose{.x_m = 0.4, .y_m = -0.7, .z_m = 0.2, .yaw_rad = 0.9};
  model.begin(pose);
  double smooth_left = 0.0, smooth_right = 0.0;
  int straight = 0;
  for (int i = 0; i < 400; ++i) {
    const double left_mps = any.between(-0.2, 0.2), dt_s = any.between(0.005, 0.2);
    const double right_mps = i % 3 == 0 ? left_mps * any.between(1.0, 1.2) : any.between(-0.2, 0.2);
    const Incline on{i % 4 == 0 ? 0.0 : any.between(-0.5, 0.5), any.between(-0.05, 0.05),
                     any.between(0.5, 1.0)};
    if (i == 200) {
      pose = {.x_m = 1.0, .yaw_rad = 2.0};
      model.begin(pose);
    }
    const Slip slip = slip_on(p, Mode::kExtended, on);
    const double left = left_mps * (1.0 - slip.left), right = right_mps * (1.0 - slip.right);
    const double share = i % 200 == 0 ? 1.0 : 1.0 - std::exp(-dt_s / 0.13);
    smooth_left += (left - smooth_left) * share;
    smooth_right += (right - smooth_right) * share;
    const Turn turn = turn_of(p, Mode::kExtended, turn_shape(smooth_left, smooth_right));
    const double vx = (left + right) / 2.0 * (1.0 - turn.slip);
    const double rate = (right - left) / turn.wheelbase_m;
    const bool turns = std::abs(rate) > p.turning_threshold_radps;
    straight += turns ? 0 : 1;
    const double vy = vx * std::tan(turns ? p.slip_angle_turning_rad : p.slip_angle_straight_rad) -
                      turn.x_icr_m * rate;
    constexpr int kSteps = 200;
    for (int n = 0; n < kSteps; ++n) {
      const double step_s = dt_s / kSteps, yaw = pose.yaw_rad + rate * step_s / 2.0;
      const double forward = vx * on.horizontal_fraction;
      pose.x_m += (forward * std::cos(yaw) - vy * std::sin(yaw)) * step_s;
      pose.y_m += (forward * std::sin(yaw) + vy * std::cos(yaw)) * step_s;
      pose.z_m += vx * std::sin(on.slope_rad) * step_s;
      pose.yaw_rad += rate * step_s;
    }
    const Twist& twist = model.advance(left_mps, right_mps, dt_s, on);
    ASSERT_NEAR(twist.vx_mps, vx, 1e-12) << i;
    ASSERT_NEAR(twist.vy_mps, vy, 1e-12) << i;
    ASSERT_NEAR(twist.yaw_rate_radps, rate, 1e-12) << i;
    ASSERT_EQ(model.slip().left, slip.left);
    ASSERT_EQ(model.slip().right, slip.right);
    ASSERT_NEAR(model.pose().x_m, pose.x_m, 1e-5) << i;
    ASSERT_NEAR(model.pose().y_m, pose.y_m, 1e-5) << i;
    ASSERT_NEAR(model.pose().z_m, pose.z_m, 1e-9) << i;
    ASSERT_NEAR(model.pose().yaw_rad, pose.yaw_rad, 1e-9) << i;
    ASSERT_EQ(model.pose().pitch_rad, -on.slope_rad);
    // Without a filter the shape is that of the same speeds.
    const Twist alone = body_twist(p, Mode::kExtended, left_mps, right_mps, on);
    ASSERT_NEAR(alone.yaw_rate_radps,
                (right - left) / turn_of(p, Mode::kExtended, turn_shape(left, right)).wheelbase_m,
                1e-12);
  }
  EXPECT_GT(straight, 20);
}

// The series and the closed form of the arc.
TEST(Arc, OfATinyTurnIsExactToItsSecondOrder) {
  for (const double turn : {-3e-3, -1.01e-4, -9.9e-5, -4e-5, 6e-5, 9.9e-5, 1.01e-4, 2e-3}) {
    Pose ahead{}, aside{};
    advance(ahead, {.vx_mps = 2.0, .yaw_rate_radps = 2.0 * turn}, 0.5);
    EXPECT_NEAR(ahead.x_m, 1.0 - turn * turn / 6.0, 1e-12) << turn;
    EXPECT_NEAR(1.0 - ahead.x_m, turn * turn / 6.0, 1e-5 * turn * turn) << turn;
    EXPECT_NEAR(ahead.y_m, turn / 2.0, 1e-6 * std::abs(turn)) << turn;
    advance(aside, {.vy_mps = 2.0, .yaw_rate_radps = 2.0 * turn}, 0.5);
    EXPECT_NEAR(aside.y_m, ahead.x_m, 1e-15) << turn;
    EXPECT_NEAR(aside.x_m, -ahead.y_m, 1e-15) << turn;
  }
}

/// Speeds of the two tracks in turns of every kind, also straight on and on the spot.
template <class Check>
void for_many_turns(Check check) {
  test::Sequence any(6);
  for (int i = 0; i < 2000; ++i) {
    SCOPED_TRACE(i);
    const double left = any.between(-0.2, 0.2);
    check(left, i % 10 == 0 ? left : i % 10 == 1 ? -left : any.between(-0.2, 0.2), any);
  }
}

/// 0 up to `from`, 1 from `to` on.
double rising(double value, double from, double to) {
  return std::clamp((value - from) / (to - from), 0.0, 1.0);
}

// By the difference of the tracks' speeds, as a share of the faster one's.
TEST(Turn, GrowsFromStraightOverArcsToTheSpotWithTheRatioOfTheSpeeds) {
  for_many_turns([](double left, double right, test::Sequence&) {
    const double share = (right - left) / std::max(std::abs(left), std::abs(right));
    const double turn = std::abs(share);
    const TurnShape is = turn_shape(left, right);
    EXPECT_NEAR(is.wide, std::clamp(share / 0.45, -1.0, 1.0) * (1.0 - rising(turn, 0.45, 0.65)),
                1e-12);
    EXPECT_NEAR(is.medium, rising(turn, 0.1, 0.35), 1e-12);
    EXPECT_NEAR(is.arc, rising(turn, 0.35, 0.65), 1e-12);
    EXPECT_NEAR(is.spin, rising(turn, 0.65, 1.3), 1e-12);
    // As the curvature of the path, until the slower track stands still.
    EXPECT_NEAR(is.curved, std::min(1.0, turn / (2.0 - std::min(turn, 1.0))), 1e-12);
  });
  EXPECT_EQ(turn_shape(0.0, 0.0).wide, 0.0);
  EXPECT_EQ(turn_shape(0.0, 0.0).curved, 0.0);
}

// What is not given is that of the next kind of turn: on the spot that of arcs, in arcs that of
// wide ones or of the spot.
TEST(Turn, WheelbaseTurningCentreAndSlipGoFromTheirWideToTheirTightValues) {
  for_many_turns([](double left, double right, test::Sequence& any) {
    TrackParameters p = uneven_tracks();
    for (double* value : {&p.wheelbase_medium_m, &p.wheelbase_tight_m, &p.wheelbase_spin_m})
      if (any.chance(0.3)) *value = 0.0;
    const double spin = p.wheelbase_spin_m > 0.0 ? p.wheelbase_spin_m : p.wheelbase_m;
    const double tight = p.wheelbase_tight_m > 0.0 ? p.wheelbase_tight_m : spin;
    const double medium = p.wheelbase_medium_m > 0.0 ? p.wheelbase_medium_m : p.wheelbase_m;
    const TurnShape s = turn_shape(left, right);
    const double arc = p.wheelbase_m + s.medium * (medium - p.wheelbase_m);
    const double tighter = arc + s.arc * (tight - arc);
    const Turn is = turn_of(p, Mode::kExtended, s);
    EXPECT_NEAR(is.wheelbase_m, tighter + s.spin * (spin - tighter), 1e-12);
    EXPECT_NEAR(is.x_icr_m, p.x_icr_m + s.spin * p.x_icr_spin_shift_m, 1e-12);
    EXPECT_NEAR(is.slip, s.wide * p.turn_slip + s.curved * p.turn_loss, 1e-12);
    const Turn paper = turn_of(p, Mode::kPaper, s);
    EXPECT_EQ(paper.wheelbase_m, p.wheelbase_m);
    EXPECT_EQ(paper.x_icr_m, 0.0);
    EXPECT_EQ(paper.slip, 0.0);
  });
}

TEST(Turn, FewEdgesPerIntervalDoNotLookLikeTurns) {
  TurnShapeFilter watch;
  double most = 0.0;
  for (int i = 0; i < 400; ++i) {
    // A speed of 1.5 edges per interval gives one and two edges in turn.
    const TurnShape shape = watch.update(i % 2 == 0 ? 0.1 : 0.2, i % 2 == 0 ? 0.2 : 0.1, 0.005);
    if (i > 100) most = std::max({most, shape.arc, std::abs(shape.wide)});
  }
  EXPECT_LT(most, 0.1);
}

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

Slip at_deg(double deg, SlipCurve curve) { return slip_at_slope(deg * kRadPerDeg, curve); }

TEST(SlipTable, GivesThePrintedRowsAndIsLinearBetweenThem) {
  const SlipRow printed[] = {{0, 0.16, 0.162},  {8, 0.17, 0.176},  {12, 0.18, 0.197},
                             {16, 0.19, 0.204}, {20, 0.20, 0.218}, {24, 0.21, 0.247},
                             {28, 0.22, 0.260}};
  for (const SlipCurve curve : {SlipCurve::kTable, SlipCurve::kTableDownhill}) {
    for (std::size_t i = 0; i + 1 < std::size(printed); ++i) {
      const SlipRow &low = printed[i], &high = printed[i + 1];
      for (const double share : {0.001, 0.25, 0.999}) {
        const Slip slip = at_deg(std::lerp(low.slope_deg, high.slope_deg, share), curve);
        EXPECT_NEAR(slip.left, std::lerp(low.left, high.left, share), 1e-12);
        EXPECT_NEAR(slip.right, std::lerp(low.right, high.right, share), 1e-12);
      }
    }
  }
}

// Outside the table each curve is held at its ends, or falls downhill like the fit to -28 deg.
TEST(SlipTable, OutsideItsRowsEachCurveIsHeldOrFallsLikeTheFit) {
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
    const Slip slip = at_deg(of.deg, of.curve);
    EXPECT_NEAR(slip.left, of.left, 1e-9) << of.deg;
    EXPECT_NEAR(slip.right, of.right, 1e-9) << of.deg;
    EXPECT_EQ(at_deg(kNan, of.curve).left, at_deg(0.0, of.curve).left) << "of no angle";
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
        const Slip here = at_deg(deg, curve), level = at_deg(0.0, curve);
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

TEST(ModelForm, EachIsFixedOrHasConstants) {
  for (const ModelForm& form : kBaselines) {
    EXPECT_EQ(form.fixed == nullptr, form.constants() > 0) << form.key;
    EXPECT_EQ(&form, &kBaselines[baseline(form.key)]);
  }
  EXPECT_EQ(baseline("none"), kBaselines.size());
}

TEST(ModelForm, WhatAFormDoesNotHaveIsSwitchedOff) {
  TrackParameters all;
  for (const ParameterRow& row : kTrackParameters) all.*row.value = 0.3;
  const TrackParameters only = kBaselines[baseline("icr")].only(all);
  EXPECT_EQ(only.slip_left, 0.3);
  EXPECT_EQ(only.slip_right, 0.3);
  EXPECT_EQ(only.x_icr_m, 0.3);
  EXPECT_EQ(only.slip_angle_straight_rad, 0.0);
  EXPECT_EQ(only.wheelbase_tight_m, 0.0);
  EXPECT_EQ(only.turn_slip, 0.0);
  const TrackParameters extended = kExtendedForm.only(all);
  for (const ParameterRow& row : kTrackParameters) EXPECT_EQ(extended.*row.value, 0.3) << row.key;
}

TEST(ModelForm, TheFixedOnesAreTheGaugeAndThePrintedConstants) {
  const TrackParameters gauge = kBaselines[baseline("differential")].fixed(0.155);
  EXPECT_EQ(gauge.wheelbase_m, 0.155);
  EXPECT_EQ(gauge.slip_left, 0.0);
  EXPECT_EQ(kBaselines[kEqsPrinted].fixed(0.155).wheelbase_m, 0.2742);
}

/// A fifth of a second after another, at speeds that differ; the gyro reads 0.3 rad/s throughout.
template <class Each>
void drive(const Each& each) {
  for (int i = 0; i < 60; ++i) each(0.08 + 0.001 * i, 0.15 - 0.002 * i, 0.3, 0.2);
}

/// Small steps of a robot that moves by `share` of its tracks' mean and turns at `turn_radps` of
/// its tracks and its gyro, without any code under test.
template <class Turn>
void expect_reckoned(const char* form, const TrackParameters& parameters, double share,
                     Turn turn_radps) {
  DeadReckoning reckoning(kBaselines[baseline(form)], parameters,
                          {.x_m = 1.0, .y_m = -2.0, .yaw_rad = 0.5});
  double x = 1.0, y = -2.0, yaw = 0.5;
  drive([&](double left, double right, double gyro, double dt_s) {
    reckoning.advance(left, right, gyro, dt_s);
    for (int i = 0; i < 2000; ++i) {
      const double step_s = dt_s / 2000, turn = turn_radps(left, right, gyro) * step_s;
      x += share * (left + right) / 2 * std::cos(yaw + turn / 2) * step_s;
      y += share * (left + right) / 2 * std::sin(yaw + turn / 2) * step_s;
      yaw += turn;
    }
  });
  EXPECT_NEAR(reckoning.pose().x_m, x, 1e-8) << form;
  EXPECT_NEAR(reckoning.pose().y_m, y, 1e-8) << form;
  EXPECT_NEAR(reckoning.pose().yaw_rad, yaw, 1e-9) << form;
}

TEST(DeadReckoning, TurnsByTheTextbooksDifferentialDriveOrByTheGyroAlone) {
  expect_reckoned("differential", without_slip(0.16), 1.0,
                  [](double left, double right, double) { return (right - left) / 0.16; });
  TrackParameters gyro = kBaselines[baseline("gyro")].only({});
  gyro.slip_left = 0.2;
  gyro.slip_right = 0.9;  // not of this form
  gyro.gyro_scale = 1.1;
  expect_reckoned("gyro", gyro, 0.8, [](double, double, double radps) { return 1.1 * radps; });
}

TEST(DeadReckoning, TheExtendedFormIsTheModelOnFlatGround) {
  const TrackParameters parameters = uneven_tracks();
  DeadReckoning reckoning(kExtendedForm, parameters);
  TrackModel model(parameters, Mode::kExtended);
  drive([&](double left, double right, double gyro, double dt_s) {
    reckoning.advance(left, right, gyro, dt_s);
    model.advance(left, right, dt_s);
    EXPECT_EQ(reckoning.pose().x_m, model.pose().x_m);
    EXPECT_EQ(reckoning.pose().yaw_rad, model.pose().yaw_rad);
  });
}

}  // namespace
}  // namespace tp100::model
