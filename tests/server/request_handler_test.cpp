// Requests of clients, without a socket.
#include "server/request_handler.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <optional>

#include "../messages/fixtures.h"
#include "fake_controls.h"

namespace tp100::server {
namespace {

using Json = nlohmann::json;
using ::testing::HasSubstr;

constexpr HostNs kNow = 100 * kNsPerS;

std::vector<messages::ParameterText> parameters() {
  return {{{.name = "control.gain",
            .type = messages::ParameterText::Type::kNumber,
            .value = 16.0,
            .standard = 16.0,
            .unit = "1/m",
            .range = {0.0, 200.0}},
           true,
           false,
           true},
          {{.name = "loop.rate_hz", .value = 200.0, .standard = 200.0, .range = {50.0, 1000.0}},
           false,
           false,
           true},
          {{.name = "server.listen",
            .type = messages::ParameterText::Type::kText,
            .value = std::string(),
            .standard = std::string()}},
          {{.name = "course",
            .type = messages::ParameterText::Type::kText,
            .value = std::string(),
            .standard = std::string()},
           false,
           false,
           true},
          {{.name = "robot.model.wheelbase_m", .value = 0.2, .standard = 0.2, .range = {0.1, 1.0}}},
          {{.name = "estimation.steering",
            .type = messages::ParameterText::Type::kChoice,
            .value = std::string("odometry"),
            .standard = std::string("odometry"),
            .choices = {"model", "odometry"}},
           true,
           true}};
}

class RequestHandlerTest : public ::testing::Test {
 protected:
  RequestHandlerTest() { broker_.add(viewer_); }

  // Everything in the viewer's outbox; data messages are separate from answers.
  struct Heard {
    std::vector<Json> texts;
    std::vector<std::string> binaries;
    std::vector<std::pair<std::uint32_t, Json>> data;  // subscription, message
  };
  static Heard hear(Viewer& viewer) {
    Heard received;
    while (!viewer.outbox().empty()) {
      const WebSocketFrame frame = viewer.outbox().pop();
      if (!frame.binary) {
        received.texts.push_back(Json::parse(*frame.body));
      } else if (frame.head_size == 0) {
        received.binaries.push_back(*frame.body);
      } else {
        received.data.emplace_back(frame.head[1], Json::parse(*frame.body));
      }
    }
    return received;
  }
  Heard hear() { return hear(*viewer_); }

  Heard say(const std::string& text, Permission permission = Permission::kCommand) {
    handler_.handle(viewer_, parse_text(text), permission, kNow);
    return hear();
  }
  Heard call(std::uint32_t service, const std::string& payload = "{}",
             Permission permission = Permission::kCommand, HostNs now = kNow) {
    handler_.handle(viewer_, ServiceCall{service, 9, "json", payload}, permission, now);
    return hear();
  }
  Heard call(Service service, const std::string& payload = "{}",
             Permission permission = Permission::kCommand) {
    return call(static_cast<std::uint32_t>(service), payload, permission);
  }
  void step(const StepRecord& record) {
    publisher_.take(record);
    handler_.tick(record.now_ns);
  }
  StepRecord ready() const {
    StepRecord record = messages::example_record();
    record.now_ns = kNow;
    record.snapshot.run_state = RunState::kIdle;
    record.snapshot.start_refusal = StartRefusal::kNone;
    return record;
  }
  static Json answer_of(const std::string& response) {
    return Json::parse(response.substr(response.find('{')));
  }

