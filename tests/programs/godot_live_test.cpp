// The engine's project sim/godot beside programs that drive in real time.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>

#include "godot.h"

namespace tp100::test {
namespace {

using ::testing::HasSubstr;

TEST_F(Godot, LostEndsTheRunAndANewOneIsWelcome) {
  Process robot({"tp100-sim", "robot", "--link", folder_.file("tp100")});
  ASSERT_TRUE(robot.wait_for("linked from")) << robot.output();
  auto engine = std::make_unique<Engine>("1-straight");
  const std::string address = engine->address();
  Process bridge({"tp100d", "run", "--port", folder_.file("tp100"), "--course", "1-straight",
                  "--world", "udp:" + address, "--config", config("timeout_ms = 1000\n")});
  ASSERT_TRUE(bridge.wait_for("world: connected to sim/godot")) << bridge.output();
  ASSERT_TRUE(bridge.wait_for("state: arming -> running")) << bridge.output();
  engine.reset();
  ASSERT_TRUE(bridge.wait_for("state: running -> aborted")) << bridge.output();
  EXPECT_TRUE(robot.wait_for("motors off")) << robot.output();
  const Engine anew("1-straight", address);
  EXPECT_TRUE(bridge.wait_for("world: connected")) << bridge.output();
  EXPECT_THAT(bridge.output(), HasSubstr("world_lost"));
}

#ifdef TP100_HAS_CAMERA
// The image rate and the delay of the images depend on the machine and are not judged. The drive is
// short because rendering takes all the time of the processors.
TEST_F(Godot, RendersForATp100dThatDrives) {
  const Finished done = run({source_path("scripts/overhead"), "--json", "--live", "--bin",
                             build_path("bin"), "--course", short_course(folder_, 0.2)});
  ASSERT_LE(done.status, 1) << done.output;
  const std::size_t begin = done.output.find("{\"course\"");
  ASSERT_NE(begin, std::string::npos) << done.output;
  const auto figures = nlohmann::json::parse(done.output.substr(begin), nullptr, false);
  ASSERT_TRUE(figures.is_object()) << done.output;
  const auto figure = [&](const char* name) { return figures.value(name, std::nan("")); };
  EXPECT_TRUE(figures.value("completed", false)) << figures;
  EXPECT_GE(figure("visible"), 1);
  EXPECT_GE(figure("found_share"), 0.95);
  EXPECT_LT(figure("image_max_m"), 0.004);
  EXPECT_GT(figure("accepted") + figure("late"), 0);
}
#endif

}  // namespace
}  // namespace tp100::test
