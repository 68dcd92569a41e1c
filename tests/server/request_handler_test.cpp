// Requests of clients, without a socket.
#include "server/request_handler.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "request_rig.h"

namespace tp100::server {
namespace {

TEST_F(RequestHandlerTest, GreetsWithInfoChannelsAndServices) {
  handler_.send_server_info(*viewer_, Permission::kStopOnly);
  const Received received = take();
  ASSERT_EQ(received.texts.size(), 3U);
  EXPECT_EQ(received.texts[0]["op"], "serverInfo");
  EXPECT_EQ(received.texts[0]["metadata"]["commands"], "stop");
  EXPECT_EQ(received.texts[1]["channels"].size(), messages::kChannelCount);
  std::vector<std::string> services;
  for (const Json& service : received.texts[2]["services"]) services.push_back(service["name"]);
  EXPECT_THAT(
      services,
      ::testing::ElementsAre(
          "start", "hold", "stop", "record_start", "record_stop", "drive_take", "drive",
          "drive_release", "choose", "place", "file_save", "file_delete", "file_check", "pause",
          "resume", "parameters_save", "parameters_restore", "run_note", "run_delete", "run_report",
          "run_compare", "doctor", "run_identify", "wheels_up_begin", "wheels_up_watch", "watch"));
}

TEST_F(RequestHandlerTest, ASubscriberGetsWhatIsKeptAtOnceAndThenWhatIsNew) {
  const Received course = send(R"({"op":"subscribe","subscriptions":[{"id":1,"channelId":17}]})");
  ASSERT_EQ(course.data.size(), 1U);
  EXPECT_EQ(course.data[0].second["name"], "example");
  EXPECT_TRUE(send(R"({"op":"subscribe","subscriptions":[{"id":2,"channelId":10}]})").data.empty());
  step(ready());
  const Received estimate = take();
  ASSERT_EQ(estimate.data.size(), 1U);
  EXPECT_EQ(estimate.data[0].first, 2U);
  send(R"({"op":"unsubscribe","subscriptionIds":[2]})");
  step(ready());
  EXPECT_TRUE(take().data.empty());
}

TEST_F(RequestHandlerTest, SubscriptionsAreChecked) {
  const auto refused = [&](const char* list) {
    return send(std::string(R"({"op":"subscribe","subscriptions":)") + list + "}").texts.size();
  };
  EXPECT_EQ(refused(R"([{"id":1,"channelId":0}])"), 1U);
  EXPECT_EQ(refused(R"([{"id":1,"channelId":999}])"), 1U);
  EXPECT_EQ(refused(R"([{"id":1,"channelId":1},{"id":1,"channelId":2}])"), 1U);
  EXPECT_EQ(refused(R"([{"id":5,"channelId":1}])"), 1U);  // the channel is already subscribed
  EXPECT_EQ(send(R"({"op":"unsubscribe","subscriptionIds":[77]})").texts.size(), 1U);
  EXPECT_EQ(viewer_->subscriptions().size(), 1U);
}

TEST_F(RequestHandlerTest, AViewerThatLeftGetsNothingMore) {
  send(R"({"op":"subscribe","subscriptions":[{"id":2,"channelId":10}]})");
  broker_.remove(viewer_);
  step(ready());
  EXPECT_TRUE(viewer_->outbox().empty());
}

TEST_F(RequestHandlerTest, WhoMayNotCommandMayOnlyStop) {
  step(ready());
  const Permission only = Permission::kStopOnly;
  for (const std::uint32_t service :
       {1U, 2U, 4U, 5U, 6U, 7U, 8U, 9U, 10U, 11U, 12U, 16U, 17U, 18U, 19U})
    EXPECT_EQ(call(service, "{}", only).texts[0]["op"], "serviceCallFailure");
  send(R"({"op":"setParameters","parameters":[{"name":"control.gain","value":20}]})", only);
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
}

TEST_F(RequestHandlerTest, ACallOfNothingFails) {
  for (const std::uint32_t service : {0U, 13U, 4294967295U})
    EXPECT_EQ(call(service).texts[0]["op"], "serviceCallFailure");
  EXPECT_EQ(call(Service::kHold, "[]").texts[0]["op"], "serviceCallFailure");
  handler_.handle(viewer_, ServiceCall{2, 1, "cbor", "{}"}, Permission::kCommand, kNow);
  EXPECT_EQ(take().texts[0]["op"], "serviceCallFailure");
  EXPECT_EQ(controls_.holds, 0);
}

TEST_F(RequestHandlerTest, WhoAsksAndNeverReadsIsFailed) {
  const ClientMessage ask = GetParameters{};
  for (int i = 0; i < 1000 && !failed_; ++i)
    handler_.handle(viewer_, ask, Permission::kCommand, kNow);
  EXPECT_TRUE(failed_);
}

TEST_F(RequestHandlerTest, WhatIsNoMessageIsTold) {
  EXPECT_FALSE(handler_.handle(viewer_, Malformed{"why"}, Permission::kCommand, kNow));
  EXPECT_EQ(take().texts[0]["message"], "why");
  EXPECT_TRUE(handler_.handle(viewer_, Unserved{"fetchAsset"}, Permission::kCommand, kNow));
}

}  // namespace
}  // namespace tp100::server
