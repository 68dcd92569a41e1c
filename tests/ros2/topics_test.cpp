// Which topics a step has, and what no bag shows: tests/npm/ros2_bag_test.mjs compares every field
// of whole runs with their channels.
#include "ros2/topics.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <map>
#include <utility>

#include "core/arithmetic.h"
#include "course/bundled_files.h"
#include "ros2/message_types.h"
#include "ros2/participant.h"
#include "ros2/robot_description.h"
#include "support/refusal.h"

namespace tp100::ros2 {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

messages::RunContext on_course_one() {
  const course::TextFile file = course::read_bundled(course::Bundled::kCourses, "1-straight");
  messages::RunContext run_context;
  run_context.course =
      std::make_shared<const course::Course>(course::parse_course(file.text, file.path));
  return run_context;
}

class TopicMessagesTest : public testing::Test {
 protected:
  /// The topics of one more step, 5 ms later.
  std::vector<Topic> step(const std::function<void(StepRecord&)>& edit = [](StepRecord&) {}) {
    record_.now_ns += 5 * kNsPerMs;
    record_.inputs.samples.resize(0);
    record_.inputs.session = SessionState::kReady;
    edit(record_);
    std::vector<Topic> sent;
    messages_.take(record_, [&](Topic topic, Bytes cdr) {
      sent.push_back(topic);
      last_[topic] = std::move(cdr);
    });
    return sent;
  }
  static void add_sample(StepRecord& record) {
    record.inputs.samples.push(
        {.measured_ns = record.now_ns - 2 * kNsPerMs, .battery_v = 7.5, .imu_age = 0});
    record.snapshot.sample = record.inputs.samples[0];
    record.snapshot.has_sample = true;
  }
  template <class Message>
  Message last(Topic topic) const {
    return deserialized<Message>(last_.at(topic)).value();
  }

