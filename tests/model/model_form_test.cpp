#include "model/model_form.h"

#include <gtest/gtest.h>

#include <cmath>

namespace tp100::model {
namespace {

TEST(ModelForm, EachIsFixedOrHasConstants) {
  for (const ModelForm& form : kBaselines) {
    SCOPED_TRACE(form.key);
    EXPECT_EQ(form.fixed == nullptr, form.constants() > 0);
    EXPECT_EQ(&form, &kBaselines[baseline(form.key)]);
  }
  EXPECT_EQ(kBaselines[baseline("differential_fitted")].constants(), 2);
  EXPECT_EQ(kBaselines[baseline("eqs_1_5")].constants(), 5);
  EXPECT_EQ(kBaselines[baseline("icr")].constants(), 4);
  EXPECT_EQ(kBaselines[baseline("gyro")].constants(), 2);
  EXPECT_EQ(kExtendedForm.constants(), 14);
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
  EXPECT_EQ(gauge.slip_angle_straight_rad, 0.0);
  const TrackParameters printed = kBaselines[kEqsPrinted].fixed(0.155);
  EXPECT_EQ(printed.wheelbase_m, 0.2742);
  EXPECT_EQ(printed.slip_right, 0.1188);
}

/// A fifth of a second after another, at speeds that differ; `gyro_radps` throughout.
template <class Each>
void drive(double gyro_radps, const Each& each) {
  for (int i = 0; i < 60; ++i) each(0.08 + 0.001 * i, 0.15 - 0.002 * i, gyro_radps, 0.2);
}

// Small steps of the textbook's differential drive, without any code under test.
TEST(DeadReckoning, TheDifferentialDriveIsTheTextbooks) {
  DeadReckoning reckoning(kBaselines[baseline("differential")], without_slip(0.16),
                          {.x_m = 1.0, .y_m = -2.0, .yaw_rad = 0.5});
  double x = 1.0, y = -2.0, yaw = 0.5;
  drive(9.9, [&](double left, double right, double gyro, double dt_s) {
    reckoning.advance(left, right, gyro, dt_s);
    for (int i = 0; i < 2000; ++i) {
      const double step_s = dt_s / 2000, turn = (right - left) / 0.16 * step_s;
      x += (left + right) / 2 * std::cos(yaw + turn / 2) * step_s;
      y += (left + right) / 2 * std::sin(yaw + turn / 2) * step_s;
      yaw += turn;
    }
  });
  EXPECT_NEAR(reckoning.pose().x_m, x, 1e-8);
  EXPECT_NEAR(reckoning.pose().y_m, y, 1e-8);
  EXPECT_NEAR(reckoning.pose().yaw_rad, yaw, 1e-9);
}

TEST(DeadReckoning, TheGyroFormTurnsByTheGyroAlone) {
  TrackParameters parameters = kBaselines[baseline("gyro")].only({});
  parameters.slip_left = 0.2;
  parameters.slip_right = 0.9;  // not of this form
  parameters.gyro_scale = 1.1;
  DeadReckoning reckoning(kBaselines[baseline("gyro")], parameters);
  double x = 0.0, y = 0.0, yaw = 0.0;
  drive(0.3, [&](double left, double right, double gyro, double dt_s) {
    reckoning.advance(left, right, gyro, dt_s);
    for (int i = 0; i < 2000; ++i) {
      const double step_s = dt_s / 2000, turn = 1.1 * 0.3 * step_s;
      x += 0.8 * (left + right) / 2 * std::cos(yaw + turn / 2) * step_s;
      y += 0.8 * (left + right) / 2 * std::sin(yaw + turn / 2) * step_s;
      yaw += turn;
    }
  });
  EXPECT_NEAR(reckoning.pose().x_m, x, 1e-8);
  EXPECT_NEAR(reckoning.pose().y_m, y, 1e-8);
  EXPECT_NEAR(reckoning.pose().yaw_rad, yaw, 1e-9);
}

TEST(DeadReckoning, TheExtendedFormIsTheModelOnFlatGround) {
  TrackParameters parameters;
  parameters.wheelbase_spin_m = 0.2;
  parameters.turn_slip = 0.05;
  DeadReckoning reckoning(kExtendedForm, parameters);
  TrackModel model(parameters, Mode::kExtended);
  drive(0.3, [&](double left, double right, double gyro, double dt_s) {
    reckoning.advance(left, right, gyro, dt_s);
    model.advance(left, right, dt_s);
    EXPECT_EQ(reckoning.pose().x_m, model.pose().x_m);
    EXPECT_EQ(reckoning.pose().yaw_rad, model.pose().yaw_rad);
  });
}

}  // namespace
}  // namespace tp100::model
