#include "firmware/number.h"

#include <gtest/gtest.h>

#include <limits>

#include "firmware/yaw_loop.h"
#include "rig.h"

namespace tp100::firmware {
namespace {

TEST(Clamp, KeepsWhatIsWithinTheLimitAndCutsTheRest) {
  for (const float value : {0.0f, -0.0f, 0.3f, -0.3f, 1.0f, -1.0f}) {
    EXPECT_EQ(clamp(value, 1.0f), value);
  }
  for (const float value : {1.0000001f, 5.0f, 3.0e38f, kInf}) {
    EXPECT_EQ(clamp(value, 1.0f), 1.0f);
    EXPECT_EQ(clamp(-value, 1.0f), -1.0f);
  }
  EXPECT_EQ(clamp(0.1f, 0.0f), 0.0f);
}

TEST(Clamp, WhatIsNoNumberBecomesZero) {
  for (const float nan : {kNan, -kNan, std::numeric_limits<float>::signaling_NaN()}) {
    EXPECT_EQ(clamp(nan, 1.0f), 0.0f);
    EXPECT_EQ(clamp(nan, 0.0f), 0.0f);
  }
}

TEST(TrackSpeeds, WhatIsNoNumberAsksForAStandstill) {
  const wire::Parameters parameters = test::good_parameters();
  for (const float bad : {kNan, -kNan}) {
    const TrackSpeeds speeds = track_speeds(bad, 0.5f, parameters);
    EXPECT_EQ(speeds.left, 0.0f);
    EXPECT_EQ(speeds.right, 0.0f);
  }
}

TEST(SpeedLoop, ATargetThatIsNoNumberGivesNoDuty) {
  const wire::Parameters parameters = test::good_parameters();
  SpeedLoop loop;
  loop.measure(0, 5000, parameters);
  EXPECT_EQ(loop.update(kNan, 0.005f, parameters), 0.0f);
  EXPECT_EQ(loop.update(0.0f, kNan, parameters), 0.0f);
}

}  // namespace
}  // namespace tp100::firmware
