// Files of robots and cameras, and the files that are bundled.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <tuple>

#include "core/arithmetic.h"
#include "course/bundled_files.h"
#include "course/camera.h"
#include "course/course.h"
#include "course/path.h"
#include "course/robot_file.h"
#include "support/accepted.h"
#include "support/paths.h"
#include "support/refusal.h"
#include "support/temporary_folder.h"

namespace tp100::course {
namespace {

using testing::HasSubstr;

std::string robot_error(const std::string& text) {
  return test::refusal([&] { parse_robot(text, "r.toml"); });
}

TEST(RobotFile, RefusesUnknownAndImpossibleValues) {
  EXPECT_EQ(robot_error("[model]\nwheelbse_m = 1\n"),
            "r.toml:2:1: unknown key 'model.wheelbse_m'; did you mean 'model.wheelbase_m'?");
  EXPECT_EQ(robot_error("[emulated.body]\nmass_kg = -1\n"),
            "r.toml:2:11: 'emulated.body.mass_kg' is -1, allowed 0.1 to 10 kg");
  EXPECT_THAT(robot_error("[emulated.body]\nshoe_width_m = 0.2\n"), HasSubstr("must be below"));
  EXPECT_THAT(robot_error("[emulated]\nbodi = {}\n"), HasSubstr("did you mean 'emulated.body'?"));
  EXPECT_NE(robot_error("[emulated]\ncontact_law = \"mud\"\n"), "");
  EXPECT_EQ(robot_error("[model]\nwheelbase_spin_m = 0\n"), "");
  EXPECT_EQ(robot_error("[model]\nwheelbase_spin_m = 0.01\n"),
            "r.toml:2:20: 'model.wheelbase_spin_m' must be 0 or at least 0.05 m");
  EXPECT_THAT(robot_error("[shape]\nbelt_radius_m = 0.03\n"),
              HasSubstr("did you mean 'shape.wheel_radius_m'?"));
}

// A user with a robot file of an earlier version would delete the key and drive with values that
// were identified beside it.
TEST(RobotFile, SaysWhatToDoAboutAConstantThatTheModelNoLongerHas) {
  for (const char* gone : {"turn_slip_tight", "x_icr_tight_shift_m"})
    EXPECT_EQ(robot_error("[model]\n" + std::string(gone) + " = 0.01\n"),
              "r.toml:2:" + std::to_string(std::string(gone).size() + 4) + ": 'model." + gone +
                  "' is a constant that the model no longer has; delete it and identify the robot "
                  "again (tp100d identify), or use the version of tp100 that wrote this file");
}

TEST(RobotFile, SimplerFormsAreThereIfTheirSectionsAre) {
  const Robot robot = parse_robot("[baselines.icr]\nslip_left = 0.2\nx_icr_m = 0.01\n", "r.toml");
  for (std::size_t i = 0; i < model::kBaselines.size(); ++i)
    EXPECT_EQ(robot.baselines[i].has_value(), i == model::baseline("icr"));
  const model::TrackParameters& icr = *robot.baselines[model::baseline("icr")];
  EXPECT_EQ(icr.slip_left, 0.2);
  EXPECT_EQ(icr.x_icr_m, 0.01);
  EXPECT_EQ(icr.slip_angle_straight_rad, 0.0);
  EXPECT_EQ(robot.model.x_icr_m, 0.0);
  EXPECT_THAT(robot_error("[baselines.gyro]\nwheelbase_m = 0.2\n"),
              HasSubstr("unknown key 'baselines.gyro.wheelbase_m'"));
  EXPECT_THAT(robot_error("[baselines.differential]\n"),
              HasSubstr("unknown key 'baselines.differential'"));
  EXPECT_THAT(robot_error("[baselines.gyro]\nslip_left = 2\n"), HasSubstr("allowed -0.5 to 0.9"));
}

TEST(RobotFile, AWrittenRobotIsInTheFilesUnitsAndReadsBackTheSame) {
  Robot robot;
  robot.description = "a \"quoted\" back\\slash\nand line";
  robot.model.slip_angle_straight_rad = 0.125 * kRadPerDeg;
  robot.baselines[model::kEqsFitted].emplace().slip_right = 0.17;
  robot.drive.invert_left_motor = true;
  robot.model.added_slips = {{{-0.3, -0.05, -0.06}, {28 * kRadPerDeg, 0.2, 0.21}}};
  robot.model.slopes = 2;
  robot.emulated.contact_law = ContactLaw::kShear;
  robot.emulated.shear.modulus_m = 0.025;
  robot.emulated.imu.gyro_noise_radps_rthz = 8.7e-5;
  const std::string text = write_robot(robot, "A note.");
  for (const char* line : {"\nslip_angle_straight_deg = 0.125\n", "\ninvert_left_motor = true\n",
                           "\ncontact_law = \"shear\"\n", "\nmodulus_m = 0.025\n"})
    EXPECT_THAT(text, HasSubstr(line));
  const Robot again = parse_robot(text, "r.toml");
  EXPECT_EQ(write_robot(again, "A note."), text);
  EXPECT_EQ(again.baselines[model::kEqsFitted]->slip_right, 0.17);
  EXPECT_EQ(again.description, robot.description);
  EXPECT_NEAR(again.model.slip_angle_straight_rad, robot.model.slip_angle_straight_rad, 1e-12);
  EXPECT_NEAR(again.model.added_slips.at(0).slope_rad, -0.3, 1e-9);
  EXPECT_EQ(again.model.added_slips.at(1).right, 0.21);
  EXPECT_EQ(again.emulated.contact_law, ContactLaw::kShear);
}

TEST(RobotFile, SaysWhereValuesCameFromAndReadsItBackWhereverItsLinesBreak) {
  Robot robot;
  robot.origins["gyro_scale"] = "ten turns by hand";
  for (std::size_t before = 1; before < 200; ++before) {
    robot.origins["slip_left"] = std::string(before, 'x') + " in a letter. From there on as before";
    const std::string text = write_robot(robot, std::string(before, 'n') + " and a note");
    EXPECT_THAT(text, HasSubstr("\n# From ten turns by hand.\ngyro_scale = 1.0\n"));
    const Robot again = parse_robot(text, "r.toml");
    EXPECT_EQ(again.origins, robot.origins) << before;
    EXPECT_EQ(write_robot(again, head_note(text)), text) << before;
  }
  EXPECT_TRUE(parse_robot("[drive]\n# From nowhere.\nspeed_kp = 4.0\n", "r.toml").origins.empty());
}

TEST(RobotFile, RefusesSlopesThatAreNoTable) {
  const auto slope = [](const char* deg) {
    return "[[model.slope]]\nslope_deg = " + std::string(deg) +
           "\nadded_left = 0.1\nadded_right = 0.1\n";
  };
  EXPECT_EQ(robot_error(slope("-8") + slope("28")), "");
  EXPECT_THAT(robot_error(slope("0")), HasSubstr("'slope_deg' is 0"));
  EXPECT_THAT(robot_error(slope("8") + slope("8")), HasSubstr("sort them"));
  EXPECT_THAT(robot_error(slope("50")), HasSubstr("allowed -45 to 45"));
  EXPECT_THAT(robot_error("[[model.slope]]\nslope_deg = 8\n"), HasSubstr("added_left"));
  EXPECT_THAT(robot_error(slope("8") + "added_lft = 1\n"), HasSubstr("unknown key"));
  std::string nine;
  for (int deg = 1; deg <= 9; ++deg) nine += slope(std::to_string(deg).c_str());
  EXPECT_THAT(robot_error(nine), HasSubstr("more than 8 slopes"));
}

Course bundled_course(const std::string& name) {
  const TextFile file = read_text_file(source_path("config/courses/" + name + ".toml"));
  return parse_course(file.text, file.path);
}

TEST(BundledCourses, HaveTheDocumentedLengthsAndEnds) {
  struct Expected {
    const char* name;
    double length_m, end_x_m, end_y_m, end_yaw_deg;
  };
  for (const Expected& expected : {Expected{"1-straight", 1.7, 1.7, 0.0, 0.0},
                                   Expected{"1-curve", 0.8 + 0.35 * kPi, 0.0, 0.7, 180.0},
                                   Expected{"1-sharp", 1.7, 1.0, 0.7, 90.0},
                                   Expected{"2", 2.6 + 0.15 * kPi, 0.3, -0.5, -180.0}}) {
    SCOPED_TRACE(expected.name);
    const Course course = bundled_course(expected.name);
    const Path path(course);
    EXPECT_EQ(course.speed_mps, 0.10);
    EXPECT_NEAR(path.length_m(), expected.length_m, 1e-9);
    EXPECT_NEAR(path.segments().back().end.x_m, expected.end_x_m, 1e-9);
    EXPECT_NEAR(path.segments().back().end.y_m, expected.end_y_m, 1e-9);
    EXPECT_NEAR(path.segments().back().end.yaw_rad, expected.end_yaw_deg * kRadPerDeg, 1e-9);
    // In the paper's arena, with room for a push.
    Fence room = course.fence;
    EXPECT_NEAR(room.max_x_m - room.min_x_m, 1.9, 1e-9);
    EXPECT_NEAR(room.max_y_m - room.min_y_m, 1.0, 1e-9);
    for (double* low : {&room.min_x_m, &room.min_y_m}) *low += 0.095;
    for (double* high : {&room.max_x_m, &room.max_y_m}) *high -= 0.095;
    EXPECT_FALSE(first_point_outside(path, room));
    EXPECT_EQ(course.disturbances.size(), course.name == "2" ? 2u : 0u);
    for (const Disturbance& push : course.disturbances) {
      EXPECT_DOUBLE_EQ(std::abs(push.sideways_m), 0.04);
      EXPECT_DOUBLE_EQ(std::abs(push.yaw_rad), 15.0 * kRadPerDeg);
    }
  }
}

TEST(BundledCourses, Course3HasThePapersStepAndRampOnItsWayBack) {
  const Course course = bundled_course("3");
  const PathPoint end = Path(course).segments().back().end;
  EXPECT_NEAR(end.x_m, 0.0, 1e-9);
  EXPECT_NEAR(end.y_m, -0.8, 1e-9);
  const auto& ramp = std::get<Ramp>(course.terrain.obstacles.at(0));
  const auto& block = std::get<Block>(course.terrain.obstacles.at(1));
  EXPECT_EQ(block.place.y_m, -0.80);
  EXPECT_EQ(block.height_m, 0.037);
  EXPECT_EQ(ramp.place.y_m, -0.80);
  EXPECT_DOUBLE_EQ(ramp.up_rad, 28 * kRadPerDeg);
  EXPECT_NEAR(ramp.length_m(), 0.2 + 2 * 0.08 / std::tan(28 * kRadPerDeg), 1e-12);
}

EmulatedCamera rough() {
  EmulatedCamera values;
  values.delay_s = 0.12;
  values.delay_jitter_s = 0.02;
  values.stamp_error_s = 0.004;
  values.stamp_lag_s = 0.008;
  values.bias_m = 0.004;
  values.dropped = 0.1;
  values.outliers = 0.02;
  values.distortion = 0.02;
  values.view_m = 1.5;
  return values;
}

/// Expects that a bundled file is what `written` makes of its text.
template <class Written>
void expect_written(const std::string& name, Written written) {
  const std::string path = "config/" + name + ".toml";
  test::expect_accepted(path, written(read_text_file(source_path(path)).text));
}

TEST(BundledFiles, OfRobotsAndCamerasSayWhatTheKeyTableSays) {
  for (const char* name : {"end-loaded", "uniform", "front-heavy", "slippery", "large", "worn"})
    expect_written("robots/" + std::string(name), [&](const std::string& text) {
      return write_robot(parse_robot(text, std::string(name) + ".toml"), head_note(text));
    });
  expect_written("cameras/overhead", [](const std::string& text) {
    return write_camera(EmulatedCamera{}, head_note(text));
  });
  expect_written("cameras/rough",
                 [](const std::string& text) { return write_camera(rough(), head_note(text)); });
}

TEST(BundledFiles, AreReadWholeWithEveryByte) {
  const test::TemporaryFolder folder;
  const std::string text("a\r\n\0b\xff", 6);
  std::ofstream(folder.path() / "x.toml", std::ios::binary) << text;
  const TextFile file = read_text_file(folder.file("x.toml"));
  EXPECT_EQ(file.text, text);
  EXPECT_EQ(file_stem(file.path), "x");
}

TEST(BundledFiles, WhatIsNoFileIsNamedInOneLine) {
  const test::TemporaryFolder folder;
  for (const auto& [kind, name, error] :
       {std::tuple(Bundled::kCourses, folder.file("none.toml"),
                   "none.toml: cannot be opened (No such file"),
        {Bundled::kRobots, folder.path().string() + "/", "is a directory"},
        {Bundled::kCourses, "no-such-course",
         "no-such-course: no such course; give a file or one of"},
        {Bundled::kRobots, "wron", "wron: no such robot; did you mean 'worn'?; give a file or"}}) {
    const std::string why =
        test::refusal([kind = kind, &name = name] { read_bundled(kind, name); });
    EXPECT_THAT(why, HasSubstr(error));
    EXPECT_THAT(why, testing::Not(HasSubstr("\n")));
  }
}

TEST(CameraFile, ReadsBackWhatItWritesAndRefusesWhatItDoesNotKnow) {
  EXPECT_EQ(write_camera(parse_camera(write_camera(rough(), ""), "f"), ""),
            write_camera(rough(), ""));
  EXPECT_THROW(parse_camera("rate_hz = 0.0\n", "f"), UserError);
  EXPECT_THROW(parse_camera("hight_m = 2.0\n", "f"), UserError);
}

}  // namespace
}  // namespace tp100::course
