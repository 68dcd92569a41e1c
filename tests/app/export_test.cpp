// The exports of a recording: which part of it they hold, what their columns mean, to which files
// they go, and what is said about it.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <functional>
#include <map>
#include <sstream>
#include <utility>
#include <vector>

#include "../record/random_record.h"
#include "app/commands.h"
#include "messages/foxglove.h"
#include "messages/messages.h"
#include "record/recording.h"
#include "recorded_run.h"
#include "report/run_result.h"
#include "support/refusal.h"
#include "support/temporary_folder.h"
#include "text/csv_reader.h"

namespace tp100::app {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using text::CsvTable;
using text::parse_csv;

struct Said {
  std::string out, err;
};

Said exported(const ExportOptions& options) {
  testing::internal::CaptureStdout();
  testing::internal::CaptureStderr();
  EXPECT_EQ(run_export(options), 0);
  Said said{testing::internal::GetCapturedStdout(), testing::internal::GetCapturedStderr()};
  return said;
}

/// The names of the files in a folder, in order.
std::vector<std::string> files_in(const std::filesystem::path& folder) {
  std::vector<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(folder))
    names.push_back(entry.path().filename().string());
  std::sort(names.begin(), names.end());
  return names;
}

/// A recording whose values all differ.
class Export : public testing::Test {
 protected:
  /// The steps from `first` to `last` are a run. Most samples have a true pose, also before and
  /// after the run.
  void record(std::uint64_t first = 100, std::uint64_t last = 299) {
    HostNs before_ns = 0;
    const auto edit = [&](StepRecord& record) {
      record::RandomFiller fill(record.step + 1);
      Snapshot& s = record.snapshot;
      for (const PoseSource source : kPoseSources) fill("", s.estimates[source].pose);
      fill("", s.world);
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
      s.run_state = record.step < first   ? RunState::kArming
                    : record.step <= last ? RunState::kRunning
                                          : RunState::kFinished;
      if (record.step == 1 || record.step == first) from_ns_ = record.now_ns;
      if (record.step <= last) to_ns_ = record.now_ns;
      // A step may report the sample of an earlier one again.
      if (record.step % 10 == 3) s.sample.measured_ns = before_ns;
      before_ns = s.sample.measured_ns;
      if (!record.inputs.samples.empty()) steps_.emplace(before_ns, s);
      return true;
    };
    record_run(file(), edit, {{"seed", "5"}}, 0, true, [&](record::Recorder& recorder, HostNs) {
      for (const auto& [at, step] : steps_) {
        if (at % 7 == 0) continue;
        record::RandomFiller fill(static_cast<std::uint64_t>(at));
        fill("", truth_[at]);
        recorder.take_truth(at, truth_[at]);
      }
    });
    start_ns_ = record::Recording(file()).start_ns();
    std::erase_if(steps_, [&](const auto& of) { return of.first < from_ns_ || of.first > to_ns_; });
  }

  std::string file() const { return folder_.file("run.mcap"); }
  std::string text(const std::string& name) const { return test::read_bytes(folder_.file(name)); }
  std::size_t lines_in(const std::string& name) const {
    const std::string all = text(name);
    return static_cast<std::size_t>(std::count(all.begin(), all.end(), '\n'));
  }
  double seconds(HostNs at) const { return to_s(at - start_ns_); }

  test::TemporaryFolder folder_;
  std::map<HostNs, Snapshot> steps_;  // the first one of each sample of the run
  std::vector<Sample> samples_;       // of the whole recording
  std::map<HostNs, Pose> truth_;      // of the whole recording, where it is known
  HostNs start_ns_ = 0;
  HostNs from_ns_ = 0, to_ns_ = 0;  // of the run
};

using Value = std::function<double(const Snapshot&)>;
using PoseOf = std::function<Pose(const Snapshot&)>;

PoseOf estimate(PoseSource source) {
  return [source](const Snapshot& s) { return s.estimates[source].pose; };
}

const std::map<std::string, PoseOf> kEstimates = {{"model", estimate(PoseSource::kModel)},
                                                  {"odometry", estimate(PoseSource::kOdometry)},
                                                  {"fused", estimate(PoseSource::kFused)}};

