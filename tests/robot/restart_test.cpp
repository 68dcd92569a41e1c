// A step that restarts at standstill continues as before, and a replay that begins there gives the
// same results bit for bit.

#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <random>
#include <vector>

#include "bridge/step.h"
#include "config/run_setup.h"
#include "record/step_codec.h"
#include "record/step_difference.h"
#include "sim/robot/lockstep.h"
#include "sim/robot/options.h"

namespace tp100::sim {
namespace {

struct Scenario {
  const char* course;
  bridge::Setup setup;
  bool camera;
  bool changes;  ///< with random changes of live parameters
};

/// The inputs of two runs of a course with more than a minute of standstill before each.
class InputKeeper : public messages::Sink {
 public:
  void take(const StepRecord& record) override { record::encode_inputs(record, inputs); }
  Bytes inputs;
};

class Restart : public testing::TestWithParam<Scenario> {
 protected:
  Restart() {
    const Scenario& scenario = GetParam();
    Loaded loaded = load({});
    loaded.files.course = course::read_bundled(course::Bundled::kCourses, scenario.course);
    loaded.files.setup = scenario.setup;
    run_ = config::parse_run(loaded.files);
    LockstepSettings settings{.course = *run_.course,
                              .robot = loaded.robot,
                              .configuration = loaded.configuration,
                              .setup = scenario.setup,
                              .sinks = {&keeper_}};
    if (scenario.camera) settings.camera = load_camera("overhead");
    const TwoRuns runs = run_lockstep_twice(settings, 120.0);
    EXPECT_TRUE(runs.first.completed);
  }

  /// Calls `each` with the recorded steps, oldest first.
  template <class Each>
  void for_each_step(Each each) {
    const auto record = std::make_unique<StepRecord>();
    for (std::span<const std::uint8_t> block = keeper_.inputs; !block.empty();) {
      ASSERT_FALSE(record::decode_inputs(block, *record));
      each(*record);
    }
  }
  bridge::Step new_step() const { return {run_.parameters, run_.course}; }

