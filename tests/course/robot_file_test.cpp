#include "course/robot_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/arithmetic.h"
#include "support/refusal.h"

namespace tp100::course {
namespace {

using testing::HasSubstr;

std::string robot_error(const std::string& text) {
  return test::refusal([&] { parse_robot(text, "r.toml"); });
}

TEST(RobotFile, ReadsTablesInTheFilesUnits) {
  const Robot robot = parse_robot(
      "[model]\nslip_left = 0.2\nslip_angle_straight_deg = 1\n[drive]\nswap_tracks = true\n"
      "[emulated]\nclock_ppm = -30\ncontact_law = \"shear\"\n[emulated.body]\nmid_lift_m = 0\n"
      "[emulated.shear]\nmodulus_m = 0.025\n",
      "r.toml");
  EXPECT_EQ(robot.model.slip_left, 0.2);
  EXPECT_DOUBLE_EQ(robot.model.slip_angle_straight_rad, kRadPerDeg);
  EXPECT_TRUE(robot.drive.swap_tracks);
  EXPECT_EQ(robot.emulated.clock_ppm, -30.0);
  EXPECT_EQ(robot.emulated.body.mid_lift_m, 0.0);
  EXPECT_EQ(robot.emulated.contact_law, ContactLaw::kShear);
  EXPECT_EQ(robot.emulated.shear.modulus_m, 0.025);
  EXPECT_EQ(robot.emulated.shear.cohesion_pa, EmulatedShear{}.cohesion_pa);
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

TEST(RobotFile, AWrittenRobotReadsBackTheSame) {
  Robot robot;
  robot.description = "a \"quoted\" back\\slash\nand line";
  robot.model.slip_angle_straight_rad = 0.123 * kRadPerDeg;
  robot.baselines[model::kEqsFitted].emplace().slip_right = 0.17;
  robot.drive.invert_left_motor = true;
  robot.model.added_slips = {{{-0.3, -0.05, -0.06}, {28 * kRadPerDeg, 0.2, 0.21}}};
  robot.model.slopes = 2;
  robot.emulated.imu.gyro_noise_radps_rthz = 8.7e-5;
  const std::string text = write_robot(robot, "A note.");
  const Robot again = parse_robot(text, "r.toml");
  EXPECT_EQ(again.baselines[model::kEqsFitted]->slip_right, 0.17);
  EXPECT_FALSE(again.baselines[model::baseline("icr")]);
  EXPECT_EQ(again.description, robot.description);
  EXPECT_NEAR(again.model.slip_angle_straight_rad, robot.model.slip_angle_straight_rad, 1e-12);
  EXPECT_TRUE(again.drive.invert_left_motor);
  ASSERT_EQ(again.model.slopes, 2u);
  EXPECT_NEAR(again.model.added_slips[0].slope_rad, -0.3, 1e-9);
  EXPECT_EQ(again.model.added_slips[1].left, 0.2);
  EXPECT_EQ(again.model.added_slips[1].right, 0.21);
  EXPECT_EQ(again.emulated.imu.gyro_noise_radps_rthz, 8.7e-5);
  EXPECT_EQ(write_robot(again, "A note."), text);
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

}  // namespace
}  // namespace tp100::course