const std::map<std::string, double Pose::*> kPoseValues = {{"x_m", &Pose::x_m},
                                                           {"y_m", &Pose::y_m},
                                                           {"z_m", &Pose::z_m},
                                                           {"roll_rad", &Pose::roll_rad},
                                                           {"pitch_rad", &Pose::pitch_rad},
                                                           {"yaw_rad", &Pose::yaw_rad}};

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
  for (const auto& [name, pose] : poses)
    for (const auto& [key, value] : kPoseValues)
      columns[name + "_" + key] = [of = pose, member = value](const Snapshot& s) {
        return of(s).*member;
      };
  return columns;
}

TEST_F(Export, PosesHasEachSampleOfTheRunOnceInColumnsThatHoldWhatTheirNamesSay) {
  record();
  EXPECT_EQ(exported({.runs = {file()}, .out = {}}).err, "");
  const std::map<std::string, Value> columns = columns_of_poses();
  std::vector<std::string_view> names = {"t_s"};
  for (const auto& [name, value] : columns) names.push_back(name);
  std::vector<std::string> truth;
  for (const auto& [key, value] : kPoseValues) truth.push_back("truth_" + key);
  const std::vector<std::string_view> gaps(truth.begin(), truth.end());
  names.insert(names.end(), gaps.begin(), gaps.end());
  const std::string csv = text("poses.csv"), header = csv.substr(0, csv.find('\n'));
  EXPECT_EQ(static_cast<std::size_t>(std::count(header.begin(), header.end(), ',')) + 1,
            names.size());
  const CsvTable table = parse_csv(csv, "poses.csv", {names, {}, gaps});
  ASSERT_GT(steps_.size(), 50u);
  ASSERT_EQ(table.rows(), steps_.size());
  std::size_t i = 0, missing = 0;
  for (const auto& [at, step] : steps_) {
    ASSERT_EQ(table["t_s"][i], seconds(at));
    for (const auto& [name, value] : columns) ASSERT_EQ(table[name][i], value(step)) << name;
    const auto known = truth_.find(at);
    if (known == truth_.end()) ++missing;
    for (const auto& [key, value] : kPoseValues) {
      const double is = table["truth_" + key][i];
      ASSERT_TRUE(known == truth_.end() ? std::isnan(is) : is == known->second.*value) << key;
    }
    ++i;
  }
  EXPECT_GT(missing, 5u);
}

TEST_F(Export, EveryColumnOfSamplesHoldsWhatItsNameSays) {
  record();
  exported({.runs = {file()}, .out = {}});
  const CsvTable table = parse_csv(text("samples.csv"), "samples.csv",
                                   {{"t_s", "left_count", "right_count", "gyro_z_radps"}, {}});
  ASSERT_EQ(table.rows(), samples_.size());
  for (std::size_t i = 0; i < table.rows(); ++i) {
    ASSERT_NEAR(table["t_s"][i], seconds(samples_[i].measured_ns), 1e-9);
    ASSERT_EQ(table["left_count"][i], static_cast<double>(samples_[i].left_counts));
    ASSERT_EQ(table["right_count"][i], static_cast<double>(samples_[i].right_counts));
    ASSERT_EQ(table["gyro_z_radps"][i], samples_[i].gyro_radps[2]);
  }
}

// Each line is `time x y z qx qy qz qw`.
TEST_F(Export, EveryTrajectoryHoldsThePosesOfItsNameDuringTheRun) {
  record();
  exported({.runs = {file()}, .out = {}});
  for (const auto& [name, pose_of] : kEstimates) {
    std::istringstream lines(text(name + ".tum"));
    for (const auto& [at, step] : steps_) {
      double t_s, x, y, z, qx, qy, qz, qw;
      ASSERT_TRUE(lines >> t_s >> x >> y >> z >> qx >> qy >> qz >> qw) << name;
      const Pose pose = pose_of(step);
      ASSERT_NEAR(t_s, seconds(at), 1e-6);
      ASSERT_NEAR(x, pose.x_m, 1e-6) << name;
      ASSERT_NEAR(y, pose.y_m, 1e-6) << name;
      ASSERT_NEAR(z, pose.z_m, 1e-6) << name;
      ASSERT_NEAR(std::atan2(2 * (qw * qx + qy * qz), 1 - 2 * (qx * qx + qy * qy)), pose.roll_rad,
                  1e-5);
      ASSERT_NEAR(std::asin(2 * (qw * qy - qz * qx)), pose.pitch_rad, 1e-5);
      ASSERT_NEAR(std::atan2(2 * (qw * qz + qx * qy), 1 - 2 * (qy * qy + qz * qz)), pose.yaw_rad,
                  1e-5);
    }
    EXPECT_EQ(lines_in(name + ".tum"), steps_.size());
  }
  std::string truth;
  for (const auto& [at, pose] : truth_)
    if (at >= from_ns_ && at <= to_ns_) truth += report::tum_line(seconds(at), pose);
  EXPECT_EQ(text("truth.tum"), truth);
}

