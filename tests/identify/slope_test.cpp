#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "core/arithmetic.h"
#include "core/error.h"
#include "identify/identify.h"
#include "identify/identify_report.h"
#include "simulated_drives.h"
#include "support/refusal.h"

namespace tp100::identify {
namespace {

using testing::HasSubstr;

/// Straight up a board, on which both tracks slip more.
RecordedDrive on_board(const Truth& truth, double slope_deg, double added_left,
                       double added_right) {
  Truth slipping = truth;
  slipping.slip_left += added_left;
  slipping.slip_right += added_right;
  RecordedDrive board = simulated_drive(slipping, "board", 0.1, 0.1, 8.0, 3);
  const double left_m = 0.8 * (1.0 - slipping.slip_left),
               right_m = 0.8 * (1.0 - slipping.slip_right);
  const double turned_rad = (right_m - left_m) / truth.wheelbase_m;
  board.measured = {.distance_m = (left_m + right_m) / 2.0,
                    .turned_rad = turned_rad,
                    .slope_rad = slope_deg * kRadPerDeg};
  return board;
}

TEST(IdentifySlopes, RunsOnSlopesShowWhatTheseAddToTheSlip) {
  const Truth truth;
  std::vector<RecordedDrive> drives = all_kinds(truth);
  drives.insert(drives.begin(), on_board(truth, 28.0, 0.21, 0.19));
  drives.push_back(on_board(truth, 28.2, 0.23, 0.21));
  drives.push_back(on_board(truth, -16.0, -0.05, -0.05));
  const Identification found = identify(drives, unknown());
  expect_all_found(found, truth);
  ASSERT_EQ(found.slopes.size(), 2u);
  EXPECT_NEAR(found.slopes[0].slope_rad, -16.0 * kRadPerDeg, 1e-12);
  EXPECT_NEAR(found.slopes[0].left, -0.05, 0.003);
  EXPECT_NEAR(found.slopes[1].left, 0.22, 0.003) << "mean of both runs";
  EXPECT_NEAR(found.slopes[1].right, 0.20, 0.003);
  EXPECT_EQ(found.prior.tracks.slopes, 2u);

  course::Robot base;
  const course::Robot robot = identified_robot(found, base, "");
  EXPECT_EQ(robot.model.slopes, 2u);
  EXPECT_NEAR(robot.model.added_slips[1].right, 0.20, 0.003);
  EXPECT_THAT(identify_report(found, base), HasSubstr("28.0 deg"));
  const auto json = nlohmann::json::parse(identify_json(found, base, robot));
  EXPECT_NEAR(json["slopes"][0]["slope_deg"], -16.0, 1e-9);
  EXPECT_NEAR(json["slopes"][0]["added_left"], -0.05, 0.003);

  // Without runs on slopes what is known of them stays.
  const Identification level =
      identify(all_kinds(truth), {.tracks = robot.model, .counts_per_metre = 20000.0});
  EXPECT_EQ(identified_robot(level, robot, "").model.slopes, 2u);
}

TEST(IdentifySlopes, WithoutAMeasuredTurnBothTracksSlipAlikeOnASlope) {
  const Truth truth;
  std::vector<RecordedDrive> drives = all_kinds(truth);
  drives.push_back(on_board(truth, 20.0, 0.1, 0.1));
  drives.back().measured.turned_rad.reset();
  const Identification found = identify(drives, unknown());
  ASSERT_EQ(found.slopes.size(), 1u);
  EXPECT_NEAR(found.slopes[0].left, 0.1, 0.003);
  EXPECT_NEAR(found.slopes[0].right, 0.1, 0.003);
}

TEST(IdentifySlopes, RefusesRunsOnSlopesThatSayNothing) {
  const Truth truth;
  const auto told = [&](std::vector<RecordedDrive> drives) -> std::string {
    return test::refusal([&] { identify(drives, unknown()); });
  };
  EXPECT_THAT(told({on_board(truth, 20.0, 0.1, 0.1)}), HasSubstr("runs on level ground"));
  std::vector<RecordedDrive> drives = all_kinds(truth);
  drives.push_back(on_board(truth, 20.0, 0.1, 0.1));
  drives.back().measured.turned_rad = 0.5;
  EXPECT_THAT(told(drives), HasSubstr("board: turned by more than 20 deg"));
  drives.back().measured = {.distance_m = 0.02, .slope_rad = 0.3};
  EXPECT_THAT(told(drives), HasSubstr("board: on a slope a run must go forward"));
  drives.back() = on_board(truth, 20.0, 0.1, 0.1);
  drives.back().measured.distance_m = 3.0 * *drives.back().measured.distance_m;
  EXPECT_THAT(told(drives), HasSubstr("board: its slope would add -"));
  const double turned_rad = 0.33, half_m = turned_rad * truth.wheelbase_m / 2.0;
  drives.back().measured.turned_rad = turned_rad;
  drives.back().measured.distance_m = 0.8 * (1.0 - truth.slip_right + 0.52) - half_m;
  EXPECT_THAT(told(drives), HasSubstr("to the slip of the right track, outside -0.5 to 0.9"));
  drives.pop_back();
  for (int i = 0; i < 9; ++i) drives.push_back(on_board(truth, 3.0 * (i + 1), 0.1, 0.1));
  EXPECT_THAT(told(drives), HasSubstr("runs on more than 8 slopes"));
}

}  // namespace
}  // namespace tp100::identify
