// The loop's duties while the daemon is a node of a ROS 2 domain.
#include <gtest/gtest.h>
#include <unistd.h>

#include <chrono>
#include <filesystem>
#include <fstream>
#include <string>
#include <thread>

#include "../server/fake_controls.h"
#include "live/ros2_node.h"
#include "live_rig.h"

namespace tp100::live {
namespace {

using namespace std::chrono_literals;

/// Whether this process has a thread of this name; waits for it, as a thread names itself.
bool has_thread(const std::string& name) {
  for (const auto end = std::chrono::steady_clock::now() + 20s;
       std::chrono::steady_clock::now() < end; std::this_thread::sleep_for(5ms))
    for (const auto& task : std::filesystem::directory_iterator("/proc/self/task")) {
      std::string found;
      std::getline(std::ifstream(task.path() / "comm"), found);
      if (found == name) return true;
    }
  return false;
}

TEST(Ros2Duty, WithANodeOnTheNetworkATurnNeitherCallsTheSystemNorLocksNorAllocates) {
  config::Configuration configuration;
  // A domain that no other test is in.
  configuration.ros2 = {.enabled = true, .domain = static_cast<int>(::getpid() % 200)};
  const auto participant = ros2_participant(configuration);
  LiveRig rig;
  server::FakeControls controls;
  messages::EventQueue events;
  Ros2Node node(*participant, {}, {.start_ns = rig.now, .start_unix_ns = kNsPerS}, rig.cycle,
                Ros2Requests(controls, events, [] {}), "");
  EXPECT_TRUE(has_thread("ros2"));
  EXPECT_TRUE(has_thread("recv"));
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
