// The loop's duties while the daemon is a node of a ROS 2 domain.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "../server/fake_controls.h"
#include "live/ros2_node.h"
#include "live_rig.h"

namespace tp100::live {
namespace {

/// Names of this process's threads.
std::vector<std::string> threads() {
  std::vector<std::string> names;
  for (const auto& task : std::filesystem::directory_iterator("/proc/self/task"))
    std::getline(std::ifstream(task.path() / "comm"), names.emplace_back());
  return names;
}

TEST(Ros2Duty, WithANodeOnTheNetworkATurnNeitherCallsTheSystemNorLocksNorAllocates) {
  config::Configuration configuration;
  // A domain that no other test is in.
  configuration.ros2 = {.enabled = true, .domain = static_cast<int>(::getpid() % 200)};
  const auto participant = ros2_participant(configuration);
  LiveRig rig;
  server::FakeControls controls;
  Ros2Node node(*participant, {}, {.start_ns = rig.now, .start_unix_ns = kNsPerS}, rig.cycle,
                controls, "");
  EXPECT_THAT(threads(), testing::IsSupersetOf({"ros2", "recv"}));
  rig.watched = true;
  // More than would be queued if the node published none.
  for (int i = 0; i < 2000; ++i) {
    if (i % 50 == 20) rig.cycle.request(OperatorRequest::kHold);
    rig.steps(1);
  }
  EXPECT_EQ(rig.duty.heap, 0u);
  EXPECT_EQ(rig.duty.locks, 0u);
  EXPECT_EQ(rig.duty.first_system_call, -1);
  if (!test::watches_system_calls())
    GTEST_SKIP() << "this kernel does not tell of system calls; heap and locks: none";
}

}  // namespace
}  // namespace tp100::live
