#include <gtest/gtest.h>

#include <vector>

#include "link/session.h"
#include "scripted_robot.h"
#include "support/alloc_count.h"

namespace tp100::link {
namespace {

// The test covers a whole session: handshake, samples, noise, requests, a reboot and a time-out.
TEST(Allocation, ASessionNeverTouchesTheHeap) {
  SessionSettings settings;
  Session session(settings);
  ScriptedRobot robot;
  HostNs now = kNsPerS;
  std::uint64_t calls = 0;
  std::uint64_t samples = 0;
  const std::vector<std::uint8_t> noise{1, 2, 3, 0, 9, 9, 0, 0xFF, 0};
  session.open(now);
  for (int turn = 0; turn < 8000; ++turn) {
    now += kNsPerMs;
    if (turn == 3000) robot.reboot(now);
    robot.silent = turn > 5000 && turn < 6000;
    robot.tick(now);
    std::vector<std::uint8_t> bytes = robot.take();
    if (turn % 50 == 0) bytes.insert(bytes.end(), noise.begin(), noise.end());
    {
      const test::AllocCount heap;
      session.receive(bytes, now);
      samples += session.take_samples().size();
      session.take_events();
      if (turn == 1000) session.request(RobotRequest::kArm, now);
      if (turn == 1500) session.request(RobotRequest::kStop, now);
      session.poll(now);
      session.send(Command{}, now);
      calls += heap.calls();
    }
    robot.receive(session.output(), now);
    session.written(session.output().size());
  }
  EXPECT_EQ(calls, 0u);
  EXPECT_GT(samples, 500u);
  EXPECT_GE(session.session_number(), 2u);
}

}  // namespace
}  // namespace tp100::link
