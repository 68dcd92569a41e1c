#include <gtest/gtest.h>

#include <cmath>

#include "sim/sensors/drive_train.h"

namespace tp100::sim {
namespace {

double speed_after(double duty, double load_n, int steps = 1500) {
  Motor motor({}, 1.0);
  for (int i = 0; i < steps; ++i) motor.step(duty, 7.6, load_n);
  return motor.track_mps();
}

TEST(Motor, HasADeadBand) {
  EXPECT_EQ(speed_after(0.05, 0.0), 0.0);
  EXPECT_EQ(speed_after(-0.05, 0.0), 0.0);
  EXPECT_GT(speed_after(0.15, 0.0), 0.005);
}

TEST(Motor, TopSpeedIsThatOfTheRealKind) {
  EXPECT_GT(speed_after(1.0, 0.0), 0.14);
  EXPECT_LT(speed_after(1.0, 0.0), 0.29);
  EXPECT_NEAR(speed_after(-1.0, 0.0), -speed_after(1.0, 0.0), 1e-12);
}

TEST(Motor, CarriesTheLoadOfASpinAtTestSpeed) { EXPECT_GT(speed_after(1.0, 3.0), 0.12); }

TEST(Motor, ClimbsTwentyEightDegreesAtTestSpeedOnAnEmptyBattery) {
  const double load_n = 0.922 * 9.81 * std::sin(28.0 * M_PI / 180.0) / 2.0;
  Motor motor({}, 1.0);
  for (int i = 0; i < 1500; ++i) motor.step(1.0, 6.2, load_n);
  EXPECT_GT(motor.track_mps(), 0.12);
}

TEST(Motor, ReachesTwoThirdsOfItsSpeedInItsTimeConstant) {
  const double end = speed_after(0.8, 0.0);
  EXPECT_NEAR(speed_after(0.8, 0.0, 80), end * (1.0 - std::exp(-1.0)), 0.05 * end);
}

TEST(Motor, CoastsToRestWithoutDutyAndStaysThere) {
  Motor motor({}, 1.0);
  for (int i = 0; i < 500; ++i) motor.step(0.6, 7.6, 0.0);
  for (int i = 0; i < 1000; ++i) motor.step(0.0, 7.6, 0.3);
  EXPECT_EQ(motor.track_mps(), 0.0);
}

TEST(Motor, AStalledMotorMakesNoMoreThanTheCurrentLimit) {
  course::EmulatedMotor values;
  values.current_limit_n = 3.0;
  Motor motor(values, 1.0);
  motor.step(1.0, 8.2, 0.0);
  EXPECT_EQ(motor.force_n(), 3.0);
}

}  // namespace
}  // namespace tp100::sim
