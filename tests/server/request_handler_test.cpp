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
  EXPECT_EQ(viewer_->outbox().size(), 0U);
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
  EXPECT_EQ(viewer_->subscriptions(), 1U);
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
