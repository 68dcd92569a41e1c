// The engine's project sim/godot beside programs that drive in real time.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <memory>
#include <string>

#include "godot.h"

namespace tp100::test {
namespace {

using ::testing::HasSubstr;

TEST_F(Godot, LostEndsTheRunAndANewOneIsWelcome) {
  const auto robot = start_robot(folder_.file("tp100"));
  auto engine = std::make_unique<Engine>("1-straight");
  const std::string address = engine->address();
  Process bridge({"tp100d", "run", "--port", folder_.file("tp100"), "--course", "1-straight",
                  "--world", "udp:" + address, "--config", config("timeout_ms = 1000\n")});
  ASSERT_TRUE(bridge.wait_for("world: connected to sim/godot")) << bridge.output();
  ASSERT_TRUE(bridge.wait_for("state: arming -> running")) << bridge.output();
  engine.reset();
  ASSERT_TRUE(bridge.wait_for("state: running -> aborted")) << bridge.output();
  EXPECT_TRUE(robot->wait_for("motors off")) << robot->output();
  const Engine anew("1-straight", address);
  EXPECT_TRUE(bridge.wait_for("world: connected")) << bridge.output();
  EXPECT_THAT(bridge.output(), HasSubstr("world_lost"));
}

}  // namespace
}  // namespace tp100::test