  config::RunSetup run_;
  InputKeeper keeper_;
};

void set_results(const bridge::Outputs& out, StepRecord& record) {
  record.command_valid = out.command_valid;
  record.request = out.request;
  record.snapshot = out.snapshot;
}

void expect_near(const Pose& is, const Pose& was) {
  EXPECT_NEAR(is.x_m, was.x_m, 1e-3);
  EXPECT_NEAR(is.y_m, was.y_m, 1e-3);
  EXPECT_NEAR(is.z_m, was.z_m, 1e-3);
  EXPECT_NEAR(is.yaw_rad, was.yaw_rad, 1e-3);
}

/// What a restart must not change.
void expect_continued(const Snapshot& was, const Snapshot& is) {
  for (const PoseSource source : kPoseSources) {
    SCOPED_TRACE(to_string(source));
    expect_near(is.estimates[source].pose, was.estimates[source].pose);
    const double variance_m2 = was.estimates[source].covariance.xx;
    EXPECT_NEAR(is.estimates[source].covariance.xx, variance_m2, 0.1 * variance_m2);
  }
  expect_near(is.world, was.world);
  EXPECT_EQ(is.run_state, was.run_state);
  EXPECT_EQ(is.start_refusal, was.start_refusal);
  EXPECT_EQ(is.faults, was.faults);
  EXPECT_EQ(is.has_sample, was.has_sample);
  EXPECT_EQ(is.steering, was.steering);
  EXPECT_EQ(is.progress_m, was.progress_m);
  EXPECT_EQ(is.cross_track_m, was.cross_track_m);
  EXPECT_NEAR(is.gyro_bias_radps, was.gyro_bias_radps, 1e-4);
  EXPECT_NEAR(is.imu_pitch_rad, was.imu_pitch_rad, 2e-3);
}

TEST_P(Restart, LosesNothingAndRepeatsBitForBit) {
  constexpr std::size_t kMax = 8;  // restarts that are followed to the end
  std::mt19937 random(7);
  bridge::Step step = new_step();
  std::vector<bridge::Step> followers;
  const auto recorded = std::make_unique<StepRecord>(), again = std::make_unique<StepRecord>();
  Snapshot before;
  HostNs next_ns = 5 * kNsPerS;
  int restarts = 0, running = 0, finished = 0;
  std::string differs;
  for_each_step([&](StepRecord& record) {
    record.inputs.restart.clear();
    if (GetParam().changes && random() % 2000 == 0)
      record.inputs.changes.push(
          {LiveParameter::kCrossTrackGain, 0.3 + 0.001 * static_cast<double>(random() % 400)});
    if (GetParam().changes && random() % 9000 == 0)
      record.inputs.changes.push(
          {LiveParameter::kSteering, static_cast<double>(random() % kPoseSources.size())});
    const bool restart = record.now_ns >= next_ns && step.at_rest();
    if (restart) {
      next_ns = record.now_ns + from_s(0.2 + 0.001 * static_cast<double>(random() % 9000));
      record.inputs.restart.push(step.carried());
      ++restarts;
      if (followers.size() < kMax && random() % 2 == 0) followers.push_back(new_step());
    }
    set_results(step(record.inputs, record.now_ns), record);
    for (bridge::Step& follower : followers) {
      *again = record;
      set_results(follower(record.inputs, record.now_ns), *again);
      if (!differs.empty()) continue;
      if (const auto difference = record::first_difference(record, *again))
        differs = "step " + std::to_string(record.step) + ": " + difference->field + " " +
                  difference->recorded + " " + difference->computed;
    }
    const Snapshot& now = record.snapshot;
    if (restart) expect_continued(before, now);
    running += now.run_state == RunState::kRunning ? 1 : 0;
    finished +=
        now.run_state == RunState::kFinished && before.run_state == RunState::kRunning ? 1 : 0;
    before = now;
  });
  EXPECT_EQ(differs, "");
  EXPECT_GT(restarts, 10);
  EXPECT_EQ(followers.size(), kMax);
  EXPECT_GT(running, 2000);
  if (!GetParam().changes) {
    // On `terrain` the emulated robot is not really taken back, and its second run meets no ramp.
    EXPECT_GE(finished, GetParam().setup == bridge::Setup::kTerrain ? 1 : 2);
  }
}

INSTANTIATE_TEST_SUITE_P(Courses, Restart,
                         testing::Values(Scenario{"1-curve", bridge::Setup::kFlat, false, false},
                                         Scenario{"1-curve", bridge::Setup::kFlat, true, true},
                                         Scenario{"2", bridge::Setup::kStand, false, false},
                                         Scenario{"3", bridge::Setup::kFlat, false, false},
                                         Scenario{"3", bridge::Setup::kTerrain, true, false}),
                         [](const auto& param) {
                           std::string name = param.param.course;
                           std::erase(name, '-');
                           return "Course" + name +
                                  std::string(bridge::to_string(param.param.setup)) +
                                  (param.param.camera ? "Camera" : "") +
                                  (param.param.changes ? "Changes" : "");
                         });

// The live daemon restarts the step by itself.
TEST(RestartPeriod, ARobotThatStandsStillHoldsAMinuteOfHistory) {
  class Count : public messages::Sink {
   public:
    void take(const StepRecord& record) override {
      if (!record.inputs.restart.empty()) at_ns.push_back(record.now_ns);
    }
    std::vector<HostNs> at_ns;
  } count;
  Loaded loaded = load({});
  run_lockstep_twice({.course = load_course("1-straight"),
                      .robot = loaded.robot,
                      .configuration = loaded.configuration,
                      .setup = loaded.setup,
                      .sinks = {&count}},
                     300.0);
  ASSERT_GE(count.at_ns.size(), 4U);
  int minutes = 0;
  for (std::size_t i = 1; i < count.at_ns.size(); ++i) {
    const double apart_s = to_s(count.at_ns[i] - count.at_ns[i - 1]);
    EXPECT_GE(apart_s, 60.0);
    if (apart_s < 61.0) ++minutes;
  }
  EXPECT_GE(minutes, 3);
}

}  // namespace
}  // namespace tp100::sim
