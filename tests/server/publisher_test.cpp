// When the publisher sends which message, and how long a STOP took.
#include "server/publisher.h"

#include <gtest/gtest.h>

#include <memory>
#include <vector>

#include "request_rig.h"

namespace tp100::server {
namespace {

class PublisherTest : public RequestHandlerTest {
 protected:
  PublisherTest() {
    subscribe_to_all(*viewer_);
    take();
  }
  void subscribe_to_all(Viewer& viewer) {
    Subscribe all;
    for (std::uint32_t i = 1; i <= messages::kChannelCount; ++i)
      all.subscriptions.push_back({i, i});
    broker_.subscribe(viewer, all);
  }
  std::vector<Json> take(messages::Channel wanted = messages::Channel::kClient) {
    std::vector<Json> out;
    while (const auto next = viewer_->outbox().pop()) {
      const WebSocketFrame& frame = *next;
      if (frame.binary && frame.head[1] == static_cast<std::uint32_t>(wanted))
        out.push_back(Json::parse(*frame.body));
    }
    return out;
  }
  /// Runs `seconds` of steps at 200 Hz with ticks in between; returns the messages of the channel.
  std::vector<Json> run(double seconds, messages::Channel wanted) {
    std::vector<Json> out;
    for (int i = 0; i < static_cast<int>(seconds * 200.0); ++i) {
      record_.now_ns += 5 * kNsPerMs;
      record_.step += 1;
      record_.link.samples += 1;
      record_.link.bytes_in += 44;
      record_.inputs.samples.resize(1);
      publisher_.take(record_);
      if (i % 10 == 0) publisher_.tick(record_.now_ns);
      for (Json& message : take(wanted)) out.push_back(std::move(message));
    }
    return out;
  }

  /// The last /state after `seconds` of steps.
  Json state(double seconds = 1.0) { return run(seconds, messages::Channel::kState).back(); }
  /// The messages of /state that the next step alone causes.
  std::vector<Json> next_states() {
    record_.now_ns += 5 * kNsPerMs;
    publisher_.take(record_);
    return take(messages::Channel::kState);
  }

