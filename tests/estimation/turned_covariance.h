#pragma once
// A covariance in world axes, of a robot and of one that started a quarter turn to its left.

#include <gtest/gtest.h>

#include "core/estimates.h"

namespace tp100::estimation {

inline void expect_turned_left(const PlanarCovariance& turned, const PlanarCovariance& ahead) {
  EXPECT_NEAR(turned.xx, ahead.yy, 1e-12);
  EXPECT_NEAR(turned.yy, ahead.xx, 1e-12);
  EXPECT_NEAR(turned.xy, -ahead.xy, 1e-12);
  EXPECT_NEAR(turned.x_yaw, -ahead.y_yaw, 1e-12);
  EXPECT_NEAR(turned.y_yaw, ahead.x_yaw, 1e-12);
  EXPECT_NEAR(turned.yaw_yaw, ahead.yaw_yaw, 1e-12);
}

}  // namespace tp100::estimation
