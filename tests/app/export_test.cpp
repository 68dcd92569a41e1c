#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <sstream>

#include "../record/random_record.h"
#include "app/commands.h"
#include "messages/foxglove.h"
#include "messages/messages.h"
#include "record/recording.h"
#include "recorded_run.h"
#include "support/temporary_folder.h"
#include "text/csv_reader.h"

namespace tp100::app {
namespace {

using text::CsvTable;
using text::parse_csv;

/// A recording whose exported values all differ from each other.
class Export : public testing::Test {
 protected:
  Export() {
    record_run(folder_.file("run.mcap"), [this](StepRecord& record) {
      record::RandomFiller fill(record.step + 1);
      Snapshot& s = record.snapshot;
      for (Pose* pose :
           {&s.estimates[PoseSource::kModel].pose, &s.estimates[PoseSource::kOdometry].pose,
            &s.estimates[PoseSource::kFused].pose, &s.world})
        fill("", *pose);
      for (double* value :
           {&s.left_mps, &s.right_mps, &s.slip_left, &s.slip_right, &s.cross_track_m,
            &s.heading_error_rad, &s.progress_m, &s.command.desired_yaw_rad, &s.command.speed_mps})
        fill("", *value);
      for (std::size_t i = 0; i < record.inputs.samples.size(); ++i) {
        Sample& sample = record.inputs.samples[i];
        fill("", sample.gyro_radps);
        sample.left_counts = static_cast<std::int64_t>(3 * record.step);
        sample.right_counts = -static_cast<std::int64_t>(5 * record.step);
        if (sample.measured_ns != 0) samples_.push_back(sample);
      }
      if (!record.inputs.samples.empty()) snapshots_.push_back(s);
      return true;
    });
    const std::string out = folder_.path().string();
    EXPECT_EQ(run_export({.runs = {folder_.file("run.mcap")}, .out = out}), 0);
    start_ns_ = record::Recording(folder_.file("run.mcap")).start_ns();
  }

  std::string text(const char* name) const { return test::read_bytes(folder_.file(name)); }
  /// The step of the row with this time.
  const Snapshot& at(double t_s) const {
    for (const Snapshot& snapshot : snapshots_)
      if (std::abs(to_s(snapshot.sample.measured_ns - start_ns_) - t_s) < 1e-6) return snapshot;
    throw std::runtime_error("no step of that time");
  }

