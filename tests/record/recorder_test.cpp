// What the recorder writes, when it ends by itself, and that nobody who asks it waits for the disk.

#include "record/recorder.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/resource.h>

#include <chrono>
#include <csignal>
#include <filesystem>
#include <future>
#include <map>
#include <memory>
#include <thread>
#include <utility>

#include "record/step_codec.h"
#include "recorder_rig.h"
#include "support/refusal.h"

namespace tp100::record {
namespace {

using testing::HasSubstr;

TEST_F(RecorderTest, WhatWasTakenIsInTheFileBitForBitAndViewersFindTheirTopics) {
  {
    Recorder recorder({.blocking = true});
    recorder.begin(settings(), facts());
    for (std::uint64_t i = 1; i <= 500; ++i) {
      recorder.take_truth(static_cast<HostNs>(i) * 5 * kNsPerMs,
                          {.x_m = 0.1 * static_cast<double>(i)});
      recorder.take(*random_record(i));
    }
    recorder.message(messages::Channel::kEvent, 7, R"({"text":"hello"})");
  }
  const Recording recording(folder_.path().string());
  EXPECT_TRUE(recording.whole());
  EXPECT_EQ(recording.fact("version"), "9.8.7");
  EXPECT_EQ(recording.fact("seed"), "7");
  EXPECT_EQ(recording.file("robot.toml"), "x = 1\n");
  std::uint64_t step = 0, truth = 0;
  std::map<std::string, int> counts;
  std::string event;
  recording.visit({.step =
                       [&](const StepRecord& record) {
                         std::vector<std::uint8_t> is, was;
                         encode_step(record, is);
                         encode_step(*random_record(++step), was);
                         ASSERT_EQ(is, was) << step;
                       },
                   .truth =
                       [&](HostNs at, const Pose& pose) {
                         ++truth;
                         ASSERT_EQ(at, static_cast<HostNs>(truth) * 5 * kNsPerMs);
                         ASSERT_EQ(pose.x_m, 0.1 * static_cast<double>(truth));
                       },
                   .message =
                       [&](const std::string& topic, std::uint64_t, std::string_view json) {
                         ++counts[topic];
                         if (topic == "/event") event = json;
                       }});
  EXPECT_EQ(step, 500u);
  EXPECT_EQ(truth, 500u);
  EXPECT_EQ(event, R"({"text":"hello"})");
  EXPECT_EQ(counts["/estimate"], 500);
  EXPECT_EQ(counts["/course"], 1);
  EXPECT_EQ(counts["/pose/model"], 125) << "a recording holds poses at 50 Hz";
}

TEST_F(RecorderTest, ARecordingThatIsNeverFinishedHasAllButItsLastHalfSecond) {
  Recorder recorder({.blocking = true});
  recorder.begin(settings(), facts());
  feed(recorder, 1, 1000);
  for (int i = 0; i < 500 && steps_in().size() < 900; ++i)
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  EXPECT_GE(steps_in().size(), 900u);
  EXPECT_FALSE(Recording(folder_.file("run.mcap")).whole());
}

TEST_F(RecorderTest, WhereTheFileMayNotGrowAnyMoreItEndsWholeAndSaysSo) {
  // The limit applies to a process, so a child process runs into it.
  const auto record = [&](const RecordingSettings& small, const rlim_t most, const char* why) {
    std::signal(SIGXFSZ, SIG_IGN);
    const rlimit limit = {most, most};
    setrlimit(RLIMIT_FSIZE, &limit);
    Recorder recorder({.blocking = true});
    recorder.begin(small, facts());
    feed(recorder, 1, 4000);
    for (int i = 0; i < 3000 && recorder.number() != 0; ++i)
      std::this_thread::sleep_for(std::chrono::milliseconds(10));
    const bool by_itself = recorder.number() == 0;
    recorder.end();
    const RecordingStatus status = recorder.status();
    const bool warned = by_itself && status.warning.find(why) != std::string::npos;
    const bool fits = status.bytes <= most && status.bytes > most / 2;
    std::_Exit(warned && fits && !status.active && Recording(small.path).whole() ? 0 : 1);
  };
  EXPECT_EXIT(record(settings(), 1'300'000, "the disk is full; the file is complete"),
              testing::ExitedWithCode(0), "");
  RecordingSettings small = settings();
  small.max_bytes = 2'000'000;
  EXPECT_EXIT(record(small, 2'000'000, "record.max_mb, 2 MB, is reached; the file is complete"),
              testing::ExitedWithCode(0), "");
  EXPECT_GT(steps_in().size(), 300u);
}

TEST_F(RecorderTest, AFileThatCannotBeWrittenIsAnErrorOfOneLine) {
  RecordingSettings bad = settings();
  bad.path = "/dev/full";
  Recorder recorder({.blocking = true});
  const auto refused = [&] { return test::refusal([&] { recorder.begin(bad, facts()); }); };
  EXPECT_THAT(refused(), HasSubstr("No space left on device"));
  bad.path = "/proc/none/run.mcap";
  EXPECT_THAT(refused(), HasSubstr("cannot create the folder"));
  EXPECT_EQ(recorder.number(), 0U);
  // The next one may be made.
  recorder.begin(settings("sub/run.mcap"), facts());
  EXPECT_NE(recorder.number(), 0U);
  recorder.end();
  remove_recording(recorder.status().path);
  EXPECT_TRUE(std::filesystem::is_empty(folder_.path())) << "a recording that is removed";
}

TEST_F(RecorderTest, WhoCannotWaitIsToldWhatWasDropped) {
  Recorder recorder;
  recorder.begin(settings(), facts());
  const auto record = random_record(1);
  record->inputs.samples.resize(record->inputs.samples.kCapacity);
  // The steps arrive faster than any disk can write them, so that the queue overflows.
  for (std::uint64_t i = 1; i <= 20000 && recorder.status().dropped == 0; ++i) {
    record->step = i;
    record->now_ns = static_cast<HostNs>(i) * 5 * kNsPerMs;
    recorder.take(*record);
  }
  recorder.end();
  EXPECT_GT(recorder.status().dropped, 0u);
  EXPECT_TRUE(Recording(folder_.file("run.mcap")).whole());
  EXPECT_GT(steps_in().size(), 0u);
}

// A disk that begins to write only when the test allows it.
class SlowDisk {
 public:
  ~SlowDisk() { go_on(); }
  void go_on() {
    if (!std::exchange(going_, true)) goes_.set_value();
  }
  Recorder::Make make(const RecordingSettings& settings, const RunFacts& facts) {
    return [settings, facts, goes = future_] {
      goes.wait();
      return std::make_unique<RecordingWriter>(settings, facts);
    };
  }

