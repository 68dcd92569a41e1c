// Compares the scene with the terrain that it shows.
#include "messages/scene.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "fixtures.h"
#include "messages/messages.h"

namespace tp100::messages {
namespace {

using Json = nlohmann::json;

Json entities() {
  const Messages messages(example_subject(), example_clock());
  return Json::parse(scene_text(messages, 0))["entities"];
}

Json entity(const std::string& id) {
  for (const Json& each : entities())
    if (each["id"] == id) return each;
  ADD_FAILURE() << id << " is not in the scene";
  return {};
}

TEST(Scene, ARampRisesAndFallsAtItsAngles) {
  const course::Ramp ramp = example_subject().course->terrain.ramps[0];
  const Json list = entity("course/ramp/0")["triangles"][0];
  ASSERT_EQ(list["points"].size() % 3, 0U);
  double lowest = 1e9, highest = -1e9, first = 1e9, last = -1e9, top_from = 1e9, top_to = -1e9;
  for (const Json& point : list["points"]) {
    const double x = point["x"], z = point["z"];
    lowest = std::min(lowest, z);
    highest = std::max(highest, z);
    first = std::min(first, x);
    last = std::max(last, x);
    if (z > 0) top_from = std::min(top_from, x), top_to = std::max(top_to, x);
    EXPECT_NEAR(std::abs(point["y"].get<double>()), ramp.width_m / 2, 1e-12);
  }
  EXPECT_EQ(lowest, 0.0);
  EXPECT_DOUBLE_EQ(highest, ramp.height_m);
  EXPECT_NEAR(std::atan2(highest, top_from - first), ramp.up_rad, 1e-9);
  EXPECT_NEAR(top_to - top_from, ramp.top_m, 1e-9);
  EXPECT_NEAR(std::atan2(highest, last - top_to), ramp.down_rad, 1e-9);
  // Seen along the heading, the side that the robot meets first lies behind the centre.
  EXPECT_NEAR(first, -ramp.length_m() / 2, 1e-9);
  EXPECT_NEAR(list["pose"]["orientation"]["z"].get<double>(), std::sin(M_PI / 4), 1e-12);
}

TEST(Scene, ABlockStandsOnTheFloor) {
  const Json cube = entity("course/block/0")["cubes"][0];
  EXPECT_DOUBLE_EQ(cube["pose"]["position"]["z"].get<double>(),
                   cube["size"]["z"].get<double>() / 2);
  EXPECT_EQ(cube["size"]["x"], 0.1);
  EXPECT_EQ(cube["size"]["y"], 0.4);
}

TEST(Scene, TheRobotMovesWithItsFrame) {
  for (const char* id : {"robot/body", "robot/left", "robot/right"})
    EXPECT_EQ(entity(id)["frame_id"], "robot");
  EXPECT_GT(entity("robot/left")["cubes"][0]["pose"]["position"]["y"], 0.0);
}

TEST(Scene, EveryKindOfPrimitiveIsAList) {
  for (const Json& each : entities()) {
    for (const char* kind :
         {"arrows", "cubes", "spheres", "cylinders", "lines", "triangles", "texts", "models"})
      EXPECT_TRUE(each[kind].is_array()) << each["id"] << kind;
  }
}

TEST(Scene, WithoutACourseThereIsOnlyTheRobot) {
  const Messages messages(RunContext{}, example_clock());
  EXPECT_EQ(Json::parse(scene_text(messages, 0))["entities"].size(), 3U);
}

}  // namespace
}  // namespace tp100::messages
