#include "model/model_form.h"

#include <gtest/gtest.h>

#include <cmath>

#include "uneven_tracks.h"

namespace tp100::model {
namespace {

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