  test::TemporaryFolder folder_;
  std::vector<Snapshot> snapshots_;  // of the steps that received a sample
  std::vector<Sample> samples_;
  HostNs start_ns_ = 0;
};

using Value = std::function<double(const Snapshot&)>;
using PoseOf = std::function<Pose(const Snapshot&)>;

PoseOf estimate(PoseSource source) {
  return [source](const Snapshot& s) { return s.estimates[source].pose; };
}

const std::map<std::string, PoseOf> kEstimates = {{"model", estimate(PoseSource::kModel)},
                                                  {"odometry", estimate(PoseSource::kOdometry)},
                                                  {"fused", estimate(PoseSource::kFused)}};

std::map<std::string, Value> columns_of_poses() {
  std::map<std::string, Value> columns = {
      {"left_mps", [](const Snapshot& s) { return s.left_mps; }},
      {"right_mps", [](const Snapshot& s) { return s.right_mps; }},
      {"slip_left", [](const Snapshot& s) { return s.slip_left; }},
      {"slip_right", [](const Snapshot& s) { return s.slip_right; }},
      {"cross_track_m", [](const Snapshot& s) { return s.cross_track_m; }},
      {"heading_error_rad", [](const Snapshot& s) { return s.heading_error_rad; }},
      {"progress_m", [](const Snapshot& s) { return s.progress_m; }},
      {"desired_yaw_rad", [](const Snapshot& s) { return s.command.desired_yaw_rad; }},
      {"speed_mps", [](const Snapshot& s) { return s.command.speed_mps; }}};
  std::map<std::string, PoseOf> poses = kEstimates;
  poses["world"] = [](const Snapshot& s) { return s.world; };
  const std::map<std::string, double Pose::*> values = {{"x_m", &Pose::x_m},
                                                        {"y_m", &Pose::y_m},
                                                        {"z_m", &Pose::z_m},
                                                        {"roll_rad", &Pose::roll_rad},
                                                        {"pitch_rad", &Pose::pitch_rad},
                                                        {"yaw_rad", &Pose::yaw_rad}};
  for (const auto& [name, pose] : poses)
    for (const auto& [key, value] : values)
      columns[name + "_" + key] = [of = pose, member = value](const Snapshot& s) {
        return of(s).*member;
      };
  return columns;
}

TEST_F(Export, EveryColumnOfPosesHoldsWhatItsNameSays) {
  const std::map<std::string, Value> columns = columns_of_poses();
  const std::string csv = text("poses.csv");
  std::vector<std::string_view> names = {"t_s"};
  for (const auto& [name, value] : columns) names.push_back(name);
  const std::string header = csv.substr(0, csv.find('\n'));
  EXPECT_EQ(static_cast<std::size_t>(std::count(header.begin(), header.end(), ',')) + 1,
            names.size());
  const CsvTable table = parse_csv(csv, "poses.csv", {names, {}});
  ASSERT_GT(table.rows(), 50u);
  for (std::size_t i = 0; i < table.rows(); ++i)
    for (const auto& [name, value] : columns)
      ASSERT_EQ(table[name][i], value(at(table["t_s"][i]))) << name << " in row " << i;
}

TEST_F(Export, EveryColumnOfSamplesHoldsWhatItsNameSays) {
  const CsvTable table = parse_csv(text("samples.csv"), "samples.csv",
                                   {{"t_s", "left_count", "right_count", "gyro_z_radps"}, {}});
  ASSERT_EQ(table.rows(), samples_.size());
  for (std::size_t i = 0; i < table.rows(); ++i) {
    ASSERT_NEAR(table["t_s"][i], to_s(samples_[i].measured_ns - start_ns_), 1e-9);
    ASSERT_EQ(table["left_count"][i], static_cast<double>(samples_[i].left_counts));
    ASSERT_EQ(table["right_count"][i], static_cast<double>(samples_[i].right_counts));
    ASSERT_EQ(table["gyro_z_radps"][i], samples_[i].gyro_radps[2]);
  }
}

// Each line is `time x y z qx qy qz qw`.
TEST_F(Export, EveryTrajectoryHoldsThePoseOfItsName) {
  for (const auto& [name, pose_of] : kEstimates) {
    std::istringstream lines(text((name + ".tum").c_str()));
    double t_s, x, y, z, qx, qy, qz, qw;
    int count = 0;
    for (; lines >> t_s >> x >> y >> z >> qx >> qy >> qz >> qw; ++count) {
      const Pose pose = pose_of(at(t_s));
      ASSERT_NEAR(x, pose.x_m, 1e-6) << name;
      ASSERT_NEAR(y, pose.y_m, 1e-6) << name;
      ASSERT_NEAR(z, pose.z_m, 1e-6) << name;
      ASSERT_NEAR(std::atan2(2 * (qw * qx + qy * qz), 1 - 2 * (qx * qx + qy * qy)), pose.roll_rad,
                  1e-5);
      ASSERT_NEAR(std::asin(2 * (qw * qy - qz * qx)), pose.pitch_rad, 1e-5);
      ASSERT_NEAR(std::atan2(2 * (qw * qz + qx * qy), 1 - 2 * (qy * qy + qz * qz)), pose.yaw_rad,
                  1e-5);
    }
    EXPECT_GT(count, 50) << name;
  }
}

TEST(ExportOfSeveralRuns, NamesTheDestinationThatHoldsOneRunOnly) {
  const std::map<std::string, std::string ExportOptions::*> destinations = {
      {"--out", &ExportOptions::out},
      {"--ros2", &ExportOptions::ros2},
      {"--images", &ExportOptions::images}};
  for (const auto& [name, destination] : destinations) {
    ExportOptions options{.runs = {"one.mcap", "two.mcap"}, .out = {}};
    options.*destination = "folder";
    EXPECT_THAT([&] { run_export(options); },
                testing::ThrowsMessage<SetupError>(testing::StartsWith(name + " is for one run")));
  }
}

TEST(ExportImages, WritesEachImageWithItsTime) {
  const test::TemporaryFolder folder;
  const std::vector<std::string> jpegs = {"\xff\xd8" + std::string("one\0", 4), "\xff\xd8two",
                                          "\xff\xd8three"};
  record_run(
      folder.file("run.mcap"), [](StepRecord&) { return true; }, {{"seed", "5"}}, 0, true,
      [&](record::Recorder& recorder, HostNs now) {
        const messages::Messages messages({}, {.start_ns = kNsPerS, .start_unix_ns = 0});
        for (std::size_t i = 0; i < jpegs.size(); ++i) {
          const HostNs at = now + static_cast<HostNs>(i) * 250 * kNsPerMs;
          recorder.message(messages::Channel::kCameraImage, at,
                           messages::image_text(messages, at, jpegs[i]));
        }
        // Entries of other programs are left out.
        for (const char* other :
             {"[]", "{", R"({"format":"jpeg"})", R"({"format":"png","data":"/9g="})",
              R"({"format":"jpeg","data":"!"})", R"({"format":7,"data":[]})"})
          recorder.message(messages::Channel::kCameraImage, now + kNsPerS, other);
      });
  const std::string out = folder.file("images");
  EXPECT_EQ(run_export({.runs = {folder.file("run.mcap")}, .images = out, .out = {}}), 0);
  EXPECT_EQ(test::read_bytes(out + "/times.csv"),
            "file,t_s\nimage-000001.jpg,2\nimage-000002.jpg,2.25\nimage-000003.jpg,2.5\n");
  EXPECT_FALSE(std::filesystem::exists(out + "/image-000004.jpg"));
  EXPECT_FALSE(std::filesystem::exists(folder.file("poses.csv"))) << "not asked for";
  for (std::size_t i = 0; i < jpegs.size(); ++i)
    EXPECT_EQ(test::read_bytes(out + "/image-00000" + std::to_string(i + 1) + ".jpg"), jpegs[i]);
}

TEST(ExportImages, TheMissingImagesAreNamedWithTheWayToGetThem) {
  const test::TemporaryFolder folder;
  const std::string run = folder.file("run.mcap");
  record_run(run);
  EXPECT_THAT(
      [&] { run_export({.runs = {run}, .images = folder.file("images"), .out = {}}); },
      testing::ThrowsMessage<SetupError>(
          run + ": has no images; run tp100-camera with an [image] section in its view file"));
}

}  // namespace
}  // namespace tp100::app
