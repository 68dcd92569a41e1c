// Requests that set the robot in motion or end its motion.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

#include "request_rig.h"

namespace tp100::server {
namespace {

using ::testing::HasSubstr;

// Otherwise the daemon would decide for the person where the robot stands.
TEST_F(RequestHandlerTest, AStartSaysWhereTheRobotStandsOnlyIfThePersonSaidSo) {
  step(ready());
  EXPECT_EQ(refused(Service::kStart), "");
  EXPECT_EQ(refused(Service::kStart, R"({"from":"here"})"), "");
  EXPECT_EQ(refused(Service::kStart, R"({"from":"start"})"), "");
  EXPECT_EQ(controls_.starts, 1);
  EXPECT_EQ(controls_.continues, 1);
  EXPECT_EQ(controls_.placed_starts, 1);
  EXPECT_THAT(refused(Service::kStart, R"({"from":"there"})"), HasSubstr("from must be"));
}

// Without it nobody could tell whether the person had seen a STOP, or acted minutes ago.
TEST_F(RequestHandlerTest, WhatSetsTheRobotInMotionSaysWhatThePersonSaw) {
  step(ready());
  controls_.stop();
  for (const Service service : {Service::kStart, Service::kResume, Service::kDriveTake}) {
    for (const char* bad :
         {R"({"stops":null})", R"({"stops":1})", R"({"stops":1.5,"t_s":97})",
          R"({"stops":-1,"t_s":97})", R"({"stops":"1","t_s":97})", R"({"stops":1,"t_s":-1})"})
      EXPECT_THAT(refused(service, bad), HasSubstr("stops and t_s are needed")) << bad;
    EXPECT_THAT(refused(service, R"({"stops":1,"t_s":98.1})"), HasSubstr("t_s is later than now"));
  }
  EXPECT_TRUE(controls_.consents.empty());
  call(Service::kStart, R"({"stops":1,"t_s":97})");
  ASSERT_EQ(controls_.consents.size(), 1U);
  EXPECT_EQ(controls_.consents[0].stops_seen, 1U);
  EXPECT_EQ(controls_.consents[0].acted_ns, 99 * kNsPerS);
  EXPECT_EQ(controls_.consents[0].seen_ns, 99 * kNsPerS);
  EXPECT_EQ(controls_.consents[0].by.number, viewer_->id());
  controls_.move_refusal = to_string(ConsentLoss::kStopped);
  EXPECT_THAT(refused(Service::kStart), HasSubstr("STOP was"));
}

// Whoever chose so must not find a robot that drives on after its page was closed.
TEST_F(RequestHandlerTest, ARunThatNoPageWatchesIsStoppedIfThatIsConfigured) {
  StepRecord record = ready();
  const auto run_for = [&](HostNs ns, bool watched) {
    for (const HostNs end = record.now_ns + ns; record.now_ns < end;) {
      record.now_ns += 100 * kNsPerMs;
      step(record);
      if (watched) call(Service::kWatch, "{}", record.now_ns);
    }
  };
  for (const bool configured : {false, true}) {
    messages::RunContext context = messages::example_subject();
    context.stop_unwatched = configured;
    publisher_.exchange(context, {}, record.now_ns);
    for (const RunState state : {RunState::kRunning, RunState::kDriving, RunState::kArming}) {
      record.snapshot.run_state = RunState::kIdle;
      run_for(10 * kNsPerS, false);
      EXPECT_EQ(controls_.stops, 0);
      record.snapshot.run_state = state;
      run_for(10 * kNsPerS, true);
      run_for(19 * kNsPerS / 10, false);
      EXPECT_EQ(controls_.stops, 0);
      run_for(kNsPerS / 5, false);
      EXPECT_EQ(controls_.stops, configured ? 1 : 0);
      controls_.stops = 0;
    }
  }
}

TEST_F(RequestHandlerTest, StopIsAnsweredAndToldWhenTheRobotHasAnswered) {
  send(R"({"op":"subscribe","subscriptions":[{"id":1,"channelId":16}]})");
  EXPECT_TRUE(call(Service::kStop).binaries.empty());
  publisher_.stop_answered(kNow + 14 * kNsPerMs, kNow + 15 * kNsPerMs);
  handler_.tick(kNow + 15 * kNsPerMs);
  const Received received = take();
  EXPECT_EQ(answer_of(received.binaries.at(0)),
            Json::parse(R"({"acknowledged":true,"acknowledged_ms":14.0})"));
  const Json stop = received.data.back().second["stop"];
  EXPECT_EQ(stop["status"], "acknowledged");
  EXPECT_EQ(stop["acknowledged_ms"], 14.0);
  EXPECT_EQ(stop["by"], "viewer 3");
  EXPECT_EQ(stop["latched"], true);
  StepRecord arming = ready(RunState::kArming);
  arming.now_ns += kNsPerS;
  step(arming);
  EXPECT_EQ(take().data.back().second["stop"]["latched"], false);
}

TEST_F(RequestHandlerTest, StopIsAnsweredAfter200MsWithoutTheRobot) {
  call(Service::kStop);
  for (const int ms : {199, 201}) {
    publisher_.tick(kNow + ms * kNsPerMs);
    handler_.tick(kNow + ms * kNsPerMs);
    const Received received = take();
    ASSERT_EQ(received.binaries.size(), ms < 200 ? 0U : 1U);
    if (ms < 200) continue;
    EXPECT_EQ(answer_of(received.binaries[0])["acknowledged"], false);
  }
}

// The page would say that the robot has not acknowledged a STOP which it has.
TEST_F(RequestHandlerTest, StopIsAnsweredWhenTheRobotWasFasterThanTheReportOfThePress) {
  publisher_.stop_answered(kNow + 5 * kNsPerMs, kNow + 5 * kNsPerMs);
  EXPECT_EQ(answered(Service::kStop),
            Json::parse(R"({"acknowledged":true,"acknowledged_ms":5.0})"));
}

}  // namespace
}  // namespace tp100::server
