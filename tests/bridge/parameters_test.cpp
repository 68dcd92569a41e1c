#include "bridge/parameters.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace tp100::bridge {
namespace {

TEST(LiveParameters, EachGoesToItsOwnPlace) {
  Parameters p;
  double next = 0.011;
  for (std::uint8_t i = 1; i <= 7; ++i) {
    EXPECT_TRUE(apply({static_cast<LiveParameter>(i), next}, true, p));
    next += 0.011;
  }
  EXPECT_DOUBLE_EQ(p.control.preview_s, 0.011);
  EXPECT_DOUBLE_EQ(p.control.cross_track_gain_1ps, 0.022);
  EXPECT_DOUBLE_EQ(p.control.max_approach_rad, 0.033);
  EXPECT_DOUBLE_EQ(p.control.acceleration_mps2, 0.044);
  EXPECT_DOUBLE_EQ(p.control.min_speed_mps, 0.055);
  EXPECT_DOUBLE_EQ(p.control.pivot_rate_radps, 0.066);
  EXPECT_DOUBLE_EQ(p.control.pivot_acceleration_radps2, 0.077);
}

TEST(LiveParameters, ValuesThatCannotBeChangeNothing) {
  const Parameters before;
  Parameters p;
  for (const double bad : {std::nan(""), -1.0, std::numeric_limits<double>::infinity(),
                           -std::numeric_limits<double>::infinity()}) {
    for (std::uint8_t i = 0; i <= 7; ++i)
      EXPECT_FALSE(apply({static_cast<LiveParameter>(i), bad}, false, p));
  }
  EXPECT_FALSE(apply({static_cast<LiveParameter>(200), 1.0}, false, p));
  EXPECT_FALSE(apply({LiveParameter::kSteering, 3.0}, false, p));
  EXPECT_FALSE(apply({LiveParameter::kSteering, 0.5}, false, p));
  EXPECT_EQ(p.control.cross_track_gain_1ps, before.control.cross_track_gain_1ps);
  EXPECT_EQ(p.steering, before.steering);
}

TEST(LiveParameters, TheSteeringPoseStaysDuringARun) {
  Parameters p;
  EXPECT_FALSE(apply({LiveParameter::kSteering, 2.0}, true, p));
  EXPECT_EQ(p.steering, PoseSource::kOdometry);
  EXPECT_TRUE(apply({LiveParameter::kSteering, 2.0}, false, p));
  EXPECT_EQ(p.steering, PoseSource::kFused);
}

}  // namespace
}  // namespace tp100::bridge