TEST_F(Export, OfARunThatNeverBeganOrIsCutOffIsAllThatThereIsAndThisIsSaid) {
  record(1000, 1000);
  const std::string never = ": the run never began; exported the whole recording\n";
  EXPECT_EQ(exported({.runs = {file()}, .csv = true, .out = {}}).err, "tp100d: " + file() + never);
  EXPECT_EQ(lines_in("poses.csv"), steps_.size() + 1);
  const std::string bytes = test::read_bytes(file());
  test::write_bytes(file(), bytes.substr(0, bytes.size() - 200));
  EXPECT_THAT(exported({.runs = {file()}, .tum = true, .out = {}}).err,
              HasSubstr(": the recording is cut off; exported everything before that\n"));
  EXPECT_EQ(lines_in("model.tum"), steps_.size());
}

TEST_F(Export, WritesTheFilesThatWereAskedForAndNamesThem) {
  record();
  const std::vector<std::string> csv = {"samples.csv", "poses.csv"};
  const std::vector<std::string> tum = {"model.tum", "odometry.tum", "fused.tum", "truth.tum"};
  std::vector<std::string> all = csv;
  all.insert(all.end(), tum.begin(), tum.end());
  const auto expect_written = [&](ExportOptions options, std::vector<std::string> names) {
    options.runs = {file()};
    std::string named;
    const std::string folder = options.out.empty() ? folder_.path().string() : options.out;
    for (const std::string& name : names) named += folder + "/" + name + "\n";
    EXPECT_EQ(exported(options).out, named);
    if (options.out.empty()) names.insert(names.end(), {"run.mcap", "csv", "tum", "all"});
    EXPECT_THAT(files_in(folder), testing::UnorderedElementsAreArray(names));
  };
  expect_written({.runs = {}, .csv = true, .out = folder_.file("csv")}, csv);
  expect_written({.runs = {}, .tum = true, .out = folder_.file("tum")}, tum);
  expect_written({.runs = {}, .out = folder_.file("all")}, all);
  expect_written({.runs = {}, .out = {}}, all);
}

// But for one that is named, which holds one run only.
TEST_F(Export, EachOfSeveralRunsIsExportedBesideItself) {
  record();
  for (const char* name : {"one", "two"}) {
    std::filesystem::create_directory(folder_.path() / name);
    std::filesystem::copy_file(file(), folder_.path() / name / "run.mcap");
  }
  exported({.runs = {folder_.file("one"), folder_.file("two")}, .csv = true, .out = {}});
  for (const char* name : {"one", "two"})
    EXPECT_THAT(files_in(folder_.path() / name),
                ElementsAre("poses.csv", "run.mcap", "samples.csv"));
  const std::pair<std::string, std::string ExportOptions::*> destinations[] = {
      {"--out", &ExportOptions::out},
      {"--ros2", &ExportOptions::ros2},
      {"--images", &ExportOptions::images}};
  for (const auto& [option, destination] : destinations) {
    ExportOptions options{.runs = {folder_.file("one"), folder_.file("two")}, .out = {}};
    options.*destination = "folder";
    EXPECT_THAT(test::refusal([&] { run_export(options); }), HasSubstr(option + " is for one run"));
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
      testing::ThrowsMessage<UserError>(
          run + ": has no images; run tp100-camera with an [image] section in its view file"));
}

}  // namespace
}  // namespace tp100::app
