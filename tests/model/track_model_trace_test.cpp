#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "core/arithmetic.h"
#include "model/model_form.h"
#include "model/track_model.h"
#include "support/golden_trace.h"

namespace tp100::model {
namespace {

using test::GoldenTrace;

/// Every parameter has an effect, and left and right differ.
TrackParameters uneven() {
  TrackParameters p;
  p.slip_left = 0.07;
  p.slip_right = 0.16;
  p.slip_angle_straight_rad = 0.021;
  p.slip_angle_turning_rad = -0.034;
  p.wheelbase_m = 0.29;
  p.x_icr_m = 0.012;
  p.wheelbase_medium_m = 0.33;
  p.wheelbase_tight_m = 0.37;
  p.x_icr_tight_shift_m = 0.006;
  p.wheelbase_spin_m = 0.42;
  p.x_icr_spin_shift_m = -0.019;
  p.turn_slip = 0.055;
  p.turn_slip_tight = 0.031;
  p.turn_loss = 0.043;
  p.gyro_scale = 1.07;
  p.turning_threshold_radps = 0.07;
  return p;
}

/// The wheelbases follow those of other turns.
TrackParameters inherited() {
  TrackParameters p = uneven();
  p.wheelbase_medium_m = p.wheelbase_tight_m = 0.0;
  return p;
}

TrackParameters with_slopes(std::vector<AddedSlip> slopes) {
  TrackParameters p = uneven();
  for (const AddedSlip& slope : slopes) p.added_slips[p.slopes++] = slope;
  return p;
}

TrackParameters uphill() {
  return with_slopes({{0.09, 0.011, 0.023}, {0.22, 0.067, 0.041}, {0.47, 0.18, 0.27}});
}
TrackParameters downhill() { return with_slopes({{-0.38, -0.12, -0.09}, {-0.15, -0.04, -0.07}}); }
TrackParameters both_ways() {
  return with_slopes({{-0.41, -0.13, -0.08}, {-0.12, -0.02, -0.05}, {0.19, 0.06, 0.03}});
}

std::vector<TrackParameters> robots() {
  return {{}, uneven(), inherited(), uphill(), downhill(), both_ways()};
}

TEST(GoldenTrace, OfTheTrackModelOverSlopesAndTurns) {
  GoldenTrace trace("model/track_model.csv",
                    {"x_m", "y_m", "z_m", "pitch_rad", "yaw_rad", "vx_mps", "vy_mps",
                     "yaw_rate_radps", "slip_left", "slip_right"});
  for (const TrackParameters& robot : robots()) {
    for (const Mode mode : {Mode::kPaper, Mode::kExtended}) {
      TrackModel model(robot, mode, 0.13);
      const auto row = [&] {
        const Pose& pose = model.pose();
        const Twist& twist = model.twist();
        trace.row({pose.x_m, pose.y_m, pose.z_m, pose.pitch_rad, pose.yaw_rad, twist.vx_mps,
                   twist.vy_mps, twist.yaw_rate_radps, model.slip().left, model.slip().right});
      };
      row();
      model.reset({.x_m = 0.4, .y_m = -0.7, .z_m = 0.2, .yaw_rad = 0.9});
      for (int i = 0; i < 32; ++i) {
        const double left = i % 11 == 5 ? 0.0 : 0.04 + 0.13 * std::sin(0.41 * i);
        const double right = i % 11 == 5 ? 0.0 : 0.05 + 0.11 * std::sin(0.27 * i + 0.8);
        Incline incline{.slope_rad = 0.55 * std::sin(0.37 * i),
                        .slip_offset = 0.04 * std::cos(0.7 * i),
                        .horizontal_fraction = 0.9 - 0.2 * std::sin(0.5 * i)};
        if (i < 6) incline = i < 3 ? Incline{} : Incline{.slip_offset = 0.06};
        if (i == 20) model.reset({.x_m = -0.3, .y_m = 0.6, .yaw_rad = -2.1});
        model.advance(left, right, 0.02 + 0.05 * (i % 4), incline);
        row();
      }
    }
  }
  EXPECT_EQ(trace.difference(), "");
}

TEST(GoldenTrace, OfTurnsFromStraightToTheSpot) {
  GoldenTrace trace("model/turns.csv",
                    {"wide", "tight", "medium", "arc", "spin", "curved", "wheelbase_m", "x_icr_m",
                     "slip", "inherited_m", "vx_mps", "vy_mps", "yaw_rate_radps"});
  const auto row = [&](double left, double right) {
    const TurnShape shape = turn_shape(left, right);
    const Turn turn = turn_of(uneven(), Mode::kExtended, shape);
    const Twist twist =
        body_twist(uneven(), Mode::kExtended, left, right, {.slope_rad = 0.1, .slip_offset = 0.02});
    trace.row({shape.wide, shape.tight, shape.medium, shape.arc, shape.spin, shape.curved,
               turn.wheelbase_m, turn.x_icr_m, turn.slip,
               turn_of(inherited(), Mode::kExtended, shape).wheelbase_m, twist.vx_mps, twist.vy_mps,
               twist.yaw_rate_radps});
  };
  row(0.0, 0.0);
  for (double ratio = -1.03; ratio < 1.0; ratio += 0.0237) row(0.11, 0.11 * ratio);
  for (double ratio = -1.02; ratio < 1.0; ratio += 0.0431) row(0.09 * ratio, 0.09);
  for (double ratio = -1.01; ratio < 1.0; ratio += 0.0719) row(-0.07 * ratio, -0.07);
  for (double ratio = -1.01; ratio < 1.0; ratio += 0.0819) row(-0.05, -0.05 * ratio);
  EXPECT_EQ(trace.difference(), "");
}

TEST(GoldenTrace, OfTheSlipOnSlopes) {
  GoldenTrace trace("model/slip.csv",
                    {"table_left",        "table_right",         "fit_left",
                     "fit_right",         "table_downhill_left", "table_downhill_right",
                     "fit_downhill_left", "fit_downhill_right",  "outside",
                     "outside_downhill",  "uphill_left",         "uphill_right",
                     "downhill_left",     "downhill_right",      "both_ways_left",
                     "both_ways_right",   "slip_left",           "slip_right",
                     "bound_left",        "bound_right"});
  const TrackParameters own[] = {uphill(), downhill(), both_ways()};
  TrackParameters by_the_table = uneven();
  for (double deg = -37.3; deg < 38.0; deg += 1.37) {
    const double slope = deg * kRadPerDeg;
    std::vector<double> values;
    bool outside[2] = {};
    for (const SlipCurve curve :
         {SlipCurve::kTable, SlipCurve::kFit, SlipCurve::kTableDownhill, SlipCurve::kFitDownhill}) {
      const SlipPair slip = slip_at_slope(slope, curve);
      values.insert(values.end(), {slip.left, slip.right});
      outside[curve == SlipCurve::kFitDownhill ? 1 : 0] = slip.outside;
    }
    values.insert(values.end(), {outside[0] ? 1.0 : 0.0, outside[1] ? 1.0 : 0.0});
    for (const TrackParameters& robot : own) {
      const AddedSlip added = added_slip(robot, slope);
      EXPECT_EQ(added.slope_rad, slope);
      values.insert(values.end(), {added.left, added.right});
    }
    by_the_table.slip_curve = deg > 10.0 ? SlipCurve::kFit : SlipCurve::kTableDownhill;
    const Slip slip = slip_on(by_the_table, Mode::kExtended, inclined(slope));
    const Slip bound = slip_on(both_ways(), Mode::kExtended,
                               {.slope_rad = slope, .slip_offset = 0.8 + 0.002 * deg});
    values.insert(values.end(), {slip.left, slip.right, bound.left, bound.right});
    trace.row(values);
  }
  EXPECT_EQ(trace.difference(), "");
}

TEST(GoldenTrace, OfDeadReckoningByEachForm) {
  GoldenTrace trace("model/forms.csv", {"form", "x_m", "y_m", "z_m", "pitch_rad", "yaw_rad"});
  double number = 0.0;
  const auto drive = [&](const ModelForm& form, const TrackParameters& robot, double lag_s) {
    DeadReckoning reckoning(form, robot, {.x_m = 0.3, .y_m = -0.2, .yaw_rad = 0.7}, lag_s);
    EXPECT_EQ(reckoning.pose().x_m, 0.3);
    for (int i = 0; i < 36; ++i) {
      reckoning.advance(0.06 + 0.12 * std::sin(0.31 * i), 0.07 + 0.1 * std::sin(0.23 * i + 1.1),
                        0.4 * std::cos(0.19 * i), 0.05 + 0.04 * (i % 3));
      const Pose& pose = reckoning.pose();
      if (i % 2 == 0)
        trace.row({number, pose.x_m, pose.y_m, pose.z_m, pose.pitch_rad, pose.yaw_rad});
    }
    ++number;
  };
  for (const ModelForm& form : kBaselines) {
    drive(form, form.fixed != nullptr ? form.fixed(0.147) : form.only(uneven()), kTurnLagS);
    // Also with parameters that the form does not have.
    drive(form, uneven(), 0.4);
  }
  drive(kExtendedForm, kExtendedForm.only(uneven()), 0.25);
  EXPECT_EQ(trace.difference(), "");
}

TEST(GoldenTrace, OfTheParametersThatEachFormKeeps) {
  std::vector<std::string> columns;
  for (const ParameterRow& of : kTrackParameters) columns.emplace_back(of.key);
  GoldenTrace trace("model/parameters.csv", columns);
  const auto row = [&](const TrackParameters& parameters) {
    std::vector<double> values;
    for (const ParameterRow& of : kTrackParameters) values.push_back(parameters.*of.value);
    trace.row(values);
  };
  row({});
  for (const ModelForm& form : kBaselines) {
    row(form.only(uneven()));
    if (form.fixed != nullptr) row(form.fixed(0.147));
  }
  row(kExtendedForm.only(uneven()));
  EXPECT_EQ(trace.difference(), "");
}

TEST(GoldenTrace, OfTheEquivalentWheelbase) {
  GoldenTrace trace("model/wheelbase.csv", {"wheelbase_m"});
  trace.row({equivalent_wheelbase_m({})});
  for (int i = 0; i < 20; ++i) {
    trace.row({equivalent_wheelbase_m({.length_m = 0.14 + 0.05 * std::sin(0.7 * i),
                                       .width_m = 0.18 + 0.04 * std::sin(1.1 * i),
                                       .offset_x_m = 0.013 * std::sin(0.5 * i + 1.0),
                                       .offset_y_m = 0.009 * std::cos(0.9 * i),
                                       .gamma = 0.3 * i})});
  }
  EXPECT_EQ(trace.difference(), "");
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

}  // namespace
}  // namespace tp100::model
