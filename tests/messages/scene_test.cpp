// What viewers draw: the scene, compared with the terrain that it shows, and the driven paths,
// thinned, bounded, and begun anew with each run.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "fixtures.h"
#include "messages/foxglove.h"
#include "messages/messages.h"
#include "messages/path_history.h"

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
  const auto ramp = std::get<course::Ramp>(example_subject().course->terrain.obstacles[0]);
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
  const Json list = entity("course/block/0")["triangles"][0];
  EXPECT_EQ(list["pose"]["position"]["z"], 0.0);
  for (const Json& point : list["points"]) {
    EXPECT_EQ(std::abs(point["x"].get<double>()), 0.05);
    EXPECT_EQ(std::abs(point["y"].get<double>()), 0.2);
    EXPECT_TRUE(point["z"] == 0.0 || point["z"] == 0.03) << point;
  }
}

TEST(Scene, TheRobotMovesWithItsFrameAndIsAllThatThereIsWithoutACourse) {
  for (const char* id : {"robot/body", "robot/left", "robot/right"})
    EXPECT_EQ(entity(id)["frame_id"], "robot");
  EXPECT_GT(entity("robot/left")["cubes"][0]["pose"]["position"]["y"], 0.0);
  const Messages messages(RunContext{}, example_clock());
  const Json without_course = Json::parse(scene_text(messages, 0))["entities"];
  EXPECT_EQ(without_course.size(), 3U);
  for (const char* kind :
       {"arrows", "cubes", "spheres", "cylinders", "lines", "triangles", "texts", "models"})
    EXPECT_TRUE(without_course[0][kind].is_array()) << kind;
}

Snapshot at(double x_m, RunState state = RunState::kRunning) {
  Snapshot snapshot;
  snapshot.has_sample = true;
  snapshot.run_state = state;
  snapshot.estimates[PoseSource::kModel].pose.x_m =
      snapshot.estimates[PoseSource::kOdometry].pose.x_m =
          snapshot.estimates[PoseSource::kFused].pose.x_m = x_m;
  return snapshot;
}

std::size_t points_of(const Json& update) {
  std::size_t points = 0;
  for (const Json& entity : update["entities"]) points += entity["lines"][0]["points"].size();
  return points;
}

TEST(PathHistory, APointPerCentimetreAndOnlyWhatIsNew) {
  PathHistory path_history;
  for (int i = 0; i <= 100; ++i) path_history.add(at(i * 1.001e-3));
  path_history.add(at(std::nan("")));
  const Json first = Json::parse(path_history.take_update({}, 0));
  EXPECT_EQ(points_of(first), 3U * 11U);
  EXPECT_EQ(path_history.take_update({}, 0), "");
  for (int i = 100; i <= 151; ++i) path_history.add(at(i * 1.001e-3));
  const Json second = Json::parse(path_history.take_update({}, 0));
  // The update has five new points and the last point of the previous part.
  EXPECT_EQ(points_of(second), 3U * 6U);
  EXPECT_TRUE(second["deletions"].empty());
  EXPECT_EQ(points_of(Json::parse(path_history.whole({}, 0))), 3U * 16U);
}

TEST(PathHistory, ANewRunDeletesTheOldOne) {
  PathHistory path_history;
  for (int i = 0; i < 50; ++i) path_history.add(at(i * 1e-2));
  path_history.take_update({}, 0);
  path_history.add(at(0.5, RunState::kFinished));
  path_history.add(at(0.0));
  const Json update = Json::parse(path_history.take_update({}, 0));
  EXPECT_EQ(update["deletions"][0]["type"], 1);
  EXPECT_EQ(points_of(update), 0U);
}

TEST(PathHistory, StaysBoundedOverAnyLength) {
  PathHistory path_history;
  for (int i = 0; i < 30'000; ++i) path_history.add(at(i * 1e-2));
  const Json whole = Json::parse(path_history.whole({}, 0));
  EXPECT_LE(points_of(whole), 3U * (PathHistory::kMaxPoints + 1));
  EXPECT_GE(points_of(whole), 3U * PathHistory::kMaxPoints / 2);
  const Json& points = whole["entities"][0]["lines"][0]["points"];
  EXPECT_EQ(points.front()["x"], 0.0) << "it still shows the whole run";
  EXPECT_NEAR(points.back()["x"].get<double>(), 300.0, 1.0);
}

}  // namespace
}  // namespace tp100::messages
