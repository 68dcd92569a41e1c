// A robot's parameters from its drives, on slopes too, and the files of drives.

#include "identify/identify.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "core/arithmetic.h"
#include "core/error.h"
#include "identify/drive_file.h"
#include "identify/drive_motion.h"
#include "identify/identify_report.h"
#include "simulated_drives.h"
#include "support/refusal.h"

namespace tp100::identify {
namespace {

using model::TrackParameters;
using testing::ElementsAre;
using testing::HasSubstr;

TEST(Identify, FindsARobotOfWhichNothingIsKnown) {
  Truth truth;
  truth.wheelbase_m = 0.49;
  expect_all_found(identify(all_kinds(truth), unknown()), truth);
  truth = {};
  const Identification found = identify(all_kinds(truth), unknown());
  expect_all_found(found, truth);
  EXPECT_LT(found.extended.rms_m, 0.003);
  EXPECT_GT(found.before.rms_m, 5.0 * found.extended.rms_m) << "with the assumed values";
  EXPECT_GT(found.baselines[model::kEqsFitted]->rms_m, found.extended.rms_m);
  EXPECT_LT(found.extended.condition, 10.0);
  EXPECT_EQ(found.prior.tracks.slip_left, found.extended[&TrackParameters::slip_left].value);
  EXPECT_EQ(found.prior.counts_per_metre, truth.counts_per_metre);
}

TEST(Identify, SimplerFormsComeFromTheSameDrives) {
  // Drives that each form can describe exactly.
  Truth even;
  even.slip_right = even.slip_left;
  even.x_icr_m = even.slip_angle_rad = 0.0;
  const Identification found = identify(all_kinds(even), unknown());
  const auto fit = [](const Identification& from, std::string_view key) {
    return from.baselines[model::baseline(key)];
  };
  for (const model::ModelForm& form : model::kBaselines) {
    SCOPED_TRACE(form.key);
    ASSERT_EQ(fit(found, form.key).has_value(), form.fixed == nullptr);
    if (form.fixed != nullptr) continue;
    const Fit of = *fit(found, form.key);
    expect_found(of, &TrackParameters::slip_left, even.slip_left, 0.003);
    EXPECT_LT(of.rms_m, 0.003);
    if (form.yaw_from_gyro)
      expect_found(of, &TrackParameters::gyro_scale, even.gyro_scale, 0.004);
    else
      expect_found(of, &TrackParameters::wheelbase_m, even.wheelbase_m, 0.01 * even.wheelbase_m);
  }

  Truth ahead;
  ahead.slip_angle_rad = 0.0;
  const Identification turned = identify(all_kinds(ahead), unknown());
  expect_found(*fit(turned, "icr"), &TrackParameters::x_icr_m, ahead.x_icr_m, 0.002);
  expect_found(*fit(turned, "icr"), &TrackParameters::slip_right, ahead.slip_right, 0.003);
  EXPECT_GT(fit(turned, "differential_fitted")->rms_m, 2.0 * fit(turned, "icr")->rms_m);

  // Also in the robot's file.
  const course::Robot robot = identified_robot(turned, {}, "");
  const course::Robot read = course::parse_robot(course::write_robot(robot, ""), "r.toml");
  EXPECT_NEAR(read.baselines[model::baseline("icr")].value().x_icr_m,
              (*fit(turned, "icr"))[&TrackParameters::x_icr_m].value, 5.1e-6);
}

TEST(Identify, ImagesThatAreOffTogetherSayLess) {
  // A periodic yaw error is added, which no model explains.
  const auto with_waves = [](double duration_s) {
    std::vector<RecordedDrive> drives = all_kinds(Truth{});
    for (RecordedDrive& drive : drives) {
      for (SeenPose& seen : drive.camera)
        seen.yaw_rad += 0.02 * std::sin(2.0 * kPi * seen.t_s / duration_s);
    }
    return identify(drives, unknown()).extended[&TrackParameters::wheelbase_tight_m].half_interval;
  };
  EXPECT_GT(with_waves(8.0), 1.25 * with_waves(0.13));
}

TEST(Identify, FalseDetectionsAndLateStampsDoNotBendIt) {
  Truth truth;
  truth.outliers = 0.1;
  truth.late_s = 0.03;
  const Identification found = identify(all_kinds(truth), unknown());
  expect_all_found(found, truth);
  EXPECT_NEAR(found.extended.camera_late_s, truth.late_s, 0.003);
  for (const RunFit& run : found.extended.runs) EXPECT_GT(run.rejected, 10u) << run.name;
}

// As on soft ground: the track speeds of a wide turn oscillate into the range of tight turns.
TEST(Identify, AnOscillatingYawDoesNotCountAsATightTurn) {
  constexpr double kStepS = 0.01, kSwingHz = 2.2, kCountsPerMetre = 20000.0;
  TrackParameters tracks = model::ModelForm{}.only({});
  tracks.wheelbase_m = 0.16;
  tracks.wheelbase_tight_m = tracks.wheelbase_spin_m = 0.24;
  const auto turned_rad = [&](double swing_mps) {
    RecordedDrive drive;
    double left_m = 0.0, right_m = 0.0;
    for (int i = 0; i < 1000; ++i) {
      drive.samples.push_back({i * kStepS, std::lround(left_m * kCountsPerMetre),
                               std::lround(right_m * kCountsPerMetre), 0.0});
      const double now_mps = swing_mps * std::sin(2.0 * kPi * kSwingHz * i * kStepS);
      left_m += (0.088 - now_mps / 2.0) * kStepS;
      right_m += (0.122 + now_mps / 2.0) * kStepS;
    }
    return DriveMotion(drive, kCountsPerMetre).poses(model::kExtendedForm, tracks).back().yaw_rad;
  };
  const double steady_rad = turned_rad(0.0);
  EXPECT_GT(steady_rad, 1.5);
  EXPECT_NEAR(turned_rad(0.05), steady_rad, 0.05 * steady_rad);
}

TEST(Identify, TapeAndProtractorAreEnough) {
  const Truth truth;
  std::vector<RecordedDrive> drives = all_kinds(truth);
  for (RecordedDrive& drive : drives) measure_by_hand(drive);
  const Identification found = identify(drives, unknown());
  const Fit& fit = found.extended;
  EXPECT_GT(std::abs(found.before.runs[1].turned_off_rad.value()), 0.1);
  EXPECT_LT(std::abs(fit.runs[1].turned_off_rad.value()), 0.02);
  EXPECT_FALSE(fit.runs[0].distance_off_m) << "it was not measured";
  expect_found(fit, &TrackParameters::slip_left, truth.slip_left, 0.01);
  expect_found(fit, &TrackParameters::slip_right, truth.slip_right, 0.01);
  expect_found(fit, &TrackParameters::wheelbase_m, truth.wheelbase_m, 0.02 * truth.wheelbase_m);
  expect_found(fit, &TrackParameters::gyro_scale, truth.gyro_scale, 0.01);
}

TEST(Identify, SaysWhatStraightRunsDoNotShow) {
  const Truth truth;
  const Prior before = unknown();
  const Identification found = identify({simulated_drive(truth, "a", 0.117, 0.123, 12.0, 1),
                                         simulated_drive(truth, "b", 0.117, 0.123, 12.0, 2)},
                                        before);
  EXPECT_FALSE(found.extended[&TrackParameters::x_icr_m].found);
  EXPECT_FALSE(found.extended[&TrackParameters::wheelbase_spin_m].found);
  EXPECT_EQ(found.prior.tracks.wheelbase_spin_m, before.tracks.wheelbase_spin_m);
  EXPECT_EQ(found.prior.tracks.x_icr_m, before.tracks.x_icr_m);
  for (const std::optional<Fit>& fit : found.baselines) EXPECT_FALSE(fit);
}

TEST(Identify, IsReportedAsJsonToo) {
  course::Robot base;
  base.name = "mine";
  base.drive.counts_per_metre = Truth{}.counts_per_metre;
  const Identification found =
      identify({simulated_drive(Truth{}, "a", 0.117, 0.123, 12.0, 1)}, prior_of(base, 0.1));
  const course::Robot robot = identified_robot(found, base, "2026-01-02");
  const auto json = nlohmann::json::parse(identify_json(found, base, robot));
  EXPECT_EQ(json["robot"], "mine");
  for (const auto& parameter : json["parameters"]) {
    EXPECT_EQ(parameter.contains("value"), parameter["found"].get<bool>());
    if (parameter["name"] == "wheelbase_spin_m") {
      EXPECT_FALSE(parameter["found"]);
    }
    if (parameter["name"] != "slip_left") continue;
    EXPECT_EQ(parameter["before"], base.model.slip_left);
    EXPECT_EQ(parameter["value"], robot.model.slip_left);
    EXPECT_GT(parameter["half_interval"], 0.0);
  }
  EXPECT_GT(json["errors_before"]["rms_m"], json["errors_after"]["rms_m"]);
  EXPECT_EQ(json["errors_after"]["runs"][0]["name"], "a");
  EXPECT_FALSE(json["warnings"].empty());
}

TEST(Identify, NamesThePairThatTurnsToOneSideMix) {
  const Truth truth;
  const Fit fit = identify({simulated_drive(truth, "a", 0.09, 0.15, 10.0, 1),
                            simulated_drive(truth, "b", 0.09, 0.15, 10.0, 2),
                            simulated_drive(truth, "c", 0.09, 0.15, 10.0, 3)},
                           unknown())
                      .extended;
  EXPECT_FALSE(fit.confused.empty());
  // The condition is below 10 with drives of all kinds.
  EXPECT_GT(fit.condition, 20.0);
}

TEST(Identify, RefusesARunWithoutAnythingToCompare) {
  RecordedDrive blind = simulated_drive(Truth{}, "blind", 0.1, 0.1, 2.0, 1);
  blind.camera.clear();
  EXPECT_THAT(test::refusal([&] { identify({blind}, unknown()); }),
              HasSubstr("blind: neither camera poses nor hand measurements"));
  EXPECT_THROW(identify({simulated_drive(Truth{}, "still", 0.0, 0.0, 2.0, 1)}, unknown()),
               UserError);
  EXPECT_THROW(identify({}, unknown()), UserError);
}

std::vector<std::string> arcs_of(double gauge_m) {
  course::ShapeValues shape;
  shape.gauge_m = gauge_m;
  std::vector<std::string> names = calibration_courses(shape);
  EXPECT_EQ(names.front(), "calibrate-straight");
  EXPECT_EQ(names.back(), "calibrate-spin-right");
  std::erase_if(names, [](const std::string& name) {
    return !name.ends_with("-left") || name == "calibrate-spin-left";
  });
  return names;
}

TEST(CalibrationCourses, HaveWideAndTightArcsForEverySize) {
  const auto wide = "calibrate-wide-left", arc = "calibrate-arc-left",
             tight = "calibrate-tight-left", widest = "calibrate-widest-left";
  EXPECT_THAT(arcs_of(0.1), ElementsAre(wide, arc, tight));
  EXPECT_THAT(arcs_of(0.155), ElementsAre(wide, arc, tight));
  EXPECT_THAT(arcs_of(0.215), ElementsAre(widest, wide, arc, tight));
  EXPECT_THAT(arcs_of(0.31), ElementsAre(widest, wide, arc));
  for (double gauge_m = 0.03; gauge_m <= 1.0; gauge_m += 0.005)
    EXPECT_GE(arcs_of(gauge_m).size(), 3u) << gauge_m;
}

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

