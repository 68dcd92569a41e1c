// Which part of a recording is exported, to which files, and what is said about it.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <vector>

#include "app/commands.h"
#include "core/error.h"
#include "record/recording.h"
#include "recorded_run.h"
#include "report/run_result.h"
#include "support/temporary_folder.h"
#include "text/format.h"

namespace tp100::app {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

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

std::vector<std::string> lines_of(const std::string& path) {
  std::istringstream text(test::read_bytes(path));
  std::vector<std::string> lines;
  for (std::string line; std::getline(text, line);) lines.push_back(line);
  return lines;
}

/// The names of the files in a folder, in order.
std::vector<std::string> files_in(const std::filesystem::path& folder) {
  std::vector<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(folder))
    names.push_back(entry.path().filename().string());
  std::sort(names.begin(), names.end());
  return names;
}

class ExportWindow : public testing::Test {
 protected:
  /// A recording of which the steps from `first` to `last` are a run, with a true pose for nearly
  /// every sample and for times before and after the run.
  void record(std::uint64_t first, std::uint64_t last) {
    record_run(
        file(),
        [&](StepRecord& record) {
          record.snapshot.run_state = record.step < first   ? RunState::kArming
                                      : record.step <= last ? RunState::kRunning
                                                            : RunState::kFinished;
          if (first_ns_ == 0) first_ns_ = record.now_ns;
          last_ns_ = record.now_ns;
          if (record.step >= first && record.step <= last) {
            if (from_ns_ == 0) from_ns_ = record.now_ns;
            to_ns_ = record.now_ns;
          }
          // A step may report the sample of an earlier one again.
          if (record.step % 10 == 3) record.snapshot.sample.measured_ns = before_ns_;
          before_ns_ = record.snapshot.sample.measured_ns;
          if (!record.inputs.samples.empty()) samples_.push_back(before_ns_);
          return true;
        },
        {{"seed", "5"}}, 0, true,
        [&](record::Recorder& recorder, HostNs) {
          double x_m = 0.5;
          for (const HostNs at : samples_) {
            x_m += 0.25;
            if (at == 0 || truth_.contains(at)) continue;
            truth_[at] = {.x_m = x_m, .y_m = -2.0, .z_m = 0.125, .yaw_rad = 0.0};
            if (truth_.size() % 7 == 0) continue;
            recorder.take_truth(at, truth_[at]);
          }
        });
    int count = 0;
    std::erase_if(truth_, [&](const auto&) { return ++count % 7 == 0; });
  }
  /// The times of the exported samples.
  std::vector<HostNs> times() const {
    std::vector<HostNs> times;
    for (const HostNs at : samples_)
      if (at >= from_ns_ && at <= to_ns_ && (times.empty() || at > times.back()))
        times.push_back(at);
    return times;
  }
  std::string file() const { return folder_.file("run.mcap"); }
  double seconds(HostNs at) const { return to_s(at - record::Recording(file()).start_ns()); }

  test::TemporaryFolder folder_;
  std::vector<HostNs> samples_;
  std::map<HostNs, Pose> truth_;
  HostNs first_ns_ = 0, last_ns_ = 0;  // of all steps
  HostNs from_ns_ = 0, to_ns_ = 0;     // of the run
  HostNs before_ns_ = 0;
};

