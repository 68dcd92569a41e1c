// Images of an overhead camera, rendered by the engine along a drive: sim/lab/overhead with the
// real tp100-camera.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "programs/process.h"
#include "support/paths.h"

namespace tp100::test {
namespace {

class Overhead : public testing::Test {
 protected:
  void SetUp() override {
    const Finished setup = run({source_path("scripts/setup"), "godot"});
    if (setup.status != 0) GTEST_SKIP() << "Godot cannot be installed here: " << setup.output;
  }
  /// The figures of a part of a drive.
  static nlohmann::json film(std::vector<std::string> words) {
    words.insert(words.begin(),
                 {source_path("sim/lab/overhead"), "--json", "--bin", build_path("bin")});
    const Finished done = run(words);
    EXPECT_EQ(done.status, 0) << done.output;
    const std::size_t begin = done.output.find("{\"course\"");
    auto figures = nlohmann::json::parse(
        begin == std::string::npos ? "" : done.output.substr(begin), nullptr, false);
    return figures.is_object() ? figures : nlohmann::json::object();
  }
  static double figure(const nlohmann::json& figures, const char* name) {
    return figures.value(name, std::nan(""));
  }
};

// While the robot climbs the ramp of course 3, under a lamp that is carried around.
TEST_F(Overhead, EveryImageShowsTheRobotWhereItIs) {
  const nlohmann::json figures = film(
      {"--setup", "terrain", "--light", "moving", "--rate", "5", "--from", "33", "--seconds", "4"});
  EXPECT_EQ(figure(figures, "visible"), 21) << figures;
  EXPECT_EQ(figure(figures, "covered"), 0);
  EXPECT_GE(figure(figures, "found_share"), 0.95);
  EXPECT_GT(figure(figures, "image_max_m"), 0.0);
  EXPECT_LT(figure(figures, "image_max_m"), 0.004);
  EXPECT_LT(figure(figures, "image_max_deg"), 2.0);
  EXPECT_GT(figure(figures, "fused_max_m"), 0.0);
  EXPECT_LT(figure(figures, "fused_max_m"), 0.02);
}

// The hand stays there for 0.6 s, during which odometry continues.
TEST_F(Overhead, AHandOverTheMarkerDoesNotMoveTheFusedPose) {
  const nlohmann::json figures =
      film({"--course", "1-straight", "--hand", "--rate", "5", "--from", "5", "--seconds", "4"});
  EXPECT_GE(figure(figures, "covered"), 4) << figures;
  EXPECT_GE(figure(figures, "visible"), 10);
  EXPECT_GE(figure(figures, "found_share"), 0.95);
  EXPECT_GT(figure(figures, "fused_max_m"), 0.0);
  EXPECT_LT(figure(figures, "fused_max_m"), 0.005);
  EXPECT_GT(figure(figures, "jump_max_m"), 0.0);
  EXPECT_LT(figure(figures, "jump_max_m"), 0.001);
  EXPECT_EQ(figure(figures, "recoveries"), 0);
}

}  // namespace
}  // namespace tp100::test
