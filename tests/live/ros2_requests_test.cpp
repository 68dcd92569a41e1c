// Starts of the robot over ROS 2, and STOP. Driving: tests/robot/hand_drive_test.cpp.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <utility>

#include "../server/fake_controls.h"
#include "live/ros2_node.h"
#include "ros2/message_types.h"

namespace tp100::live {
namespace {

using ::testing::HasSubstr;
using ::testing::IsEmpty;

/// Controls that answer choices when the test says so.
class SlowControls : public server::FakeControls {
 public:
  void choose(const server::SetupChoice& choice, server::Answer answer) override {
    choices.push_back(choice);
    answers.push_back(std::move(answer));
  }
  std::vector<server::Answer> answers;
};

class Ros2RequestsTest : public ::testing::Test {
 protected:
  Ros2RequestsTest() { step(); }

  /// A step of the robot, 5 ms later.
  void step(const std::function<void(StepRecord&)>& edit = [](StepRecord&) {}) {
    now_ += 5 * kNsPerMs;
    record_.now_ns = now_;
    record_.inputs.requests.resize(0);
    edit(record_);
    requests_.observe(record_, now_);
  }
  void wait(HostNs ns) {
    for (const HostNs end = now_ + ns; now_ < end;) step();
  }
  void refuse_starts(StartRefusal why) {
    step([&](StepRecord& record) {
      record.snapshot.start_refusal = record.snapshot.drive_refusal = why;
    });
  }
  template <class Message>
  void send(ros2::Input input, const Message& message, HostNs age_ns = 0,
            std::uint64_t writer = 1) {
    const Bytes cdr = ros2::serialized(message);
    requests_.take({.input = input,
                    .writer = writer,
                    .written_ns = kNsPerS * 1'000 + now_ - age_ns,
                    .taken_ns = kNsPerS * 1'000 + now_,
                    .cdr = cdr},
                   now_);
  }
  void send_goal(double x_m, double y_m, HostNs age_ns = 0) {
    ros2::geometry_msgs::PoseStamped goal{.header = {.frame_id = "map"}};
    goal.pose = {.position = {.x = x_m, .y = y_m}, .orientation = {.w = 1.0}};
    send(ros2::Input::kGoal, goal, age_ns);
  }
  void send_course(const std::string& name) {
    send(ros2::Input::kCourse, ros2::std_msgs::String{.data = name});
  }
  /// Answers the choice: it is in force, or refused.
  void answer(const std::string& course, const std::string& why = "") {
    if (why.empty()) requests_.set_course(course);
    std::exchange(controls_.answers.back(), {})(why, "{}");
  }
  /// Messages since the last call.
  std::string take_messages() {
    std::string text;
    for (const auto& [event, log_only] : events_.drain()) text += event.text + "\n";
    return text;
  }

