#include "server/history.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

namespace tp100::server {
namespace {

using messages::Channel;
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

}  // namespace
}  // namespace tp100::server
