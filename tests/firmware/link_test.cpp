// Tests what leaves for the host, and in which order, when the line takes little.

#include <gtest/gtest.h>

#include <random>

#include "../support/wire_host.h"
#include "firmware/host_link.h"
#include "scripted_hal.h"

namespace tp100::firmware {
namespace {

using test::text_of;
using wire::Type;

class HostLinkTest : public test::ReceivedFrames, public testing::Test {
 protected:
  void post_one_of_each(std::uint32_t number) {
    link.log(2, "what was said: ", "and more of it, which does not fit any more", number);
    wire::Hello hello{};
    hello.boot_nonce = number;
    link.post(hello);
    link.post(wire::FaultReport{number, 1, 2, 3});
    wire::Sample sample{};
    sample.device_us = number;
    link.post(sample);
    link.post(wire::Acknowledge{1, number, 0, 0});
    link.post(wire::SyncReply{static_cast<std::uint16_t>(number), 0, 0, 0, 0});
  }
  /// Types of the frames that leave if the line takes `room` bytes now.
  std::vector<Type> flush(std::size_t room) {
    hal.room = room;
    link.flush();
    std::vector<Type> types;
    for (const std::uint8_t byte : hal.sent) {
      if (const auto type = receive(byte)) types.push_back(*type);
    }
    hal.sent.clear();
    hal.room = 0;
    return types;
  }

  ScriptedHal hal;
  HostLink link{hal};
};

TEST_F(HostLinkTest, TheMostUrgentLeavesFirst) {
  hal.room = 0;
  post_one_of_each(7);
  EXPECT_EQ(flush(250), (std::vector{Type::kSyncReply, Type::kAcknowledge, Type::kSample,
                                     Type::kFaultReport, Type::kHello, Type::kLog}));
  EXPECT_EQ(text_of(logs.at(0)), "what was said: and more of it, which doe") << "cut at 40 letters";
  EXPECT_EQ(logs[0].level, 2);
}

// A delimiter precedes a hello, so that earlier bytes on the line do not become its beginning.
TEST_F(HostLinkTest, AFrameLeavesOnlyWhenThereIsRoomForAllOfIt) {
  hal.room = 0;
  link.post(wire::Hello{});
  EXPECT_TRUE(flush(wire::Hello::kSize + 5).empty());
  EXPECT_EQ(flush(1 + wire::Hello::kSize + 5), std::vector{Type::kHello});
  EXPECT_FALSE(hal.overfilled);
}

// Samples, sync replies and hellos are replaced by newer ones; answers, reports and texts wait up
// to a number, and the others are counted.
TEST_F(HostLinkTest, WhatWaitsForTheLineIsKeptOrCounted) {
  hal.room = 0;
  for (std::uint32_t i = 1; i <= 13; ++i) post_one_of_each(i);
  while (!flush(250).empty()) {
  }
  ASSERT_EQ(samples.size(), 1U);
  EXPECT_EQ(samples[0].device_us, 13U);
  EXPECT_EQ(sync_replies.at(0).id, 13);
  EXPECT_EQ(hellos.at(0).boot_nonce, 13U);
  ASSERT_EQ(acknowledges.size(), 6U);
  EXPECT_EQ(reports.size(), 13U) << "a place for each fault";
  EXPECT_EQ(logs.size(), 4U);
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_EQ(acknowledges[i].token, i + 1) << "in their order";
    EXPECT_EQ(reports[i].device_us, i + 1);
    EXPECT_EQ(logs[i].device_us, i + 1);
  }
  EXPECT_EQ(link.counts().unsent, 12 + 12 + 7 + 9);
}

TEST_F(HostLinkTest, HoweverMuchTheLineTakesNothingIsBrokenOrInventedOrLostUncounted) {
  std::mt19937 random(1);
  int posted = 0;
  for (int i = 0; i < 3000; ++i) {
    hal.room = random() % 80;
    if (random() % 4 == 0) post_one_of_each(static_cast<std::uint32_t>(i)), ++posted;
    flush(random() % 120);
  }
  while (!flush(250).empty()) {
  }
  EXPECT_EQ(bad_frames, 0);
  EXPECT_FALSE(hal.overfilled);
  const std::size_t left = samples.size() + sync_replies.size() + acknowledges.size() +
                           reports.size() + logs.size() + link.counts().unsent;
  EXPECT_EQ(left, static_cast<std::size_t>(5 * posted)) << "a newer hello replaces one uncounted";
  EXPECT_TRUE(std::is_sorted(acknowledges.begin(), acknowledges.end(),
                             [](const auto& a, const auto& b) { return a.token < b.token; }));
}

}  // namespace
}  // namespace tp100::firmware