  SlowControls controls_;
  messages::EventQueue events_;
  int stops_ = 0;
  Ros2Requests requests_{controls_, events_, [this] { ++stops_; }};
  StepRecord record_;
  HostNs now_ = 0;
};

TEST_F(Ros2RequestsTest, AGoalChoosesTheCourseToItAndACourseIsStartedByItsName) {
  step([](StepRecord& record) { record.snapshot.world = {.x_m = 0.5, .yaw_rad = 1.0}; });
  send_goal(1.0, 2.0);
  ASSERT_EQ(controls_.choices.size(), 1u);
  ASSERT_TRUE(controls_.choices[0].goal);
  EXPECT_EQ(controls_.choices[0].goal->from.x_m, 0.5);
  EXPECT_EQ(controls_.choices[0].goal->to.y_m, 2.0);
  step();
  EXPECT_EQ(controls_.continues, 0) << "the course is not in force yet";
  answer("goal");
  step();
  EXPECT_EQ(controls_.continues, 1) << "from where it stands";
  EXPECT_EQ(take_messages(), "ROS 2 /goal_pose starts the robot\n");
  wait(Ros2Requests::kSilenceNs);
  EXPECT_EQ(controls_.continues, 1);
  send_course("1-sharp");
  EXPECT_EQ(controls_.choices.at(1).course, "1-sharp");
  answer("1-sharp");
  step();
  EXPECT_EQ(controls_.starts, 1);
  const auto answered = requests_.take_answer();
  ASSERT_TRUE(answered);
  EXPECT_EQ(answered->text, "ROS 2 /tp100/course starts the robot");
  EXPECT_EQ(answered->level, messages::Event::Level::kInfo);
  EXPECT_FALSE(requests_.take_answer());
}

TEST_F(Ros2RequestsTest, WhatCannotBeStartedIsRefusedWithTheReason) {
  send_goal(9.0, 0.0);
  answer("goal", "goal.toml:7:1: the path leaves the fence at (1.800, 0.000) m");
  step();
  EXPECT_EQ(take_messages(),
            "ROS 2: /goal_pose refused: the path leaves the fence at (1.800, 0.000) m\n");
  EXPECT_EQ(requests_.take_answer()->level, messages::Event::Level::kWarning);
  send_course("1-shrap");
  answer("", "1-shrap: no such course; did you mean '1-sharp'?");
  wait(kNsPerS);
  const std::size_t chosen = controls_.choices.size();
  send_course("");
  wait(Ros2Requests::kSilenceNs);
  take_messages();
  // Where the page's start is refused, too, nothing is chosen.
  refuse_starts(StartRefusal::kNoSession);
  send_goal(1.0, 0.0);
  EXPECT_EQ(take_messages(), "ROS 2: /goal_pose refused: no robot yet\n");
  refuse_starts(StartRefusal::kDriven);
  send_course("3");
  step([](StepRecord& record) { record.snapshot.run_state = RunState::kRunning; });
  wait(kNsPerS);
  send_course("3");
  // Nor by a message that came late.
  step([](StepRecord& record) { record.snapshot.run_state = RunState::kIdle; });
  refuse_starts(StartRefusal::kNone);
  wait(Ros2Requests::kSilenceNs);
  send_goal(1.0, 0.0, 3 * kNsPerS);
  EXPECT_THAT(take_messages(),
              HasSubstr("/goal_pose refused: sent 3.0 s ago by the clock of its sender"));
  EXPECT_EQ(controls_.choices.size(), chosen);
  EXPECT_EQ(controls_.starts, 0);
}

TEST_F(Ros2RequestsTest, AStartThatCannotBeginSoonIsRefused) {
  send_course("3");
  answer("3");
  refuse_starts(StartRefusal::kNotStill);
  wait(2 * kNsPerS);
  EXPECT_EQ(controls_.starts, 0);
  EXPECT_EQ(take_messages(), "");
  wait(2 * kNsPerS);
  EXPECT_EQ(take_messages(),
            "ROS 2: /tp100/course refused: the gyro is not still; leave the robot at rest for a "
            "second\n");
  refuse_starts(StartRefusal::kNone);
  wait(kNsPerS);
  EXPECT_EQ(controls_.starts, 0);
  // Sooner, it begins.
  wait(2 * kNsPerS);
  send_course("3");
  answer("3");
  refuse_starts(StartRefusal::kNotStill);
  wait(kNsPerS);
  refuse_starts(StartRefusal::kNone);
  EXPECT_EQ(controls_.starts, 1);
}

// Like after a STOP, repeated requests of a node must not start the robot again.
TEST_F(Ros2RequestsTest, AMessageThatIsRepeatedStartsOnce) {
  for (int i = 0; i < 60; ++i) {
    send_goal(1.0, 0.0);
    if (i == 0) answer("goal");
    wait(kNsPerS);
  }
  EXPECT_EQ(controls_.choices.size(), 1u);
  EXPECT_EQ(controls_.continues, 1);
  EXPECT_THAT(take_messages(), HasSubstr("/goal_pose is repeated and starts nothing"));
  wait(Ros2Requests::kSilenceNs);
  send_goal(1.0, 0.0);
  EXPECT_EQ(controls_.choices.size(), 2u);
}

TEST_F(Ros2RequestsTest, AStartIsOfItsOwnCourseAndPlaceOnly) {
  send_course("3");
  answer("3");
  requests_.set_course("2");
  step();
  EXPECT_THAT(take_messages(), HasSubstr("another course was chosen meanwhile"));
  send_goal(1.0, 0.0);
  answer("goal");
  step([](StepRecord& record) { record.snapshot.world.x_m += 0.02; });
  EXPECT_EQ(controls_.starts, 0);
  // The answer to an earlier request does not count for the present one.
  wait(Ros2Requests::kSilenceNs);
  send_course("3");
  step([](StepRecord& record) { record.inputs.requests.push(OperatorRequest::kHold); });
  wait(Ros2Requests::kSilenceNs);
  send_course("3");
  requests_.set_course("3");
  controls_.answers.at(2)("", "{}");
  wait(kNsPerS);
  EXPECT_EQ(controls_.starts, 0);
  answer("3");
  step();
  EXPECT_EQ(controls_.starts, 1);
}

TEST_F(Ros2RequestsTest, AStopNeedsNoMessageThatIsRightAndEndsAStart) {
  send_course("3");
  send(ros2::Input::kStop, ros2::std_msgs::String{.data = "not empty"});
  answer("3");
  wait(kNsPerS);
  EXPECT_EQ(controls_.stops, 1);
  EXPECT_EQ(controls_.starts, 0);
  EXPECT_EQ(stops_, 1);
  requests_.take({.input = ros2::Input::kStop}, now_);
  EXPECT_EQ(controls_.stops, 2);
  requests_.take({.input = ros2::Input::kStop, .gone = true}, now_);
  EXPECT_EQ(controls_.stops, 2);
  EXPECT_THAT(take_messages(), HasSubstr("/tp100/stop: STOP"));
}

// A node of another machine whose clock is wrong would drive with a delay that nobody sees.
TEST_F(Ros2RequestsTest, AVelocityCountsByItsTimeOnly) {
  for (const bool wanted : {false, true})
    send(ros2::Input::kDrive, ros2::std_msgs::Bool{.data = wanted});
  const auto velocity = [&](HostNs age_ns) {
    ros2::geometry_msgs::Twist twist{};
    twist.linear.x = 0.1;
    send(ros2::Input::kVelocity, twist, age_ns);
  };
  wait(kNsPerS);
  velocity(40 * kNsPerMs);
  ASSERT_EQ(controls_.inputs.size(), 1u);
  EXPECT_EQ(controls_.inputs[0].at_ns, now_ - 40 * kNsPerMs);
  take_messages();
  for (const HostNs wrong : {-kNsPerS, 3 * kNsPerS}) {
    velocity(wrong);
    EXPECT_THAT(take_messages(), HasSubstr("synchronise both machines' clocks"));
    wait(kNsPerS);
  }
  EXPECT_EQ(controls_.inputs.size(), 1u);
  velocity(400 * kNsPerMs);
  EXPECT_THAT(take_messages(), HasSubstr("0.4 s old by this machine's clock"));
}

// Another node's release must not make a stream of true take the lease, after a STOP least of all.
TEST_F(Ros2RequestsTest, TrueTakesTheWheelOnlyAfterTheSameNodesFalseAndAfterAStopWasSeen) {
  const auto say = [&](std::uint64_t writer, bool wanted) {
    send(ros2::Input::kDrive, ros2::std_msgs::Bool{.data = wanted}, 0, writer);
  };
  say(1, true);
  EXPECT_THAT(take_messages(), HasSubstr("send false, then true"));
  say(2, false);
  say(1, true);
  EXPECT_TRUE(controls_.consents.empty());
  say(2, true);
  ASSERT_EQ(controls_.consents.size(), 1u);
  say(2, false);
  controls_.stop();
  wait(kNsPerS / 2);
  say(2, true);
  EXPECT_EQ(controls_.consents.back().stops_seen, 0u) << "half a second is too short to look";
  say(2, false);
  wait(kNsPerS);
  say(2, true);
  EXPECT_EQ(controls_.consents.back().stops_seen, 1u);
}

TEST_F(Ros2RequestsTest, WhatIsRefusedAgainAndAgainIsSaidOnceASecondAndHidesNoOtherTopic) {
  for (int i = 0; i < 1'000; ++i) {
    requests_.take({.input = ros2::Input::kGoal, .writer = 1}, now_);
    step();
  }
  send_course("");
  const std::string all = take_messages();
  EXPECT_EQ(std::count(all.begin(), all.end(), '\n'), 6);
  EXPECT_THAT(all, HasSubstr("/goal_pose refused: no geometry_msgs/msg/PoseStamped"));
  EXPECT_THAT(all, HasSubstr("/tp100/course refused"));
}

}  // namespace
}  // namespace tp100::live
