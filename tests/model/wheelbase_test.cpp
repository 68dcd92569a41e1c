#include <gtest/gtest.h>

#include "model/track_model.h"

namespace tp100::model {
namespace {

TEST(EquivalentWheelbase, TheTableGivesThePrintedValue) {
  EXPECT_NEAR(equivalent_wheelbase_m({}), 0.2742, 5e-6);
}

TEST(EquivalentWheelbase, GammaZeroAndOneGiveTheValuesOfTheDigest) {
  WheelbaseGeometry geometry;
  geometry.gamma = 0.0;
  EXPECT_NEAR(equivalent_wheelbase_m(geometry), 0.2648, 1e-4);
  geometry.gamma = 1.0;
  EXPECT_NEAR(equivalent_wheelbase_m(geometry), 0.2658, 1e-4);
}

}  // namespace
}  // namespace tp100::model
