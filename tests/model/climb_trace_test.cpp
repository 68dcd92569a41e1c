#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <utility>
#include <vector>

#include "model/climb_curve.h"
#include "model/step_climb.h"
#include "support/golden_trace.h"

namespace tp100::model {
namespace {

using test::GoldenTrace;

constexpr ClimbGeometry kOther{.axle_spacing_m = 0.151,
                               .wheel_radius_m = 0.029,
                               .com_forward_m = 0.081,
                               .com_height_m = 0.024,
                               .body_length_m = 0.21,
                               .body_height_m = 0.07};

TEST(GoldenTrace, OfEveryPartOfTheClimb) {
  GoldenTrace trace("model/climb_curve.csv",
                    {"travel_m", "angle_rad", "rate_radpm", "axle_x_m", "axle_z_m", "held_x_m",
                     "held_z_m", "direction_x", "direction_z", "bend_radpm2"});
  const auto row = [&](double travel_m, const Lean& lean, double bend = 0.0) {
    trace.row({travel_m, lean.angle_rad, lean.rate_radpm, lean.rear_axle.x, lean.rear_axle.z,
               lean.held_point.x, lean.held_point.z, lean.track_direction.x, lean.track_direction.z,
               bend});
  };
  for (const ClimbCurve& curve : {ClimbCurve({}, {}, RiserForm::kTrackHolds),
                                  ClimbCurve(kOther, {0.041, 0.087}, RiserForm::kPaper),
                                  ClimbCurve(kOther, {0.019, 0.12}, RiserForm::kTrackHolds)}) {
    const ClimbMarks& m = curve.marks();
    const auto rows = [&](double begin, double end, const std::function<void(double)>& at) {
      for (int i = 0; i <= 8 && end > begin; ++i) at(begin + (end - begin) * (0.01 + 0.12 * i));
    };
    rows(-0.1, 0.0, [&](double s) { row(s, curve.approach(s)); });
    rows(0.0, m.riser_end, [&](double s) { row(s, curve.riser(s)); });
    rows(m.riser_end, m.wrap_end, [&](double s) { row(s, curve.wrap(s)); });
    rows(m.wrap_end, m.cross_end, [&](double s) { row(s, curve.cross(s), curve.cross_bend(s)); });
    rows(m.cross_end, m.flat_end, [&](double s) { row(s, curve.about_near_edge(s, 5.0 * s)); });
    rows(m.flat_begin, m.nose_end, [&](double s) { row(s, curve.about_far_edge(s, -1.7 * s)); });
    rows(m.nose_begin, m.nose_end, [&](double s) { row(s, curve.nose(s)); });
    rows(m.nose_end, m.slide_end, [&](double s) { row(s, curve.slide(s)); });
    rows(m.slide_end, m.slide_end + 0.1, [&](double s) { row(s, curve.down(s)); });
  }
  EXPECT_EQ(trace.difference(), "");
}

TEST(GoldenTrace, OfTheMarksAndLimitsOfClimbs) {
  GoldenTrace trace(
      "model/climb_marks.csv",
      {"height_m", "riser_end", "wrap_end", "cross_end", "flat_begin", "flat_end", "nose_begin",
       "nose_end", "slide_end", "touch_x_m", "limit_m", "tip_rad", "gyration_m2"});
  for (int i = 0; i < 24; ++i) {
    const ClimbGeometry g{.axle_spacing_m = 0.14 + 0.02 * std::sin(0.9 * i),
                          .wheel_radius_m = 0.026 + 0.006 * std::sin(1.7 * i),
                          .com_forward_m = 0.068 + 0.013 * std::sin(0.6 * i + 1.0),
                          .com_height_m = 0.022 + 0.006 * std::cos(1.3 * i),
                          .body_length_m = 0.19 + 0.03 * std::sin(0.4 * i),
                          .body_height_m = 0.06 + 0.02 * std::cos(0.5 * i)};
    const double limit_m = climb_limit_m(g);
    const BlockShape block{limit_m * (0.99 - 0.035 * i), 0.05 + 0.01 * i};
    const RiserForm form = i % 3 == 1 ? RiserForm::kPaper : RiserForm::kTrackHolds;
    const StepClimb climb(g, block, form);
    const ClimbMarks& m = climb.curve().marks();
    trace.row({block.height_m, m.riser_end, m.wrap_end, m.cross_end, m.flat_begin, m.flat_end,
               m.nose_begin, m.nose_end, m.slide_end, climb.touch_x_m(), limit_m,
               tip_angle_rad(g, block.height_m).value_or(-1.0), gyration_squared_m2(g)});
  }
  // A centre of mass so low that the limit lies where the edge leaves the track's flat.
  for (const double com_height_m : {0.001, 0.004, 0.05, 0.09}) {
    ClimbGeometry g = kOther;
    g.com_height_m = com_height_m;
    trace.row({0, 0, 0, 0, 0, 0, 0, 0, 0, 0, climb_limit_m(g),
               tip_angle_rad(g, 0.9 * climb_limit_m(g)).value_or(-1.0), 0});
  }
  EXPECT_EQ(trace.difference(), "");
}

const std::vector<std::string> kStateColumns = {
    "phase",         "travel_m",      "pitch_rad",       "pitch_rate_radps",
    "com_x_m",       "com_z_m",       "com_x_mps",       "com_z_mps",
    "reference_x_m", "reference_z_m", "reference_x_mps", "reference_z_mps"};

void add(GoldenTrace& trace, const ClimbState& s) {
  trace.row({static_cast<double>(s.phase), s.travel_m, s.pitch_rad, s.pitch_rate_radps, s.com_m.x,
             s.com_m.z, s.com_mps.x, s.com_mps.z, s.reference_m.x, s.reference_m.z,
             s.reference_mps.x, s.reference_mps.z});
}

/// Advances by `speed(i)` for `steps` steps and records some of them, more of them while falling.
void drive(GoldenTrace& trace, StepClimb& climb, int steps, double dt_s, int every,
           const std::function<double(int)>& speed) {
  for (int i = 0; i < steps; ++i) {
    const ClimbState& state = climb.advance(speed(i) * dt_s, dt_s);
    const bool falling = state.phase == ClimbPhase::kTip || state.phase == ClimbPhase::kTipOff;
    if (i % (falling ? (every + 3) / 4 : every) == 0) add(trace, state);
  }
}

TEST(GoldenTrace, OfClimbsOverBlocksOfManyShapes) {
  GoldenTrace trace("model/climbs.csv", kStateColumns);
  struct Shape {
    ClimbGeometry geometry{};
    BlockShape block{};
    RiserForm form = RiserForm::kTrackHolds;
    TipStart start = TipStart::kBalance;
    double speed = 0.1;
  };
  const Shape shapes[] = {{},
                          {.form = RiserForm::kPaper, .start = TipStart::kLiftOff, .speed = 0.13},
                          {.start = TipStart::kLiftOff, .speed = 0.19},
                          {.block = {0.024, 0.07}, .speed = 0.07},
                          {.block = {0.039, 0.030}},
                          {.block = {0.037, 0.015}, .start = TipStart::kLiftOff, .speed = 0.22},
                          {.geometry = kOther, .block = {0.046, 0.13}, .speed = 0.28},
                          {.geometry = kOther, .block = {0.008, 0.09}, .speed = 0.45},
                          {.geometry = kOther, .block = {0.035, 0.11}, .speed = 0.6}};
  for (const Shape& c : shapes) {
    StepClimb climb(c.geometry, c.block, c.form, c.start);
    climb.reset(0.013);
    add(trace, climb.state());
    const double dt_s = 4.7e-4 / c.speed;
    drive(trace, climb, 920, dt_s, 28,
          [&](int i) { return c.speed * (1.0 + 0.4 * std::sin(0.021 * i)); });
  }
  EXPECT_EQ(trace.difference(), "");
}

TEST(GoldenTrace, OfClimbsBackAndForth) {
  GoldenTrace trace("model/climbs_back.csv", kStateColumns);
  for (const TipStart start : {TipStart::kBalance, TipStart::kLiftOff}) {
    StepClimb climb(kOther, {0.041, 0.093}, RiserForm::kTrackHolds, start);
    const ClimbMarks& m = climb.curve().marks();
    add(trace, climb.state());
    const auto until = [&](double travel_m, double speed) {
      const double dt_s = 0.0037;
      for (int i = 0; i < 3000 && (climb.state().travel_m < travel_m) == (speed > 0.0); ++i) {
        const ClimbState& s = climb.advance(speed * dt_s, dt_s);
        const bool falling = s.phase == ClimbPhase::kTip || s.phase == ClimbPhase::kTipOff;
        if (i % (falling ? 5 : 31) == 0) add(trace, s);
        if (falling && i > 400) break;
      }
      add(trace, climb.advance(0.0, 0.011));
    };
    until(m.riser_end / 2.0, 0.07);
    until(-0.004, -0.09);
    until((m.riser_end + m.wrap_end) / 2.0, 0.11);
    until(m.riser_end / 3.0, -0.06);
    until(m.cross_end - 0.0021, 0.08);
    // From slow to fast, so that the rear lifts off at once.
    until(m.cross_end + 0.0013, 0.55);
    until(m.wrap_end - 0.005, -0.3);
    until(m.cross_end + 0.003, 0.12);
    until(m.flat_end - 0.02, 0.12);
    until(m.flat_begin + 0.01, -0.1);
    until(m.wrap_end + 0.01, -0.1);
    until(m.flat_end + 0.004, 0.14);
    until(m.flat_begin + 0.02, -0.15);
    until(m.nose_end - 0.011, 0.13);
    until(m.flat_end - 0.012, -0.1);
    until((m.nose_end + m.slide_end) / 2.0, 0.1);
    until(m.nose_begin + 0.01, -0.08);
    until(m.slide_end + 0.02, 0.12);
    drive(trace, climb, 5, 0.01, 1, [](int i) { return i < 3 ? -0.12 : 0.09; });
  }
  // Back while it falls: on a block so short that the far edge is passed before the fall begins,
  // and just before it lands.
  for (const auto& [depth_m, pitch_rad] : {std::pair{0.009, -2.0}, std::pair{0.093, -0.3}}) {
    StepClimb climb(kOther, {0.041, depth_m});
    for (int i = 0; i < 3000 && (climb.state().phase != ClimbPhase::kTip ||
                                 climb.state().pitch_rad < pitch_rad);
         ++i)
      climb.advance(2e-4, 2e-3);
    const double back_mps = pitch_rad < -1.0 ? -0.2 : -0.6;
    drive(trace, climb, 80, 0.002, 5, [&](int) { return back_mps; });
  }
  EXPECT_EQ(trace.difference(), "");
}

TEST(GoldenTrace, OfClimbsInLongSteps) {
  GoldenTrace trace("model/climbs_long.csv", kStateColumns);
  for (const double dt_s : {0.09, 0.8, 4.0, 30.0}) {
    StepClimb climb(kOther, {0.041, 0.093});
    for (int i = 1; i <= 12; ++i)
      add(trace, climb.advance(0.031 + 0.012 * std::sin(1.3 * i), dt_s));
    for (int i = 1; i <= 4; ++i) add(trace, climb.advance(-0.11, dt_s));
  }
  EXPECT_EQ(trace.difference(), "");
}

}  // namespace
}  // namespace tp100::model
