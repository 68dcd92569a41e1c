#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <memory>

#include "../support/temporary_folder.h"
#include "live/live_recording.h"
#include "record/recording.h"

namespace tp100::live {
namespace {

using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::SizeIs;
namespace fs = std::filesystem;

constexpr HostNs kStepNs = 5 * kNsPerMs;

/// Contents of a recording file.
struct Contents {
  std::vector<HostNs> steps;
  std::vector<FaultMask> faults;
  std::vector<std::string> messages;
};

class BlackBoxTest : public testing::Test {
 protected:
  BlackBoxTest() {
    files_.robot = course::read_bundled(course::Bundled::kRobots, "end-loaded");
    files_.course = course::read_bundled(course::Bundled::kCourses, "1-curve");
    run_ = config::parse_run(files_);
    run_.configuration.record.black_box_directory = folder_.file("boxes");
    run_.configuration.record.black_box_s = 3.0;
  }

  LiveRecording& recording() {
    if (!recording_)
      recording_.emplace(std::make_shared<const ActiveRun>(config::LoadedRun{files_, run_}),
                         messages::PublishClock{}, events_);
    return *recording_;
  }
  BlackBox& box() {
    if (!box_) box_.emplace(run_.configuration.record, recording(), events_);
    return *box_;
  }
  void finish() {
    box().finish();
    EXPECT_TRUE(recording().finish(std::chrono::steady_clock::time_point::max()));
  }
  /// Half a second without a fault, then 1.5 s with it.
  void fail() {
    drive(0.5);
    drive(1.5, fault_bit(Fault::link_lost));
    recording().finish(std::chrono::steady_clock::time_point::max());
  }
  void drive(double seconds, FaultMask faults = 0) {
    for (int i = 0; i < static_cast<int>(seconds * 200.0); ++i) {
      record_->now_ns += kStepNs;
      ++record_->step;
      record_->snapshot.faults = faults;
      recording().take(*record_);
      box().take(*record_);
    }
  }
  std::vector<std::string> written() const {
    std::vector<std::string> names;
    if (!fs::exists(folder_.file("boxes"))) return names;
    for (const fs::directory_entry& entry : fs::directory_iterator(folder_.file("boxes")))
      names.push_back(entry.path().string() + "/run.mcap");
    return names;
  }
  static Contents contents(const std::string& path) {
    Contents found;
    record::Recording(path).visit(
        {.step =
             [&](const StepRecord& record) {
               found.steps.push_back(record.now_ns);
               found.faults.push_back(record.snapshot.faults);
             },
         .truth = [](HostNs, const Pose&) {},
         .message =
             [&](const std::string& topic, std::uint64_t, std::string_view json) {
               if (topic == "/event") found.messages.emplace_back(json);
             }});
    return found;
  }

  /// Everything that was told since the last call.
  std::string told() {
    std::string text;
    for (const auto& [event, log_only] : events_.drain()) text += event.text + "\n";
    return text;
  }

