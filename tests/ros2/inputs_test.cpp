// What nodes of ROS 2 send. Messages of any bytes: tests/fuzz/ros2_fuzz.cpp.
#include "ros2/inputs.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <deque>
#include <limits>

#include "core/arithmetic.h"
#include "ros2/message_types.h"

namespace tp100::ros2 {
namespace {

using testing::HasSubstr;

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

class InputsTest : public testing::Test {
 protected:
  template <class Message>
  Received received(Input input, const Message& message) {
    return {.input = input,
            .writer = 7,
            .written_ns = 5 * kNsPerS,
            .cdr = bytes_.emplace_back(serialized(message))};
  }
  static geometry_msgs::PoseStamped goal(double x_m, double yaw_rad,
                                         const std::string& frame = "map") {
    geometry_msgs::PoseStamped out{.header = {.frame_id = frame}};
    out.pose.position.x = x_m;
    out.pose.orientation = {.z = std::sin(yaw_rad / 2), .w = std::cos(yaw_rad / 2)};
    return out;
  }
  static geometry_msgs::PoseWithCovarianceStamped pose(double x_m, double yaw_rad,
                                                       const std::string& frame = "map") {
    geometry_msgs::PoseWithCovarianceStamped out{.header = {.frame_id = frame}};
    out.pose.pose = goal(x_m, yaw_rad).pose;
    return out;
  }
  std::deque<Bytes> bytes_;  // of all messages
  std::string why_;
};

TEST_F(InputsTest, AVelocityIsAsOldAsItsMessageOrItsStamp) {
  const geometry_msgs::Twist twist{.linear = {.x = 0.1}, .angular = {.z = -0.5}};
  auto wanted = read_velocity(received(Input::kVelocity, twist), why_);
  ASSERT_TRUE(wanted) << why_;
  EXPECT_EQ(wanted->speed_mps, 0.1);
  EXPECT_EQ(wanted->yaw_rate_radps, -0.5);
  EXPECT_EQ(wanted->stamp_ns, 5 * kNsPerS);
  geometry_msgs::TwistStamped stamped{.twist = twist};
  wanted = read_velocity(received(Input::kVelocityStamped, stamped), why_);
  ASSERT_TRUE(wanted) << why_;
  EXPECT_EQ(wanted->stamp_ns, 5 * kNsPerS) << "a stamp of 0 is none";
  stamped.header = {.stamp = {.sec = 3, .nanosec = 4}, .frame_id = "base_link"};
  wanted = read_velocity(received(Input::kVelocityStamped, stamped), why_);
  ASSERT_TRUE(wanted) << why_;
  EXPECT_EQ(wanted->yaw_rate_radps, -0.5);
  EXPECT_EQ(wanted->stamp_ns, 3 * kNsPerS + 4);
}

TEST_F(InputsTest, AVelocityThatIsNotFiniteOrHasNoTimeIsRefused) {
  const auto refused = [&](const geometry_msgs::Twist& twist) {
    return !read_velocity(received(Input::kVelocity, twist), why_);
  };
  for (const double bad : {kNan, std::numeric_limits<double>::infinity(), -101.0}) {
    EXPECT_TRUE(refused({.linear = {.x = bad}})) << bad;
    EXPECT_TRUE(refused({.angular = {.z = bad}})) << bad;
  }
  EXPECT_TRUE(refused({.linear = {.y = kNan}}));
  EXPECT_THAT(why_, HasSubstr("not finite"));
  for (const std::int64_t bad :
       {std::int64_t{0}, std::int64_t{-1}, std::numeric_limits<std::int64_t>::max()}) {
    Received message = received(Input::kVelocity, geometry_msgs::Twist{});
    message.written_ns = bad;
    EXPECT_FALSE(read_velocity(message, why_)) << bad;
  }
}

TEST_F(InputsTest, AnInitialPoseOrAGoalIsAPoseOfTheMap) {
  const auto both = [&](double x_m, double yaw_rad, const std::string& frame = "map") {
    return std::array{received(Input::kInitialPose, pose(x_m, yaw_rad, frame)),
                      received(Input::kGoal, goal(x_m, yaw_rad, frame))};
  };
  for (const char* frame : {"map", ""}) {
    for (const Received& message : both(1.5, -3.0, frame)) {
      const auto at = read_pose(message, why_);
      ASSERT_TRUE(at) << why_;
      EXPECT_EQ(at->x_m, 1.5);
      EXPECT_NEAR(at->yaw_rad, -3.0, 1e-12);
    }
  }
  for (const std::string& frame : {std::string("odom"), std::string("/map"), std::string("od\nom"),
                                   std::string("map\0", 4), std::string(9999, 'm')}) {
    for (const Received& message : both(1.5, 0.0, frame)) {
      EXPECT_FALSE(read_pose(message, why_));
      EXPECT_THAT(why_, HasSubstr("give it in 'map'"));
      EXPECT_THAT(why_, testing::Not(HasSubstr("\n")));
      EXPECT_LT(why_.size(), 120u);
    }
  }
  for (const double bad : {kNan, std::numeric_limits<double>::infinity(), -1e300, 101.0}) {
    for (const Received& message : both(bad, 0.0)) EXPECT_FALSE(read_pose(message, why_)) << bad;
    auto turned = goal(0.0, 0.0);
    turned.pose.orientation.x = bad;
    EXPECT_FALSE(read_pose(received(Input::kGoal, turned), why_)) << bad;
  }
  auto no_rotation = goal(0.0, 0.0);
  no_rotation.pose.orientation = {};
  EXPECT_FALSE(read_pose(received(Input::kGoal, no_rotation), why_));
  // Another type with the same name.
  EXPECT_FALSE(read_pose(received(Input::kGoal, pose(0.0, 0.0)), why_));
  EXPECT_EQ(why_, "no geometry_msgs/msg/PoseStamped in little-endian CDR");
}

TEST_F(InputsTest, ACourseHasANameOf64CharactersAtMost) {
  const auto name_of = [&](const std::string& name) {
    return read_course(received(Input::kCourse, std_msgs::String{.data = name}), why_);
  };
  ASSERT_TRUE(name_of("1-sharp"));
  EXPECT_EQ(name_of("1-sharp")->name, "1-sharp");
  EXPECT_EQ(name_of("1-sharp")->request, OperatorRequest::kStart);
  EXPECT_EQ(name_of("1-sharp/here")->name, "1-sharp");
  EXPECT_EQ(name_of("1-sharp/here")->request, OperatorRequest::kContinue);
  EXPECT_EQ(name_of("1-sharp/start")->request, OperatorRequest::kStartPlaced);
  EXPECT_FALSE(name_of("/start"));
  EXPECT_TRUE(name_of(std::string(64, 'a')));
  for (const std::string& bad : {std::string(), std::string(65, 'a'), std::string(1 << 20, 'a')}) {
    EXPECT_FALSE(name_of(bad));
    EXPECT_EQ(why_, "the name of a course has 1 to 64 characters");
  }
  EXPECT_FALSE(read_course(received(Input::kCourse, std_msgs::Bool{}), why_));
}

TEST_F(InputsTest, AMarkIsOneShortLine) {
  const auto text_of = [&](const std::string& text) {
    return read_mark(received(Input::kMark, std_msgs::String{.data = text}), why_);
  };
  EXPECT_EQ(text_of("slips here"), "slips here");
  EXPECT_EQ(text_of(""), "mark");
  EXPECT_FALSE(text_of("two\nlines"));
  EXPECT_FALSE(text_of(std::string(81, 'a')));
}

TEST_F(InputsTest, AStartIsAtMostTwoSecondsOld) {
  Received message = received(Input::kCourse, std_msgs::String{.data = "3"});
  const auto in_time_after = [&](std::int64_t ns) {
    message.taken_ns = message.written_ns + ns;
    return in_time(message, why_);
  };
  EXPECT_TRUE(in_time_after(0));
  EXPECT_TRUE(in_time_after(kMaxAgeNs));
  EXPECT_TRUE(in_time_after(-kMaxAgeNs));
  EXPECT_FALSE(in_time_after(-kMaxAgeNs - 1));
  EXPECT_FALSE(in_time_after(7 * kNsPerS));
  EXPECT_THAT(why_, HasSubstr("sent 7.0 s ago"));
  for (const std::int64_t bad : {std::int64_t{0}, std::numeric_limits<std::int64_t>::min(),
                                 std::numeric_limits<std::int64_t>::max()}) {
    message.written_ns = bad;
    EXPECT_FALSE(in_time(message, why_)) << bad;
  }
}

/// A value of every kind that CDR has.
diagnostic_msgs::DiagnosticArray everything() {
  return {.header = {.stamp = {.sec = -1, .nanosec = 2}, .frame_id = "map"},
          .status = {{.level = 1,
                      .name = "",
                      .message = "two",
                      .values = {{.key = "a", .value = "b"}, {.key = "cd", .value = ""}}},
                     {.level = 2}}};
}

TEST(CdrReading, RefusesEveryTruncationAndWhatIsTooLongOrOfAnotherEncoding) {
  Bytes bytes = serialized(everything());
  const std::size_t whole = bytes.size();
  const auto reads = [&] {
    return deserialized<diagnostic_msgs::DiagnosticArray>(bytes).has_value();
  };
  // DDS may add up to three bytes of padding.
  for (std::size_t size = whole + 4;; --size) {
    bytes.resize(size);
    EXPECT_EQ(reads(), size >= whole && size < whole + 4) << size;
    if (size == 0) break;
  }
  bytes = serialized(everything());
  for (int i = 0; i < 256; ++i) {
    bytes[1] = static_cast<std::uint8_t>(i);
    EXPECT_EQ(reads(), i == 1) << i;
  }
  bytes[1] = bytes[0] = 1;
  EXPECT_FALSE(reads());
}

TEST(CdrReading, RefusesLengthsThatTheBytesDoNotHave) {
  // Text and sequence of 4 GB; a text without its zero; a truth value of 2.
  EXPECT_FALSE(deserialized<std_msgs::String>(Bytes{0, 1, 0, 0, 255, 255, 255, 255, 'a', 0, 0, 0}));
  EXPECT_FALSE(
      deserialized<tf2_msgs::TFMessage>(Bytes{0, 1, 0, 0, 255, 255, 255, 255, 1, 2, 3, 4}));
  EXPECT_FALSE(deserialized<std_msgs::String>(Bytes{0, 1, 0, 0, 2, 0, 0, 0, 'a', 'b'}));
  EXPECT_TRUE(deserialized<std_msgs::String>(Bytes{0, 1, 0, 0, 2, 0, 0, 0, 'a', 0}));
  EXPECT_FALSE(deserialized<std_msgs::Bool>(Bytes{0, 1, 0, 0, 2}));
  EXPECT_TRUE(deserialized<std_msgs::Bool>(Bytes{0, 1, 0, 0, 1}));
}

}  // namespace
}  // namespace tp100::ros2
