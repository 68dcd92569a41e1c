// What is said to a world and believed of it: hellos, poses, sessions, and every false answer.

#include "worlds/peer.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <nlohmann/json.hpp>
#include <random>

#include "../support/corrupted.h"

namespace tp100::worlds {
namespace {

using ::testing::HasSubstr;
using Json = nlohmann::json;

constexpr std::uint16_t kPort = 40000;

// A bridge at 200 Hz and a world whose answers the test supplies.
class PeerTest : public ::testing::Test {
 protected:
  explicit PeerTest(Authority authority = Authority::kBridge) : peer_(settings(authority)) {}
  static PeerSettings settings(Authority authority) {
    PeerSettings out;
    out.hello.session = 100;
    out.hello.authority = authority;
    out.surfaces = {{"sand", 0.2}};
    return out;
  }
  // Makes one step; returns the message that was sent.
  Json step() {
    now_ += 5 * kNsPerMs;
    record_->now_ns = now_;
    ++record_->step;
    const auto sent = peer_.step(*record_, now_);
    return sent ? Json::parse(*sent) : Json();
  }
  Json step_until(const char* type) {
    for (int i = 0; i < 200; ++i)
      if (const Json sent = step(); sent.is_object() && sent["type"] == type) return sent;
    ADD_FAILURE() << "no " << type;
    return {};
  }
  std::optional<WorldSample> say(const Json& message, std::uint16_t port = kPort) {
    return peer_.receive(message.dump(), port, now_);
  }
  void welcome() {
    const Json hello = step_until("hello");
    say({{"v", 1}, {"type", "welcome"}, {"session", hello["session"]}, {"name", "test"}});
    ASSERT_TRUE(peer_.welcomed());
  }
  static Json answer(std::uint64_t seq, std::uint64_t ack) {
    return {{"v", 1}, {"type", "world"}, {"seq", seq}, {"ack", ack}};
  }

