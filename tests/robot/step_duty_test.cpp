// Real-time duties: the inputs of emulated runs are passed to a fresh step while its calls are
// monitored.
#include <gtest/gtest.h>

#include "../bench/kept_run.h"
#include "bridge/step.h"
#include "support/real_time_monitor.h"

namespace tp100::sim {
namespace {

class StepDuty : public ::testing::TestWithParam<bridge::Setup> {};

TEST_P(StepDuty, OnCourse3WithFilterCameraAndControlIsToComputeAndNothingElse) {
  const test::KeptRun run = test::keep_course_3(GetParam());
  ASSERT_TRUE(run.completed);

  bridge::Step step(run.parameters, run.course);
  test::RealTimeViolations duty;
  std::uint64_t images = 0;
  for (const StepRecord& record : run.records) {
    const StepInputs& inputs = record.inputs;
    images += inputs.camera.size();
    const test::RealTimeMonitor watch(duty);
    step(inputs, record.now_ns);
  }
  EXPECT_GT(run.records.size(), 5000U);
  EXPECT_GT(images, 500U);
  EXPECT_EQ(duty.heap, 0U);
  EXPECT_EQ(duty.locks, 0U);
  EXPECT_EQ(duty.first_system_call, -1) << "the number of the first system call";
  if (!test::watches_system_calls())
    GTEST_SKIP() << "this kernel does not tell of system calls; heap and locks: none";
}

INSTANTIATE_TEST_SUITE_P(Setups, StepDuty,
                         ::testing::Values(bridge::Setup::kFlat, bridge::Setup::kTerrain),
                         [](const auto& tested) {
                           return std::string(bridge::to_string(tested.param));
                         });

}  // namespace
}  // namespace tp100::sim
