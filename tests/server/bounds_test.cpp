// What waits for a viewer, what is kept for those that come later, and what each may ask for: all
// of it is bounded.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "server/access.h"
#include "server/broker.h"
#include "server/publisher.h"

namespace tp100::server {
namespace {

using messages::Channel;

WebSocketFrame frame(const std::string& body) {
  WebSocketFrame out;
  out.body = std::make_shared<const std::string>(body);
  return out;
}

TEST(Outbox, TheOldestDataGoesFirst) {
  Outbox box;
  for (std::size_t i = 0; i < Outbox::kMaxData + 5; ++i) box.push_data(frame(std::to_string(i)));
  EXPECT_EQ(box.size(), Outbox::kMaxData);
  EXPECT_EQ(box.dropped(), 5U);
  EXPECT_EQ(*box.pop()->body, "5");
}

TEST(Outbox, BytesAreBoundedToo) {
  Outbox box;
  const std::string large(Outbox::kMaxCounted, 'x');
  for (std::size_t i = 0; i < Outbox::kMaxData; ++i) box.push_data(frame(large));
  EXPECT_LE(box.size() * large.size(), Outbox::kMaxDataBytes);
  EXPECT_EQ(box.dropped() + box.size(), Outbox::kMaxData);
  // A viewer that subscribes to path, course and scene of the longest course at once gets all.
  Outbox setup;
  for (int i = 0; i < 3; ++i) setup.push_data(frame(std::string(Outbox::kMaxDataBytes, 'x')));
  EXPECT_EQ(setup.size(), 3U);
  EXPECT_EQ(setup.dropped(), 0U);
}

TEST(Outbox, AnswersGoBeforeDataAndAreNeverDroppedButBounded) {
  Outbox box;
  for (std::size_t i = 0; i < 2 * Outbox::kMaxData; ++i) box.push_data(frame("data"));
  std::size_t taken = 0;
  while (box.push_reply(frame("answer"))) ++taken;
  EXPECT_EQ(taken, Outbox::kMaxReplies);
  for (std::size_t i = 0; i < taken; ++i) EXPECT_EQ(*box.pop()->body, "answer");
  EXPECT_EQ(*box.pop()->body, "data");
  EXPECT_TRUE(box.push_reply(frame("answer")));
}

using Json = nlohmann::json;

std::string message(HostNs at, std::size_t size = 0) {
  return R"({"t_s":)" + std::to_string(to_s(at)) + R"(,"x":")" + std::string(size, 'x') + "\"}";
}

TEST(History, KeepsTheLastMinutesOfEachChannelAtAReducedRate) {
  History history;
  EXPECT_EQ(history.json("estimate"), "[]");
  HostNs now = 0;
  for (; now < 400 * kNsPerS; now += 5 * kNsPerMs)
    history.take(Channel::kEstimate, now, message(now));
  const Json kept = Json::parse(history.json("estimate").value());
  EXPECT_EQ(kept.size(), 1501U);
  EXPECT_NEAR(kept.front()["t_s"], 99.8, 0.3);
  EXPECT_NEAR(kept.back()["t_s"], 399.8, 0.3);
  EXPECT_EQ(history.json("slip"), "[]");
}

TEST(History, IsBoundedInBytesHoweverLongMessagesAre) {
  History history;
  for (HostNs now = 0; now < 100 * kNsPerS; now += History::kIntervalNs)
    history.take(Channel::kLink, now, message(now, 100'000));
  EXPECT_LE(history.json("link")->size(), History::kMaxBytes + 1000);
  history.take(Channel::kLink, 200 * kNsPerS, message(0, History::kMaxBytes));
  EXPECT_LE(history.json("link")->size(), History::kMaxBytes);
}

TEST(History, HasFiguresOnly) {
  History history;
  EXPECT_TRUE(history.due(Channel::kSample, 0));
  EXPECT_FALSE(history.due(Channel::kEvent, 0));
  history.take(Channel::kEvent, 0, "{}");
  for (const char* topic : {"event", "client", "", "/estimate", "../estimate"})
    EXPECT_FALSE(history.json(topic)) << topic;
}

constexpr HostNs kBegin = 1000 * kNsPerS;

// A client that asks for more than its share would slow down everything that the others see.
TEST(Budget, GivesItsUnitsAndNoMoreAtAnyRateOfAsking) {
  for (const double asked_per_s : {10.0, 90.0, 110.0, 400.0, 50'000.0}) {
    for (const double units : {0.5, 1.0, 30.0}) {
      Budget budget(100.0);
      double given = 0.0;
      const auto every_ns = static_cast<HostNs>(1e9 * units / asked_per_s);
      for (HostNs at = 0; at < 20 * kNsPerS; at += every_ns)
        if (budget.charge(units, kBegin + at)) given += units;
      if (asked_per_s <= 100.0) {
        EXPECT_GE(given, 20.0 * asked_per_s - units);
      } else {
        EXPECT_LE(given, 21.0 * 100.0 + units) << asked_per_s << " a second";
      }
    }
  }
}

TEST(Budget, ComesBackWithinTwoSecondsWhateverWasSpent) {
  Budget budget(100.0);
  EXPECT_FALSE(budget.charge(1e9, kBegin));
  EXPECT_FALSE(budget.charge(1.0, kBegin + kNsPerS / 2));
  EXPECT_FALSE(budget.full(kBegin + kNsPerS));
  EXPECT_TRUE(budget.full(kBegin + 3 * kNsPerS));
  EXPECT_TRUE(budget.charge(1.0, kBegin + 3 * kNsPerS));
}

// Forty connections of one address must not get forty times as much; a connection that is closed
// and opened again nothing anew.
TEST(Budgets, AnAddressHasOneHoweverOftenItConnects) {
  Budgets budgets;
  EXPECT_EQ(budgets.of("10.0.0.1"), budgets.of("10.0.0.1"));
  EXPECT_NE(budgets.of("10.0.0.1"), budgets.of("10.0.0.2"));
  budgets.of("10.0.0.1")->charge(1e9, kBegin);
  budgets.tick(kBegin);
  EXPECT_FALSE(budgets.of("10.0.0.1")->charge(1.0, kBegin));
  budgets.tick(kBegin + 5 * kNsPerS);
  EXPECT_TRUE(budgets.of("10.0.0.1")->charge(1.0, kBegin + 5 * kNsPerS));
}

}  // namespace
}  // namespace tp100::server
