// Recordings of emulated runs are replayed bit for bit, and reports of them have the runs' figures.

#include "record/recording.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <ostream>
#include <string_view>

#include "../programs/process.h"
#include "app/commands.h"
#include "report/metrics.h"
#include "report/result_text.h"
#include "report/run_result.h"
#include "sim/robot/lockstep.h"
#include "sim/robot/lockstep_recorder.h"
#include "support/paths.h"
#include "support/temporary_folder.h"
#include "text/csv_reader.h"

namespace tp100::sim {
namespace {

using record::Recording;
using testing::HasSubstr;
using Json = nlohmann::json;

/// What is driven and recorded.
struct Drive {
  std::string course;
  std::string setup = "flat";
  std::string board = "native";
  bool camera = false;
};

void PrintTo(const Drive& drive, std::ostream* out) { *out << drive.course << ' ' << drive.setup; }

struct Recorded {
  report::RunResult result;
  std::string path;
};

Recorded recorded(const Drive& drive, const test::TemporaryFolder& folder) {
  Loaded loaded =
      load({.board = drive.board, .body = {}, .robot = {}, .config = {}, .setup = drive.setup});
  loaded.files.course = course::read_bundled(course::Bundled::kCourses, drive.course);
  LockstepRecorder recorder(folder.path().string(), loaded, 1);
  LockstepSettings settings{.course = load_course(drive.course),
                            .robot = loaded.robot,
                            .configuration = loaded.configuration,
                            .setup = loaded.setup,
                            .board = loaded.board};
  recorder.record(settings);
  if (drive.camera) settings.camera = load_camera("overhead");
  Recorded done{run_lockstep(settings), recorder.path()};
  recorder.finish();
  return done;
}

class RecordedCourse : public testing::TestWithParam<Drive> {
 protected:
  test::TemporaryFolder folder_;
};

// A column that holds another value, or another unit than its name says, misleads whoever plots it.
void expect_columns(const Recording& recording, const std::string& file) {
  app::run_replay({.in = recording.path(), .out = file, .config = {}});
  const text::CsvTable table =
      text::parse_csv(test::read_bytes(file), file,
                      {{"t_s", "x_m", "y_m", "z_m", "roll_rad", "pitch_rad", "yaw_rad", "vx_mps",
                        "vy_mps", "yaw_rate_radps", "slip_left", "slip_right"},
                       {}});
  std::size_t row = 0;
  recording.visit({.step = [&](const StepRecord& record) {
    if (record.inputs.samples.empty()) return;
    const auto expect = [&](std::string_view name, double value) {
      ASSERT_EQ(table[name].at(row), value) << name << " in row " << row;
    };
    const Snapshot& s = record.snapshot;
    expect("t_s", to_s(s.sample.measured_ns - recording.start_ns()));
    visit_fields(expect, s.estimates[PoseSource::kOdometry].pose);
    visit_fields(expect, s.estimates[PoseSource::kOdometry].twist);
    expect("slip_left", s.slip_left);
    expect("slip_right", s.slip_right);
    ++row;
  }});
  EXPECT_EQ(row, table.rows());
}

TEST_P(RecordedCourse, ReplaysBitForBitAndHoldsTheTruth) {
  const Drive& drive = GetParam();
  const Recorded run = recorded(drive, folder_);
  const Recording recording(run.path);
  EXPECT_TRUE(recording.whole());
  EXPECT_EQ(recording.fact("board"), drive.board);
  EXPECT_EQ(recording.fact("setup"), drive.setup);
  const config::RunSetup files = config::parse_run(app::recorded_files(recording));
  std::size_t seen = 0;
  const app::Replayed replay =
      app::replay_steps(recording, files.parameters, files.course, true,
                        [&](const StepRecord& record) { seen += record.inputs.camera.size(); });
  EXPECT_GT(replay.steps, 1000u);
  EXPECT_FALSE(replay.differs_at) << *replay.differs_at << " " << replay.difference.field;
  EXPECT_FALSE(replay.gap_before);
  EXPECT_EQ(seen > 100, drive.camera) << "images are inputs, too";
  if (drive.camera) expect_columns(recording, folder_.file("poses.csv"));

  std::map<double, Pose> truth;
  recording.visit({.truth = [&](HostNs at, const Pose& pose) { truth[to_s(at)] = pose; }});
  if (drive.setup == "stand") {
    EXPECT_TRUE(truth.empty()) << "nothing moves there";
    return;
  }
  // The clock of the run begins with the run, so the poses are found by their values.
  ASSERT_FALSE(run.result.points.empty());
  std::size_t found = 0;
  auto known = truth.begin();
  for (const report::TrajectoryPoint& point : run.result.points) {
    while (known != truth.end() && known->second.x_m != point.truth.x_m) ++known;
    if (known != truth.end() && known->second.y_m == point.truth.y_m) ++found;
  }
  EXPECT_EQ(found, run.result.points.size());
}

std::vector<Drive> drives() {
  std::vector<Drive> all = {
      {"1-curve"}, {"1-curve", "flat", "native", true}, {"2"},
      {"3"},       {"3", "terrain", "native", true},    {"1-straight", "stand"}};
#ifdef TP100_HAS_IMAGE
  for (const char* setup : {"stand", "flat", "terrain"})
    all.push_back({"1-straight", setup, "avr", false});
#endif
  return all;
}

INSTANTIATE_TEST_SUITE_P(Courses, RecordedCourse, testing::ValuesIn(drives()),
                         [](const auto& param) {
                           std::string name =
                               param.param.course + param.param.setup + param.param.board;
                           std::erase(name, '-');
                           return "Course" + name + (param.param.camera ? "camera" : "");
                         });

// The output of `tp100-sim course --json`, the report of the run's recording, and what compares two
// runs have the same figures.
TEST(RecordedRun, TheReportHasTheFiguresOfTheRun) {
  for (const Drive& drive : {Drive{"2"}, Drive{"3", "terrain", "native", true}}) {
    SCOPED_TRACE(drive.course);
    const test::TemporaryFolder folder;
    const Recorded run = recorded(drive, folder);
    const test::Finished report = test::run({"tp100d", "report", run.path});
    ASSERT_EQ(report.status, 0) << report.output;
    const std::string beside = std::filesystem::path(run.path).parent_path().string();
    const Json metrics = Json::parse(test::read_bytes(beside + "/metrics.json"));
    const Json expected = Json::parse(
        report::result_json(run.result, report::figures(run.result, load_course(drive.course))));
    int both = 0;
    for (const auto& [name, value] : expected.items()) {
      if (!metrics.contains(name)) continue;
      ++both;
      EXPECT_EQ(metrics.at(name), value) << name;
    }
    EXPECT_GE(both, 12);
    EXPECT_EQ(metrics["truth"], true);
    EXPECT_EQ(metrics["baselines"].size(), model::kBaselines.size());
    if (drive.camera) {
      EXPECT_GT(metrics["camera"]["used"], 1000);
    }
    const std::string page = test::read_bytes(beside + "/report.html");
    for (const model::ModelForm& form : model::kBaselines)
      EXPECT_THAT(page, HasSubstr("<td>" + std::string(form.key) + "</td>"));
    EXPECT_EQ(run.result.disturbances.empty(),
              page.find("the robot is pushed") == std::string::npos);

    const std::string out = folder.file("compared");
    const test::Finished compared =
        test::run({"tp100d", "compare", run.path, run.path, "--out", out});
    ASSERT_EQ(compared.status, 0) << compared.output;
    EXPECT_THAT(test::read_bytes(out + "/compare.html"), HasSubstr(" (2): eqs_1_5</td>"));
    EXPECT_EQ(Json::parse(test::read_bytes(out + "/compare.json"))["runs"][1]["baselines"],
              expected["baselines"]);
  }
}

TEST(RecordedRun, OneSeedGivesOneFile) {
  const test::TemporaryFolder a, b;
  const std::string first = test::read_bytes(recorded({"1-straight"}, a).path);
  EXPECT_GT(first.size(), 100000u);
  EXPECT_TRUE(first == test::read_bytes(recorded({"1-straight"}, b).path));
}

}  // namespace
}  // namespace tp100::sim
