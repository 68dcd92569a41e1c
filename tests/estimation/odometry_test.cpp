#include "estimation/odometry.h"

#include <gtest/gtest.h>

#include <cmath>

namespace tp100::estimation {
namespace {

TEST(Odometry, TurnsWithTheGyroAndNotWithTheTracks) {
  Odometry odometry(model::TrackParameters{});
  odometry.advance({.left_mps = 0.05, .right_mps = 0.15}, 0.0, 1.0);
  EXPECT_EQ(odometry.pose().yaw_rad, 0.0);
  odometry.advance({.left_mps = 0.1, .right_mps = 0.1}, 0.7, 1.0);
  EXPECT_NEAR(odometry.pose().yaw_rad, 0.7, 1e-12);
}

TEST(Odometry, WithoutAGyroItIsTheExtendedModel) {
  // Turns of every shape, each with its own wheelbase.
  model::TrackParameters parameters;
  parameters.slip_left = 0.3;
  parameters.wheelbase_tight_m = 0.30;
  parameters.wheelbase_spin_m = 0.35;
  Odometry odometry(parameters);
  model::TrackModel model(parameters, model::Mode::kExtended);
  for (int i = 0; i < 150; ++i) {
    const double left = 0.1 + 0.001 * i, right = 0.12 - 0.001 * i;
    odometry.advance_without_gyro({left, right}, 0.1);
    model.advance(left, right, 0.1);
  }
  EXPECT_EQ(odometry.pose().x_m, model.pose().x_m);
  EXPECT_EQ(odometry.pose().y_m, model.pose().y_m);
  EXPECT_EQ(odometry.pose().yaw_rad, model.pose().yaw_rad);
}

TEST(Odometry, AQuarterCircleEndsWhereGeometrySays) {
  model::TrackParameters parameters;
  parameters.slip_left = parameters.slip_right = 0.2;
  Odometry odometry(parameters);
  const double rate = 0.25, speed = 0.1;
  const double duration_s = kPi / 2 / rate;
  for (int i = 0; i < 100; ++i) {
    odometry.advance({speed / 0.8, speed / 0.8}, rate, duration_s / 100);
  }
  EXPECT_NEAR(odometry.pose().x_m, speed / rate, 1e-9);
  EXPECT_NEAR(odometry.pose().y_m, speed / rate, 1e-9);
}

}  // namespace
}  // namespace tp100::estimation
