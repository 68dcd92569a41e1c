// Requests that choose, start and pause a run.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <optional>
#include <string>

#include "request_rig.h"

namespace tp100::server {
namespace {

using ::testing::HasSubstr;

TEST_F(RequestHandlerTest, StartNeedsARobotThatIsReadyAndIdle) {
  EXPECT_THAT(std::string(call(Service::kStart).texts[0]["message"]), HasSubstr("no robot yet"));
  StepRecord running = ready();
  running.snapshot.run_state = RunState::kRunning;
  running.snapshot.start_refusal = StartRefusal::kUnderWay;
  step(running);
  EXPECT_THAT(std::string(call(Service::kStart).texts[0]["message"]), HasSubstr("under way"));
  step(ready());
  EXPECT_EQ(answer_of(call(Service::kStart).binaries.at(0)), Json::parse(R"({"accepted":true})"));
  EXPECT_EQ(controls_.starts, 1);
  EXPECT_EQ(controls_.go_ons, 0);
}

TEST_F(RequestHandlerTest, AStartSaysWhereTheRobotStands) {
  const auto message = [&](const char* request) -> std::string {
    const Received received = call(Service::kStart, request);
    return received.texts.empty() ? "" : std::string(received.texts[0]["message"]);
  };
  StepRecord record = ready();
  record.snapshot.progress_m = 0.0;
  step(record);
  EXPECT_THAT(message(R"({"from":"here"})"),
              HasSubstr("no run ended before the end of its course"));
  record.snapshot.run_state = RunState::kAborted;
  record.snapshot.progress_m = 0.1;
  step(record);
  for (const char* bad : {R"({"from":"there"})", R"({"from":1})"})
    EXPECT_THAT(message(bad), HasSubstr("from must be \"start\"")) << bad;
  EXPECT_THAT(message(R"({"x":1})"), HasSubstr("no argument 'x'"));
  EXPECT_EQ(controls_.starts + controls_.go_ons, 0);
  EXPECT_EQ(message(R"({"from":"here"})"), "");
  EXPECT_EQ(controls_.go_ons, 1);
  EXPECT_EQ(message(R"({"from":"start"})"), "");
  EXPECT_EQ(controls_.starts, 1);
}

TEST_F(RequestHandlerTest, WhatIsChosenIsPassedOnUnlessARunIsUnderWay) {
  step(ready());
  const Json answer =
      answer_of(call(Service::kChoose, R"({"course":"3","setup":"flat"})").binaries.at(0));
  EXPECT_EQ(answer["course"], "3");
  ASSERT_EQ(controls_.choices.size(), 1U);
  EXPECT_EQ(controls_.choices[0].course, "3");
  EXPECT_EQ(controls_.choices[0].robot, std::nullopt) << "what is not named stays";
  EXPECT_EQ(controls_.choices[0].setup, "flat");
  controls_.change_refusal = "mine.toml:3:1: unknown key 'x'";
  EXPECT_EQ(call(Service::kChoose, R"({"course":"mine"})").texts[0]["message"],
            controls_.change_refusal);

  for (const RunState run : {RunState::kArming, RunState::kRunning, RunState::kDriving}) {
    StepRecord record = ready();
    record.snapshot.run_state = run;
    step(record);
    EXPECT_THAT(std::string(call(Service::kChoose, R"({"course":"3"})").texts[0]["message"]),
                HasSubstr("a run is under way"));
    EXPECT_THAT(std::string(call(Service::kPlace, R"({"at":"start"})").texts[0]["message"]),
                HasSubstr("a run is under way"));
  }
  EXPECT_EQ(controls_.choices.size(), 2U);
  EXPECT_TRUE(controls_.places.empty());
}

TEST_F(RequestHandlerTest, ARunIsPausedAndResumed) {
  step(ready());
  EXPECT_EQ(call(Service::kPause, "{}").texts[0]["message"], "no run is under way");
  StepRecord record = ready();
  record.snapshot.run_state = RunState::kRunning;
  step(record);
  EXPECT_EQ(call(Service::kResume, "{}").texts[0]["message"], "the run is not paused");
  call(Service::kPause, "{}");
  EXPECT_EQ(controls_.pauses, 1);
  record.snapshot.pause_left_s = 119.0;
  step(record);
  // Two people who both press Pause must not set the robot in motion.
  EXPECT_EQ(answer_of(call(Service::kPause).binaries.at(0)), Json::parse(R"({"accepted":true})"));
  EXPECT_EQ(controls_.resumes, 0);
  call(Service::kResume, "{}");
  EXPECT_EQ(controls_.resumes, 1);
}

// Without it nobody could tell whether the person had seen a STOP, or acted minutes ago.
TEST_F(RequestHandlerTest, WhatSetsTheRobotInMotionSaysWhatThePersonSaw) {
  step(ready());
  controls_.stop();
  for (const Service service :
       {Service::kStart, Service::kResume, Service::kDriveTake, Service::kWheelsUpBegin}) {
    for (const char* bad :
         {R"({"stops":null})", R"({"stops":1})", R"({"stops":1.5,"t_s":97})",
          R"({"stops":-1,"t_s":97})", R"({"stops":"1","t_s":97})", R"({"stops":1,"t_s":-1})"})
      EXPECT_THAT(std::string(call(service, bad).texts.at(0)["message"]),
                  HasSubstr("stops and t_s are needed"))
          << bad;
    EXPECT_THAT(std::string(call(service, R"({"stops":1,"t_s":98.1})").texts.at(0)["message"]),
                HasSubstr("t_s is later than now"));
  }
  EXPECT_TRUE(controls_.consents.empty());
  call(Service::kStart, R"({"stops":1,"t_s":97})");
  ASSERT_EQ(controls_.consents.size(), 1U);
  EXPECT_EQ(controls_.consents[0].stops_seen, 1U);
  EXPECT_EQ(controls_.consents[0].acted_ns, 99 * kNsPerS);
  EXPECT_EQ(controls_.consents[0].by.number, viewer_->id());
  controls_.move_refusal = to_string(ConsentLoss::kStopped);
  EXPECT_THAT(std::string(call(Service::kStart).texts.at(0)["message"]), HasSubstr("STOP was"));
}

// Whoever chose so must not find a robot that drives on after its page was closed.
TEST_F(RequestHandlerTest, ARunThatNoPageWatchesIsStoppedIfThatIsConfigured) {
  StepRecord record = ready();
  const auto run_for = [&](HostNs ns, bool watched) {
    for (const HostNs end = record.now_ns + ns; record.now_ns < end;) {
      record.now_ns += 100 * kNsPerMs;
      step(record);
      if (watched)
        call(static_cast<std::uint32_t>(Service::kWatch), "{}", Permission::kCommand,
             record.now_ns);
    }
  };
  for (const bool configured : {false, true}) {
    messages::RunContext context = messages::example_subject();
    context.stop_unwatched = configured;
    publisher_.change_setup(context, {}, record.now_ns);
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

TEST_F(RequestHandlerTest, ADraftIsCheckedAlsoDuringARun) {
  StepRecord record = ready();
  record.snapshot.run_state = RunState::kRunning;
  step(record);
  call(Service::kFileCheck, R"({"kind":"course","name":"mine","text":"x"})");
  ASSERT_EQ(controls_.checked.size(), 1U);
  EXPECT_EQ(controls_.checked[0].text, "x");
  EXPECT_TRUE(controls_.saved.empty());
  EXPECT_THAT(
      std::string(call(Service::kFileCheck, R"({"kind":"map","name":"mine"})").texts[0]["message"]),
      HasSubstr("kind must be"));
}

TEST_F(RequestHandlerTest, ARobotIsPlacedAtTheStartOrAtAPose) {
  step(ready());
  call(Service::kPlace, R"({"at":"start"})");
  call(Service::kPlace, R"({"x_m":1.5,"y_m":-2,"yaw_rad":0.5})");
  ASSERT_EQ(controls_.places.size(), 2U);
  EXPECT_FALSE(controls_.places[0]);
  ASSERT_TRUE(controls_.places[1]);
  EXPECT_EQ(controls_.places[1]->x_m, 1.5);
  EXPECT_EQ(controls_.places[1]->y_m, -2.0);
  EXPECT_EQ(controls_.places[1]->yaw_rad, 0.5);
}

TEST_F(RequestHandlerTest, ArgumentsOfTheSetupServicesAreChecked) {
  step(ready());
  struct Bad {
    Service service;
    const char* request;
    const char* why;
  };
  for (const Bad& bad :
       {Bad{Service::kChoose, "{}", "give a course"},
        {Service::kChoose, R"({"course":3})", "must be names"},
        {Service::kChoose, R"({"curse":"3"})", "no argument 'curse'"},
        {Service::kPlace, "{}", "give x_m"},
        {Service::kPlace, R"({"at":"end"})", "give x_m"},
        {Service::kPlace, R"({"x_m":1,"y_m":1})", "give x_m"},
        {Service::kPlace, R"({"x_m":1,"y_m":1,"yaw_rad":"1"})", "give x_m"},
        {Service::kPlace, R"({"x_m":101,"y_m":1,"yaw_rad":1})", "from -100 to 100"},
        {Service::kPlace, R"({"x_m":1e999,"y_m":1,"yaw_rad":1})", "JSON"},
        {Service::kPlace, R"({"at":"start","x_m":1,"y_m":1})", "give x_m"},
        {Service::kFileSave, R"({"kind":"word","name":"a","text":""})", "kind must be"},
        {Service::kFileSave, R"({"kind":"course","name":"../a","text":""})", "name must be"},
        {Service::kFileSave, R"({"kind":"course","name":".a","text":""})", "name must be"},
        {Service::kFileSave, R"({"kind":"course","text":""})", "name must be"},
        {Service::kFileSave, R"({"kind":"course","name":"a","text":"","replace":1})", "replace"},
        {Service::kFileDelete, R"({"kind":"course","name":"a","text":""})", "no argument 'text'"}})
    EXPECT_THAT(std::string(call(bad.service, bad.request).texts.at(0)["message"]),
                HasSubstr(bad.why))
        << bad.request;
  EXPECT_TRUE(controls_.choices.empty() && controls_.places.empty());
  EXPECT_TRUE(controls_.saved.empty() && controls_.deleted.empty());
}

}  // namespace
}  // namespace tp100::server