  const course::Robot robot = identified_robot(found, {}, "");
  EXPECT_EQ(robot.model.slopes, 2u);
  EXPECT_NEAR(robot.model.added_slips[1].right, 0.20, 0.003);

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
  const auto told = [&](const std::vector<RecordedDrive>& drives) {
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

std::string told(std::string_view text) {
  return test::refusal([&] { parse_drive(text, "d.csv"); });
}

TEST(DriveFile, ReadsSamplesAndImagesFromTheirRows) {
  const RecordedDrive drive = parse_drive(
      "t_s,left_count,right_count,gyro_z_radps,camera_x_m,camera_y_m,camera_yaw_rad\n"
      "0,1,-2,0.5,,,\n0.001,,,,0.1,0.2,0.3\n0.005,3,4,0.25,1,2,3\n",
      "dir/run-7.csv");
  EXPECT_EQ(drive.name, "run-7");
  EXPECT_EQ(drive.samples.at(0).right_counts, -2);
  EXPECT_EQ(drive.samples.at(1).gyro_z_radps, 0.25);
  EXPECT_EQ(drive.camera.at(0).t_s, 0.001);
  EXPECT_EQ(drive.camera.at(1).yaw_rad, 3.0);
}

TEST(DriveFile, AWrittenDriveReadsBackBitForBit) {
  RecordedDrive drive;
  drive.name = "w";
  for (int i = 0; i < 20; ++i) {
    drive.samples.push_back({0.1 * i / 3.0, 9'000'000'000'000'000 - i, -7 * i, 1e-3 / (i + 3)});
    if (i % 3 == 0) drive.camera.push_back({0.1 * i / 3.0, 1.0 / 3, -2.0 / 7, 0.1 * i});
    if (i % 4 == 1) drive.camera.push_back({0.1 * i / 3.0 + 0.001, 0.1, 1e-17, -3.0});
  }
  const std::string text = write_drive(drive);
  const RecordedDrive again = parse_drive(text, "w.csv");
  EXPECT_EQ(write_drive(again), text);
  ASSERT_EQ(again.samples.size(), drive.samples.size());
  ASSERT_EQ(again.camera.size(), drive.camera.size());
  EXPECT_EQ(again.samples[19].left_counts, drive.samples[19].left_counts);
  EXPECT_EQ(again.camera[1].y_m, drive.camera[1].y_m);
  drive.camera.clear();
  EXPECT_THAT(write_drive(drive), HasSubstr("gyro_z_radps\n"));
  EXPECT_EQ(parse_drive(write_drive(drive), "w.csv").samples.size(), 20u);
}

TEST(DriveFile, RefusesABadRowAtItsLine) {
  const std::string head = "t_s,left_count,right_count,gyro_z_radps\n";
  EXPECT_EQ(told(head + "0,1,2,0\n0.1,1.5,2,0\n"),
            "d.csv:3: left_count is 1.5, expected a whole number");
  EXPECT_EQ(told(head + "0,1,2,0\n0.1,,2,0\n"),
            "d.csv:3: of left_count, right_count and gyro_z_radps only some have a value; give all "
            "or none");
  EXPECT_THAT(told(head + "0,1,2,0\n0.1,1e17,2,0\n"), HasSubstr("d.csv:3: left_count is"));
  EXPECT_THAT(told(head + "0,1,2,0\n0.1,1,2,inf\n"), HasSubstr("d.csv:3: gyro_z_radps is"));
  EXPECT_EQ(told(head + "0,,,\n"), "d.csv:2: neither a sample nor a camera pose in this row");
  EXPECT_THAT(told(head + "0,1,2,0\n"), HasSubstr("fewer than two samples"));
  EXPECT_EQ(told("t_s,left_count,right_count,gyro_z_radps,camera_x_m\n0,1,2,0,\n"),
            "d.csv:1: column 'camera_y_m' is missing; a camera pose needs all three");
}

TEST(DriveFile, HandMeasurementsGoToTheirRun) {
  std::vector<RecordedDrive> drives(3);
  add_measured("run,distance_m,turned_deg\n1,1.5,\n3,,-360\n", "m.csv", drives);
  EXPECT_EQ(drives[0].measured.distance_m, 1.5);
  EXPECT_FALSE(drives[0].measured.turned_rad);
  EXPECT_FALSE(drives[1].measured.distance_m);
  ASSERT_TRUE(drives[2].measured.turned_rad);
  EXPECT_DOUBLE_EQ(*drives[2].measured.turned_rad, -2.0 * kPi);
  add_measured("run,distance_m,slope_deg\n1,,0\n2,0.8,-16\n", "m.csv", drives);
  EXPECT_NEAR(drives[1].measured.slope_rad.value(), -16.0 * kRadPerDeg, 1e-12);
  EXPECT_FALSE(drives[0].measured.slope_rad) << "level";
  std::vector<RecordedDrive> again(3);
  add_measured(write_measured(drives), "w.csv", again);
  EXPECT_EQ(again[0].measured.distance_m, drives[0].measured.distance_m);
  EXPECT_EQ(again[2].measured.turned_rad, drives[2].measured.turned_rad);
  EXPECT_NEAR(again[1].measured.slope_rad.value(), -16.0 * kRadPerDeg, 1e-12);
  EXPECT_EQ(write_measured(std::vector<RecordedDrive>(2)), "");
  EXPECT_EQ(test::refusal([&] { add_measured("run,left_m\n4,0\n", "m.csv", drives); }),
            "m.csv:2: run is 4, but there are runs 1 to 3");
  EXPECT_THROW(add_measured("run,slope_deg\n3,16\n", "m.csv", drives), UserError)
      << "without a distance";
}

}  // namespace
}  // namespace tp100::identify
