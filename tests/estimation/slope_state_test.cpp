#include <gtest/gtest.h>

#include <random>

#include "core/arithmetic.h"
#include "estimation/attitude.h"
#include "interval.h"

namespace tp100::estimation {
namespace {

constexpr double kDeg = kRadPerDeg;

TEST(SlopeState, FindsARampWithin300MillisecondsOfFourDegrees) {
  SlopeState state{{}};
  double pitch_deg = 0.0, passed_s = -1.0, found_s = -1.0;
  for (int i = 0; i < 400; ++i) {
    pitch_deg -= 20.0 * kDt;
    const double now_s = i * kDt;
    if (passed_s < 0.0 && pitch_deg < -4.0) passed_s = now_s;
    if (state.update(pitch_deg * kDeg, kDt) == Slope::kUp && found_s < 0.0) found_s = now_s;
  }
  ASSERT_GT(found_s, 0.0);
  EXPECT_LT(found_s - passed_s, 0.3);
}

TEST(SlopeState, HoldsOnASlopeThatWaversAndLeavesItOnTheFlat) {
  SlopeState state{{}};
  for (int i = 0; i < 100; ++i) state.update(10 * kDeg, kDt);
  ASSERT_EQ(state.state(), Slope::kDown);
  for (int i = 0; i < 400; ++i) ASSERT_EQ(state.update(3.0 * kDeg, kDt), Slope::kDown);
  for (int i = 0; i < 40; ++i) state.update(1.0 * kDeg, kDt);
  EXPECT_EQ(state.state(), Slope::kFlat);
}

TEST(SlopeState, PassesFromClimbingToDescending) {
  SlopeState state{{}};
  for (int i = 0; i < 100; ++i) state.update(-20 * kDeg, kDt);
  for (int i = 0; i < 100; ++i) state.update(20 * kDeg, kDt);
  EXPECT_EQ(state.state(), Slope::kDown);
}

TEST(SlopeState, NoiseAndABumpChangeNothing) {
  SlopeState state{{}};
  std::mt19937_64 random(1);
  std::normal_distribution<double> noise(0.0, 1.5 * kDeg);
  for (int i = 0; i < 20000; ++i) {
    const double bump = i % 400 < 20 ? 8 * kDeg : 0.0;
    ASSERT_EQ(state.update(bump + noise(random), kDt), Slope::kFlat);
  }
}

}  // namespace
}  // namespace tp100::estimation
