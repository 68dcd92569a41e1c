// The specification of a campaign: what varies, and from which files it is made.

#include "sim/campaign/campaign_spec.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <set>

#include "../support/temporary_folder.h"
#include "sim/campaign/campaign_folder.h"
#include "support/refusal.h"

namespace tp100::sim {
namespace {

using testing::HasSubstr;

CampaignSpec spec(const std::string& text) { return parse_campaign(text, "spec.toml"); }

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
      "runs = 48\nbody = { list = [\"ode\", \"shear\"] }\n"
      "course = { list = [\"1-curve\", \"2\"] }\nfloor = { list = [\"even\", \"uneven\"] }\n"
      "robot = { list = [\"uniform\", \"large\", \"worn\"] }\n"
      "[configuration]\ncontrol.law = { list = [\"lqr\", \"stanley\"] }");
  std::set<std::string> seen;
  for (std::uint64_t index = 0; index < of.runs; ++index) {
    const PlannedRun run = plan(of, index);
    ASSERT_EQ(run.sampled.size(), 5u);
    seen.insert(run.options.body + run.course + run.options.floor + run.options.robot +
                std::get<std::string>(run.options.configuration_values.at(0).second));
  }
  EXPECT_EQ(seen.size(), 48u);
  EXPECT_EQ(plan(of, 1).options.body, "shear") << "the first in alphabetical order changes first";
  EXPECT_EQ(plan(of, 1).options.robot, "uniform");
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

TEST(CampaignSpec, NonsenseIsRefusedWithItsPlace) {
  for (const auto& [text, error] :
       {std::pair{"course = \"3\"", "missing key 'runs'"},
        {"runs = 0\ncourse = \"3\"", "spec.toml:1:8: 'runs' is 0"},
        {"runs = 1", "missing key 'course'"},
        {"runs = 1\ncourse = 3", "course needs a string"},
        {"runs = 1\ncourse = { uniform = [1, 2] }", "course needs a string"},
        {"runs = 1\ncourse = \"3\"\nrobt = \"x\"", "did you mean 'robot'?"},
        {"runs = 1\ncourse = \"3\"\n[robot_values]\nemulated.body.fricton = 0.5",
         "did you mean 'emulated.body.friction'?"}})
    EXPECT_THAT(test::refusal([text = text] { load(plan(spec(text), 0).options); }),
                HasSubstr(error));
}

std::vector<Variable> read(const std::string& text) {
  text::TomlTable root = text::TomlDocument(text, "spec.toml").root();
  std::vector<Variable> variables = read_variables(root);
  root.finish();
  return variables;
}

Variable one(const std::string& text) { return read("x = " + text).at(0); }

double number(const Variable& variable, std::uint64_t index, std::uint64_t seed = 1) {
  return std::get<double>(draw(variable, {seed, index, index}));
}

TEST(Variable, UniformAndNormalValuesHaveTheirRangesAndMoments) {
  const Variable uniform = one("{ uniform = [-1, 3.0] }"), normal = one("{ normal = [5, 2] }");
  double least = 9.0, most = -9.0, sum = 0.0, off = 0.0, squares = 0.0;
  int within = 0;
  for (std::uint64_t i = 0; i < 4000; ++i) {
    const double value = number(uniform, i), deviation = number(normal, i) - 5.0;
    sum += value;
    least = std::min(least, value);
    most = std::max(most, value);
    off += deviation;
    squares += deviation * deviation;
    within += std::abs(deviation) < 2.0 ? 1 : 0;
  }
  EXPECT_TRUE(least >= -1.0 && least < -0.99 && most > 2.99 && most <= 3.0);
  EXPECT_NEAR(sum / 4000.0, 1.0, 0.06);
  EXPECT_NEAR(off / 4000.0, 0.0, 0.12);
  EXPECT_NEAR(std::sqrt(squares / 4000.0), 2.0, 0.08);
  EXPECT_NEAR(within / 4000.0, 0.683, 0.025);
}

TEST(Variable, WhatIsSampledDependsOnSeedIndexAndName) {
  const std::vector<Variable> two = read("a = { uniform = [0, 1] }\nb = { uniform = [0, 1] }");
  std::set<double> values;
  for (const Variable& variable : two)
    for (const std::uint64_t seed : {1U, 2U})
      for (std::uint64_t index = 0; index < 100; ++index) {
        values.insert(number(variable, index, seed));
        EXPECT_EQ(number(variable, index, seed), number(variable, index, seed));
      }
  EXPECT_EQ(values.size(), 400u);
}

TEST(Variable, NonsenseIsRefusedWithItsPlace) {
  for (const auto& [text, error] :
       {std::pair{"x = { uniform = [2, 1] }", "spec.toml:1:17: the lowest comes first"},
        {"x = { uniform = [2] }",
         "spec.toml:1:17: uniform needs two numbers: the lowest and the highest"},
        {"x = { normal = [0, -1] }", "spec.toml:1:16: a standard deviation is not negative"},
        {"x = { list = [] }", "needs a value, or one of"},
        {"x = [1, 2]", "expected true, false, a number or a string"},
        {"x = { uniform = [0, 1], sd = 1 }", "unknown key 'x.sd'"},
        {"x = { uniform = [0, nan] }", "two numbers"}})
    EXPECT_THAT([text = text] { read(text); },
                testing::ThrowsMessage<UserError>(testing::HasSubstr(error)));
}

using test::TemporaryFolder;
using testing::Contains;
using testing::Key;
using testing::Not;
using testing::Pair;

Origin origin(const std::string& spec) {
  return origin_of(parse_campaign("runs = 2\n" + spec, "spec.toml"));
}

void write(const std::string& path, const std::string& text) { std::ofstream(path) << text; }

TEST(Origin, HasEveryFileOfEveryList) {
  const Origin of = origin(
      "course = { list = [\"2\", \"3\"] }\nrobot = { list = [\"uniform\", \"\"] }\n"
      "camera = { list = [\"\", \"overhead\"] }\n");
  for (const char* name :
       {"course 2", "course 3", "robot uniform", "robot end-loaded", "camera overhead"})
    EXPECT_THAT(of, Contains(Pair(name, testing::MatchesRegex("[0-9a-f]{16}"))));
  EXPECT_NE(of.at("course 2"), of.at("course 3"));
  EXPECT_THAT(of, Not(Contains(Key("camera "))));
}

TEST(Origin, HasTheRobotsThatTheConfigurationNames) {
  const TemporaryFolder folder;
  write(folder.file("tp100.toml"), "robot = \"uniform\"\n");
  const std::string spec = "course = \"3\"\nconfig = \"" + folder.file("tp100.toml") + "\"\n";
  const Origin of = origin(spec);
  EXPECT_THAT(of, Contains(Key("robot uniform")));
  EXPECT_THAT(of, Contains(Key("configuration " + folder.file("tp100.toml"))));
  EXPECT_THAT(of, Not(Contains(Key("robot end-loaded"))));
  EXPECT_THAT(origin(spec + "[configuration]\nrobot = { list = [\"uniform\", \"end-loaded\"] }\n"),
              Contains(Key("robot end-loaded")));
}

TEST(Origin, HasTheProgramItsLibrariesAndTheFirmwareIfTheImageRuns) {
  const std::string text = origin_text(origin("course = \"3\"\n"));
  EXPECT_THAT(text, testing::ContainsRegex("program: tp100-sim [0-9.]+, build [0-9a-f]{16}\n"));
  EXPECT_THAT(text, testing::ContainsRegex("library libode.so.*: [0-9a-f]{16}\n"));
  EXPECT_THAT(text, Not(HasSubstr("firmware")));
  EXPECT_THAT(origin("course = \"3\"\nboard = { list = [\"native\", \"avr\"] }\n"),
              Contains(Key("firmware")));
}

TEST(Origin, ChangesWithAFileAndSaysWhich) {
  const TemporaryFolder folder;
  const std::string course = folder.file("course.toml"), spec = "course = \"" + course + "\"\n";
  const Origin none = origin(spec);
  EXPECT_EQ(none.at("course " + course), "not there");
  write(course, "a");
  const Origin first = origin(spec);
  // This is the published FNV-1a hash of "a".
  EXPECT_EQ(first.at("course " + course), "af63dc4c8601ec8c");
  EXPECT_EQ(difference(none, first), "course " + course + " was not there, is af63dc4c8601ec8c");
  EXPECT_EQ(difference(first, origin(spec)), "");
  write(course, "b");
  EXPECT_THAT(difference(first, origin(spec)), HasSubstr("course " + course + " was af63dc4c"));
}

TEST(Origin, IsReadBackAsItWasWritten) {
  const Origin of = {{"course a: b.toml", "1"}, {"program", "tp100-sim 1.0, build 2"}};
  EXPECT_EQ(read_origin(origin_text(of)), of);
  EXPECT_EQ(read_origin("nothing\n\n"), Origin());
  EXPECT_EQ(difference(of, {{"program", "tp100-sim 1.0, build 2"}}),
            "course a: b.toml was 1, is not there");
  EXPECT_EQ(difference({}, {{"x", "1"}}), "x was not there, is 1");
}

}  // namespace
}  // namespace tp100::sim
