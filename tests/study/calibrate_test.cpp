#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "sim/study/commands.h"

namespace tp100::sim {
namespace {

Loaded robot(const std::string& name) {
  Options options;
  options.robot = name;
  return load(options);
}

// The short form of `tp100-sim calibrate --runs 50`, with a robot that turns about a point ahead of
// it. The intervals are 95 % intervals for a given noise.
TEST(Calibration, FindsWhatTheBodyReallyDid) {
  const Calibration calibration = calibrate(robot("front-heavy"), 1, 7);
  EXPECT_TRUE(calibration.accurate());
  std::size_t held = 0;
  for (const model::ParameterRow& row : model::kTrackParameters)
    if (calibration.holds(row.value)) ++held;
  EXPECT_GE(held + 1, model::kTrackParameters.size());
  EXPECT_TRUE(calibration.found.extended.confused.empty());
  for (std::size_t i = 0; i < model::kBaselines.size(); ++i)
    EXPECT_EQ(calibration.found.baselines[i].has_value(), model::kBaselines[i].fixed == nullptr);
}

TEST(CalibrationJson, WhatCouldNotBeMeasuredIsLeftOut) {
  model::TrackParameters truth;
  truth.turn_slip = -HUGE_VAL;
  truth.turn_slip_tight = std::nan("");
  const auto json = nlohmann::json::parse(calibration_json("narrow", 3, {}, truth));
  EXPECT_EQ(json.at("robot"), "narrow");
  EXPECT_FALSE(json.at("turn_slip").contains("true"));
  EXPECT_FALSE(json.at("turn_slip_tight").contains("true"));
  EXPECT_TRUE(json.at("turn_slip").at("found").is_number());
}

}  // namespace
}  // namespace tp100::sim