TEST_F(ExportWindow, HoldsTheStepsOfTheRunEachSampleOnceAndTheTruthWhereItIsKnown) {
  record(100, 299);
  const Said said = exported({.runs = {file()}, .out = {}});
  EXPECT_EQ(said.err, "");
  const std::vector<HostNs> times = this->times();
  ASSERT_GT(times.size(), 50u);
  ASSERT_LT(times.size() + 50, truth_.size());
  const std::vector<std::string> rows = lines_of(folder_.file("poses.csv"));
  const std::vector<std::string> model = lines_of(folder_.file("model.tum"));
  ASSERT_EQ(rows.size(), times.size() + 1);
  ASSERT_EQ(model.size(), times.size());
  EXPECT_THAT(rows[0], testing::StartsWith("t_s,model_x_m,"));
  EXPECT_THAT(rows[0], HasSubstr(",world_yaw_rad,truth_x_m,truth_y_m,truth_z_m,truth_roll_rad,"
                                 "truth_pitch_rad,truth_yaw_rad,left_mps,"));
  std::vector<std::string> truth;
  std::size_t missing = 0;
  for (std::size_t i = 0; i < times.size(); ++i) {
    const double t_s = seconds(times[i]);
    EXPECT_THAT(rows[i + 1], testing::StartsWith(text::shortest(t_s) + ","));
    EXPECT_THAT(model[i], testing::StartsWith(text::format("%.6f ", t_s)));
    std::vector<std::string> cells;
    std::istringstream row(rows[i + 1]);
    for (std::string cell; std::getline(row, cell, ',');) cells.push_back(cell);
    ASSERT_EQ(cells.size(), 40u);
    const std::vector<std::string> of_truth(cells.begin() + 25, cells.begin() + 31);
    const auto known = truth_.find(times[i]);
    if (known == truth_.end()) {
      ++missing;
      EXPECT_THAT(of_truth, testing::Each(""));
    } else {
      EXPECT_THAT(of_truth,
                  ElementsAre(text::shortest(known->second.x_m), "-2", "0.125", "0", "0", "0"));
    }
  }
  EXPECT_GT(missing, 5u);
  for (const auto& [at, pose] : truth_)
    if (at >= from_ns_ && at <= to_ns_) truth.push_back(report::tum_line(seconds(at), pose));
  std::string expected;
  for (const std::string& line : truth) expected += line;
  EXPECT_EQ(test::read_bytes(folder_.file("truth.tum")), expected);
}

TEST_F(ExportWindow, OfARunThatNeverBeganIsTheWholeRecordingAndThisIsSaid) {
  record(1000, 1000);
  const Said said = exported({.runs = {file()}, .csv = true, .out = {}});
  EXPECT_EQ(said.err,
            "tp100d: " + file() + ": the run never began; exported the whole recording\n");
  from_ns_ = first_ns_;
  to_ns_ = last_ns_;
  EXPECT_EQ(lines_of(folder_.file("poses.csv")).size(), times().size() + 1);
}

TEST_F(ExportWindow, OfARecordingThatIsCutOffIsWhatItHasAndThisIsSaid) {
  record(100, 299);
  const std::string bytes = test::read_bytes(file());
  test::write_bytes(file(), bytes.substr(0, bytes.size() - 200));
  const Said said = exported({.runs = {file()}, .tum = true, .out = {}});
  EXPECT_EQ(said.err,
            "tp100d: " + file() + ": the recording is cut off; exported everything before that\n");
  EXPECT_EQ(lines_of(folder_.file("model.tum")).size(), times().size());
}

TEST_F(ExportWindow, WritesTheFilesThatWereAskedForAndNamesThem) {
  record(100, 299);
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

TEST_F(ExportWindow, ABagAloneIsNamedFileByFile) {
  record(100, 299);
  const std::string bag = folder_.file("bag");
  const Said said = exported({.runs = {file()}, .ros2 = bag, .out = {}});
  std::size_t listed = 0;
  for (const std::string& name : files_in(bag)) {
    EXPECT_THAT(said.out, HasSubstr(bag + "/" + name + "\n"));
    listed += bag.size() + name.size() + 2;
  }
  EXPECT_EQ(said.out.size(), listed);
  EXPECT_THAT(files_in(folder_.path()), ElementsAre("bag", "run.mcap"));
}

TEST_F(ExportWindow, EachOfSeveralRunsIsExportedBesideItself) {
  record(100, 299);
  for (const char* name : {"one", "two"}) {
    std::filesystem::create_directory(folder_.path() / name);
    std::filesystem::copy_file(file(), folder_.path() / name / "run.mcap");
  }
  exported({.runs = {folder_.file("one"), folder_.file("two")}, .csv = true, .out = {}});
  for (const char* name : {"one", "two"})
    EXPECT_THAT(files_in(folder_.path() / name),
                ElementsAre("poses.csv", "run.mcap", "samples.csv"));
}

}  // namespace
}  // namespace tp100::app
