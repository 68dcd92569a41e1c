#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <array>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <map>
#include <sstream>

#include "../support/temporary_folder.h"
#include "app/commands.h"
#include "core/arithmetic.h"
#include "core/error.h"
#include "support/refusal.h"
#include "text/csv_reader.h"

namespace tp100::app {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

text::CsvTable replayed(const std::string& csv, ReplayModel model,
                        const bridge::Parameters& parameters = {}) {
  return text::parse_csv(replay_csv(csv, "in.csv", model, parameters), "out.csv",
                         {{"t_s", "x_m", "y_m", "z_m", "roll_rad", "pitch_rad", "yaw_rad", "vx_mps",
                           "vy_mps", "yaw_rate_radps", "slip_left", "slip_right"},
                          {}});
}

std::string error_of(const std::string& csv, ReplayModel model = kPaperModel) {
  return test::refusal([&] { replay_csv(csv, "in.csv", model, {}); });
}

/// Rows of constant speeds every `dt_s`.
std::string constant(double left_mps, double right_mps, double dt_s, int rows) {
  std::string text = "t_s,left_mps,right_mps\n";
  for (int i = 0; i < rows; ++i) {
    std::array<char, 120> line{};
    std::snprintf(line.data(), line.size(), "%.17g,%.17g,%.17g\n", i * dt_s, left_mps, right_mps);
    text += line.data();
  }
  return text;
}

TEST(Replay, EveryColumnHoldsWhatItsNameSays) {
  const Pose pose{.x_m = 1, .y_m = 2, .z_m = 3, .roll_rad = 4, .pitch_rad = 5, .yaw_rad = 6};
  const Twist twist{.vx_mps = 7, .vy_mps = 8, .yaw_rate_radps = 9};
  const std::map<std::string_view, double> columns = {{"t_s", 0.5},        {"x_m", 1.0},
                                                      {"y_m", 2.0},        {"z_m", 3.0},
                                                      {"roll_rad", 4.0},   {"pitch_rad", 5.0},
                                                      {"yaw_rad", 6.0},    {"vx_mps", 7.0},
                                                      {"vy_mps", 8.0},     {"yaw_rate_radps", 9.0},
                                                      {"slip_left", 10.0}, {"slip_right", 11.0}};
  std::vector<std::string_view> names = {"t_s"};
  for (const auto& [name, value] : columns)
    if (name != "t_s") names.push_back(name);
  const text::CsvTable table = text::parse_csv(
      kReplayHeader + replay_row(0.5, pose, twist, {10, 11}), "out.csv", {names, {}});
  for (const auto& [name, value] : columns) EXPECT_EQ(table[name][0], value) << name;
}

// The equations: tests/model.
TEST(Replay, PaperModeIgnoresTheRobotsValuesAndWhenTheRunWas) {
  bridge::Parameters other;
  other.model.slip_left = 0.3;
  other.model.wheelbase_m = 0.5;
  other.model.x_icr_m = 0.1;
  const text::CsvTable turn = replayed(constant(0.05, 0.12, 1.0, 3), kPaperModel, other);
  const double left_mps = 0.05 * (1 - 0.1), right_mps = 0.12 * (1 - 0.1188);
  const double rate_radps = (right_mps - left_mps) / 0.2742;
  EXPECT_NEAR(turn["yaw_rate_radps"][1], rate_radps, 1e-15);
  EXPECT_NEAR(turn["yaw_rad"][2], 2.0 * rate_radps, 1e-12);
  EXPECT_NEAR(turn["vx_mps"][1], (left_mps + right_mps) / 2, 1e-15);
  EXPECT_EQ(turn["slip_left"][0], 0.1);
  EXPECT_EQ(turn["slip_right"][0], 0.1188);
  for (const double begin_s : {1.8e9, 1.8e12}) {
    std::string csv = "t_s,left_mps,right_mps\n";
    for (int i = 0; i < 3; ++i) csv += std::to_string(begin_s + i) + ",0.05,0.12\n";
    const text::CsvTable later = replayed(csv, kPaperModel);
    for (const char* column : {"x_m", "y_m", "yaw_rad"})
      EXPECT_EQ(later[column][2], turn[column][2]) << "at Unix seconds or milliseconds";
  }
}

TEST(Replay, TheTurningThresholdIsConfigured) {
  bridge::Parameters parameters;
  parameters.model.turning_threshold_radps = 10.0;
  const std::string csv = constant(0.05, 0.12, 1.0, 2);
  EXPECT_EQ(replayed(csv, kPaperModel)["vy_mps"][0], 0.0);
  EXPECT_GT(replayed(csv, kPaperModel, parameters)["vy_mps"][0], 1e-4);
}

TEST(Replay, RowsHoldUntilTheNextAndThePoseStartsAtZero) {
  const text::CsvTable table =
      replayed("t_s,left_mps,right_mps\n5,0.1,0.1\n6,0,0\n8,0.2,0.2\n9,0.5,0.5\n", kPaperModel);
  EXPECT_EQ(table["t_s"][0], 5.0);
  EXPECT_EQ(table["x_m"][0], 0.0);
  EXPECT_EQ(table["yaw_rad"][0], 0.0);
  EXPECT_NEAR(table["x_m"][1], 0.1 * (1 - (0.1 + 0.1188) / 2), 1e-4);
  EXPECT_EQ(table["x_m"][2], table["x_m"][1]);
  EXPECT_GT(table["x_m"][3], table["x_m"][2]);
  EXPECT_EQ(table["vx_mps"][1], 0.0);
  EXPECT_GT(table["vx_mps"][3], 0.4);
}

TEST(Replay, ExtendedModeUsesTheRobotsValuesAndTheSlope) {
  bridge::Parameters parameters;
  parameters.model.slip_left = parameters.model.slip_right = 0.2;
  parameters.model.slip_angle_straight_rad = 0.0;
  parameters.model.x_icr_m = 0.01;
  parameters.model.wheelbase_m = 0.3;
  const text::CsvTable turn =
      replayed("t_s,left_mps,right_mps\n0,-0.1,0.1\n1,0,0\n", kExtendedModel, parameters);
  const double rate = 0.16 / 0.3;
  EXPECT_NEAR(turn["yaw_rad"][1], rate, 1e-12);
  EXPECT_NEAR(turn["vy_mps"][0], -0.01 * rate, 1e-15);
  const double slope = 28 * kRadPerDeg;
  const text::CsvTable climb = replayed(
      "t_s,left_mps,right_mps,slope_rad\n0,0.1,0.1," + std::to_string(slope) + "\n1,0,0,0\n",
      kExtendedModel, parameters);
  EXPECT_NEAR(climb["slip_left"][0], 0.2 + 0.06, 1e-6);
  EXPECT_NEAR(climb["slip_right"][0], 0.2 + 0.098, 1e-6);
  EXPECT_NEAR(climb["pitch_rad"][0], -slope, 1e-6);
  EXPECT_NEAR(climb["z_m"][1], climb["vx_mps"][0] * std::sin(slope), 1e-6);
  EXPECT_EQ(climb["pitch_rad"][1], 0.0);
}

TEST(Replay, OdometryTurnsWithTheGyro) {
  const text::CsvTable table =
      replayed("t_s,left_mps,right_mps,gyro_z_radps\n0,0.1,0.1,0.5\n1,0.1,0.1,-0.25\n3,0,0,0\n",
               ReplayModel{PoseSource::kOdometry});
  EXPECT_NEAR(table["yaw_rad"][1], 0.5, 1e-12);
  EXPECT_NEAR(table["yaw_rad"][2], 0.0, 1e-12);
}

TEST(Replay, RefusesBadInputAtItsLine) {
  EXPECT_EQ(error_of("t_s,left_mps,right_mps\n0,0.1,0.1\n0.1,0.1,x\n"),
            "in.csv:3: right_mps is 'x', expected a number");
  const std::string all = "t_s,left_mps,right_mps,slope_rad,gyro_z_radps\n";
  for (const auto& [row, error] :
       {std::pair{"-2e13,0,0,0,0", "t_s is -2e+13, allowed -1e+13 to 1e+13"},
        {"0,1e300,0.1,0,0", "left_mps is 1e+300, allowed -100 to 100"},
        {"0,0.1,-101,0,0", "right_mps is -101, allowed -100 to 100"},
        {"0,0,0,1.6,0", "slope_rad is 1.6, allowed -1.57 to 1.57"},
        {"0,0,0,0,1001", "gyro_z_radps is 1001, allowed -1000 to 1000"}})
    EXPECT_EQ(error_of(all + row + "\n", ReplayModel{PoseSource::kOdometry}),
              "in.csv:2: " + std::string(error));
  EXPECT_THAT(error_of("t_s,left_mps,right_mps\n0,0.1,0.1\n", ReplayModel{PoseSource::kOdometry}),
              HasSubstr("in.csv:1: column 'gyro_z_radps' is missing"));
  EXPECT_THAT(error_of(""), StartsWith("in.csv:1: "));
}

TEST(Replay, KnowsItsModelsByName) {
  EXPECT_EQ(replay_model("paper"), kPaperModel);
  EXPECT_EQ(replay_model("odometry"), ReplayModel{PoseSource::kOdometry});
  EXPECT_THAT(error_of("t_s,left_mps,right_mps\n0,0,0\n", ReplayModel{PoseSource::kFused}),
              HasSubstr("needs a recording"));
  EXPECT_THAT(test::refusal([] { replay_model("papre"); }), HasSubstr("did you mean 'paper'?"));
}

TEST(ReplayFiles, HaveOneRowPerInputRowAndLeaveNothingBehindOnFailure) {
  const test::TemporaryFolder folder;
  const auto file = [&](const std::string& name, const std::string& text) {
    test::write_bytes(folder.file(name), text);
    return folder.file(name);
  };
  const std::string out = folder.file("out.csv"), steady = constant(0.1, 0.12, 0.005, 10);
  const std::string good = file("good.csv", steady);
  const std::string bad = file("in.csv", "t_s,left_mps,right_mps\n0,1,1\n1,1");
  EXPECT_THROW(run_replay({bad, out, "", ""}), SetupError);
  EXPECT_THROW(run_replay({folder.file("none"), out, "", ""}), SetupError);
  EXPECT_THROW(run_replay({good, folder.file("no/out"), "", ""}), SetupError);
  EXPECT_THROW(run_replay({good, out, file("c.toml", "robt = 1"), ""}), SetupError);
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder.path()), {}), 3);
  EXPECT_EQ(run_replay({good, out, "", "paper"}), 0);
  EXPECT_EQ(test::read_bytes(out), replay_csv(steady, "", kPaperModel, {}));
}

}  // namespace
}  // namespace tp100::app
