// What waits for a viewer, what is kept for those that come later, and what each may ask for: all
// of it is bounded.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "server/access.h"
#include "server/broker.h"
#include "server/link_window.h"
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

// Who looks on over a slow link would see the past, later and later.
TEST(Outbox, WhatWaitsIsReplacedByNewerDataAtItsPlace) {
  Outbox box;
  const auto data = [](std::uint32_t subscription, std::uint64_t at_ms, const std::string& body) {
    WebSocketFrame out = frame(body);
    out.unix_ns = (1000 + at_ms) * 1'000'000;
    out.head = message_head(subscription, out.unix_ns);
    out.head_size = out.head.size();
    return out;
  };
  for (std::uint64_t at_ms = 0; at_ms <= 1000; at_ms += 5)
    box.push_data(data(1, at_ms, std::to_string(at_ms)));
  box.push_data(data(2, 0, "other"));
  WebSocketFrame event = frame("event");
  event.head = message_head(1, 0);
  box.push_data(event);
  box.push_data(data(1, 1300, "newest"));
  EXPECT_EQ(*box.pop()->body, "newest");
  EXPECT_EQ(*box.pop()->body, "other");
  EXPECT_EQ(*box.pop()->body, "event");
  EXPECT_FALSE(box.pop());
  EXPECT_EQ(box.dropped(), 201U);
  box.push_data(data(3, 0, std::string(Outbox::kMaxCounted + 1, 'x')));
  box.push_data(data(3, 1, "small"));
  EXPECT_EQ(*box.pop()->body, "small");
}

/// Drives a window as a link would that carries so many bytes a second, and returns how old data is
/// at its end at most, after `settle_ns`.
double latest_s(double bytes_ps, HostNs round_trip_ns, HostNs settle_ns) {
  constexpr std::uint64_t kMessage = 1000;
  constexpr HostNs kStepNs = 5 * kNsPerMs, kEndNs = 30 * kNsPerS;
  LinkWindow window;
  double queued = 0.0, latest_s = 0.0;
  HostNs pong_ns = 0;
  for (HostNs now = 0; now < kEndNs; now += kStepNs) {
    queued = std::max(0.0, queued - bytes_ps * to_s(kStepNs));
    if (pong_ns != 0 && now >= pong_ns) {
      pong_ns = 0;
      window.pong(now);
    }
    if (window.open()) {
      window.sent(kMessage);
      queued += static_cast<double>(kMessage);
    }
    if (window.ping(now))
      pong_ns = now + round_trip_ns + static_cast<HostNs>(queued / bytes_ps * 1e9);
    if (now > settle_ns) latest_s = std::max(latest_s, queued / bytes_ps);
  }
  return latest_s;
}

// The buffers of a link hold seconds: what is shown would be that old.
TEST(LinkWindow, DataIsFreshOnAnyLink) {
  EXPECT_LT(latest_s(40'000.0, 300 * kNsPerMs, 5 * kNsPerS), 0.6);
  EXPECT_LT(latest_s(100'000.0, 20 * kNsPerMs, 5 * kNsPerS), 0.4);
  EXPECT_LT(latest_s(1e9, kNsPerMs / 5, 0), 0.01);
}

TEST(LinkWindow, AFastLinkCarriesEverything) {
  LinkWindow window;
  std::uint64_t sent = 0;
  for (HostNs now = 0; now < 5 * kNsPerS; now += kNsPerMs) {
    for (int i = 0; i < 10 && window.open(); ++i, ++sent) window.sent(1000);
    if (window.ping(now)) window.pong(now + kNsPerMs);
  }
  EXPECT_GT(sent, 45'000U);
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
  EXPECT_EQ(Json::parse(history.json("estimate", 60.0).value()).size(), 300U);
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
