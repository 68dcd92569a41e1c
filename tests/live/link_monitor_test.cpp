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

TEST_F(LinkMonitorTest, EveryTroubleHasALineWithCauseAndFixAndAGoodLinkHasNone) {
  LinkCounters& link = record_->link;
  record_->snapshot.has_sample = true;
  record_->snapshot.age_us = 6000;
  link.sync_rejected = 2;
  EXPECT_THAT(drive(60.0), SizeIs(0));
  link.crc_errors = link.unknown_type = link.implausible = link.unwritten = 1;
  link.robot_corrupted = link.missed_edges = 1;
  link.duplicated = 20;
  link.sync_rejected = 22;
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

TEST_F(LinkMonitorTest, PosesOfACameraThatAreOfNoUseAreSpokenOf) {
  const auto poses = [this](std::uint32_t used, std::uint32_t rejected) {
    record_->snapshot.filter.camera_used += used;
    record_->snapshot.filter.camera_rejected += rejected;
    return drive(1.0);
  };
  for (int i = 0; i < 600; ++i) EXPECT_THAT(poses(30, 1), SizeIs(0)) << "a few are usual";
  std::vector<messages::Event> events;
  for (int i = 0; i < 10; ++i)
    for (messages::Event& one : poses(15, 15)) events.push_back(std::move(one));
  ASSERT_THAT(events, SizeIs(1)) << "however many were used before";
  EXPECT_THAT(events[0].text, HasSubstr("rejected"));
  record_->snapshot.filter.camera_used = record_->snapshot.filter.camera_rejected = 0;
  EXPECT_THAT(poses(30, 0), SizeIs(0)) << "a run counts anew";

  watch_.take(link::CameraCounters{.malformed = 3, .late = 12});
  events = drive(0.1);
  ASSERT_THAT(events, SizeIs(2));
  EXPECT_THAT(events[0].text, HasSubstr("3 malformed"));
  EXPECT_THAT(events[1].text, HasSubstr("12 poses"));
  for (const messages::Event& one : events) EXPECT_EQ(one.kind, "camera");
}

TEST_F(LinkMonitorTest, ASlopeOnASetUpWithoutOneIsSpokenOfWithTheSetUp) {
  Snapshot& snapshot = record_->snapshot;
  snapshot.imu_pitch_rad = -28.0 * kRadPerDeg;
  EXPECT_THAT(drive(1.0), SizeIs(0)) << "the robot may be carried";
  snapshot.run_state = RunState::kRunning;
  const auto events = drive(1.0);
  ASSERT_THAT(events, SizeIs(1));
  EXPECT_THAT(events[0].text, HasSubstr("28 deg"));
  EXPECT_THAT(events[0].text, HasSubstr("set-up"));
  snapshot.imu_pitch_rad = 0.0;
  drive(20.0);
  snapshot.imu_pitch_rad = 0.3;
  snapshot.terrain_contact.pitch_source = PitchSource::kImu;
  EXPECT_THAT(drive(1.0), SizeIs(0)) << "on terrain slopes are real";
}

// A fault of the run would scroll out of sight under what lasts.
TEST_F(LinkMonitorTest, WhatLastsIsSaidLessAndLessOftenWithItsNumber) {
  drive(0.1);
  record_->link.crc_errors = 1;
  const auto first = drive(1.0);
  ASSERT_THAT(first, SizeIs(1));
  EXPECT_THAT(first[0].text, HasSubstr("1 corrupted"));
  record_->link.crc_errors = 41;
  std::size_t said = 0;
  for (int s = 0; s < 600; ++s) {
    ++record_->link.crc_errors;
    said += drive(1.0).size();
  }
  EXPECT_GE(said, 4U);
  EXPECT_LE(said, 6U) << "after 20, 40, 80, 160 and 320 s";
  drive(700.0);
  ++record_->link.crc_errors;
  EXPECT_THAT(drive(1.0), SizeIs(1)) << "what comes again after a long time is new";
}

// Nobody finds a USB bridge on a pseudo-terminal.
TEST_F(LinkMonitorTest, LateSamplesOfAPseudoTerminalAreTheMachinesFault) {
  for (const bool pseudo_terminal : {false, true}) {
    LinkMonitor monitor;
    monitor.set_pseudo_terminal(pseudo_terminal);
    StepRecord record;
    record.inputs.session = SessionState::kReady;
    record.snapshot.has_sample = true;
    record.snapshot.age_us = 50'000;
    for (int i = 1; i <= 5; ++i) {
      record.step = static_cast<std::uint64_t>(i);
      record.now_ns = 10 * kNsPerS + i * 5 * kNsPerMs;
      monitor.take(record);
    }
    const auto events = monitor.drain_events();
    ASSERT_THAT(events, SizeIs(1));
    EXPECT_EQ(events[0].cause.find("USB") == std::string::npos, pseudo_terminal);
  }
}

TEST_F(LinkMonitorTest, APauseOfTheLoopIsSpokenOfWithItsLengthButNotStepsThatFoundNoRoom) {
  drive(0.1);
  record_->now_ns += 300 * kNsPerMs;
  record_->step += 60;
  EXPECT_THAT(drive(0.1), SizeIs(0));
  record_->now_ns += 300 * kNsPerMs;
  const auto events = drive(0.1);
  ASSERT_THAT(events, SizeIs(1));
  EXPECT_THAT(events[0].text, HasSubstr("305 ms"));
}

}  // namespace
}  // namespace tp100::live
