#include "live/link_monitor.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <memory>

namespace tp100::live {
namespace {

using ::testing::HasSubstr;
using ::testing::SizeIs;

class LinkMonitorTest : public ::testing::Test {
 protected:
  LinkMonitorTest() { record_->inputs.session = SessionState::kReady; }
  /// Steps for `seconds` at 200 Hz; returns the events that were reported.
  std::vector<messages::Event> drive(double seconds) {
    std::vector<messages::Event> events;
    for (const HostNs end = record_->now_ns + from_s(seconds); record_->now_ns < end;) {
      record_->now_ns += 5 * kNsPerMs;
      ++record_->step;
      watch_.take(*record_);
      for (messages::Event& word : watch_.drain_events()) events.push_back(std::move(word));
    }
    return events;
  }
  std::unique_ptr<StepRecord> record_ = std::make_unique<StepRecord>();
  LinkMonitor watch_;
};

TEST_F(LinkMonitorTest, AGoodLinkIsNotSpokenOf) {
  record_->snapshot.has_sample = true;
  record_->snapshot.age_us = 6000;
  record_->link.sync_rejected = 2;
  EXPECT_THAT(drive(60.0), SizeIs(0));
}

TEST_F(LinkMonitorTest, EveryTroubleHasALineWithCauseAndFix) {
  drive(0.1);
  LinkCounters& link = record_->link;
  link.crc_errors = link.unknown_type = link.implausible = link.unwritten = 1;
  link.robot_corrupted = link.missed_edges = 1;
  link.duplicated = link.sync_rejected = 20;
  record_->snapshot.has_sample = true;
  record_->snapshot.age_us = 23'000;
  record_->now_ns += 100 * kNsPerMs;
  const std::vector<messages::Event> events = drive(1.0);
  EXPECT_THAT(events, SizeIs(10));
  for (const messages::Event& word : events) {
    EXPECT_EQ(word.level, messages::Event::Level::kWarning) << word.text;
    EXPECT_NE(word.cause, "") << word.text;
    EXPECT_NE(word.fix, "") << word.text;
  }
}

TEST_F(LinkMonitorTest, WhatLastsIsSaidEveryTenSecondsWithItsNumber) {
  drive(0.1);
  record_->link.crc_errors = 1;
  const auto first = drive(1.0);
  ASSERT_THAT(first, SizeIs(1));
  EXPECT_THAT(first[0].text, HasSubstr("1 corrupted"));
  record_->link.crc_errors = 41;
  EXPECT_THAT(drive(8.0), SizeIs(0));
  const auto second = drive(2.0);
  ASSERT_THAT(second, SizeIs(1));
  EXPECT_THAT(second[0].text, HasSubstr("40 corrupted"));
}

TEST_F(LinkMonitorTest, StepsThatFoundNoRoomAreNoPause) {
  drive(0.1);
  record_->now_ns += 300 * kNsPerMs;
  record_->step += 60;
  EXPECT_THAT(drive(0.1), SizeIs(0));
}

TEST_F(LinkMonitorTest, APauseOfTheLoopIsSpokenOfWithItsLength) {
  drive(0.1);
  record_->now_ns += 300 * kNsPerMs;
  const auto events = drive(0.1);
  ASSERT_THAT(events, SizeIs(1));
  EXPECT_THAT(events[0].text, HasSubstr("305 ms"));
}

}  // namespace
}  // namespace tp100::live
