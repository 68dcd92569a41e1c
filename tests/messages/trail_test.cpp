#include "messages/trail.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

namespace tp100::messages {
namespace {

using Json = nlohmann::json;

Snapshot at(double x_m, RunState state = RunState::kRunning) {
  Snapshot snapshot;
  snapshot.has_sample = true;
  snapshot.run_state = state;
  snapshot.model.x_m = snapshot.odometry.x_m = snapshot.fused.pose.x_m = x_m;
  return snapshot;
}

std::size_t points_of(const Json& update) {
  std::size_t points = 0;
  for (const Json& entity : update["entities"]) points += entity["lines"][0]["points"].size();
  return points;
}

TEST(Trail, APointPerCentimetreAndOnlyWhatIsNew) {
  Trail trail;
  for (int i = 0; i <= 100; ++i) trail.add(at(i * 1.001e-3));
  const Json first = Json::parse(trail.take_update({}, 0));
  EXPECT_EQ(points_of(first), 3U * 11U);
  EXPECT_EQ(trail.take_update({}, 0), "");
  for (int i = 100; i <= 151; ++i) trail.add(at(i * 1.001e-3));
  const Json second = Json::parse(trail.take_update({}, 0));
  // Five new ones, and the last of the part before.
  EXPECT_EQ(points_of(second), 3U * 6U);
  EXPECT_TRUE(second["deletions"].empty());
  EXPECT_EQ(points_of(Json::parse(trail.whole({}, 0))), 3U * 16U);
}

TEST(Trail, ANewRunDeletesTheOldOne) {
  Trail trail;
  for (int i = 0; i < 50; ++i) trail.add(at(i * 1e-2));
  trail.take_update({}, 0);
  trail.add(at(0.5, RunState::kFinished));
  trail.add(at(0.0));
  const Json update = Json::parse(trail.take_update({}, 0));
  EXPECT_EQ(update["deletions"][0]["type"], 1);
  EXPECT_EQ(points_of(update), 0U);
}

TEST(Trail, StaysBoundedOverAnyLength) {
  Trail trail;
  for (int i = 0; i < 30'000; ++i) trail.add(at(i * 1e-2));
  EXPECT_LE(points_of(Json::parse(trail.whole({}, 0))), 3U * (Trail::kMaxPoints + 1));
}

TEST(Trail, PosesThatAreNoNumbersAddNothing) {
  Trail trail;
  trail.add(at(0.0));
  for (int i = 0; i < 100; ++i) trail.add(at(std::nan("")));
  EXPECT_EQ(points_of(Json::parse(trail.whole({}, 0))), 0U);
}

}  // namespace
}  // namespace tp100::messages
