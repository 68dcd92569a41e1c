// The configuration file: the bundled one, the values of its keys, and what is refused.

#include "config/configuration.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <sstream>

#include "config/world_settings.h"
#include "core/arithmetic.h"
#include "support/accepted.h"
#include "support/refusal.h"
#include "support/temporary_folder.h"

namespace tp100::config {
namespace {

using testing::HasSubstr;

std::string error_of(const std::string& text) {
  return test::refusal([&] { parse_configuration(text, "tp100.toml"); });
}

// `scripts/test --accept` rewrites the bundled file from the key table.
TEST(Configuration, TheBundledFileIsWhatTheKeyTableSays) {
  const std::string text = write_configuration(Configuration{});
  test::expect_accepted("config/tp100.toml", text);
  EXPECT_EQ(write_configuration(parse_configuration("", "f")), text) << "these are the defaults";
}

TEST(Configuration, ValuesOfAFileAreThoseInForce) {
  const Configuration read = parse_configuration(
      "course = 'mine.toml'\nsetup = 'stand'\n[link]\nport = '/dev/ttyACM0'\nhang_up = true\n"
      "[loop]\npacing = 'robot'\ncpu = 1\n[estimation]\nsteering = 'model'\n"
      "[control]\nmax_tilt_deg = 33\ncommand_life_ms = 150\n",
      "f");
  EXPECT_EQ(read.course, "mine.toml");
  EXPECT_EQ(read.parameters.setup, bridge::Setup::kStand);
  EXPECT_EQ(read.link.port, "/dev/ttyACM0");
  EXPECT_TRUE(read.link.hang_up);
  EXPECT_EQ(read.loop.pacing, Pacing::kRobot);
  EXPECT_EQ(read.loop.cpu, 1);
  EXPECT_EQ(read.parameters.steering, PoseSource::kModel);
  EXPECT_NEAR(read.parameters.control.max_tilt_rad, 33 * kRadPerDeg, 1e-12);
  EXPECT_DOUBLE_EQ(read.parameters.command_life_s, 0.15);
}

TEST(Configuration, EveryKeyOfTheBundledFileRefusesAWrongType) {
  std::istringstream lines(write_configuration(Configuration{}));
  std::string section, line;
  int keys = 0;
  while (std::getline(lines, line)) {
    if (line.starts_with("[")) section = line + "\n";
    const std::size_t equals = line.find(" = ");
    if (line.starts_with("#") || equals == std::string::npos) continue;
    ++keys;
    const std::string name = line.substr(0, equals);
    EXPECT_THAT(error_of(section + name + " = [1]\n"), HasSubstr(name + "' is an array, expected"));
    EXPECT_EQ(error_of(section + line + "\n"), "");
    EXPECT_THAT(error_of(section + name + "x = 1\n"), HasSubstr("did you mean"));
  }
  EXPECT_GT(keys, 35);
}

TEST(Configuration, RefusesUnknownKeysAndValuesOutOfRangeInOneLine) {
  EXPECT_EQ(error_of("[loop]\nrate = 100\n"),
            "tp100.toml:2:1: unknown key 'loop.rate'; did you mean 'loop.rate_hz'?");
  EXPECT_EQ(error_of("[loop]\nrate_hz = 2000\n"),
            "tp100.toml:2:11: 'loop.rate_hz' is 2000, allowed 50 to 1000 Hz");
  EXPECT_EQ(error_of("[control]\ncommand_life_ms = 500\n"),
            "tp100.toml:2:19: 'control.command_life_ms' is 500, allowed 20 to 190 ms");
  EXPECT_THAT(error_of("setup = 'flatt'\n"), HasSubstr("did you mean 'flat'?"));
}

TEST(Configuration, TheRobotGivesModelAndDriveAndTheConfigurationTheTurningThreshold) {
  const Configuration configuration =
      parse_configuration("[model]\nturning_threshold_radps = 0.2\n", "f");
  course::Robot robot;
  robot.model.wheelbase_m = 0.3;
  robot.drive.dead_band = 0.25;
  const bridge::Parameters parameters = bridge_parameters(configuration, robot);
  EXPECT_EQ(parameters.model.wheelbase_m, 0.3);
  EXPECT_EQ(parameters.drive.dead_band, 0.25);
  EXPECT_EQ(parameters.model.turning_threshold_radps, 0.2);
}

TEST(Configuration, AWorldIsToldWhatIsInForce) {
  WorldRun run{.parameters = {},
               .settings = {},
               .version = "1",
               .course = "3",
               .setup = "flat",
               .surfaces = {{"sand", 0.2}}};
  run.parameters.owns_pose = true;
  run.settings.rate_hz = 50.0;
  const worlds::PeerSettings told = peer_settings(run, 7, true);
  EXPECT_EQ(told.hello.session, 7U);
  EXPECT_EQ(told.hello.authority, worlds::Authority::kWorld);
  EXPECT_EQ(told.hello.rate_hz, 50.0);
  EXPECT_TRUE(told.hello.lockstep);
  EXPECT_EQ(told.hello.version + told.hello.course + told.hello.setup, "13flat");
  EXPECT_EQ(told.surfaces.at(0).second, 0.2);
}

}  // namespace
}  // namespace tp100::config
