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

/// Pose after `t_s` of constant speeds by eqs 1-5 of the paper with its constants, implemented
/// independently of the product.
struct Expected {
  double x, y, yaw, vx, vy, rate;
};
Expected paper(double left, double right, double t_s) {
  const double wl = left * (1 - 0.1), wr = right * (1 - 0.1188), width = 0.2742;
  const double vx = (wr + wl) / 2, rate = (wr - wl) / width;
  const double beta = std::abs(rate) > 0.05 ? 0.0 : 0.404 * 3.14159265358979323846 / 180;
  const double vy = vx * std::tan(beta);
  const double a = rate * t_s;
  if (rate == 0.0) return {vx * t_s, vy * t_s, 0.0, vx, vy, rate};
  // The robot moves on a circle about the instantaneous centre.
  return {(vx * std::sin(a) - vy * (1 - std::cos(a))) / rate,
          (vx * (1 - std::cos(a)) + vy * std::sin(a)) / rate,
          a,
          vx,
          vy,
          rate};
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

TEST(Replay, TimesMayBeUnixTime) {
  const auto end = [](double begin_s) {
    std::string csv = "t_s,left_mps,right_mps\n";
    for (const double t_s : {begin_s, begin_s + 1.0}) csv += std::to_string(t_s) + ",0.1,0.13\n";
    const text::CsvTable poses = replayed(csv, kPaperModel);
    return std::array{poses["x_m"][1], poses["y_m"][1], poses["yaw_rad"][1]};
  };
  EXPECT_EQ(end(1.8e9), end(0.0));
  EXPECT_EQ(end(1.8e12), end(0.0)) << "times as large as Unix milliseconds must work too";
}

TEST(Replay, PaperModeIsEquations1To5WhateverTheConfiguration) {
  bridge::Parameters other;
  other.model.slip_left = 0.3;
  other.model.wheelbase_m = 0.5;
  other.model.x_icr_m = 0.1;
  const double kSpeeds[][2] = {{0.1, 0.1},    {0.05, 0.12}, {-0.1, 0.1},
                               {-0.08, -0.1}, {0.1, 0.0},   {0.1 * 0.8812 / 0.9, 0.1}};
  for (const auto& [left, right] : kSpeeds) {
    const text::CsvTable table = replayed(constant(left, right, 0.005, 4001), kPaperModel, other);
    for (std::size_t i = 0; i < table.rows(); i += 400) {
      const Expected want = paper(left, right, table["t_s"][i]);
      EXPECT_NEAR(table["x_m"][i], want.x, 1e-9);
      EXPECT_NEAR(table["y_m"][i], want.y, 1e-9);
      EXPECT_NEAR(table["yaw_rad"][i], want.yaw, 1e-9);
      EXPECT_NEAR(table["vx_mps"][i], want.vx, 1e-15);
      EXPECT_NEAR(table["vy_mps"][i], want.vy, 1e-15);
      EXPECT_NEAR(table["yaw_rate_radps"][i], want.rate, 1e-15);
      EXPECT_EQ(table["slip_left"][i], 0.1);
      EXPECT_EQ(table["slip_right"][i], 0.1188);
    }
  }
}

TEST(Replay, TheStepSizeDoesNotMatter) {
  const text::CsvTable coarse = replayed(constant(-0.05, 0.2, 30.0, 2), kPaperModel);
  const text::CsvTable fine = replayed(constant(-0.05, 0.2, 0.001, 30001), kPaperModel);
  EXPECT_GT(std::abs(coarse["yaw_rad"][1]), 2 * kPi);  // the yaw is unwrapped
  EXPECT_NEAR(coarse["x_m"][1], fine["x_m"].back(), 1e-9);
  EXPECT_NEAR(coarse["y_m"][1], fine["y_m"].back(), 1e-9);
  EXPECT_NEAR(coarse["yaw_rad"][1], fine["yaw_rad"].back(), 1e-9);
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
  EXPECT_NEAR(table["x_m"][1], paper(0.1, 0.1, 1.0).x, 1e-12);
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

TEST(Replay, OdometryTakesTheGyrosBiasWhileStandingStill) {
  std::string csv = "t_s,left_mps,right_mps,gyro_z_radps\n";
  for (int i = 0; i < 600; ++i)
    csv += std::to_string(i * 0.01) + (i < 200 ? ",0,0,0.02\n" : ",0.1,0.1,0.02\n");
  const text::CsvTable table = replayed(csv, ReplayModel{PoseSource::kOdometry});
  EXPECT_NEAR(table["yaw_rad"].back() - table["yaw_rad"][200], 0.0, 2e-4);
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
  EXPECT_EQ(replay_model("fused"), ReplayModel{PoseSource::kFused});
  EXPECT_THAT(error_of("t_s,left_mps,right_mps\n0,0,0\n", ReplayModel{PoseSource::kFused}),
              HasSubstr("needs a recording"));
  try {
    replay_model("papre");
    FAIL();
  } catch (const SetupError& error) {
    EXPECT_THAT(error.what(), HasSubstr("did you mean 'paper'?"));
  }
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
