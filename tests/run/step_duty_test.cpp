// What the real-time thread owes: the inputs of emulated runs, fed to a fresh step under watch.
#include <gtest/gtest.h>

#include <memory>
#include <vector>

#include "../bench/kept_steps.h"
#include "app/replay_recording.h"
#include "bridge/step.h"
#include "sim/run/lockstep.h"
#include "sim/run/options.h"
#include "support/alloc_count.h"
#include "support/duty_watch.h"

namespace tp100::sim {
namespace {

class StepDuty : public ::testing::TestWithParam<bridge::Setup> {};

TEST_P(StepDuty, OnCourse3WithFilterCameraAndControlIsToComputeAndNothingElse) {
  Loaded loaded = load({});
  loaded.configuration.parameters.steering = bridge::Steering::kFused;
  const auto course = std::make_shared<const course::Course>(load_course("3"));
  test::StepKeeper keeper;
  const analysis::RunResult result = run_lockstep({.course = *course,
                                                   .robot = loaded.robot,
                                                   .configuration = loaded.configuration,
                                                   .setup = GetParam(),
                                                   .camera = load_camera("overhead"),
                                                   .sink = &keeper});
  ASSERT_TRUE(result.completed);

  bridge::Parameters parameters = app::bridge_parameters(loaded.configuration, loaded.robot);
  parameters.setup = GetParam();
  bridge::Step step(parameters, course);
  const bool watching = test::watches_system_calls();
  std::uint64_t heap = 0, locks = 0, pictures = 0;
  long call = -1;
  for (const StepRecord& record : keeper.records) {
    const bridge::Inputs inputs = app::inputs_of(record);
    pictures += inputs.camera.size();
    const test::AllocCount allocations;
    const test::DutyWatch duty;
    step(inputs, record.now_ns);
    heap += allocations.calls();
    locks += duty.locks();
    if (call < 0) call = duty.first_system_call();
  }
  EXPECT_GT(keeper.records.size(), 5000U);
  EXPECT_GT(pictures, 500U);
  EXPECT_EQ(heap, 0U);
  EXPECT_EQ(locks, 0U);
  EXPECT_EQ(call, -1) << "a system call of this number";
  if (!watching) GTEST_SKIP() << "this kernel does not tell of system calls; heap and locks: none";
}

INSTANTIATE_TEST_SUITE_P(Setups, StepDuty,
                         ::testing::Values(bridge::Setup::kFlat, bridge::Setup::kTerrain),
                         [](const auto& tested) {
                           return std::string(bridge::to_string(tested.param));
                         });

}  // namespace
}  // namespace tp100::sim
