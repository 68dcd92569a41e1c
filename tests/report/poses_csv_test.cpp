#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <functional>

#include "report/run_result.h"
#include "text/csv_reader.h"

namespace tp100::report {
namespace {

using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

/// All values of a pose differ from each other and from those of poses with other numbers.
Pose pose(double number) {
  return {.x_m = number + 0.1,
          .y_m = number + 0.2,
          .z_m = number + 0.3,
          .roll_rad = number + 0.4,
          .pitch_rad = number + 0.5,
          .yaw_rad = number + 0.6};
}

RunResult a_run(bool has_camera) {
  RunResult run;
  run.has_camera = has_camera;
  for (int i = 0; i < 3; ++i) {
    const double number = 100.0 * i;
    run.points.push_back({.t_s = 0.1 * i,
                          .truth = pose(number + 10),
                          .world = pose(number + 20),
                          .estimates = {{pose(number + 30), pose(number + 40), pose(number + 50)}},
                          .progress_m = number + 60});
  }
  return run;
}

TEST(PosesCsv, EveryColumnHoldsWhatItsNameSays) {
  const RunResult run = a_run(true);
  const struct {
    const char* name;
    std::function<const Pose&(const TrajectoryPoint&)> pose;
  } poses[] = {
      {"truth", &TrajectoryPoint::truth},
      {"world", &TrajectoryPoint::world},
      {"model",
       [](const TrajectoryPoint& p) -> const Pose& { return p.estimates[PoseSource::kModel]; }},
      {"odometry",
       [](const TrajectoryPoint& p) -> const Pose& { return p.estimates[PoseSource::kOdometry]; }},
      {"fused",
       [](const TrajectoryPoint& p) -> const Pose& { return p.estimates[PoseSource::kFused]; }}};
  const struct {
    const char* name;
    double Pose::*value;
  } values[] = {{"x_m", &Pose::x_m},
                {"y_m", &Pose::y_m},
                {"z_m", &Pose::z_m},
                {"roll_rad", &Pose::roll_rad},
                {"pitch_rad", &Pose::pitch_rad},
                {"yaw_rad", &Pose::yaw_rad}};
  std::vector<std::string> names;
  for (const auto& pose : poses)
    for (const auto& value : values) names.push_back(std::string(pose.name) + "_" + value.name);
  text::CsvColumns columns{{"t_s", "progress_m"}, {}};
  columns.required.insert(columns.required.end(), names.begin(), names.end());

  const text::CsvTable table = text::parse_csv(poses_csv(run), "poses.csv", columns);
  ASSERT_EQ(table.rows(), run.points.size());
  for (std::size_t i = 0; i < run.points.size(); ++i) {
    EXPECT_EQ(table["t_s"][i], run.points[i].t_s);
    EXPECT_EQ(table["progress_m"][i], run.points[i].progress_m);
    auto name = names.begin();
    for (const auto& pose : poses)
      for (const auto& value : values) {
        EXPECT_EQ(table[*name][i], pose.pose(run.points[i]).*value.value) << *name;
        ++name;
      }
  }
}

TEST(PosesCsv, WithoutACameraThereIsNoFusedPose) {
  const std::string text = poses_csv(a_run(false));
  EXPECT_THAT(text, StartsWith("t_s,truth_x_m,"));
  EXPECT_THAT(text, Not(HasSubstr("fused")));
  EXPECT_EQ(text::parse_csv(text, "poses.csv", {{"t_s"}, {}}).rows(), 3u);
}

}  // namespace
}  // namespace tp100::report