 private:
  bool going_ = false;
  std::promise<void> goes_;
  std::shared_future<void> future_ = goes_.get_future().share();
};

TEST_F(RecorderTest, WhoAsksNeverWaitsForTheDiskAndNothingIsLost) {
  std::vector<std::string> answers;
  Recorder recorder({.history = HistorySettings{}});
  SlowDisk disk;
  const auto answer = [&](const std::string& name) {
    return [&answers, name](const std::string& why) { answers.push_back(name + why); };
  };
  feed(recorder, 1, 10);
  EXPECT_EQ(recorder.ask_begin(disk.make(settings("first.mcap"), facts()), answer("begun")), 1U);
  feed(recorder, 11, 20);
  EXPECT_EQ(recorder.number(), 1U);
  EXPECT_FALSE(recorder.status().active) << "there must be no file yet";
  recorder.ask_end(7, answer("another's: "));
  recorder.ask_end(1, answer("ended"));
  EXPECT_EQ(recorder.number(), 0U);
  feed(recorder, 21, 30);
  EXPECT_EQ(recorder.ask_begin(disk.make(settings("second.mcap"), facts()), answer("begun")), 2U);
  feed(recorder, 31, 40);
  EXPECT_THAT(answers, testing::ElementsAre("another's: nothing is recorded"));
  EXPECT_FALSE(recorder.end(Recorder::Clock::now()))
      << "it must end only after the disk has written";
  disk.go_on();
  EXPECT_TRUE(recorder.end());
  EXPECT_THAT(answers,
              testing::ElementsAre("another's: nothing is recorded", "begun", "ended", "begun"));
  EXPECT_EQ(steps_in("first.mcap"), numbers(11, 20));
  EXPECT_EQ(steps_in("second.mcap"), numbers(31, 40));
  EXPECT_TRUE(Recording(folder_.file("second.mcap")).whole());
}

TEST_F(RecorderTest, OneRecordingAtATimeAndNoEndlessQueueOfRequests) {
  std::string why;
  Recorder recorder;
  SlowDisk disk;
  const auto note = [&](const std::string& text) { why = text; };
  const auto ignore = [](const std::string&) {};
  recorder.ask_begin(disk.make(settings(), facts()), ignore);
  EXPECT_EQ(recorder.ask_begin(disk.make(settings("other"), facts()), note), 0U);
  EXPECT_THAT(why, HasSubstr("running already"));
  why.clear();
  for (int i = 0; i < 100 && why.empty(); ++i) {
    recorder.ask_end(0, note);
    if (why.empty()) recorder.ask_begin(disk.make(settings(), facts()), note);
  }
  EXPECT_THAT(why, HasSubstr("has not served earlier requests"));
}

}  // namespace
}  // namespace tp100::record