  StepRecord record_ = messages::example_record();
};

TEST_F(PublisherTest, EveryChannelKeepsItsRate) {
  for (const messages::Channel channel :
       {messages::Channel::kEstimate, messages::Channel::kTransforms,
        messages::pose_channel(PoseSource::kModel), messages::pose_channel(PoseSource::kFused),
        messages::Channel::kSample, messages::Channel::kCommand})
    EXPECT_EQ(run(1.0, channel).size(), 200U);
  for (const auto& [channel, hz] :
       {std::pair(messages::Channel::kSlip, 20.0), std::pair(messages::Channel::kLink, 5.0),
        std::pair(messages::Channel::kLoop, 2.0), std::pair(messages::Channel::kState, 5.0)})
    EXPECT_NEAR(static_cast<double>(run(4.0, channel).size()), 4.0 * hz, hz);
  record_.command_valid = false;
  EXPECT_TRUE(run(0.1, messages::Channel::kCommand).empty());
}

// Forty viewers that do not read would otherwise keep forty copies of each long course that was
// ever chosen.
TEST_F(PublisherTest, AllViewersShareTheMessagesOfACourseUntilTheNextReplacesThem) {
  std::vector<std::shared_ptr<Viewer>> deaf;
  for (std::uint32_t id = 2; id < 42; ++id) {
    deaf.push_back(std::make_shared<Viewer>(
        id, [] {}, [] {}));
    broker_.add(deaf.back());
    subscribe_to_all(*deaf.back());
  }
  std::vector<std::weak_ptr<const std::string>> texts;
  for (int i = 0; i < 10; ++i) {
    messages::SharedMessages setup;
    for (const messages::Channel channel :
         {messages::Channel::kCourse, messages::Channel::kScene}) {
      setup.emplace_back(channel, std::make_shared<const std::string>(1 << 20, ' '));
      texts.emplace_back(setup.back().second);
    }
    publisher_.exchange(messages::example_subject(), setup, kNsPerS * i);
  }
  for (std::size_t i = 0; i < texts.size(); ++i)
    EXPECT_EQ(texts[i].use_count(), i < texts.size() - 2 ? 0 : 42) << i;
}

TEST_F(PublisherTest, AChangeOfStateOrOfTheMotorsIsToldAtOnce) {
  state();
  record_.snapshot.run_state = RunState::kAborted;
  record_.snapshot.faults = fault_bit(Fault::tilt);
  const auto aborted = next_states();
  ASSERT_EQ(aborted.size(), 1U);
  EXPECT_EQ(aborted[0]["run"], "aborted");
  EXPECT_EQ(aborted[0]["faults"][0]["name"], "tilt");
  record_.snapshot.sample.state = RobotState::kDisarmed;
  record_.snapshot.sample.right_duty = 0.0;
  EXPECT_EQ(state()["motors_on"], false);
  record_.snapshot.sample.right_duty = 0.2;
  const auto moving = next_states();
  ASSERT_EQ(moving.size(), 1U);
  EXPECT_EQ(moving[0]["motors_on"], true);
}

TEST_F(PublisherTest, ABatteryThatIsOffHasNoVoltage) {
  for (const auto& [volts, on] : {std::pair{7.9, true}, {kBatteryOffV, true}, {3.99, false}}) {
    record_.snapshot.sample.battery_v = volts;
    EXPECT_EQ(state().contains("battery_v"), on) << volts;
  }
}

TEST_F(PublisherTest, AStopIsTheDaemonsUntilTheRobotHasLatchedIt) {
  record_.snapshot.faults = fault_bit(Fault::stop_requested);
  EXPECT_EQ(state()["faults"][0]["from"], "daemon");
  record_.snapshot.sample.faults = fault_bit(Fault::stop_requested);
  EXPECT_EQ(state()["faults"][0]["from"], "robot");
  record_.snapshot.has_sample = false;
  EXPECT_EQ(state()["faults"][0]["from"], "daemon");
}

TEST_F(PublisherTest, TheRunsClockStandsStillWhenItIsOverAndAStartIsOffered) {
  state(2.0);
  record_.snapshot.run_state = RunState::kFinished;
  record_.snapshot.start_refusal = StartRefusal::kNone;
  const Json over = state();
  EXPECT_NEAR(over["run_s"].get<double>(), 2.0, 0.02);
  EXPECT_EQ(over["can"]["start"], true);
  EXPECT_EQ(over["session"], "ready");
  EXPECT_EQ(over["robot_state"], "running");
  record_.snapshot.start_refusal = StartRefusal::kNotStill;
  const Json refused = state();
  EXPECT_EQ(refused["can"]["start"], false);
  EXPECT_EQ(refused["why_not_start"], std::string(to_string(StartRefusal::kNotStill)));
}

TEST_F(PublisherTest, SaysWhoDrivesAndWhetherAnotherMay) {
  record_.snapshot.run_state = RunState::kIdle;
  record_.snapshot.drive_refusal = StartRefusal::kNone;
  const Json free = state();
  EXPECT_EQ(free["can"]["drive"], true);
  EXPECT_FALSE(free.contains("driver"));
  controls_.lease.take("viewer 1", record_.now_ns);
  controls_.lease.take("viewer 2", record_.now_ns);
  record_.snapshot.run_state = RunState::kDriving;
  record_.snapshot.drive_refusal = StartRefusal::kDriven;
  const Json taken = state(0.05);
  EXPECT_EQ(taken["run"], "driving");
  EXPECT_EQ(taken["can"]["drive"], false);
  EXPECT_EQ(taken["why_not_drive"], "viewer 1 drives");
  EXPECT_EQ(taken["driver"], (Json{{"by", "viewer 1"}, {"fresh", true}, {"asked_by", "viewer 2"}}));
  const Json left = state(0.2);
  EXPECT_EQ(left["driver"]["fresh"], false);
  EXPECT_EQ(left["can"]["drive"], true) << "from a driver without fresh input it can be taken";
}

TEST_F(PublisherTest, TheLinkHasRatesOfTheLastSecond) {
  const auto received = run(3.0, messages::Channel::kLink);
  EXPECT_NEAR(received.back()["samples_hz"].get<double>(), 200.0, 2.0);
  EXPECT_NEAR(received.back()["in_bytes_ps"].get<double>(), 8800.0, 90.0);
  EXPECT_EQ(received.back()["port"], "/dev/ttyACM0");
  EXPECT_EQ(received.back()["quality"], "good");
  EXPECT_GE(received.back()["counters"]["samples"], 500);
}

TEST_F(PublisherTest, ALoopThatStandsStillDoesNotSilenceTheRest) {
  run(1.0, messages::Channel::kState);
  int states = 0;
  for (int i = 1; i <= 40; ++i) {
    publisher_.tick(record_.now_ns + i * 50 * kNsPerMs);
    states += static_cast<int>(take(messages::Channel::kState).size());
  }
  EXPECT_GE(states, 9);
}

TEST_F(PublisherTest, ANewcomerGetsTheWholePathHistory) {
  for (int i = 0; i < 100; ++i) {
    record_.snapshot.estimates[PoseSource::kModel].pose.x_m = i * 0.011;
    run(0.005, messages::Channel::kPathHistory);
  }
  run(1.0, messages::Channel::kPathHistory);
  const auto late = std::make_shared<Viewer>(
      2, [] {}, [] {});
  broker_.add(late);
  broker_.subscribe(*late, {{{1, static_cast<std::uint32_t>(messages::Channel::kPathHistory)}}});
  ASSERT_GT(late->outbox().size(), 0U);
  const Json path_history = Json::parse(*late->outbox().pop()->body);
  EXPECT_GE(path_history["entities"][0]["lines"][0]["points"].size(), 99U);
}

TEST_F(PublisherTest, ACheckThatHasThePortAcknowledgesAStop) {
  state();
  const HostNs pressed_ns = record_.now_ns;
  controls_.motors_off = pressed_ns - 1;
  publisher_.stop_pressed("viewer 1", pressed_ns);
  EXPECT_EQ(state(0.1)["stop"]["status"], "pending")
      << "the motors were off before the STOP: they may run again";
  controls_.motors_off = pressed_ns + 30 * kNsPerMs;
  const Json stop = state(0.1)["stop"];
  EXPECT_EQ(stop["status"], "acknowledged");
  EXPECT_DOUBLE_EQ(stop["acknowledged_ms"].get<double>(), 30.0);
}

TEST_F(PublisherTest, ARecordingIsToldWhenItChanges) {
  run(1.0, messages::Channel::kRecording);
  EXPECT_TRUE(run(2.0, messages::Channel::kRecording).empty());
  controls_.record.available = controls_.record.active = true;
  controls_.record.run = "r";
  EXPECT_EQ(run(0.2, messages::Channel::kRecording).at(0)["run"], "r");
  EXPECT_NEAR(static_cast<double>(run(4.0, messages::Channel::kRecording).size()), 4.0, 1.0);
}

TEST_F(PublisherTest, KeepsAHistoryWithoutAnySubscriber) {
  broker_.remove(viewer_);
  run(2.0, messages::Channel::kClient);
  for (const char* topic : {"estimate", "sample", "slip", "link", "state"}) {
    const Json kept = Json::parse(publisher_.history().json(topic).value());
    EXPECT_NEAR(static_cast<double>(kept.size()), 9.5, 1.5) << topic;
    EXPECT_TRUE(kept.back().contains("t_s")) << topic;
  }
}

using Status = messages::StopFigures::Status;
constexpr HostNs kMs = kNsPerMs;

TEST(StopMonitor, TellsHowLongTheRobotTookAndAfter200MsThatItHasNotAcknowledged) {
  StopMonitor stop;
  EXPECT_EQ(stop.figures().status, Status::kNone);
  stop.press("keyboard", 1000 * kMs);
  // The answer to an earlier STOP.
  stop.answered(999 * kMs);
  EXPECT_FALSE(stop.tick(1199 * kMs));
  EXPECT_EQ(stop.figures().status, Status::kPending);
  EXPECT_TRUE(stop.tick(1200 * kMs));
  EXPECT_EQ(stop.figures().status, Status::kNotAcknowledged);
  EXPECT_FALSE(stop.tick(1300 * kMs)) << "said once";
  // The acknowledgement may still arrive after a reconnect.
  stop.answered(6000 * kMs);
  EXPECT_EQ(stop.figures().status, Status::kAcknowledged);
  EXPECT_DOUBLE_EQ(stop.figures().acknowledged_ms, 5000.0);
}

TEST(StopMonitor, PressingAgainDoesNotMakeItLookFaster) {
  StopMonitor stop;
  stop.press("viewer 1", 1000 * kMs);
  stop.press("viewer 2", 1100 * kMs);
  EXPECT_EQ(stop.figures().by, "viewer 2");
  EXPECT_TRUE(stop.tick(1200 * kMs));
  stop.answered(1300 * kMs);
  EXPECT_DOUBLE_EQ(stop.figures().acknowledged_ms, 300.0);
}

TEST(StopMonitor, OnlyAStartEndsTheLatch) {
  StopMonitor stop;
  stop.press("viewer 1", 1000 * kMs);
  stop.answered(1010 * kMs);
  EXPECT_TRUE(stop.figures().latched);
  // A step that was measured at the time of the press does not include the STOP yet.
  stop.under_way(1005 * kMs, false);
  EXPECT_TRUE(stop.figures().latched);
  // This report is late: it is about a run that began earlier.
  stop.under_way(999 * kMs, true);
  EXPECT_TRUE(stop.figures().latched);
  stop.under_way(1100 * kMs, true);
  EXPECT_FALSE(stop.figures().latched);
  EXPECT_EQ(stop.figures().status, Status::kAcknowledged);
  stop.press("viewer 1", 2000 * kMs);
  stop.under_way(2300 * kMs, false);
  EXPECT_FALSE(stop.figures().latched);
}

}  // namespace
}  // namespace tp100::server
