#include "messages/path_history.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

namespace tp100::messages {
namespace {

using Json = nlohmann::json;

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

TEST(PathHistory, PosesThatAreNoNumbersAddNothing) {
  PathHistory path_history;
  path_history.add(at(0.0));
  for (int i = 0; i < 100; ++i) path_history.add(at(std::nan("")));
  EXPECT_EQ(points_of(Json::parse(path_history.whole({}, 0))), 0U);
}

}  // namespace
}  // namespace tp100::messages