  TopicMessages messages_{on_course_one(), {.start_ns = 0, .start_unix_ns = 5 * kNsPerS}, false};
  StepRecord record_;
  std::map<Topic, Bytes> last_;
};

TEST_F(TopicMessagesTest, AStepHasWhatItsSamplesMeasured) {
  step();
  EXPECT_THAT(step(), IsEmpty());
  EXPECT_THAT(step(add_sample),
              ElementsAre(Topic::kImu, Topic::kOdometry, Topic::kTransforms, Topic::kFusedPose,
                          Topic::kJointStates, Topic::kBatteryState));
  // An old value of the IMU is no new measurement.
  EXPECT_THAT(
      step([](StepRecord& record) {
        add_sample(record);
        record.inputs.samples[0].imu_age = 1;
      }),
      ElementsAre(Topic::kOdometry, Topic::kTransforms, Topic::kFusedPose, Topic::kJointStates));
  EXPECT_THAT(step([](StepRecord& record) {
                add_sample(record);
                add_sample(record);
              }),
              ElementsAre(Topic::kImu, Topic::kImu, Topic::kOdometry, Topic::kTransforms,
                          Topic::kFusedPose, Topic::kJointStates));
}

// What the answer says: tests/npm/ros2_start_test.mjs.
TEST_F(TopicMessagesTest, TheStateComesWithEachAnswerAndEachSetup) {
  step(add_sample);
  EXPECT_THAT(step(), IsEmpty());
  messages_.answer({});
  EXPECT_THAT(step(), ElementsAre(Topic::kState));
  EXPECT_THAT(step(), IsEmpty());
  messages_.exchange(on_course_one());
  EXPECT_THAT(step(), ElementsAre(Topic::kState));
}

/// The covariance as ROS has it: of x, y, z, roll, pitch and yaw.
using Matrix = std::array<double, 36>;
Matrix ros(const PlanarCovariance& planar) {
  Matrix matrix{};
  matrix[0] = planar.xx;
  matrix[1] = matrix[6] = planar.xy;
  matrix[5] = matrix[30] = planar.x_yaw;
  matrix[7] = planar.yy;
  matrix[11] = matrix[31] = planar.y_yaw;
  matrix[35] = planar.yaw_yaw;
  matrix[14] = matrix[21] = matrix[28] = 1e6;
  return matrix;
}

TEST_F(TopicMessagesTest, CovariancesAreTheEstimatorsAndZRollAndPitchAreUnknown) {
  const PlanarCovariance pose{1.0, 0.2, 0.3, 2.0, 0.4, 3.0}, twist{4.0, 0.5, 0.6, 5.0, 0.7, 6.0},
      fused{7.0, 0.8, 0.9, 8.0, 1.1, 9.0};
  step([&](StepRecord& record) {
    add_sample(record);
    record.snapshot.estimates[PoseSource::kOdometry].covariance = pose;
    record.snapshot.odometry_twist_covariance = twist;
    record.snapshot.estimates[PoseSource::kFused].covariance = fused;
  });
  const auto odometry = last<nav_msgs::Odometry>(Topic::kOdometry);
  EXPECT_EQ(odometry.pose.covariance, ros(pose));
  EXPECT_EQ(odometry.twist.covariance, ros(twist));
  const auto seen = last<geometry_msgs::PoseWithCovarianceStamped>(Topic::kFusedPose);
  EXPECT_EQ(seen.pose.covariance, ros(fused));
}

TEST_F(TopicMessagesTest, TheImuHasTheNoiseOfItsDataSheet) {
  step(add_sample);
  const auto imu = last<sensor_msgs::Imu>(Topic::kImu);
  for (std::size_t i = 0; i < 9; ++i) {
    const bool own = i % 4 == 0;
    EXPECT_NEAR(std::sqrt(imu.angular_velocity_covariance[i]), own ? 0.04 * kRadPerDeg : 0.0, 5e-5);
    EXPECT_NEAR(std::sqrt(imu.linear_acceleration_covariance[i]), own ? 0.0326 : 0.0, 1e-4);
  }
}

TEST_F(TopicMessagesTest, OnlyVirtualTimeHasAClockAndOnlyACourseAPath) {
  std::vector<Topic> sent;
  const auto collect = [&](Topic topic, const Bytes&) { sent.push_back(topic); };
  TopicMessages(on_course_one(), {}, true).take(record_, collect);
  EXPECT_THAT(sent, testing::Contains(Topic::kClock));
  EXPECT_THAT(step(add_sample), testing::Not(testing::Contains(Topic::kClock)));
  sent.clear();
  messages_.begin(0, collect);
  EXPECT_THAT(sent, ElementsAre(Topic::kRobotDescription, Topic::kStaticTransforms, Topic::kPath));
  sent.clear();
  TopicMessages({}, {}, false).begin(0, collect);
  EXPECT_THAT(sent, ElementsAre(Topic::kRobotDescription, Topic::kStaticTransforms));
}

TEST(RobotDescription, HasANameThatXmlAllows) {
  course::Robot robot;
  robot.name = "a<b";
  EXPECT_THAT(robot_description(robot), HasSubstr("<robot name=\"a_b\">"));
}

TEST(Participant, RefusesWhatItCannotUseInOneLine) {
  const auto refusal = [](const config::Ros2Settings& settings) {
    return test::refusal([&] { Participant(settings, "test", kLiveTopics); });
  };
  const std::string why = refusal({.enabled = true, .domain = 0, .interface = "no\"such"});
  if (why.find("without Cyclone DDS") != std::string::npos) {
    EXPECT_THAT(why, HasSubstr("scripts/build installs"));
    return;
  }
  EXPECT_THAT(why, HasSubstr("not a network interface"));
  const std::string missing = refusal({.enabled = true, .domain = 0, .interface = "none0"});
  EXPECT_THAT(missing, HasSubstr("none0"));
  EXPECT_THAT(missing, HasSubstr("check ros2.interface"));
  EXPECT_THAT(missing, testing::Not(HasSubstr("\n")));
  ::setenv("ROS_DOMAIN_ID", "233", 1);
  EXPECT_THAT(refusal({.enabled = true}), HasSubstr("ROS_DOMAIN_ID=233: not a domain"));
  ::unsetenv("ROS_DOMAIN_ID");
}

}  // namespace
}  // namespace tp100::ros2