  FakeControls controls_;
  Broker broker_{messages::channel_texts()};
  Publisher publisher_{broker_,
                       messages::Messages(messages::example_subject(), messages::example_clock()),
                       controls_};
  RequestHandler handler_{broker_, publisher_, controls_, parameters(), "session"};
  std::shared_ptr<Viewer> viewer_ = std::make_shared<Viewer>(
      3, [] {}, [this] { failed_ = true; });
  bool failed_ = false;
};

TEST_F(RequestHandlerTest, GreetsWithInfoChannelsAndServices) {
  handler_.send_server_info(*viewer_, Permission::kStopOnly);
  const Heard received = hear();
  ASSERT_EQ(received.texts.size(), 3U);
  EXPECT_EQ(received.texts[0]["op"], "serverInfo");
  EXPECT_EQ(received.texts[0]["metadata"]["commands"], "stop");
  EXPECT_EQ(received.texts[1]["channels"].size(), messages::kChannelCount);
  std::vector<std::string> services;
  for (const Json& service : received.texts[2]["services"]) services.push_back(service["name"]);
  EXPECT_THAT(services,
              ::testing::ElementsAre("start", "hold", "stop", "record_start", "record_stop",
                                     "drive_take", "drive", "drive_release", "choose", "place",
                                     "file_save", "file_delete", "file_check", "pause", "resume",
                                     "parameters_save", "parameters_restore", "run_note",
                                     "run_delete", "run_report", "run_compare", "doctor",
                                     "run_identify", "wheels_up_begin", "wheels_up_watch"));
}

TEST_F(RequestHandlerTest, ASubscriberGetsWhatIsKeptAtOnceAndThenWhatIsNew) {
  const Heard course = say(R"({"op":"subscribe","subscriptions":[{"id":1,"channelId":17}]})");
  ASSERT_EQ(course.data.size(), 1U);
  EXPECT_EQ(course.data[0].second["name"], "example");
  EXPECT_TRUE(say(R"({"op":"subscribe","subscriptions":[{"id":2,"channelId":10}]})").data.empty());
  step(ready());
  const Heard estimate = hear();
  ASSERT_EQ(estimate.data.size(), 1U);
  EXPECT_EQ(estimate.data[0].first, 2U);
  say(R"({"op":"unsubscribe","subscriptionIds":[2]})");
  step(ready());
  EXPECT_TRUE(hear().data.empty());
}

TEST_F(RequestHandlerTest, SubscriptionsAreChecked) {
  const auto refused = [&](const char* list) {
    return say(std::string(R"({"op":"subscribe","subscriptions":)") + list + "}").texts.size();
  };
  EXPECT_EQ(refused(R"([{"id":1,"channelId":0}])"), 1U);
  EXPECT_EQ(refused(R"([{"id":1,"channelId":999}])"), 1U);
  EXPECT_EQ(refused(R"([{"id":1,"channelId":1},{"id":1,"channelId":2}])"), 1U);
  EXPECT_EQ(refused(R"([{"id":5,"channelId":1}])"), 1U);  // the channel is already subscribed
  EXPECT_EQ(say(R"({"op":"unsubscribe","subscriptionIds":[77]})").texts.size(), 1U);
  EXPECT_EQ(viewer_->subscriptions().size(), 1U);
}

TEST_F(RequestHandlerTest, AViewerThatLeftGetsNothingMore) {
  say(R"({"op":"subscribe","subscriptions":[{"id":2,"channelId":10}]})");
  broker_.remove(viewer_);
  step(ready());
  EXPECT_TRUE(viewer_->outbox().empty());
}

TEST_F(RequestHandlerTest, ParametersAreListed) {
  const Heard all = say(R"({"op":"getParameters","parameterNames":[],"id":"q"})");
  EXPECT_EQ(all.texts[0]["parameters"].size(), 6U);
  EXPECT_EQ(all.texts[0]["id"], "q");
  const Heard one = say(R"({"op":"getParameters","parameterNames":["loop.rate_hz","none"]})");
  EXPECT_EQ(one.texts[0]["parameters"].size(), 1U);
}

TEST_F(RequestHandlerTest, AGoodValueIsPassedOnAndTold) {
  say(R"({"op":"subscribeParameterUpdates","parameterNames":["control.gain"]})");
  const Heard received =
      say(R"({"op":"setParameters","parameters":[{"name":"control.gain","value":20}],"id":"s"})");
  ASSERT_EQ(controls_.sets.size(), 1U);
  EXPECT_EQ(controls_.sets[0].second, messages::ParameterValue(20.0));
  ASSERT_EQ(received.texts.size(), 2U);  // one for the subscription, then the answer to the request
  EXPECT_EQ(received.texts[1]["parameters"][0]["value"], 20);
  EXPECT_EQ(received.texts[1]["id"], "s");
}

TEST_F(RequestHandlerTest, WatchedParametersAddUpUntilTheyAreTakenBack) {
  const auto told = [&] {
    const Heard received =
        say(R"({"op":"setParameters","parameters":[{"name":"control.gain","value":20}]})");
    return received.texts.size() - 1;
  };
  EXPECT_EQ(told(), 0U);
  say(R"({"op":"subscribeParameterUpdates","parameterNames":["control.gain"]})");
  say(R"({"op":"subscribeParameterUpdates","parameterNames":["loop.rate_hz","none"]})");
  EXPECT_EQ(told(), 1U);
  say(R"({"op":"unsubscribeParameterUpdates","parameterNames":["control.gain"]})");
  EXPECT_EQ(told(), 0U);
  say(R"({"op":"subscribeParameterUpdates","parameterNames":[]})");
  EXPECT_EQ(told(), 1U);
  say(R"({"op":"unsubscribeParameterUpdates","parameterNames":[]})");
  EXPECT_EQ(told(), 0U);
}

TEST_F(RequestHandlerTest, NothingUncheckedIsPassedOn) {
  for (const char* parameter :
       {R"({"name":"control.gain","value":-1})", R"({"name":"control.gain","value":201})",
        R"({"name":"control.gain","value":"20"})", R"({"name":"control.gain","value":null})",
        R"({"name":"control.gain"})", R"({"name":"loop.rate_hz","value":100})",
        R"({"name":"none","value":1})", R"({"name":"estimation.steering","value":"truth"})"}) {
    const Heard received =
        say(std::string(R"({"op":"setParameters","parameters":[)") + parameter + "]}");
    ASSERT_EQ(received.texts.size(), 2U) << parameter;
    EXPECT_EQ(received.texts[0]["op"], "status");
    EXPECT_EQ(received.texts[0]["level"], 2);
  }
  EXPECT_TRUE(controls_.sets.empty());
  // JSON cannot express these values, but a caller in the program could pass them.
  for (const double value : {std::nan(""), std::numeric_limits<double>::infinity()})
    handler_.handle(viewer_, SetParameters{{{"control.gain", messages::ParameterValue(value)}}, ""},
                    Permission::kCommand, kNow);
  EXPECT_TRUE(controls_.sets.empty());
}

TEST_F(RequestHandlerTest, SomeParametersWaitForTheEndOfARun) {
  const char* set =
      R"({"op":"setParameters","parameters":[{"name":"estimation.steering","value":"model"}]})";
  StepRecord record = ready();
  record.snapshot.run_state = RunState::kRunning;
  step(record);
  EXPECT_THAT(say(set).texts[0]["message"], HasSubstr("during a run"));
  EXPECT_TRUE(controls_.sets.empty());
  step(ready());
  say(set);
  EXPECT_EQ(controls_.sets.size(), 1U);
}

TEST_F(RequestHandlerTest, TheStepHasTheLastWord) {
  step(ready());
  say(R"({"op":"setParameters","parameters":[{"name":"estimation.steering","value":"model"}]})");
  const auto value = [&] {
    return say(R"({"op":"getParameters","parameterNames":["estimation.steering"]})")
        .texts.back()["parameters"][0]["value"];
  };
  EXPECT_EQ(value(), "model");
  StepRecord later = ready();
  later.now_ns += kNsPerS;
  step(later);  // the pose source is still odometry: the change came too late
  EXPECT_EQ(value(), "odometry");
  later.now_ns += kNsPerS;
  later.snapshot.steering = PoseSource::kModel;
  step(later);
  EXPECT_EQ(value(), "model");
}

TEST_F(RequestHandlerTest, WhoMayNotCommandMayOnlyStop) {
  step(ready());
  const Permission only = Permission::kStopOnly;
  for (const std::uint32_t service :
       {1U, 2U, 4U, 5U, 6U, 7U, 8U, 9U, 10U, 11U, 12U, 16U, 17U, 18U, 19U})
    EXPECT_EQ(call(service, "{}", only).texts[0]["op"], "serviceCallFailure");
  say(R"({"op":"setParameters","parameters":[{"name":"control.gain","value":20}]})", only);
  EXPECT_EQ(controls_.starts, 0);
  EXPECT_EQ(controls_.holds, 0);
  EXPECT_TRUE(controls_.sets.empty());
  call(Service::kChoose, R"({"course":"3"})", only);
  call(Service::kPlace, R"({"at":"start"})", only);
  call(Service::kFileSave, R"({"kind":"course","name":"a","text":""})", only);
  call(Service::kFileDelete, R"({"kind":"course","name":"a"})", only);
  EXPECT_TRUE(controls_.choices.empty() && controls_.places.empty());
  for (const Service service : {Service::kRunNote, Service::kRunDelete, Service::kRunReport})
    call(service, R"({"run":"a"})", only);
  call(Service::kRunCompare, R"({"run":"a","with":"b"})", only);
  call(Service::kDoctor, R"({"part":"robot"})", only);
  call(Service::kRunIdentify, R"({"runs":"a"})", only);
  call(Service::kWheelsUpBegin, R"({"tracks":"free"})", only);
  EXPECT_TRUE(controls_.checkers.empty());
  EXPECT_TRUE(controls_.examined.empty());
  EXPECT_TRUE(controls_.saved.empty() && controls_.deleted.empty() && controls_.managed.empty());
  call(3, "{}", only);
  EXPECT_EQ(controls_.stops, 1);
}

TEST_F(RequestHandlerTest, StartNeedsARobotThatIsReadyAndIdle) {
  EXPECT_THAT(std::string(call(1).texts[0]["message"]), HasSubstr("no robot yet"));
  StepRecord running = ready();
  running.snapshot.run_state = RunState::kRunning;
  running.snapshot.start_refusal = StartRefusal::kUnderWay;
  step(running);
  EXPECT_THAT(std::string(call(1).texts[0]["message"]), HasSubstr("under way"));
  step(ready());
  EXPECT_EQ(answer_of(call(1).binaries.at(0)), Json::parse(R"({"accepted":true})"));
  EXPECT_EQ(controls_.starts, 1);
  EXPECT_EQ(controls_.go_ons, 0);
}

TEST_F(RequestHandlerTest, AStartSaysWhereTheRobotStands) {
  const auto message = [&](const char* request) -> std::string {
    const Heard heard = call(1, request);
    return heard.texts.empty() ? "" : std::string(heard.texts[0]["message"]);
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
    EXPECT_THAT(message(bad), HasSubstr("from is \"start\"")) << bad;
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
  EXPECT_EQ(call(Service::kPause, "{}").texts[0]["message"], "the run is paused already");
  call(Service::kResume, "{}");
  EXPECT_EQ(controls_.resumes, 1);
  EXPECT_EQ(controls_.pauses, 1);
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
      HasSubstr("kind is"));
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
       {Bad{Service::kChoose, "{}", "name a course"},
        {Service::kChoose, R"({"course":3})", "are names"},
        {Service::kChoose, R"({"curse":"3"})", "no argument 'curse'"},
        {Service::kPlace, "{}", "give x_m"},
        {Service::kPlace, R"({"at":"end"})", "give x_m"},
        {Service::kPlace, R"({"x_m":1,"y_m":1})", "give x_m"},
        {Service::kPlace, R"({"x_m":1,"y_m":1,"yaw_rad":"1"})", "give x_m"},
        {Service::kPlace, R"({"x_m":101,"y_m":1,"yaw_rad":1})", "from -100 to 100"},
        {Service::kPlace, R"({"x_m":1e999,"y_m":1,"yaw_rad":1})", "JSON"},
        {Service::kPlace, R"({"at":"start","x_m":1,"y_m":1})", "give x_m"},
        {Service::kFileSave, R"({"kind":"word","name":"a","text":""})", "kind is"},
        {Service::kFileSave, R"({"kind":"course","name":"../a","text":""})", "name takes"},
        {Service::kFileSave, R"({"kind":"course","name":".a","text":""})", "name takes"},
        {Service::kFileSave, R"({"kind":"course","text":""})", "name takes"},
        {Service::kFileSave, R"({"kind":"course","name":"a","text":"","replace":1})", "replace"},
        {Service::kFileDelete, R"({"kind":"course","name":"a","text":""})", "no argument 'text'"}})
    EXPECT_THAT(std::string(call(bad.service, bad.request).texts.at(0)["message"]),
                HasSubstr(bad.why))
        << bad.request;
  EXPECT_TRUE(controls_.choices.empty() && controls_.places.empty());
  EXPECT_TRUE(controls_.saved.empty() && controls_.deleted.empty());
}

TEST_F(RequestHandlerTest, ARunIsNamedReportedComparedAndDeleted) {
  const Heard named = call(Service::kRunNote, R"({"run":"a","name":"","tags":"wet","keep":false})");
  EXPECT_EQ(answer_of(named.binaries.at(0))["run"], "a");
  call(Service::kRunReport, R"({"run":"a"})");
  call(Service::kRunCompare, R"({"run":"a","with":"b"})");
  call(Service::kRunDelete, R"({"run":"a"})");
  ASSERT_EQ(controls_.managed.size(), 4U);
  EXPECT_EQ(controls_.managed[0].note.name, "");
  EXPECT_EQ(controls_.managed[0].note.note, std::nullopt);
  EXPECT_EQ(controls_.managed[0].note.tags, "wet");
  EXPECT_EQ(controls_.managed[0].note.keep, false);
  EXPECT_EQ(controls_.managed[1].what, RunRequest::What::kReport);
  EXPECT_EQ(controls_.managed[2].with, "b");
  EXPECT_EQ(controls_.managed[3].what, RunRequest::What::kDelete);
  controls_.change_refusal = "is open";
  EXPECT_EQ(call(Service::kRunDelete, R"({"run":"a"})").texts.at(0)["message"], "is open");
}

TEST_F(RequestHandlerTest, ARobotIsIdentifiedFromRunsThatAreNamed) {
  call(Service::kRunIdentify, R"({"runs":"a b","measured":"run,distance_m\n1,2\n"})");
  call(Service::kRunIdentify, R"({"runs":"a"})");
  ASSERT_EQ(controls_.managed.size(), 2U);
  EXPECT_EQ(controls_.managed[0].what, RunRequest::What::kIdentify);
  EXPECT_EQ(controls_.managed[0].drives, (std::vector<std::string>{"a", "b"}));
  EXPECT_EQ(controls_.managed[0].measured, "run,distance_m\n1,2\n");
  std::string many;
  for (int i = 0; i <= 100; ++i) many += "a ";
  for (const std::string& bad :
       {std::string("{}"), std::string(R"({"runs":""})"), std::string(R"({"runs":"a ../b"})"),
        std::string(R"({"runs":1})"), std::string(R"({"runs":"a","measured":1})"),
        R"({"runs":")" + many + R"("})"})
    EXPECT_THAT(std::string(call(Service::kRunIdentify, bad.c_str()).texts.at(0)["message"]),
                HasSubstr("runs are one to 100 names"))
        << bad;
  EXPECT_EQ(controls_.managed.size(), 2U);
}

TEST_F(RequestHandlerTest, ArgumentsOfTheServicesOfRunsAreChecked) {
  const std::string long_name(129, 'a');
  for (const std::string& name :
       {std::string("../a"), std::string(), std::string("."), std::string("a/b"),
        std::string("a\\u0000b"), std::string("gr\xC3\xBCn"), long_name}) {
    for (const Service service : {Service::kRunNote, Service::kRunDelete, Service::kRunReport})
      EXPECT_THAT(std::string(call(service, R"({"run":")" + name + R"("})").texts.at(0)["message"]),
                  HasSubstr("run is the name of a run"));
    EXPECT_THAT(std::string(call(Service::kRunCompare, R"({"run":"a","with":")" + name + R"("})")
                                .texts.at(0)["message"]),
                HasSubstr("names of runs"));
  }
  struct Bad {
    Service service;
    const char* request;
    const char* why;
  };
  for (const Bad& bad : {Bad{Service::kRunNote, R"({"run":"a","name":1})", "are texts"},
                         {Service::kRunNote, R"({"run":"a","keep":"yes"})", "are texts"},
                         {Service::kRunNote, R"({"run":"a","name":"a\u0000b"})", "name takes"},
                         {Service::kRunNote, R"({"run":"a","tags":"a\nb"})", "tags takes"},
                         {Service::kRunDelete, R"({"run":"a","with":"b"})", "no argument 'with'"},
                         {Service::kRunCompare, R"({"run":"a"})", "names of runs"}})
    EXPECT_THAT(std::string(call(bad.service, bad.request).texts.at(0)["message"]),
                HasSubstr(bad.why))
        << bad.request;
  EXPECT_TRUE(controls_.managed.empty());
}

TEST_F(RequestHandlerTest, TracksRunOnlyWhenTheyAreFreeAndNothingElseIsUnderWay) {
  const auto refused = [&](const char* request) {
    return std::string(call(Service::kWheelsUpBegin, request).texts.at(0)["message"]);
  };
  StepRecord lost = ready();
  lost.snapshot.drive_refusal = StartRefusal::kNoSession;
  step(lost);
  EXPECT_EQ(refused(R"({"tracks":"free"})"), to_string(StartRefusal::kNoSession));
  step(ready());
  for (const char* bad : {"{}", R"({"tracks":"perhaps"})", R"({"tracks":true})"})
    EXPECT_THAT(refused(bad), HasSubstr("tracks is \"free\""));
  StepRecord running = ready();
  running.snapshot.run_state = RunState::kRunning;
  step(running);
  EXPECT_NE(refused(R"({"tracks":"free"})"), "");
  EXPECT_TRUE(controls_.checkers.empty());
  step(ready());
  const Heard begun = call(Service::kWheelsUpBegin, R"({"tracks":"free"})");
  EXPECT_EQ(answer_of(begun.binaries.at(0))["token"], "free");
  EXPECT_EQ(controls_.checkers.size(), 1U);

  const Heard seen =
      call(Service::kWheelsUpWatch, R"({"token":"t","input_ms":5,"question":2,"answer":"b"})");
  EXPECT_EQ(answer_of(seen.binaries.at(0))["step"], "the left track runs");
  ASSERT_EQ(controls_.watched.size(), 1U);
  EXPECT_EQ(controls_.watched[0].token, "t");
  EXPECT_EQ(controls_.watched[0].input_ms, 5.0);
  EXPECT_EQ(controls_.watched[0].question, 2U);
  EXPECT_EQ(controls_.watched[0].answer, "b");
  for (const char* bad : {"{}", R"({"token":"t"})", R"({"token":1,"input_ms":5})"})
    EXPECT_THAT(std::string(call(Service::kWheelsUpWatch, bad).texts.at(0)["message"]),
                HasSubstr("token is a text"));
}

TEST_F(RequestHandlerTest, TheDoctorExaminesOnePartAtATimeAndNothingDuringARun) {
  step(ready());
  for (const char* part : {"port", "robot", "machine"}) {
    const Heard found = call(Service::kDoctor, std::string(R"({"part":")") + part + R"("})");
    EXPECT_EQ(answer_of(found.binaries.at(0))["port"], "/dev/ttyACM0");
  }
  EXPECT_THAT(controls_.examined,
              ::testing::ElementsAre(DoctorPart::kPort, DoctorPart::kRobot, DoctorPart::kMachine));
  for (const char* bad : {"{}", R"({"part":"wheels"})", R"({"part":1})"})
    EXPECT_THAT(std::string(call(Service::kDoctor, bad).texts.at(0)["message"]),
                HasSubstr("part is \"port\""));
  StepRecord running = ready();
  running.snapshot.run_state = RunState::kRunning;
  step(running);
  EXPECT_THAT(std::string(call(Service::kDoctor, R"({"part":"robot"})").texts.at(0)["message"]),
              HasSubstr("a run is under way"));
  EXPECT_EQ(controls_.examined.size(), 3U);
}

TEST_F(RequestHandlerTest, OtherParametersKeepWhatViewersHaveSet) {
  say(R"({"op":"setParameters","parameters":[{"name":"control.gain","value":20}]})");
  std::vector<messages::ParameterText> next = parameters();
  next[1].value = 400.0;
  handler_.change_setup(next, kNow);
  const Json values = say(R"({"op":"getParameters","parameterNames":[]})").texts.at(0);
  EXPECT_EQ(values["parameters"][0]["value"], 20.0);
  EXPECT_EQ(values["parameters"][1]["value"], 400.0);
}

TEST_F(RequestHandlerTest, StopIsAnsweredWhenTheRobotHasAnswered) {
  EXPECT_TRUE(call(3).binaries.empty());
  EXPECT_EQ(controls_.stops, 1);
  publisher_.stop_answered(kNow + 14 * kNsPerMs, kNow + 15 * kNsPerMs);
  handler_.tick(kNow + 15 * kNsPerMs);
  const Json answer = answer_of(hear().binaries.at(0));
  EXPECT_EQ(answer["acknowledged"], true);
  EXPECT_EQ(answer["acknowledged_ms"], 14.0);
}

TEST_F(RequestHandlerTest, StopIsAnsweredAfter200MsWithoutTheRobot) {
  call(3);
  publisher_.tick(kNow + 199 * kNsPerMs);
  handler_.tick(kNow + 199 * kNsPerMs);
  EXPECT_TRUE(hear().binaries.empty());
  publisher_.tick(kNow + 201 * kNsPerMs);
  handler_.tick(kNow + 201 * kNsPerMs);
  EXPECT_EQ(answer_of(hear().binaries.at(0))["acknowledged"], false);
}

TEST_F(RequestHandlerTest, StopIsStopWhateverElseIsWrongWithTheCall) {
  handler_.handle(viewer_, ServiceCall{3, 1, "cbor", "\xff"}, Permission::kStopOnly, kNow);
  EXPECT_EQ(controls_.stops, 1);
}

TEST_F(RequestHandlerTest, StateTellsOfTheStop) {
  say(R"({"op":"subscribe","subscriptions":[{"id":1,"channelId":16}]})");
  call(3);
  publisher_.stop_answered(kNow + 14 * kNsPerMs, kNow + 15 * kNsPerMs);
  const Heard received = hear();
  ASSERT_FALSE(received.data.empty());
  const Json stop = received.data.back().second["stop"];
  EXPECT_EQ(stop["status"], "acknowledged");
  EXPECT_EQ(stop["acknowledged_ms"], 14.0);
  EXPECT_EQ(stop["by"], "viewer 3");
  EXPECT_EQ(stop["latched"], true);
  StepRecord arming = ready();
  arming.now_ns += kNsPerS;
  arming.snapshot.run_state = RunState::kArming;
  step(arming);
  EXPECT_EQ(hear().data.back().second["stop"]["latched"], false);
}

TEST_F(RequestHandlerTest, ACallOfNothingFails) {
  for (const std::uint32_t service : {0U, 13U, 4294967295U})
    EXPECT_EQ(call(service).texts[0]["op"], "serviceCallFailure");
  EXPECT_EQ(call(2, "[]").texts[0]["op"], "serviceCallFailure");
  handler_.handle(viewer_, ServiceCall{2, 1, "cbor", "{}"}, Permission::kCommand, kNow);
  EXPECT_EQ(hear().texts[0]["op"], "serviceCallFailure");
  EXPECT_EQ(controls_.holds, 0);
}

TEST_F(RequestHandlerTest, RecordingsHaveHarmlessNames) {
  controls_.can_record = true;
  for (const char* name : {"../x", "/x", ".x", "a b", "a/b", "\\u0000", "ü"})
    EXPECT_EQ(call(4, std::string(R"({"name":")") + name + "\"}").texts.size(), 1U) << name;
  EXPECT_EQ(call(4, R"({"name":1})").texts.size(), 1U);
  EXPECT_EQ(answer_of(call(4, R"({"name":"run-1_a.b"})").binaries.at(0))["run"], "run-1_a.b");
  EXPECT_EQ(answer_of(call(5).binaries.at(0))["run"], "run-1_a.b");
}

TEST_F(RequestHandlerTest, AnAnswerOfASlowDiskComesLaterAndStopBeforeIt) {
  controls_.slow_disk = true;
  const Heard nothing = call(5);
  EXPECT_TRUE(nothing.texts.empty() && nothing.binaries.empty());
  call(3);
  EXPECT_EQ(controls_.stops, 1);
  messages::RecordingFigures late;
  late.run = "late";
  late.bytes = 7;
  controls_.unanswered("", late);
  handler_.tick(kNow);
  const Json answer = answer_of(hear().binaries.at(0));
  EXPECT_EQ(answer["run"], "late");
  EXPECT_EQ(answer["bytes"], 7);
  call(5);
  controls_.unanswered("no disk", {});
  handler_.tick(kNow);
  EXPECT_EQ(hear().texts.at(0)["op"], "serviceCallFailure");
  // A viewer that has left must not get an answer.
  call(5);
  viewer_.reset();
  controls_.unanswered("", {});
  handler_.tick(kNow);
}

TEST_F(RequestHandlerTest, WhoAsksAndNeverReadsIsFailed) {
  const ClientMessage ask = GetParameters{};
  for (int i = 0; i < 1000 && !failed_; ++i)
    handler_.handle(viewer_, ask, Permission::kCommand, kNow);
  EXPECT_TRUE(failed_);
}

TEST_F(RequestHandlerTest, WhatIsNoMessageIsTold) {
  EXPECT_FALSE(handler_.handle(viewer_, Malformed{"why"}, Permission::kCommand, kNow));
  EXPECT_EQ(hear().texts[0]["message"], "why");
  EXPECT_TRUE(handler_.handle(viewer_, Unserved{"fetchAsset"}, Permission::kCommand, kNow));
}

TEST_F(RequestHandlerTest, TheWheelIsTakenDrivenAndReleased) {
  step(ready());
  hear();
  const Json taken = answer_of(call(6).binaries.at(0));
  const std::string token = taken.at("token");
  const auto drive = [&](const std::string& text) {
    return call(
        7, R"({"token":")" + text + R"(","speed_mps":0.1,"yaw_rate_radps":-0.2,"input_ms":5})");
  };
  EXPECT_EQ(drive(token).binaries.size(), 1U);
  ASSERT_EQ(controls_.inputs.size(), 1U);
  EXPECT_EQ(controls_.inputs[0].speed_mps, 0.1);
  EXPECT_EQ(controls_.inputs[0].yaw_rate_radps, -0.2);
  EXPECT_EQ(drive("other").texts.at(0)["op"], "serviceCallFailure");
  EXPECT_EQ(controls_.inputs.size(), 1U);
  EXPECT_EQ(call(8, R"({"token":"other"})").texts.size(), 1U);
  EXPECT_EQ(call(8, R"({"token":")" + token + R"("})").binaries.size(), 1U);
  EXPECT_EQ(drive(token).texts.size(), 1U);
}

TEST_F(RequestHandlerTest, TheWheelIsNotForViewersWithoutRights) {
  step(ready());
  hear();
  for (std::uint32_t service = 6; service <= 8; ++service)
    EXPECT_EQ(call(service, "{}", Permission::kStopOnly).texts.size(), 1U) << service;
  EXPECT_EQ(controls_.wheel.figures(kNow).by, "");
}

TEST_F(RequestHandlerTest, TheWheelIsRefusedWithTheReasonOfTheStep) {
  StepRecord record = ready();
  record.snapshot.drive_refusal = StartRefusal::kNotStill;
  step(record);
  hear();
  EXPECT_EQ(call(6).texts.at(0)["message"], std::string(to_string(StartRefusal::kNotStill)));
  EXPECT_EQ(call(6, R"({"x":1})").texts.at(0)["message"], "there is no argument 'x'");
}

TEST_F(RequestHandlerTest, AViewerThatLeavesNoLongerDrives) {
  step(ready());
  hear();
  const std::string token = answer_of(call(6).binaries.at(0)).at("token");
  handler_.leave(Viewer(
                     77, [] {}, [] {}),
                 kNow);
  EXPECT_EQ(controls_.drivers_lost, 0);
  handler_.leave(*viewer_, kNow);
  EXPECT_EQ(controls_.drivers_lost, 1);
  EXPECT_EQ(call(7, R"({"token":")" + token + R"(","speed_mps":0,"yaw_rate_radps":0,"input_ms":0})")
                .texts.size(),
            1U);
}

TEST_F(RequestHandlerTest, ParametersAreSavedIfTheyMayBeAndTakeTheValue) {
  const Heard saved = call(Service::kParametersSave, R"({"control.gain":12.5,"course":"3"})");
  ASSERT_EQ(saved.binaries.size(), 1U);
  EXPECT_EQ(answer_of(saved.binaries[0])["file"], "tp100.toml");
  ASSERT_EQ(controls_.parameters_saved.size(), 1U);
  EXPECT_FALSE(controls_.parameters_saved[0].check);
  ASSERT_EQ(controls_.parameters_saved[0].values.size(), 2U);
  EXPECT_EQ(controls_.parameters_saved[0].values[0].first, "control.gain");
  EXPECT_EQ(controls_.parameters_saved[0].values[0].second, messages::ParameterValue(12.5));
  call(Service::kParametersSave, R"({"check":true,"course":""})");
  EXPECT_TRUE(controls_.parameters_saved.at(1).check);
  call(Service::kParametersRestore, R"({"check":true})");
  call(Service::kParametersRestore, "");
  EXPECT_THAT(controls_.restored, ::testing::ElementsAre(true, false));
}

TEST_F(RequestHandlerTest, HostileParametersToSaveAreRefusedByName) {
  const auto refused = [&](const char* request) {
    const Heard received = call(Service::kParametersSave, request);
    return received.texts.empty() ? std::string()
                                  : received.texts[0].value("message", std::string());
  };
  EXPECT_EQ(refused("{}"), "name parameters and their values");
  EXPECT_EQ(refused(R"({"check":true})"), "name parameters and their values");
  EXPECT_EQ(refused(R"({"check":1,"control.gain":1})"), "check is true or false");
  EXPECT_EQ(refused(R"({"control.gian":1})"), "there is no parameter 'control.gian'");
  EXPECT_EQ(refused(R"({"a\nb":1})"), "there is no parameter 'a?b'");
  EXPECT_THAT(refused(R"({"server.listen":"0.0.0.0:80"})"),
              HasSubstr("server.listen is not saved"));
  EXPECT_THAT(refused(R"({"robot.model.wheelbase_m":0.3})"), HasSubstr("the robot's file"));
  EXPECT_THAT(refused(R"({"control.gain":201})"), HasSubstr("control.gain ranges from 0 to 200"));
  EXPECT_THAT(refused(R"({"control.gain":"12"})"), HasSubstr("control.gain takes a number"));
  for (const char* other : {"null", "[1]", "{}"})
    EXPECT_EQ(refused((R"({"control.gain":)" + std::string(other) + "}").c_str()),
              "control.gain takes no value of that type");
  EXPECT_EQ(refused(R"({"control.gain":NaN})"), "the request must be a JSON object");
  EXPECT_NE(refused(R"({"control.gain":1e999})"), "");
  for (const char* name : {R"(a\nb)", "../x", "/etc/passwd", R"(a\u0000)"})
    EXPECT_THAT(refused((R"({"course":")" + std::string(name) + "\"}").c_str()),
                HasSubstr("course: name takes letters"));
  EXPECT_NE(call(Service::kParametersRestore, R"({"check":null})").texts.size(), 0U);
  EXPECT_NE(call(Service::kParametersRestore, R"({"file":"x"})").texts.size(), 0U);
  EXPECT_TRUE(controls_.parameters_saved.empty());
  EXPECT_TRUE(controls_.restored.empty());
  const Heard viewer =
      call(Service::kParametersSave, R"({"control.gain":1})", Permission::kStopOnly);
  EXPECT_THAT(viewer.texts.at(0)["message"], HasSubstr("server.commands"));
  EXPECT_TRUE(controls_.parameters_saved.empty());
}

TEST_F(RequestHandlerTest, DuringARunOnlyWhatIsInForceAtOnceIsSaved) {
  StepRecord record = ready();
  record.snapshot.run_state = RunState::kRunning;
  step(record);
  EXPECT_EQ(call(Service::kParametersSave, R"({"control.gain":1})").binaries.size(), 1U);
  EXPECT_EQ(call(Service::kParametersSave, R"({"check":true,"loop.rate_hz":100})").binaries.size(),
            1U);
  const Heard refused = call(Service::kParametersSave, R"({"control.gain":1,"loop.rate_hz":100})");
  EXPECT_THAT(refused.texts.at(0)["message"], HasSubstr("loop.rate_hz takes effect when"));
  EXPECT_THAT(call(Service::kParametersRestore, "{}").texts.at(0)["message"],
              HasSubstr("not during a run"));
  EXPECT_EQ(controls_.parameters_saved.size(), 2U);
  EXPECT_TRUE(controls_.restored.empty());
}

TEST_F(RequestHandlerTest, AnArgumentThatIsNoPlainValueIsNotOverlooked) {
  EXPECT_NE(call(Service::kStart, R"({"from":{}})").texts.size(), 0U);
  EXPECT_NE(call(Service::kHold, R"({"x":null})").texts.size(), 0U);
  EXPECT_EQ(controls_.starts + controls_.holds, 0);
}

}  // namespace
}  // namespace tp100::server
