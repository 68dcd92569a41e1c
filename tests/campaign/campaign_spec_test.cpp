#include "sim/campaign/campaign_spec.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <set>

#include "support/refusal.h"

namespace tp100::sim {
namespace {

using testing::HasSubstr;

CampaignSpec spec(const std::string& text) { return parse_campaign(text, "spec.toml"); }

std::string refused(const std::string& text) {
  return test::refusal([&] { spec(text); });
}

TEST(CampaignSpec, WithoutAnythingElseRunsDifferByTheirSeedOnly) {
  const CampaignSpec of = spec("runs = 3\nseed = 100\ncourse = \"1-curve\"");
  EXPECT_EQ(of.runs, 3u);
  const PlannedRun run = plan(of, 2);
  EXPECT_EQ(run.options.seed, 102u);
  EXPECT_EQ(run.course, "1-curve");
  EXPECT_EQ(run.options.board, "native");
  EXPECT_TRUE(run.camera.empty());
  EXPECT_TRUE(run.sampled.empty());
}

TEST(CampaignSpec, ListsAreCrossed) {
  const CampaignSpec of = spec(
      "runs = 12\ncourse = { list = [\"1-curve\", \"2\"] }\n"
      "robot = { list = [\"uniform\", \"large\", \"worn\"] }\n"
      "[configuration]\ncontrol.law = { list = [\"lqr\", \"stanley\"] }");
  std::set<std::string> seen;
  for (std::uint64_t index = 0; index < of.runs; ++index) {
    const PlannedRun run = plan(of, index);
    ASSERT_EQ(run.sampled.size(), 3u);
    seen.insert(run.course + run.options.robot +
                std::get<std::string>(run.options.configuration_values.at(0).second));
  }
  EXPECT_EQ(seen.size(), 12u);
  EXPECT_EQ(plan(of, 1).course, "2") << "the first list in alphabetical order changes first";
  EXPECT_EQ(plan(of, 1).options.robot, "uniform");
}

TEST(CampaignSpec, BodyAndFloorAreChoices) {
  const CampaignSpec of = spec(
      "runs = 4\ncourse = \"1-curve\"\nbody = { list = [\"ode\", \"shear\"] }\n"
      "floor = { list = [\"even\", \"uneven\"] }");
  std::set<std::pair<course::ContactLaw, course::Floor>> seen;
  for (std::uint64_t index = 0; index < of.runs; ++index) {
    const PlannedRun run = plan(of, index);
    EXPECT_EQ(run.sampled.at(0).first, "body");
    const auto& emulated = load(run.options).robot.emulated;
    EXPECT_EQ(emulated.contact_law == course::ContactLaw::kOde,
              std::get<std::string>(run.sampled.at(0).second) == "ode");
    EXPECT_EQ(emulated.floor == course::Floor::kEven,
              std::get<std::string>(run.sampled.at(1).second) == "even");
    seen.emplace(emulated.contact_law, emulated.floor);
  }
  EXPECT_EQ(seen.size(), 4u);
}

TEST(CampaignSpec, ValuesReachConfigurationAndRobot) {
  const CampaignSpec of = spec(
      "runs = 2\ncourse = \"3\"\nfaults = \"drop:0.1@2 jitter:5\"\n"
      "[configuration]\nloop.rate_hz = 100\n"
      "[robot_values]\nemulated.body.friction = { uniform = [0.6, 0.9] }");
  const PlannedRun run = plan(of, 1);
  EXPECT_THAT(run.faults, testing::ElementsAre("drop:0.1@2", "jitter:5"));
  const Loaded loaded = load(run.options);
  EXPECT_EQ(loaded.configuration.loop.rate_hz, 100.0);
  EXPECT_EQ(loaded.robot.name, "end-loaded");
  const double friction = std::get<double>(run.sampled.at(0).second);
  EXPECT_EQ(run.sampled.at(0).first, "robot_values.emulated.body.friction");
  EXPECT_EQ(loaded.robot.emulated.body.friction, friction);
  EXPECT_NE(loaded.robot.emulated.body.friction,
            load(plan(of, 0).options).robot.emulated.body.friction);
}

TEST(CampaignSpec, WhatNobodyKnowsIsNamed) {
  const CampaignSpec of =
      spec("runs = 1\ncourse = \"3\"\n[robot_values]\nemulated.body.fricton = 0.5");
  EXPECT_THAT([&] { load(plan(of, 0).options); },
              testing::ThrowsMessage<SetupError>(
                  testing::AllOf(HasSubstr("end-loaded.toml with other values"),
                                 HasSubstr("did you mean 'emulated.body.friction'?"))));
}

TEST(CampaignSpec, NonsenseIsRefusedWithItsPlace) {
  EXPECT_THAT(refused("course = \"3\""), HasSubstr("missing key 'runs'"));
  EXPECT_THAT(refused("runs = 0\ncourse = \"3\""), HasSubstr("spec.toml:1:8: 'runs' is 0"));
  EXPECT_THAT(refused("runs = 1"), HasSubstr("missing key 'course'"));
  EXPECT_THAT(refused("runs = 1\ncourse = 3"), HasSubstr("course needs a string"));
  EXPECT_THAT(refused("runs = 1\ncourse = \"3\"\nrobt = \"x\""),
              HasSubstr("did you mean 'robot'?"));
  EXPECT_THAT(refused("runs = 1\ncourse = { uniform = [1, 2] }"),
              HasSubstr("course needs a string"));
}

}  // namespace
}  // namespace tp100::sim
