#include <gtest/gtest.h>

#include <map>
#include <nlohmann/json.hpp>
#include <string>

#include "../support/temporary_folder.h"
#include "course/bundled_files.h"
#include "identify/drive_file.h"
#include "sim/robot/commands.h"
#include "text/csv_reader.h"

namespace tp100::sim {
namespace {

// `tp100-sim course --out` writes poses and samples of the same instants.
TEST(CourseFiles, HaveOneTimeZeroWhereTheRunBegins) {
  const test::TemporaryFolder folder;
  CourseCommand command;
  command.course = "1-straight";
  command.camera = "overhead";
  command.out = folder.file("out");
  command.json = true;
  testing::internal::CaptureStdout();
  const int status = run_course(command);
  const auto figures = nlohmann::json::parse(testing::internal::GetCapturedStdout());
  ASSERT_EQ(status, 0);
  const std::string stem = folder.file("out/1-straight-end-loaded-1");
  const text::CsvTable poses =
      text::parse_csv(course::read_text_file(stem + ".csv").text, "poses.csv",
                      {{"t_s", "truth_x_m", "truth_y_m", "truth_yaw_rad"}, {}});
  const identify::RecordedDrive drive =
      identify::parse_drive(course::read_text_file(stem + "-samples.csv").text, "samples.csv");
  ASSERT_GT(poses.rows(), 1000u);
  std::size_t sample = 0;
  std::map<double, Pose> truth;
  for (std::size_t i = 0; i < poses.rows(); ++i) {
    const double t_s = poses["t_s"][i];
    while (sample < drive.samples.size() && drive.samples[sample].t_s < t_s) ++sample;
    ASSERT_LT(sample, drive.samples.size());
    ASSERT_EQ(drive.samples[sample].t_s, t_s) << "row " << i;
    truth[t_s] = {.x_m = poses["truth_x_m"][i], .y_m = poses["truth_y_m"][i]};
  }
  EXPECT_GE(poses["t_s"][0], 0.0);
  EXPECT_LT(poses["t_s"][0], 0.02);
  EXPECT_NEAR(poses["t_s"][poses.rows() - 1], figures["duration_s"].get<double>(), 0.05);
  EXPECT_LT(drive.samples.front().t_s, -0.5) << "the standstill before the run";
  // The camera's times have the same zero: at each of them the robot was where the camera saw it.
  std::size_t seen = 0;
  for (const identify::SeenPose& pose : drive.camera) {
    const auto near = truth.lower_bound(pose.t_s);
    if (pose.t_s < 0.0 || near == truth.end()) continue;
    EXPECT_NEAR(pose.x_m, near->second.x_m, 0.01) << pose.t_s;
    ++seen;
  }
  EXPECT_GT(seen, 100u);
}

}  // namespace
}  // namespace tp100::sim
