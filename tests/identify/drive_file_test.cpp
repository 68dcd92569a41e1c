#include "identify/drive_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/arithmetic.h"
#include "support/refusal.h"

namespace tp100::identify {
namespace {

using testing::HasSubstr;

std::string told(std::string_view text) {
  return test::refusal([&] { parse_drive(text, "d.csv"); });
}

TEST(DriveFile, ReadsSamplesAndImagesFromTheirRows) {
  const RecordedDrive drive = parse_drive(
      "t_s,left_count,right_count,gyro_z_radps,camera_x_m,camera_y_m,camera_yaw_rad\n"
      "0,1,-2,0.5,,,\n"
      "0.001,,,,0.1,0.2,0.3\n"
      "0.005,3,4,0.25,1,2,3\n",
      "dir/run-7.csv");
  EXPECT_EQ(drive.name, "run-7");
  ASSERT_EQ(drive.samples.size(), 2u);
  EXPECT_EQ(drive.samples[0].right_counts, -2);
  EXPECT_EQ(drive.samples[1].left_counts, 3);
  EXPECT_EQ(drive.samples[1].gyro_z_radps, 0.25);
  ASSERT_EQ(drive.camera.size(), 2u);
  EXPECT_EQ(drive.camera[0].t_s, 0.001);
  EXPECT_EQ(drive.camera[1].yaw_rad, 3.0);
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
  EXPECT_THAT(told(head + "0,1,2,0\n0.1,1,2,nan\n"), HasSubstr("d.csv:3: gyro_z_radps is"));
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
  EXPECT_THROW(add_measured("run,slope_deg\n3,16\n", "m.csv", drives), SetupError)
      << "without a distance";
}

}  // namespace
}  // namespace tp100::identify