  test::TemporaryFolder folder_;
  messages::EventQueue events_;
  config::RunFiles files_;
  config::RunSetup run_;
  std::unique_ptr<StepRecord> record_ = std::make_unique<StepRecord>();
  std::optional<LiveRecording> recording_;
  std::optional<BlackBox> box_;
};

TEST_F(BlackBoxTest, HoldsTheSecondsBeforeAFaultAndOneAfterItOnce) {
  drive(10.0);
  EXPECT_THAT(written(), IsEmpty());
  const HostNs fault_ns = record_->now_ns + kStepNs;
  drive(20.0, fault_bit(Fault::link_lost));
  finish();
  ASSERT_THAT(written(), SizeIs(1)) << "a fault that stays is written once";
  EXPECT_THAT(written()[0], HasSubstr("black-box-link_lost"));
  const Contents found = contents(written()[0]);
  ASSERT_FALSE(found.steps.empty());
  EXPECT_EQ(found.steps.back(), fault_ns + kTailNs);
  EXPECT_NEAR(to_s(found.steps.back() - found.steps.front()), 3.0, 0.01);
  EXPECT_EQ(found.faults.front(), 0U);
  EXPECT_EQ(found.faults.back(), fault_bit(Fault::link_lost));
  EXPECT_THAT(told(), HasSubstr("around link_lost are in"));
}

TEST_F(BlackBoxTest, EveryNewFaultIsWrittenAndTheOldestMakeRoom) {
  fail();
  const std::string oldest = written().at(0);
  for (std::size_t i = 0; i < BlackBox::kMaxFiles; ++i) fail();
  finish();
  EXPECT_THAT(written(), SizeIs(BlackBox::kMaxFiles));
  EXPECT_FALSE(fs::exists(oldest));
}

TEST_F(BlackBoxTest, ARecordingMakesRoomForItselfAndSaysSo) {
  run_.configuration.record.directory = folder_.file("runs");
  run_.configuration.record.quota_mb = 1;
  for (const std::string name : {"runs/old", "runs/noted"}) {
    fs::create_directories(folder_.file(name));
    test::write_bytes(folder_.file(name + "/run.mcap"), std::string(900'000, 'x'));
  }
  test::write_bytes(folder_.file("runs/noted/run.toml"), "keep = true\n");
  drive(0.1);
  recording().begin();
  EXPECT_FALSE(fs::exists(folder_.file("runs/old")));
  EXPECT_TRUE(fs::exists(folder_.file("runs/noted")));
  EXPECT_EQ(told(), "deleted to stay within record.quota_mb: old\n");
  finish();
}

// A cable that comes and goes would fill the disk over the weeks; the runs of a person must stay.
TEST_F(BlackBoxTest, BlackBoxesOfEarlierStartsMakeRoomAndNothingElseDoes) {
  const auto leave = [this](const std::string& name, std::uintmax_t bytes) {
    const fs::path run = folder_.path() / "boxes" / name;
    fs::create_directories(run);
    test::write_bytes(run / "run.mcap", "x");
    fs::resize_file(run / "run.mcap", bytes);
    return run;
  };
  const fs::path old = leave("20260101-000000-black-box-link_lost", 300'000'000),
                 noted = leave("20260102-000000-black-box-heading", 150'000'000),
                 run = leave("20260103-000000-1-straight", 400'000'000),
                 newer = leave("20260104-000000-black-box-cross_track", 100'000'000);
  test::write_bytes(noted / "run.toml", "keep = true\n");
  fs::last_write_time(old / "run.mcap", fs::file_time_type::clock::now() - std::chrono::hours(9));
  fail();
  finish();
  EXPECT_FALSE(fs::exists(old));
  EXPECT_TRUE(fs::exists(noted) && fs::exists(run) && fs::exists(newer));
}

TEST_F(BlackBoxTest, AProgramThatEndsWritesWhatItHas) {
  drive(0.5);
  drive(0.1, fault_bit(Fault::link_lost));
  finish();
  ASSERT_THAT(written(), SizeIs(1));
  EXPECT_THAT(contents(written()[0]).steps, SizeIs(120));
}

TEST_F(BlackBoxTest, WhatWasSaidIsInItFromTheSameTime) {
  drive(1.0);
  recording().on_message(messages::Channel::kEvent, 100'000'000, R"({"text":"long ago"})");
  drive(9.0);
  recording().on_message(messages::Channel::kEvent, 9'900'000'000, R"({"text":"just before"})");
  recording().on_message(messages::Channel::kEstimate, 9'900'000'000,
                         R"({"text":"follows from the steps"})");
  drive(2.0, fault_bit(Fault::link_lost));
  finish();
  ASSERT_THAT(written(), SizeIs(1));
  EXPECT_THAT(contents(written()[0]).messages, testing::ElementsAre(HasSubstr("just before")));
}

TEST_F(BlackBoxTest, IsNotWrittenIfItHasNoSecondsOrARecordingHasThemAlready) {
  for (const bool records : {false, true}) {
    run_.configuration.record.black_box_s = records ? 3.0 : 0.0;
    run_.configuration.record.directory = folder_.file("runs");
    drive(0.5);
    if (records) recording().begin();
    drive(0.5);
    drive(2.0, fault_bit(Fault::link_lost));
    finish();
    EXPECT_THAT(written(), IsEmpty());
    box_.reset();
    recording_.reset();
  }
}

TEST_F(BlackBoxTest, AFolderThatCannotBeMadeIsSaid) {
  test::write_bytes(folder_.file("file"), "in the way");
  run_.configuration.record.black_box_directory = folder_.file("file") + "/boxes";
  fail();
  finish();
  EXPECT_THAT(told(), HasSubstr("black box of link_lost is not written"));
}

TEST(BlackBoxDirectory, IsWhatWasSetElseWhereRecordingsAreElseTheUsers) {
  EXPECT_EQ(black_box_directory({.directory = "runs", .black_box_directory = "boxes"}), "boxes");
  EXPECT_EQ(black_box_directory({.directory = "runs", .black_box_directory = {}}), "runs");
  ::setenv("XDG_STATE_HOME", "/state", 1);
  EXPECT_EQ(black_box_directory({}), "/state/tp100");
  ::unsetenv("XDG_STATE_HOME");
  ::setenv("HOME", "/home/somebody", 1);
  EXPECT_EQ(black_box_directory({}), "/home/somebody/.local/state/tp100");
  ::unsetenv("HOME");
  EXPECT_EQ(black_box_directory({}), "");
}

}  // namespace
}  // namespace tp100::live
