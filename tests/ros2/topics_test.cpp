#include "ros2/topics.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <cstring>
#include <map>
#include <regex>
#include <utility>

#include "core/arithmetic.h"
#include "course/bundled_files.h"
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
  double number(Topic topic, std::size_t at) const {
    double value = 0.0;
    std::memcpy(&value, last_.at(topic).data() + at, sizeof value);
    return value;
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

TEST_F(TopicMessagesTest, ThePoseIsStampedWhenItsSampleWasMeasured) {
  step(add_sample);
  std::int32_t sec = 0;
  std::uint32_t nanosec = 0;
  std::memcpy(&sec, last_.at(Topic::kOdometry).data() + 4, 4);
  std::memcpy(&nanosec, last_.at(Topic::kOdometry).data() + 8, 4);
  EXPECT_EQ(sec, 5);
  EXPECT_EQ(nanosec, 3'000'000u);
}

TEST_F(TopicMessagesTest, StateAndBatteryComeOnceASecondAndTheStateAtAChange) {
  int states = 0, batteries = 0;
  const auto count = [&](const std::vector<Topic>& sent) {
    states += static_cast<int>(std::count(sent.begin(), sent.end(), Topic::kState));
    batteries += static_cast<int>(std::count(sent.begin(), sent.end(), Topic::kBatteryState));
  };
  for (int i = 0; i < 1000; ++i) count(step(add_sample));
  EXPECT_EQ(states, 5);
  EXPECT_EQ(batteries, 5);
  count(step([](StepRecord& record) { record.snapshot.run_state = RunState::kRunning; }));
  EXPECT_EQ(states, 6);
  count(
      step([](StepRecord& record) { record.snapshot.faults = fault_bit(Fault::stop_requested); }));
  EXPECT_EQ(states, 7);
}

TEST_F(TopicMessagesTest, TheStateHasTheLastAnswerAndComesWithEachNewOne) {
  const auto has = [&](const std::string& text) {
    const Bytes& cdr = last_.at(Topic::kState);
    return std::search(cdr.begin(), cdr.end(), text.begin(), text.end()) != cdr.end();
  };
  step(add_sample);
  EXPECT_FALSE(has("tp100d: answer"));
  step(add_sample);
  messages_.answer({.level = messages::Event::Level::kWarning, .text = "/goal_pose refused: why"});
  EXPECT_THAT(step(), ElementsAre(Topic::kState));
  EXPECT_TRUE(has("tp100d: answer") && has("/goal_pose refused: why"));
  EXPECT_THAT(step(), IsEmpty());
  messages_.change_setup(on_course_one());
  EXPECT_THAT(step(), ElementsAre(Topic::kState));
  EXPECT_TRUE(has("/goal_pose refused: why"));
}

/// A covariance of ROS from this number of a message on.
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

// `/odom`: header (4 + 8 + "odom"), child ("base_link"), then the pose from byte 44 on, its
// covariance from byte 100, the twist from byte 388 and its covariance from byte 436.
TEST_F(TopicMessagesTest, CovariancesAreTheEstimatorsAndZRollAndPitchAreUnknown) {
  const PlanarCovariance pose{1.0, 0.2, 0.3, 2.0, 0.4, 3.0}, twist{4.0, 0.5, 0.6, 5.0, 0.7, 6.0},
      fused{7.0, 0.8, 0.9, 8.0, 1.1, 9.0};
  step([&](StepRecord& record) {
    add_sample(record);
    record.snapshot.estimates[PoseSource::kOdometry].pose.x_m = 1.5;
    record.snapshot.estimates[PoseSource::kOdometry].twist.vx_mps = 2.5;
    record.snapshot.estimates[PoseSource::kOdometry].covariance = pose;
    record.snapshot.odometry_twist_covariance = twist;
    record.snapshot.estimates[PoseSource::kFused].covariance = fused;
  });
  const auto matrix = [this](Topic topic, std::size_t at) {
    Matrix found{};
    for (double& value : found) value = number(topic, std::exchange(at, at + sizeof value));
    return found;
  };
  ASSERT_EQ(number(Topic::kOdometry, 44), 1.5);
  EXPECT_EQ(matrix(Topic::kOdometry, 100), ros(pose));
  ASSERT_EQ(number(Topic::kOdometry, 388), 2.5);
  EXPECT_EQ(matrix(Topic::kOdometry, 436), ros(twist));
  // Header (4 + 8 + "map"), then the pose from byte 20 on.
  EXPECT_EQ(matrix(Topic::kFusedPose, 76), ros(fused));
}

// Header (4 + 8 + "imu_link"), orientation from byte 28 on, its covariance, then rates with
// theirs and accelerations with theirs.
TEST_F(TopicMessagesTest, TheImuHasTheMeasuredValuesTheNoiseOfItsDataSheetAndNoOrientation) {
  step([](StepRecord& record) {
    add_sample(record);
    record.inputs.samples[0].gyro_radps = {0.1, 0.2, 0.3};
    record.inputs.samples[0].accel_mps2 = {1.0, 2.0, 9.0};
  });
  EXPECT_EQ(number(Topic::kImu, 60), -1.0);
  constexpr std::size_t kRates = 60 + 72, kAccelerations = kRates + 24 + 72;
  constexpr std::array kMeasured = {0.1, 0.2, 0.3, 1.0, 2.0, 9.0};
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_NEAR(number(Topic::kImu, kRates + 8 * i), kMeasured[i], 1e-6);
    EXPECT_NEAR(number(Topic::kImu, kAccelerations + 8 * i), kMeasured[i + 3], 1e-6);
  }
  for (std::size_t i = 0; i < 9; ++i) {
    const bool own = i % 4 == 0;
    EXPECT_NEAR(std::sqrt(number(Topic::kImu, kRates + 24 + 8 * i)), own ? 0.04 * kRadPerDeg : 0.0,
                5e-5);
    EXPECT_NEAR(std::sqrt(number(Topic::kImu, kAccelerations + 24 + 8 * i)), own ? 0.0326 : 0.0,
                1e-4);
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

TEST(RobotDescription, HasEveryLinkOnceAndJoinsAllOfThem) {
  course::Robot robot;
  robot.name = "a<b";
  const std::string urdf = robot_description(robot);
  EXPECT_THAT(urdf, HasSubstr("<robot name=\"a_b\">"));
  const auto names = [&](const char* pattern) {
    std::vector<std::string> found;
    const std::regex expression(pattern);
    for (std::sregex_iterator at(urdf.begin(), urdf.end(), expression), end; at != end; ++at)
      found.push_back((*at)[1]);
    return found;
  };
  EXPECT_THAT(names("<link name=\"([^\"]*)\""),
              ElementsAre(kBaseLink, kImuLink, "left_sprocket", "right_sprocket"));
  EXPECT_THAT(names("<joint name=\"([^\"]*)\""), ElementsAre("imu_joint", kLeftJoint, kRightJoint));
  EXPECT_THAT(names("<child link=\"([^\"]*)\""),
              ElementsAre(kImuLink, "left_sprocket", "right_sprocket"));
  // Left is positive y.
  EXPECT_THAT(
      urdf, HasSubstr("<child link=\"left_sprocket\"/>\n    <origin xyz=\"0.0665 0.0775 0.026\""));
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