  std::unique_ptr<StepRecord> record_ = std::make_unique<StepRecord>();
  Peer peer_;
  HostNs now_ = kNsPerS;
};

TEST_F(PeerTest, SaysHelloFourTimesASecondUntilWelcomedByWhoGotIt) {
  int hellos = 0;
  for (int i = 0; i < 400; ++i) {
    const Json sent = step();
    if (!sent.is_object()) continue;
    ++hellos;
    EXPECT_EQ(sent["type"], "hello");
    say({{"v", 1}, {"type", "welcome"}, {"session", 1 + sent["session"].get<int>()}});
    EXPECT_FALSE(peer_.welcomed());
  }
  EXPECT_EQ(hellos, 8);
  EXPECT_EQ(peer_.counters().foreign, 8u);
}

// A world that moves its robot by the track speeds goes as far as the tracks did, however coarse
// the encoders are: at 100 poses and 200 steps a second it does not see every step.
TEST_F(PeerTest, PosesGoOutAtTheirRateWithMeansOfTheTrackSpeedsAndAreAnswered) {
  welcome();
  step_until("pose");
  std::uint64_t seq = 0;
  double left_m = 0.0, right_m = 0.0, sent_left_m = 0.0, sent_right_m = 0.0;
  for (int i = 0; i < 400; ++i) {
    record_->snapshot.left_mps = i % 2 == 0 ? 0.2 : 0.0;
    record_->snapshot.right_mps = i % 3 == 0 ? 0.3 : 0.0;
    left_m += record_->snapshot.left_mps * 0.005;
    right_m += record_->snapshot.right_mps * 0.005;
    const Json sent = step();
    if (!sent.is_object()) continue;
    sent_left_m += sent["tracks"]["l"].get<double>() * 0.010;
    sent_right_m += sent["tracks"]["r"].get<double>() * 0.010;
    const HostNs stepped = now_;
    now_ += kNsPerMs;
    const auto sample = say(answer(++seq, sent["seq"]));
    ASSERT_TRUE(sample);
    EXPECT_EQ(sample->answered_ns, stepped);
    EXPECT_EQ(sample->session, 1u);
    now_ -= kNsPerMs;
  }
  EXPECT_NEAR(sent_left_m, left_m, 1e-6);
  EXPECT_NEAR(sent_right_m, right_m, 1e-4);
  step();
  const auto frozen = say(answer(++seq, peer_.sent()));
  ASSERT_TRUE(frozen);
  EXPECT_LT(frozen->answered_ns, now_) << "an answer given again is none to a new pose";
  EXPECT_NEAR(static_cast<double>(peer_.counters().answered), 200.0, 1.0);
  EXPECT_NEAR(peer_.counters().mean_round_trip_ms, 1.0, 1e-9);
  EXPECT_EQ(peer_.counters().missing, 0u);
}

TEST_F(PeerTest, NamesThePoseThatSteersNow) {
  welcome();
  Snapshot& snapshot = record_->snapshot;
  for (const PoseSource steering : kPoseSources) {
    const double x_m = 1.0 + static_cast<double>(steering);
    snapshot.steering = steering;
    snapshot.estimates[steering].pose.x_m = x_m;
    const Json sent = step_until("pose");
    EXPECT_EQ(sent["src"], to_string(steering));
    EXPECT_EQ(sent["floor"]["pos"][0], x_m);
    EXPECT_EQ(sent["estimates"][to_string(steering)], sent["floor"]);
  }
}

TEST_F(PeerTest, SaysWhichGroundAndKnowsTheCoursesSurfaces) {
  welcome();
  Json message = answer(1, step_until("pose")["seq"]);
  message["ground"] = {{"z", 0.04}, {"pitch", -0.4}, {"surface", "sand"}};
  message["contact"] = {{"step", 0.037}, {"blocked", true}};
  message["cmd"] = {{"estop", true}};
  message["pose"] = {{"pos", {1, 2, 3}}, {"rpy", {0, 0, 0}}};
  auto sample = say(message);
  ASSERT_TRUE(sample && sample->has_ground);
  EXPECT_EQ(sample->slip_offset, 0.2);
  EXPECT_EQ(sample->height_m, 0.04);
  EXPECT_EQ(sample->pitch_rad, -0.4);
  EXPECT_EQ(sample->step_height_m, 0.037);
  EXPECT_TRUE(sample->blocked);
  EXPECT_TRUE(sample->stop);
  EXPECT_FALSE(sample->has_pose) << "the bridge has authority over the pose";
  message["seq"] = 2;
  message["ground"]["surface"] = "ice";
  sample = say(message);
  ASSERT_TRUE(sample);
  EXPECT_EQ(sample->slip_offset, 0.0);
  EXPECT_EQ(peer_.counters().unknown_surface, 1u);
}

struct OwnerTest : PeerTest {
  OwnerTest() : PeerTest(Authority::kWorld) {}
};

TEST_F(OwnerTest, AWorldThatOwnsThePoseGivesIt) {
  welcome();
  Json message = answer(1, step_until("pose")["seq"]);
  message["pose"] = {{"pos", {1, 2, 3}}, {"rpy", {0, 0, 0.5}}};
  const auto sample = say(message);
  ASSERT_TRUE(sample && sample->has_pose);
  EXPECT_EQ(sample->pose.y_m, 2.0);
  EXPECT_EQ(sample->pose.yaw_rad, 0.5);
}

TEST_F(PeerTest, CountsWhatNeverCameAndDropsWhatIsOld) {
  welcome();
  const Json first = step_until("pose");
  EXPECT_TRUE(say(answer(1, first["seq"])));
  const Json second = step_until("pose");
  EXPECT_TRUE(say(answer(5, second["seq"])));
  EXPECT_EQ(peer_.counters().missing, 3u);
  EXPECT_FALSE(say(answer(5, second["seq"])));
  EXPECT_FALSE(say(answer(3, second["seq"])));
  EXPECT_FALSE(say(answer(6, first["seq"]))) << "the answer is to an older pose";
  EXPECT_EQ(peer_.counters().reordered, 3u);
  EXPECT_FALSE(say(answer(6, second["seq"].get<std::uint64_t>() + 1))) << "the pose was never sent";
  EXPECT_EQ(peer_.counters().unknown_ack, 1u);
}

TEST_F(PeerTest, AnotherPortOrSessionOrAnEarlierTimeIsNotHeard) {
  welcome();
  Json message = answer(1, step_until("pose")["seq"]);
  EXPECT_FALSE(say(message, kPort + 1));
  message["session"] = 5;
  EXPECT_FALSE(say(message));
  EXPECT_EQ(peer_.counters().foreign, 2u);
  message["session"] = 100;
  message["timestamp"] = 10.0;
  EXPECT_TRUE(say(message));
  message["seq"] = 2;
  message["timestamp"] = 9.0;
  EXPECT_FALSE(say(message));
  EXPECT_EQ(peer_.counters().back_in_time, 1u);
}

TEST_F(PeerTest, ASilentWorldIsGreetedAnewAndBeginsAnotherSession) {
  welcome();
  EXPECT_TRUE(say(answer(50, step_until("pose")["seq"])));
  const Json hello = step_until("hello");
  EXPECT_EQ(peer_.counters().losses, 1u);
  EXPECT_THAT(peer_.take_note(), HasSubstr("silent"));
  EXPECT_EQ(hello["session"], 101);
  EXPECT_FALSE(say(answer(51, peer_.sent()))) << "the new session is not welcomed yet";
  welcome();
  const auto sample = say(answer(1, step_until("pose")["seq"]));
  ASSERT_TRUE(sample) << "its numbers begin again at 1";
  EXPECT_EQ(sample->session, 2u);
}

TEST_F(PeerTest, AnotherVersionIsAnsweredOnce) {
  const Json hello = step_until("hello");
  say({{"v", 2}, {"type", "welcome"}, {"session", hello["session"]}});
  const auto reply = peer_.take_reply();
  ASSERT_TRUE(reply);
  EXPECT_THAT(Json::parse(*reply)["text"].get<std::string>(), HasSubstr("not world/2"));
  for (int i = 0; i < 10; ++i) say({{"v", 2}, {"type", "world"}});
  EXPECT_FALSE(peer_.take_reply());
  EXPECT_EQ(peer_.counters().wrong_version, 11u);
}

TEST_F(PeerTest, AWorldOfAnotherFrameOrAuthorityIsToldSo) {
  Json answer = {{"v", 1}, {"type", "welcome"}, {"session", step_until("hello")["session"]}};
  for (const auto& [key, other] : {std::pair{"frame", "unreal"}, {"authority", "world"}}) {
    Json wrong = answer;
    wrong[key] = other;
    say(wrong);
    EXPECT_FALSE(peer_.welcomed()) << key;
  }
  const auto reply = peer_.take_reply();
  ASSERT_TRUE(reply);
  EXPECT_THAT(*reply, HasSubstr("world.frame ros and world.authority bridge"));
  answer["frame"] = "ros";
  answer["authority"] = "bridge";
  say(answer);
  EXPECT_TRUE(peer_.welcomed());
}

TEST_F(PeerTest, RunsAreCounted) {
  welcome();
  EXPECT_EQ(step_until("pose")["run"], 0);
  for (int run = 1; run < 4; ++run) {
    record_->snapshot.run_state = RunState::kRunning;
    step();
    EXPECT_EQ(step_until("pose")["run"], run);
    record_->snapshot.run_state = RunState::kAborted;
    EXPECT_EQ(step_until("pose")["run"], run);
  }
}

// Every datagram must be counted by exactly one counter, and every sample that is passed on must be
// in range.
TEST_F(PeerTest, SurvivesGarbage) {
  welcome();
  std::mt19937 random(11);
  for (int i = 0; i < 6000; ++i) {
    step();
    // A corrupted digit can make a sequence number so large that all later messages are old.
    if (!peer_.welcomed()) welcome();
    Json message = answer(static_cast<std::uint64_t>(i), peer_.sent());
    message["ground"] = {{"z", 0.041}, {"pitch", -0.489}, {"surface", "sand"}};
    message["contact"] = {{"step", 0.037}};
    const std::string text = message.dump();
    const auto sample =
        peer_.receive(i % 3 == 0 ? text : test::corrupted(text, i / 3, 5, random), kPort, now_);
    if (!sample) continue;
    EXPECT_LE(std::abs(sample->height_m), 100.0);
    EXPECT_LE(std::abs(sample->pitch_rad), 1.5708);
    EXPECT_TRUE(sample->step_height_m >= 0.0 && sample->step_height_m <= 1.0);
  }
  const PeerCounters& c = peer_.counters();
  EXPECT_EQ(c.received, c.accepted + c.malformed + c.wrong_version + c.foreign + c.reordered +
                            c.back_in_time + c.unknown_ack);
  EXPECT_GT(c.malformed, 0u);
  EXPECT_GT(c.accepted, 1000u);
}

}  // namespace
}  // namespace tp100::worlds
