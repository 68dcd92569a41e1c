// What every client may ask for, and what is refused to all of them. Without a socket.
#include "server/request_handler.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "request_rig.h"

namespace tp100::server {
namespace {

using ::testing::HasSubstr;

TEST_F(RequestHandlerTest, GreetsWithInfoChannelsAndServices) {
  handler_.send_server_info(*viewer_, Permission::kStopOnly);
  const Received received = take();
  ASSERT_EQ(received.texts.size(), 3U);
  EXPECT_EQ(received.texts[0]["op"], "serverInfo");
  EXPECT_EQ(received.texts[0]["metadata"]["commands"], "stop");
  EXPECT_EQ(received.texts[1]["channels"].size(), messages::kChannelCount);
  // Clients call a service by its number, which therefore must not change.
  std::string services;
  for (const Json& each : received.texts[2]["services"])
    services += std::to_string(int{each["id"]}) + " " + std::string(each["name"]) + ", ";
  EXPECT_EQ(services,
            "1 start, 2 hold, 3 stop, 4 record_start, 5 record_stop, 6 drive_take, 7 drive, "
            "8 drive_release, 9 choose, 10 place, 11 file_save, 12 file_delete, 13 file_check, "
            "14 pause, 15 resume, 16 parameters_save, 17 parameters_restore, 18 run_note, "
            "19 run_delete, 20 run_report, 21 run_compare, 22 doctor, 23 run_identify, "
            "24 wheels_up_begin, 25 wheels_up_watch, 26 watch, ");
}

TEST_F(RequestHandlerTest, ASubscriberGetsWhatIsKeptAtOnceAndThenWhatIsNewUntilItLeaves) {
  const Received course = send(R"({"op":"subscribe","subscriptions":[{"id":1,"channelId":17}]})");
  ASSERT_EQ(course.data.size(), 1U);
  EXPECT_EQ(course.data[0].second["name"], "example");
  const char* subscribe = R"({"op":"subscribe","subscriptions":[{"id":2,"channelId":10}]})";
  EXPECT_TRUE(send(subscribe).data.empty());
  step(ready());
  const Received estimate = take();
  ASSERT_EQ(estimate.data.size(), 1U);
  EXPECT_EQ(estimate.data[0].first, 2U);
  send(R"({"op":"unsubscribe","subscriptionIds":[2]})");
  step(ready());
  EXPECT_TRUE(take().data.empty());
  send(subscribe);
  broker_.remove(viewer_);
  step(ready());
  EXPECT_TRUE(viewer_->outbox().empty());
}

TEST_F(RequestHandlerTest, SubscriptionsAreChecked) {
  const auto errors = [&](const char* list) {
    return send(std::string(R"({"op":"subscribe","subscriptions":)") + list + "}").texts.size();
  };
  EXPECT_EQ(errors(R"([{"id":1,"channelId":0}])"), 1U);
  EXPECT_EQ(errors(R"([{"id":1,"channelId":999}])"), 1U);
  EXPECT_EQ(errors(R"([{"id":1,"channelId":1},{"id":1,"channelId":2}])"), 1U);
  EXPECT_EQ(errors(R"([{"id":5,"channelId":1}])"), 1U) << "the channel is subscribed already";
  EXPECT_EQ(send(R"({"op":"unsubscribe","subscriptionIds":[77]})").texts.size(), 1U);
  EXPECT_EQ(viewer_->subscriptions().size(), 1U);
}

// A page that may only watch would start, drive, change or delete something.
TEST_F(RequestHandlerTest, WhoMayNotCommandMayStopAndWatchAndNothingElse) {
  StepRecord record = ready();
  for (const RunState state : {RunState::kIdle, RunState::kRunning}) {
    record.snapshot.run_state = state;
    step(record);
    for (const ServiceText& each : services()) {
      const auto service = static_cast<Service>(each.id);
      if (service == Service::kStop || service == Service::kWatch) continue;
      for (const char* request :
           {"{}", R"({"run":"a"})", R"({"run":"a","with":"b"})", R"({"runs":"a"})",
            R"({"course":"3"})", R"({"at":"start"})", R"({"part":"robot"})", R"({"tracks":"free"})",
            R"({"kind":"course","name":"a","text":""})", R"({"kind":"course","name":"a"})",
            R"({"control.gain":1})"})
        EXPECT_THAT(refused(service, request, Permission::kStopOnly),
                    HasSubstr("only stop is taken from this client (server.commands)"))
            << each.name << request;
    }
  }
  set("control.gain", "20", Permission::kStopOnly);
  EXPECT_EQ(controls_.requests(), 0U);
  EXPECT_TRUE(controls_.checkers.empty());
  EXPECT_EQ(controls_.wheel.figures(kNow).by, "");
  EXPECT_EQ(refused(Service::kWatch, "{}", Permission::kStopOnly), "");
  EXPECT_EQ(refused(Service::kStop, "{}", Permission::kStopOnly), "");
}

TEST_F(RequestHandlerTest, ArgumentsOfEveryServiceAreChecked) {
  step(ready());
  struct Bad {
    Service service;
    std::string request;
    const char* why;
  };
  const auto named = [](const char* key, const std::string& name, const char* rest = "") {
    return R"({")" + std::string(key) + R"(":")" + name + "\"" + rest + "}";
  };
  std::vector<Bad> all = {
      {Service::kHold, "[]", "must be a JSON object"},
      {Service::kHold, R"({"x":null})", "no argument 'x'"},
      {Service::kStart, R"({"x":1})", "no argument 'x'"},
      {Service::kStart, R"({"from":"there"})", "from must be \"start\""},
      {Service::kDriveRelease, R"({"token":1})", "token must be a string"},
      {Service::kWheelsUpBegin, R"({"tracks":"perhaps"})", "tracks = \"free\""},
      {Service::kWheelsUpWatch, R"({"token":1,"input_ms":5})", "token must be a string"},
      {Service::kDoctor, R"({"part":"wheels"})", "part must be \"port\""},
      {Service::kChoose, "{}", "give a course"},
      {Service::kChoose, R"({"course":3})", "must be names"},
      {Service::kChoose, R"({"curse":"3"})", "no argument 'curse'"},
      {Service::kPlace, "{}", "give x_m"},
      {Service::kPlace, R"({"at":"start","x_m":1,"y_m":1})", "give x_m"},
      {Service::kPlace, R"({"x_m":1,"y_m":1,"yaw_rad":"1"})", "give x_m"},
      {Service::kPlace, R"({"x_m":101,"y_m":1,"yaw_rad":1})", "from -100 to 100"},
      {Service::kPlace, R"({"x_m":1,"y_m":1,"yaw_rad":-101})", "from -100 to 100"},
      {Service::kPlace, R"({"x_m":1e999,"y_m":1,"yaw_rad":1})", "JSON"},
      {Service::kFileSave, R"({"kind":"word","name":"a","text":""})", "kind must be"},
      {Service::kFileSave, R"({"kind":"course","name":"../a","text":""})", "name must be"},
      {Service::kFileSave, R"({"kind":"course","name":"a","text":"","replace":1})", "replace"},
      {Service::kFileDelete, R"({"kind":"course","name":"a","text":""})", "no argument 'text'"},
      {Service::kFileCheck, R"({"kind":"map","name":"mine"})", "kind must be"},
      {Service::kRunNote, R"({"run":"a","name":1})", "must be strings"},
      {Service::kRunNote, R"({"run":"a","keep":"yes"})", "must be strings"},
      {Service::kRunNote, R"({"run":"a","name":"a\u0000b"})", "name takes"},
      {Service::kRunNote, R"({"run":"a","tags":"a\nb"})", "tags takes"},
      {Service::kRunDelete, R"({"run":"a","with":"b"})", "no argument 'with'"},
      {Service::kRunCompare, R"({"run":"a"})", "names of runs"},
      {Service::kRunIdentify, "{}", "one to 100 names"},
      {Service::kRunIdentify, R"({"runs":"a","measured":1})", "one to 100 names"},
      {Service::kRecordStart, R"({"name":1})", "name"},
      {Service::kParametersSave, "{}", "give parameters and their values"},
      {Service::kParametersSave, R"({"check":1,"control.gain":1})", "check must be true or false"},
      {Service::kParametersSave, R"({"control.gian":1})", "there is no parameter 'control.gian'"},
      {Service::kParametersSave, R"({"a\nb":1})", "there is no parameter 'a?b'"},
      {Service::kParametersSave, R"({"server.listen":"0.0.0.0:80"})", "cannot be saved by viewers"},
      {Service::kParametersSave, R"({"robot.model.wheelbase_m":0.3})", "the robot's file"},
      {Service::kParametersSave, R"({"control.gain":201})", "control.gain ranges from 0 to 200"},
      {Service::kParametersSave, R"({"control.gain":"12"})", "control.gain takes a number"},
      {Service::kParametersSave, R"({"control.gain":null})", "takes no value of that type"},
      {Service::kParametersRestore, R"({"check":null})", "check must be true or false"}};
  std::string many;
  for (int i = 0; i <= 100; ++i) many += "a ";
  for (const std::string& runs : {std::string("a ../b"), many})
    all.push_back({Service::kRunIdentify, named("runs", runs), "one to 100 names"});
  for (const std::string& run :
       {std::string(), std::string("."), std::string("../a"), std::string("a/b"),
        std::string("a\\u0000b"), std::string("a%2Fb"), std::string(256, 'a')}) {
    for (const Service service : {Service::kRunNote, Service::kRunDelete, Service::kRunReport})
      all.push_back({service, named("run", run), "run must be the name of a run"});
    all.push_back({Service::kRunCompare, named("with", run, R"(,"run":"a")"), "names of runs"});
  }
  for (const char* name : {"../x", "/x", ".x", "a b", "a/b", "\\u0000", "ü"})
    all.push_back({Service::kRecordStart, named("name", name), "name"});
  for (const char* name : {R"(a\nb)", "../x", "/etc/passwd", R"(a\u0000)"})
    all.push_back({Service::kParametersSave, named("course", name), "name must be 1 to 255 bytes"});
  for (const Bad& bad : all)
    EXPECT_THAT(refused(bad.service, bad.request), HasSubstr(bad.why)) << bad.request;
  for (const std::uint32_t service : {0U, 27U, 4294967295U})
    EXPECT_EQ(call(service).texts[0]["op"], "serviceCallFailure");
  handler_.handle(viewer_, ServiceCall{2, 1, "cbor", "{}"}, Permission::kCommand, kNow);
  EXPECT_EQ(take().texts[0]["op"], "serviceCallFailure");
  EXPECT_EQ(controls_.requests(), 0U);
  EXPECT_TRUE(controls_.checkers.empty());
}

TEST_F(RequestHandlerTest, WhoAsksAndNeverReadsIsFailed) {
  const ClientMessage ask = GetParameters{};
  for (int i = 0; i < 1000 && !failed_; ++i)
    handler_.handle(viewer_, ask, Permission::kCommand, kNow);
  EXPECT_TRUE(failed_);
}

TEST_F(RequestHandlerTest, WhatIsNoMessageOrNotServedIsTold) {
  EXPECT_FALSE(handler_.handle(viewer_, Malformed{"why"}, Permission::kCommand, kNow));
  EXPECT_EQ(take().texts[0]["message"], "why");
  EXPECT_THAT(send(R"({"op":"fetchAsset","uri":"x","requestId":1})").texts[0]["message"],
              HasSubstr("does not serve 'fetchAsset'"));
}

}  // namespace
}  // namespace tp100::server
