#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "bridge/parameters.h"
#include "live/active_run.h"

namespace tp100::live {
namespace {

using messages::ParameterText;
using messages::ParameterValue;

std::vector<ParameterText> listed() { return ActiveRun({}).parameters; }

const ParameterText& named(const std::vector<ParameterText>& list, const std::string& name) {
  return *std::find_if(list.begin(), list.end(),
                       [&](const ParameterText& each) { return each.name == name; });
}

TEST(ParameterList, HoldsEveryKeyOnceWithUnitLimitsAndMeaningAndNoSafetyLimitIsLive) {
  const auto list = listed();
  std::set<std::string> names;
  for (const ParameterText& each : list) {
    EXPECT_TRUE(names.insert(each.name).second) << each.name;
    EXPECT_NE(each.meaning, "") << each.name;
    if (each.type == ParameterText::Type::kNumber || each.type == ParameterText::Type::kInteger) {
      EXPECT_LT(each.range.min, each.range.max) << each.name;
    }
    if (each.type == ParameterText::Type::kChoice) {
      EXPECT_GT(each.choices.size(), 1U) << each.name;
    }
    // A viewer must not lift a limit that keeps the robot safe.
    for (const char* limit : {"fence", "abort", "battery", "tilt", "max_cross", "life", "timeout"})
      EXPECT_FALSE(each.live && each.name.find(limit) != std::string::npos) << each.name;
  }
  for (const char* name : {"loop.rate_hz", "control.preview_s", "robot.model.wheelbase_m",
                           "robot.drive.counts_per_metre", "server.listen"})
    EXPECT_TRUE(names.contains(name)) << name;
  EXPECT_EQ(named(list, "control.max_approach_deg").unit, "deg");
}

TEST(ParameterList, WhatIsLiveReachesItsOwnPlaceInTheStep) {
  const auto list = listed();
  std::set<LiveParameter> seen;
  for (const ParameterText& each : list) {
    const double middle = (each.range.min + each.range.max) / 2.0;
    const ParameterValue value = each.type == ParameterText::Type::kChoice
                                     ? ParameterValue(each.choices.back())
                                     : ParameterValue(middle);
    const auto change = change_for(each, value);
    EXPECT_EQ(change.has_value(), each.live) << each.name;
    if (change) seen.insert(change->parameter);
  }
  EXPECT_EQ(seen.size(), 8U);

  // The step reckons in radians.
  bridge::Parameters step;
  ASSERT_TRUE(bridge::apply(change_for(named(list, "control.max_approach_deg"), 90.0).value(),
                            false, step));
  EXPECT_NEAR(step.control.max_approach_rad, 1.5707963, 1e-6);
  EXPECT_FALSE(change_for(named(list, "estimation.steering"), std::string("truth")));
  EXPECT_FALSE(change_for(named(list, "estimation.steering"), true));
}

}  // namespace
}  // namespace tp100::live
