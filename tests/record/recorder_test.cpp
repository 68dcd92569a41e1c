#include "record/recorder.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/resource.h>

#include <chrono>
#include <csignal>
#include <filesystem>
#include <future>
#include <memory>
#include <thread>
#include <utility>

#include "core/error.h"
#include "record/step_codec.h"
#include "recorder_rig.h"
#include "support/refusal.h"

namespace tp100::record {
namespace {

using testing::HasSubstr;

TEST_F(RecorderTest, WhatWasTakenIsInTheFileBitForBit) {
  {
    Recorder recorder({.blocking = true});
    recorder.begin(settings(), facts());
    for (std::uint64_t i = 1; i <= 500; ++i) {
      recorder.take_truth(static_cast<HostNs>(i) * 5 * kNsPerMs,
                          {.x_m = 0.1 * static_cast<double>(i)});
      recorder.take(*random_record(i));
    }
  }
  const Recording recording(folder_.path().string());
  EXPECT_TRUE(recording.whole());
  EXPECT_EQ(recording.fact("version"), "9.8.7");
  EXPECT_EQ(recording.fact("seed"), "7");
  EXPECT_EQ(recording.file("robot.toml"), "x = 1\n");
  std::uint64_t step = 0, truth = 0;
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
                       }});
  EXPECT_EQ(step, 500u);
  EXPECT_EQ(truth, 500u);
}

TEST_F(RecorderTest, ViewersFindTheirTopics) {
  {
    Recorder recorder({.blocking = true});
    recorder.begin(settings(), facts());
    feed(recorder, 1, 100);
    recorder.message(messages::Channel::kEvent, 7, R"({"text":"hello"})");
  }
  std::map<std::string, int> counts;
  std::string event;
  Recording(folder_.file("run.mcap"))
      .visit({.message = [&](const std::string& topic, std::uint64_t, std::string_view json) {
        ++counts[topic];
        if (topic == "/event") event = json;
      }});
  EXPECT_EQ(counts["/estimate"], 100);
  EXPECT_EQ(counts["/course"], 1);
  EXPECT_EQ(counts["/scene"], 1);
  EXPECT_EQ(counts["/pose/model"], 25) << "/pose/model is published at 50 Hz";
  EXPECT_EQ(counts["/tf"], 25);
  EXPECT_EQ(event, R"({"text":"hello"})");
}

TEST_F(RecorderTest, ARecordingThatIsNeverFinishedHasAllButItsLastHalfSecond) {
  Recorder recorder({.blocking = true});
  recorder.begin(settings(), facts());
  feed(recorder, 1, 1000);
  // Once the number of steps stops growing, the queue is empty.
  const auto steps = [&] { return steps_in(Recording(folder_.file("run.mcap"))); };
  for (int i = 0; i < 500 && steps() < 900; ++i)
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  EXPECT_GE(steps(), 900u);
  EXPECT_FALSE(Recording(folder_.file("run.mcap")).whole());
}

TEST_F(RecorderTest, AtItsSizeLimitItEndsWholeAndSaysSo) {
  RecordingSettings small = settings();
  small.max_bytes = 2'000'000;
  Recorder recorder({.blocking = true});
  recorder.begin(small, facts());
  feed(recorder, 1, 4000);
  recorder.end();
  const RecordingStatus status = recorder.status();
  EXPECT_FALSE(status.active);
  EXPECT_THAT(status.warning, HasSubstr("record.max_mb, 2 MB, is reached; the file is complete"));
  EXPECT_LE(status.bytes, 2'000'000u);
  EXPECT_GT(status.bytes, 1'000'000u);
  const Recording recording(folder_.file("run.mcap"));
  EXPECT_TRUE(recording.whole());
  EXPECT_GT(steps_in(recording), 300u);
}

TEST_F(RecorderTest, WhereTheFileMayNotGrowAnyMoreItEndsWholeAndSaysSo) {
  // The limit applies to a process, so a child process runs into it.
  const auto record_beyond_a_limit = [&] {
    std::signal(SIGXFSZ, SIG_IGN);
    const rlimit limit = {1'000'000, 1'000'000};
    setrlimit(RLIMIT_FSIZE, &limit);
    Recorder recorder({.blocking = true});
    recorder.begin(settings(), facts());
    feed(recorder, 1, 4000);
    recorder.end();
    const RecordingStatus status = recorder.status();
    const bool warned =
        status.warning.find("the disk is full; the file is complete") != std::string::npos;
    std::_Exit(warned && !status.active && Recording(settings().path).whole() ? 0 : 1);
  };
  EXPECT_EXIT(record_beyond_a_limit(), testing::ExitedWithCode(0), "");
}

TEST_F(RecorderTest, AFileThatCannotBeWrittenIsAnErrorOfOneLine) {
  RecordingSettings bad = settings();
  bad.path = "/dev/full";
  const auto error_of = [](const RecordingSettings& s) -> std::string {
    return test::refusal([&] {
      Recorder recorder;
      recorder.begin(s, facts());
    });
  };
  EXPECT_THAT(error_of(bad), HasSubstr("No space left on device"));
  bad.path = "/proc/none/run.mcap";
  EXPECT_THAT(error_of(bad), HasSubstr("cannot create the folder"));
  // The next one may be made.
  Recorder recorder({.blocking = true});
  EXPECT_THROW(recorder.begin(bad, facts()), SetupError);
  EXPECT_EQ(recorder.number(), 0U);
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
  const std::uint64_t dropped = recorder.status().dropped;
  const Recording recording(folder_.file("run.mcap"));
  EXPECT_TRUE(recording.whole());
  EXPECT_GT(dropped, 0u);
  EXPECT_GT(steps_in(recording), 0u);
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
  EXPECT_EQ(steps_in(Recording(folder_.file("first.mcap"))), 10U);
  EXPECT_EQ(steps_in(Recording(folder_.file("second.mcap"))), 10U);
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
