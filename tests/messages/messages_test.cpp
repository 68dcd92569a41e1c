// What the channels of a run say: estimates, samples, commands, the course and its geometry.

#include "messages/messages.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

#include "core/arithmetic.h"
#include "fixtures.h"
#include "messages/foxglove.h"
#include "messages/status_messages.h"

namespace tp100::messages {
namespace {

using Json = nlohmann::json;

class MessagesTest : public ::testing::Test {
 protected:
  Messages messages_{example_subject(), example_clock()};
  StepRecord record_ = example_record();
};

TEST_F(MessagesTest, TheEstimatesAreNeverMixedAndTruthCarriesItsAge) {
  const Truth truth{record_.now_ns - 5 * kNsPerMs, {.x_m = 0.44}};
  const Json json = Json::parse(messages_.estimate(record_, truth));
  EXPECT_EQ(json["model"]["x_m"], 0.11);
  EXPECT_EQ(json["odometry"]["x_m"], 0.22);
  EXPECT_EQ(json["odometry"]["yaw_rad"], 0.3);
  EXPECT_EQ(json["fused"]["x_m"], 0.33);
  EXPECT_EQ(json["truth"]["x_m"], 0.44);
  EXPECT_EQ(json["truth"]["age_us"], 5000);
  EXPECT_EQ(json["t_s"], 10.0);
}

TEST_F(MessagesTest, WhatIsNotKnownOrNoNumberStaysOut) {
  record_.snapshot.has_sample = false;
  record_.snapshot.estimates[PoseSource::kFused].covariance.xx = -1.0;
  record_.snapshot.estimates[PoseSource::kModel].pose.x_m = std::numeric_limits<double>::infinity();
  const Json json = Json::parse(messages_.estimate(record_, std::nullopt));
  EXPECT_FALSE(json.contains("age_us"));
  EXPECT_FALSE(json.contains("truth"));
  EXPECT_FALSE(json["fused"].contains("camera_age_us"));
  EXPECT_FALSE(json["fused"].contains("sd_x_m"));
  EXPECT_FALSE(json["model"].contains("x_m"));
}

TEST_F(MessagesTest, CommandedTrackSpeedsAreThoseOfTheStepAndNoneWithoutACommand) {
  record_.snapshot.commanded_left_mps = 0.05;
  record_.snapshot.commanded_right_mps = 0.15;
  for (const bool commanded : {true, false}) {
    record_.command_valid = commanded;
    const Json tracks = Json::parse(messages_.estimate(record_, std::nullopt))["tracks"];
    EXPECT_EQ(tracks.value("left_commanded_mps", 0.0), commanded ? 0.05 : 0.0);
    EXPECT_EQ(tracks.value("right_commanded_mps", 0.0), commanded ? 0.15 : 0.0);
  }
}

TEST_F(MessagesTest, EveryEstimateHasItsStandardDeviations) {
  for (const PoseSource source : kPoseSources) {
    const double sd = 0.01 * (1.0 + static_cast<double>(source));
    record_.snapshot.estimates[source].covariance = {
        .xx = square(sd), .yy = square(2.0 * sd), .yaw_yaw = square(3.0 * sd)};
    const Json estimate = Json::parse(messages_.estimate(record_, std::nullopt))[to_string(source)];
    EXPECT_NEAR(estimate["sd_x_m"], sd, 1e-12) << to_string(source);
    EXPECT_NEAR(estimate["sd_y_m"], 2.0 * sd, 1e-12) << to_string(source);
    EXPECT_NEAR(estimate["sd_yaw_rad"], 3.0 * sd, 1e-12) << to_string(source);
  }
}

TEST_F(MessagesTest, TheReferenceIsThePathAtTheProgress) {
  const Json json = Json::parse(messages_.estimate(record_, std::nullopt));
  EXPECT_NEAR(json["reference"]["x_m"].get<double>(), 0.2, 1e-12);
  const Messages without({}, example_clock());
  EXPECT_FALSE(Json::parse(without.estimate(record_, std::nullopt)).contains("reference"));
}

TEST_F(MessagesTest, ASampleNamesItsFaults) {
  Sample sample = record_.snapshot.sample;
  sample.faults = fault_bit(Fault::battery_low) | fault_bit(Fault::imu_stale);
  const Json json = Json::parse(messages_.sample(sample, record_.now_ns));
  EXPECT_EQ(json["faults"], Json({"imu_stale", "battery_low"}));
  EXPECT_EQ(json["age_us"], 3000);
  EXPECT_EQ(json["state"], "running");
}

TEST_F(MessagesTest, ACommandSaysHowLongItLives) {
  record_.snapshot.command.expiry_us =
      record_.inputs.clock.to_device(record_.now_ns + 180 * kNsPerMs);
  const Json json = Json::parse(messages_.command(record_));
  EXPECT_NEAR(json["expires_in_ms"].get<double>(), 180.0, 0.01);
  record_.inputs.clock.valid = false;
  EXPECT_FALSE(Json::parse(messages_.command(record_)).contains("expires_in_ms"));
}

// The longest course must fit into the messages that every viewer gets of it.
TEST_F(MessagesTest, ThePathOfAnyCourseIsDenseAndHasFewPoints) {
  EXPECT_DOUBLE_EQ(path_points(*messages_.path()).back().yaw_rad, kPi / 2 - 1.0);
  for (const std::size_t segments : {1U, 10U, 999U}) {
    for (const double length_m : {0.5, 380.0, course::kLongestPathM}) {
      course::Course course;
      for (std::size_t i = 0; i < segments; ++i)
        course.path.push_back(course::Line{length_m / static_cast<double>(segments)});
      const auto points = path_points(course::Path(course));
      EXPECT_LE(points.size(), kMaxPathPoints);
      EXPECT_EQ(points.front().s_m, 0.0);
      for (std::size_t i = 1; i < points.size(); ++i) {
        ASSERT_GE(points[i].s_m, points[i - 1].s_m);
        ASSERT_LE(points[i].x_m - points[i - 1].x_m, length_m <= 380.0 ? 0.0201 : 0.053);
      }
      EXPECT_NEAR(points.back().s_m, length_m, 1e-9);
    }
  }
}

TEST_F(MessagesTest, ACourseTellsItsGeometry) {
  const Json json = Json::parse(messages_.course());
  EXPECT_EQ(json["name"], "example");
  const Json &ramp = json["obstacles"][0], &block = json["obstacles"][1];
  EXPECT_EQ(ramp["kind"], "ramp");
  EXPECT_EQ(ramp["y_m"], 2.0);
  EXPECT_EQ(ramp["heading_rad"], kPi / 2);
  EXPECT_NEAR(
      ramp["profile"][1]["along_m"].get<double>() - ramp["profile"][0]["along_m"].get<double>(),
      0.1 / std::tan(0.5), 1e-12);
  EXPECT_EQ(ramp["profile"][2]["height_m"], 0.1);
  EXPECT_EQ(block["kind"], "block");
  EXPECT_EQ(block["width_m"], 0.4);
  EXPECT_EQ(block["profile"][3], Json({{"along_m", 0.05}, {"height_m", 0.0}}));
  EXPECT_EQ(json["surfaces"][0]["name"], "ice");
  EXPECT_EQ(json["fence"]["max_y_m"], 4.0);
  EXPECT_EQ(json["segments"][1]["kind"], "pivot");
  EXPECT_EQ(json["segments"][1]["begin"], Json({{"x_m", 1.0}, {"y_m", 0.0}, {"yaw_rad", 0.0}}));
  EXPECT_EQ(json["segments"][1]["end"], Json({{"x_m", 1.0}, {"y_m", 0.0}, {"yaw_rad", kPi / 2}}));
  EXPECT_EQ(json["segments"][2]["begin"], json["segments"][1]["end"]);
  EXPECT_EQ(json["segments"][2]["to_m"], 1.5);
  const Json none = Json::parse(Messages(RunContext{}, example_clock()).course());
  EXPECT_TRUE(none["path"].empty());
  EXPECT_FALSE(none.contains("fence"));
}

// The block lies across the first line, from 0.45 to 0.55 m.
TEST_F(MessagesTest, ThePathOfACourseLiesOnTheGround) {
  double low_m = 0.0, high_m = 1.0;  // the last place on the floor before the block, and behind it
  const Json json = Json::parse(messages_.course());
  for (const Json& point : json["path"]) {
    const double s_m = point["s_m"], z_m = point["z_m"];
    if (s_m > 0.4501 && s_m < 0.5499) {
      EXPECT_EQ(z_m, 0.03) << s_m;
    } else if (s_m < 0.4499 || s_m > 0.5501) {
      EXPECT_EQ(z_m, 0.0) << s_m;
      if (s_m < 0.5) low_m = std::max(low_m, s_m);
      if (s_m > 0.5) high_m = std::min(high_m, s_m);
    }
  }
  EXPECT_GT(low_m, 0.4445);
  EXPECT_LT(high_m, 0.5555);
}

TEST_F(MessagesTest, TransformsMoveTheRobotInTheCoursesWorld) {
  const Truth truth{record_.now_ns, {.x_m = 0.44}};
  const Json json = Json::parse(transforms_text(messages_, record_, truth))["transforms"];
  ASSERT_EQ(json.size(), 5U);
  EXPECT_EQ(json[0]["child_frame_id"], "robot");
  EXPECT_EQ(json[0]["translation"], Json({{"x", 0.22}, {"y", 0.0}, {"z", 0.05}}));
  EXPECT_EQ(json[0]["timestamp"], Json({{"sec", 1010}, {"nsec", 0}}));
  EXPECT_EQ(json[4]["child_frame_id"], "truth");
}

// R = Rz(yaw) Ry(pitch) Rx(roll), written out: the forward axis, and the height of the left one.
TEST(Quaternion, TurnsAVectorAsTheEulerAnglesDo) {
  const double roll = 0.3, pitch = -0.7, yaw = 2.1;
  const auto [x, y, z, w] = quaternion({.roll_rad = roll, .pitch_rad = pitch, .yaw_rad = yaw});
  EXPECT_NEAR(1 - 2 * (y * y + z * z), std::cos(yaw) * std::cos(pitch), 1e-12);
  EXPECT_NEAR(2 * (x * y + w * z), std::sin(yaw) * std::cos(pitch), 1e-12);
  EXPECT_NEAR(2 * (x * z - w * y), -std::sin(pitch), 1e-12) << "nose-up is negative";
  EXPECT_NEAR(2 * (y * z + w * x), std::cos(pitch) * std::sin(roll), 1e-12);
}

TEST_F(MessagesTest, ALogLineHoldsCauseAndFix) {
  const Event event{.at_ns = 3 * kNsPerS,
                    .kind = "fault",
                    .level = Event::Level::kError,
                    .text = "tilt",
                    .cause = "too steep",
                    .fix = "set it upright"};
  const Json json = Json::parse(log_text(messages_, event));
  EXPECT_EQ(json["message"], "tilt: too steep; set it upright");
  EXPECT_EQ(json["level"], 4);
  EXPECT_EQ(json["timestamp"]["sec"], 1001);
  EXPECT_EQ(Json::parse(messages_.event(event))["level"], "error");
}

}  // namespace
}  // namespace tp100::messages
