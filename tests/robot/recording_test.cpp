// Recordings of emulated runs are replayed bit for bit.

#include "record/recording.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>

#include "../programs/process.h"
#include "app/replay.h"
#include "identify/drive_file.h"
#include "report/metrics.h"
#include "report/result_text.h"
#include "report/run_result.h"
#include "sim/robot/lockstep.h"
#include "sim/robot/lockstep_recorder.h"
#include "support/paths.h"
#include "support/temporary_folder.h"

namespace tp100::sim {
namespace {

using record::Recording;
using testing::HasSubstr;
using Json = nlohmann::json;

app::Replayed replayed(const Recording& recording) {
  const config::RunSetup run = config::parse_run(app::recorded_files(recording));
  return app::replay_steps(recording, run.parameters, run.course, true, [](const StepRecord&) {});
}

struct Recorded {
  report::RunResult result;
  std::string path;
};

Recorded drive(const std::string& course, const std::string& folder, bool camera = false,
               const Options& options = {}) {
  Loaded loaded = load(options);
  loaded.files.course = course::read_bundled(course::Bundled::kCourses, course);
  LockstepRecorder recorder(folder, loaded, 1);
  LockstepSettings settings{.course = load_course(course),
                            .robot = loaded.robot,
                            .configuration = loaded.configuration,
                            .setup = loaded.setup,
                            .board = loaded.board,
                            .sink = &recorder};
  if (camera) settings.camera = load_camera("overhead");
  Recorded recorded{run_lockstep(settings), recorder.path()};
  recorder.finish();
  return recorded;
}

/// The output of `tp100-sim course --json`.
Json figures_of_the_run(const Recorded& run) {
  return Json::parse(
      report::result_json(run.result, report::figures(run.result, load_course(run.result.course))));
}

void expect_equal_where_both_are(const Json& metrics, const Json& expected) {
  int both = 0;
  for (const auto& [name, value] : expected.items()) {
    if (!metrics.contains(name)) continue;
    ++both;
    EXPECT_EQ(metrics.at(name), value) << name;
  }
  EXPECT_GE(both, 13);
}

class RecordedCourse : public testing::TestWithParam<const char*> {
 protected:
  test::TemporaryFolder folder_;
};

TEST_P(RecordedCourse, ReplaysBitForBitAndHoldsTheTruth) {
  const Recorded run = drive(GetParam(), folder_.path().string());
  const Recording recording(run.path);
  EXPECT_TRUE(recording.whole());
  const app::Replayed replay = replayed(recording);
  EXPECT_GT(replay.steps, 1000u);
  EXPECT_FALSE(replay.differs_at) << *replay.differs_at << " " << replay.difference.field;
  EXPECT_FALSE(replay.gap_before);

  std::map<double, Pose> truth;
  recording.visit({.truth = [&](HostNs at, const Pose& pose) { truth[to_s(at)] = pose; }});
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

TEST_P(RecordedCourse, TheReportHasTheFiguresOfTheRun) {
  const Recorded run = drive(GetParam(), folder_.path().string());
  const test::Finished report = test::run({"tp100d", "report", run.path});
  ASSERT_EQ(report.status, 0) << report.output;
  const std::string folder = std::filesystem::path(run.path).parent_path().string();
  const Json metrics = Json::parse(test::read_bytes(folder + "/metrics.json"));
  const Json expected = figures_of_the_run(run);
  expect_equal_where_both_are(metrics, expected);
  EXPECT_EQ(metrics["truth"], true);
  EXPECT_EQ(metrics["baselines"].size(), model::kBaselines.size());
  const std::string page = test::read_bytes(folder + "/report.html");
  EXPECT_THAT(page, HasSubstr("tp100Replay(document"));
  for (const PoseSource source : {PoseSource::kModel, PoseSource::kOdometry})
    EXPECT_TRUE(metrics[to_string(source)].contains("within_2_sd")) << to_string(source);
  EXPECT_THAT(page, HasSubstr("<dt>true pose within 2 sd of "));
  for (const model::ModelForm& form : model::kBaselines)
    EXPECT_THAT(page, HasSubstr("<td>" + std::string(form.key) + "</td>"));
  const std::string out = folder_.file("compared");
  const test::Finished compared =
      test::run({"tp100d", "compare", run.path, run.path, "--out", out});
  ASSERT_EQ(compared.status, 0) << compared.output;
  EXPECT_THAT(test::read_bytes(out + "/compare.html"), HasSubstr(" (2): eqs_1_5</td>"));
  EXPECT_EQ(Json::parse(test::read_bytes(out + "/compare.json"))["runs"][1]["baselines"],
            expected["baselines"]);
  EXPECT_EQ(run.result.disturbances.empty(), page.find("the robot is pushed") == std::string::npos);
}

// Small steps of the equations, from the recording's samples and without any code under test.
TEST_P(RecordedCourse, SimplerFormsAreDeadReckoningOnItsSamples) {
  const Recorded run = drive(GetParam(), folder_.path().string());
  const identify::RecordedDrive samples = identify::recorded_drive(Recording(run.path));
  const course::Robot robot = load({}).robot;
  const model::TrackParameters& fitted = *robot.baselines[model::kEqsFitted];
  const std::vector<report::TrajectoryPoint>& points = run.result.points;
  const double begin_s = static_cast<double>(points.front().measured.device_us) * 1e-6;
  const double end_s = static_cast<double>(points.back().measured.device_us) * 1e-6;
  Pose pose = points.front().estimates[PoseSource::kModel];
  for (std::size_t i = 1; i < samples.samples.size(); ++i) {
    const identify::DriveSample &a = samples.samples[i - 1], &b = samples.samples[i];
    if (a.t_s < begin_s - 1e-9 || b.t_s > end_s + 1e-9) continue;
    const double per_metre = robot.drive.counts_per_metre, dt_s = b.t_s - a.t_s;
    const double left_m =
        static_cast<double>(b.left_counts - a.left_counts) / per_metre * (1 - fitted.slip_left);
    const double right_m =
        static_cast<double>(b.right_counts - a.right_counts) / per_metre * (1 - fitted.slip_right);
    const double turn = (right_m - left_m) / fitted.wheelbase_m;
    const double beta = std::abs(turn / dt_s) > 0.05 ? fitted.slip_angle_turning_rad
                                                     : fitted.slip_angle_straight_rad;
    const double x_m = (left_m + right_m) / 2, y_m = x_m * std::tan(beta);
    const double middle = pose.yaw_rad + turn / 2;
    pose.x_m += x_m * std::cos(middle) - y_m * std::sin(middle);
    pose.y_m += x_m * std::sin(middle) + y_m * std::cos(middle);
    pose.yaw_rad += turn;
  }
  const std::vector<Pose> poses =
      report::baseline_poses(run.result, model::kBaselines[model::kEqsFitted], fitted);
  EXPECT_NEAR(poses.back().x_m, pose.x_m, 1e-4);
  EXPECT_NEAR(poses.back().y_m, pose.y_m, 1e-4);
  EXPECT_NEAR(poses.back().yaw_rad, pose.yaw_rad, 1e-6);
  if (run.result.disturbances.empty()) {
    const Pose& truth = points.back().truth;
    EXPECT_NEAR(report::figures(run.result, load_course(GetParam()))
                    .baselines[model::kEqsFitted]
                    ->final_position_error_m,
                std::hypot(pose.x_m - truth.x_m, pose.y_m - truth.y_m), 1e-4);
  }
}

TEST_P(RecordedCourse, IsExportedFromTheFirstToTheLastStepOfItsRun) {
  const Recorded run = drive(GetParam(), folder_.path().string());
  const std::string out = folder_.file("out");
  const test::Finished exported = test::run({"tp100d", "export", run.path, "--out", out});
  ASSERT_EQ(exported.status, 0) << exported.output;
  std::string expected;
  for (const char* name :
       {"samples.csv", "poses.csv", "model.tum", "odometry.tum", "fused.tum", "truth.tum"})
    expected += out + "/" + name + "\n";
  EXPECT_EQ(exported.output, expected);

  const Recording recording(run.path);
  HostNs from = 0, to = 0, last = 0;
  recording.visit({.step = [&](const StepRecord& record) {
    if (record.snapshot.run_state != RunState::kRunning) return;
    if (from == 0) from = record.now_ns;
    to = record.now_ns;
  }});
  std::size_t rows = 0;
  std::string model, odometry, fused, truth;
  recording.visit(
      {.step =
           [&](const StepRecord& record) {
             const HostNs at = record.snapshot.sample.measured_ns;
             if (record.inputs.samples.empty() || at < from || at > to || at <= last) return;
             last = at;
             ++rows;
             const double t_s = to_s(at - recording.start_ns());
             model += report::tum_line(t_s, record.snapshot.estimates[PoseSource::kModel].pose);
             odometry +=
                 report::tum_line(t_s, record.snapshot.estimates[PoseSource::kOdometry].pose);
             fused += report::tum_line(t_s, record.snapshot.estimates[PoseSource::kFused].pose);
           },
       .truth =
           [&](HostNs at, const Pose& pose) {
             if (at >= from && at <= to)
               truth += report::tum_line(to_s(at - recording.start_ns()), pose);
           }});
  ASSERT_GT(rows, 1000u);
  EXPECT_EQ(test::read_bytes(out + "/model.tum"), model);
  EXPECT_EQ(test::read_bytes(out + "/odometry.tum"), odometry);
  EXPECT_EQ(test::read_bytes(out + "/fused.tum"), fused);
  EXPECT_EQ(test::read_bytes(out + "/truth.tum"), truth);
  EXPECT_EQ(test::lines(test::read_bytes(out + "/poses.csv")), rows + 1);

  const test::Finished two = test::run({"tp100d", "export", run.path, run.path, "--out", out});
  EXPECT_EQ(two.status, 2);
  EXPECT_THAT(two.output, HasSubstr("--out is for one run"));
}

INSTANTIATE_TEST_SUITE_P(Courses, RecordedCourse, testing::Values("1-curve", "2", "3"),
                         [](const auto& param) {
                           std::string name = param.param;
                           std::erase(name, '-');
                           return "Course" + name;
                         });

#ifdef TP100_HAS_IMAGE
constexpr const char* kBoards[] = {"native", "avr"};
#else
constexpr const char* kBoards[] = {"native"};
#endif

TEST(RecordedRun, EveryBoardReplaysBitForBitInEverySetup) {
  for (const char* board : kBoards) {
    for (const char* setup : {"stand", "flat", "terrain"}) {
      const test::TemporaryFolder folder;
      const Recording recording(
          drive("1-straight", folder.path().string(), false,
                {.board = board, .body = {}, .robot = {}, .config = {}, .setup = setup})
              .path);
      EXPECT_EQ(recording.fact("board"), board);
      EXPECT_EQ(recording.fact("setup"), setup);
      const app::Replayed replay = replayed(recording);
      EXPECT_GT(replay.steps, 1000u) << board << " " << setup;
      EXPECT_FALSE(replay.differs_at) << board << " " << setup << " " << replay.difference.field;
      EXPECT_FALSE(replay.gap_before) << board << " " << setup;
    }
  }
}

TEST(RecordedRun, ARampAndAStepUnderTheTracksReplayToo) {
  const test::TemporaryFolder folder;
  const Recording recording(drive("3", folder.path().string(), false,
                                  {.body = {}, .robot = {}, .config = {}, .setup = "terrain"})
                                .path);
  EXPECT_FALSE(replayed(recording).differs_at);
}

// The floor has the obstacles, so the IMU sees slopes; the filter uses a camera.
TEST(RecordedRun, TheReportHasSlopesObstaclesAndCameraOfTheRun) {
  const test::TemporaryFolder folder;
  const Recorded run = drive("3", folder.path().string(), true,
                             {.body = {}, .robot = {}, .config = {}, .setup = "terrain"});
  const test::Finished report = test::run({"tp100d", "report", run.path});
  ASSERT_EQ(report.status, 0) << report.output;
  const std::string folder_of_run = std::filesystem::path(run.path).parent_path().string();
  const Json metrics = Json::parse(test::read_bytes(folder_of_run + "/metrics.json"));
  expect_equal_where_both_are(metrics, figures_of_the_run(run));
  EXPECT_EQ(metrics["slope"]["obstacles"], 2);
  EXPECT_TRUE(metrics["slope"]["changes"].at(0)["found_s"].is_number());
  EXPECT_GT(metrics["camera"]["used"], 1000);
}

TEST(RecordedRun, ACameraIsAnInputToo) {
  const test::TemporaryFolder folder;
  const Recorded run = drive("1-curve", folder.path().string(), true);
  const Recording recording(run.path);
  std::uint64_t seen = 0;
  recording.visit({.step = [&](const StepRecord& record) { seen += record.inputs.camera.size(); }});
  EXPECT_GT(seen, 100u);
  EXPECT_FALSE(replayed(recording).differs_at);
}

TEST(RecordedRun, OneSeedGivesOneFile) {
  const test::TemporaryFolder a, b;
  const std::string first = test::read_bytes(drive("1-straight", a.path().string()).path);
  EXPECT_GT(first.size(), 100000u);
  EXPECT_TRUE(first == test::read_bytes(drive("1-straight", b.path().string()).path));
}

}  // namespace
}  // namespace tp100::sim
