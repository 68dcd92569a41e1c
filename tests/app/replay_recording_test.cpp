#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "../record/random_record.h"
#include "app/commands.h"
#include "core/processor.h"
#include "recorded_run.h"
#include "support/temporary_folder.h"

namespace tp100::app {
namespace {

using testing::HasSubstr;

class ReplayRecording : public testing::Test {
 protected:
  std::string file() const { return folder_.file("run.mcap"); }
  std::string poses() const { return folder_.file("poses.csv"); }
  ReplayOptions options() const { return {.in = file(), .out = poses(), .config = {}}; }
  Replayed replayed(bool verify = true) const {
    const record::Recording recording(file());
    const config::RunSetup run = config::parse_run(recorded_files(recording));
    return replay_steps(recording, run.parameters, run.course, verify, [](const StepRecord&) {});
  }
  test::TemporaryFolder folder_;
};

TEST_F(ReplayRecording, WhatBeganLaterIsReplayedFromTheStart) {
  record_run(
      file(), [](StepRecord&) { return true; }, {}, 250);
  const Replayed result = replayed();
  EXPECT_EQ(result.steps, 400u);
  EXPECT_EQ(result.before, 250u);
  EXPECT_FALSE(result.differs_at.has_value()) << result.difference.field;
  EXPECT_FALSE(result.gap_before.has_value());
  ASSERT_EQ(run_replay(options()), 0);
  const std::string text = test::read_bytes(poses());
  EXPECT_EQ(static_cast<std::uint64_t>(std::count(text.begin(), text.end(), '\n')),
            1 + result.steps - result.before);
}

TEST_F(ReplayRecording, AParameterThatChangedOnTheWayIsAnInputLikeAnyOther) {
  record_run(file(), [](StepRecord& record) {
    record.inputs.changes.clear();
    return true;
  });
  EXPECT_TRUE(replayed().differs_at.has_value())
      << "the replay matches although the parameter change is missing";
}

TEST_F(ReplayRecording, WritesAPoseForEachStepThatGotASample) {
  record_run(file());
  ASSERT_EQ(run_replay(options()), 0);
  const std::string text = test::read_bytes(poses());
  EXPECT_GT(std::count(text.begin(), text.end(), '\n'), 300);
  // The folder of a run is accepted in place of its recording.
  ReplayOptions folder = options();
  folder.in = folder_.path().string();
  EXPECT_EQ(run_replay(folder), 0);
  EXPECT_EQ(test::read_bytes(poses()), text);
}

TEST_F(ReplayRecording, OneWrongBitOfOnePoseIsFoundAndNothingIsWritten) {
  record_run(file(), [](StepRecord& record) {
    if (record.step == 250)
      record.snapshot.estimates[PoseSource::kOdometry].pose.y_m =
          std::nextafter(record.snapshot.estimates[PoseSource::kOdometry].pose.y_m, 1.0);
    return true;
  });
  const Replayed result = replayed();
  EXPECT_EQ(result.differs_at, 250u);
  EXPECT_EQ(result.difference.field, "snapshot.odometry.y_m");
  testing::internal::CaptureStderr();
  EXPECT_EQ(run_replay(options()), 1);
  EXPECT_THAT(testing::internal::GetCapturedStderr(),
              HasSubstr("step 250 after 1.250 s: snapshot.odometry.y_m is 0, recorded "));
  EXPECT_FALSE(std::filesystem::exists(poses()));
}

// Results that another kind of processor, which the recording names, may have rounded differently.
class ReplayElsewhere : public ReplayRecording {
 protected:
  void record(const std::function<void(Snapshot&)>& edit) const {
    record_run(file(),
               [&](StepRecord& record) {
                 if (record.step == 250 || record.step == 300) edit(record.snapshot);
                 return true;
               },
               {{config::kArithmeticFact, "pdp11, glibc 2.36 without FMA"}});
  }
  /// Replays; returns what it printed on both streams.
  std::string replay(int status) const {
    testing::internal::CaptureStdout();
    testing::internal::CaptureStderr();
    EXPECT_EQ(run_replay(options()), status);
    const std::string output = testing::internal::GetCapturedStdout();
    return output + testing::internal::GetCapturedStderr();
  }
  const std::string processors_ =
      "recorded on pdp11, glibc 2.36 without FMA, replayed on " + arithmetic();
};

TEST_F(ReplayElsewhere, SaysTheLargestDifferenceOfLastBits) {
  record([](Snapshot& snapshot) {
    snapshot.estimates[PoseSource::kOdometry].pose.y_m += 0x1p-50;
    snapshot.command.desired_yaw_rad += 0x1p-51;
  });
  EXPECT_THAT(replay(0), HasSubstr("400 steps replayed, the largest difference is 8.9e-16 m, "
                                   "4.4e-16 rad and 0 in other results (" +
                                   processors_ + ")"));
  EXPECT_TRUE(std::filesystem::exists(poses()));
}

TEST_F(ReplayElsewhere, MoreThanRoundingOrAnotherDecisionIsADifference) {
  record([](Snapshot& snapshot) { snapshot.recovering = !snapshot.recovering; });
  EXPECT_THAT(replay(1), HasSubstr("a decision or a count differs; " + processors_));
  record([](Snapshot& snapshot) { snapshot.estimates[PoseSource::kOdometry].pose.y_m += 1e-8; });
  const std::string output = replay(1);
  EXPECT_THAT(output,
              HasSubstr("step 250 after 1.250 s: snapshot.odometry.y_m is 0, recorded 1e-08"));
  EXPECT_THAT(output, HasSubstr("more than rounding: the largest difference is 1e-08 m, 0 rad"));
  EXPECT_THAT(output, HasSubstr(processors_));
  EXPECT_FALSE(std::filesystem::exists(poses()));
}

TEST_F(ReplayRecording, AMissingStepEndsTheReplay) {
  record_run(file(), [](StepRecord& record) { return record.step < 200 || record.step > 209; });
  const Replayed result = replayed();
  EXPECT_EQ(result.steps, 199u);
  EXPECT_EQ(result.gap_before, 210u);
  testing::internal::CaptureStderr();
  EXPECT_EQ(run_replay(options()), 1);
  EXPECT_THAT(testing::internal::GetCapturedStderr(), HasSubstr("steps 200 to 209 are missing"));
}

TEST_F(ReplayRecording, OtherParametersAreReplayedAndNotJudged) {
  record_run(file());
  test::write_bytes(folder_.file("tp100.toml"), "[control]\npreview_s = 0.2\n");
  ReplayOptions other = options();
  other.config = folder_.file("tp100.toml");
  testing::internal::CaptureStdout();
  EXPECT_EQ(run_replay(other), 0);
  EXPECT_THAT(testing::internal::GetCapturedStdout(), HasSubstr("other parameters"));
}

// The address and undefined-behaviour sanitizers detect any harm that these inputs do.
TEST_F(ReplayRecording, InputsThatNoRobotSentDoNoHarm) {
  record_run(file(), [](StepRecord& record) {
    const std::uint64_t step = record.step;
    const HostNs now = record.now_ns;
    // The robot's own inputs come in between, so that the run makes progress.
    if (step % 50 < 25) return true;
    record = *record::random_record(step);
    record.step = step;
    record.now_ns = step % 3 == 0 ? record.inputs.clock.reference_host_ns : now;
    return true;
  });
  const Replayed result = replayed(false);
  EXPECT_EQ(result.steps, 400u);
  test::write_bytes(folder_.file("tp100.toml"), "[model]\nmode = \"paper\"\n");
  ReplayOptions other = options();
  other.config = folder_.file("tp100.toml");
  testing::internal::CaptureStdout();
  EXPECT_EQ(run_replay(other), 0);
  testing::internal::GetCapturedStdout();
}

}  // namespace
}  // namespace tp100::app
