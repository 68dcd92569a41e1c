#include "identify/identify.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "core/arithmetic.h"
#include "core/error.h"
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
  const Truth truth;
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
  const auto fit = [](const Identification& from, const char* key) {
    return from.baselines[model::baseline(key)];
  };
  for (const char* key : {"differential_fitted", "eqs_1_5", "icr", "gyro"}) {
    SCOPED_TRACE(key);
    ASSERT_TRUE(fit(found, key));
    expect_found(*fit(found, key), &TrackParameters::slip_left, even.slip_left, 0.003);
    EXPECT_LT(fit(found, key)->rms_m, 0.003);
  }
  for (const char* key : {"differential_fitted", "eqs_1_5", "icr"})
    expect_found(*fit(found, key), &TrackParameters::wheelbase_m, even.wheelbase_m,
                 0.01 * even.wheelbase_m);
  expect_found(*fit(found, "gyro"), &TrackParameters::gyro_scale, even.gyro_scale, 0.004);
  // None of these is fitted.
  EXPECT_FALSE(fit(found, "differential"));
  EXPECT_FALSE(fit(found, "eqs_1_5_printed"));

  Truth ahead;
  ahead.slip_angle_rad = 0.0;
  const Identification turned = identify(all_kinds(ahead), unknown());
  expect_found(*fit(turned, "icr"), &TrackParameters::x_icr_m, ahead.x_icr_m, 0.002);
  expect_found(*fit(turned, "icr"), &TrackParameters::slip_right, ahead.slip_right, 0.003);
  EXPECT_GT(fit(turned, "differential_fitted")->rms_m, 2.0 * fit(turned, "icr")->rms_m);

  // Also in the robot's file.
  const course::Robot robot = identified_robot(turned, {}, "");
  const course::Robot read = course::parse_robot(course::write_robot(robot, ""), "r.toml");
  const auto& icr = read.baselines[model::baseline("icr")];
  ASSERT_TRUE(icr);
  EXPECT_NEAR(icr->x_icr_m, (*fit(turned, "icr"))[&TrackParameters::x_icr_m].value, 5.1e-6);
  EXPECT_EQ(icr->slip_angle_straight_rad, 0.0);
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

TEST(Identify, ALargerRobotConvergesFromTheSameStart) {
  Truth truth;
  truth.wheelbase_m = 0.49;
  expect_all_found(identify(all_kinds(truth), unknown()), truth);
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
  const Truth truth;
  course::Robot base;
  base.name = "mine";
  base.drive.counts_per_metre = truth.counts_per_metre;
  const Identification found =
      identify({simulated_drive(truth, "a", 0.117, 0.123, 12.0, 1)}, prior_of(base, 0.1));
  const course::Robot robot = identified_robot(found, base, "2026-01-02");
  const auto json = nlohmann::json::parse(identify_json(found, base, robot));
  EXPECT_EQ(json["robot"], "mine");
  for (const auto& parameter : json["parameters"]) {
    const bool seen = parameter["found"];
    EXPECT_EQ(parameter.contains("value"), seen);
    if (parameter["name"] == "slip_left") {
      EXPECT_TRUE(seen);
      EXPECT_EQ(parameter["before"], base.model.slip_left);
      EXPECT_EQ(parameter["value"], robot.model.slip_left);
      EXPECT_GT(parameter["half_interval"], 0.0);
    }
    if (parameter["name"] == "wheelbase_spin_m") {
      EXPECT_FALSE(seen);
      EXPECT_EQ(parameter["unit"], "m");
    }
  }
  EXPECT_GT(json["errors_before"]["rms_m"], json["errors_after"]["rms_m"]);
  EXPECT_EQ(json["errors_after"]["runs"][0]["name"], "a");
  EXPECT_FALSE(json["errors_after"]["runs"][0].contains("distance_off_m"));
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
               SetupError);
  EXPECT_THROW(identify({}, unknown()), SetupError);
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

}  // namespace
}  // namespace tp100::identify
