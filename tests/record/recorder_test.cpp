#include "record/recorder.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/resource.h>

#include <chrono>
#include <csignal>
#include <future>
#include <thread>
#include <tuple>

#include "../messages/fixtures.h"
#include "core/error.h"
#include "random_record.h"
#include "record/recording.h"
#include "record/recording_file.h"
#include "record/step_codec.h"
#include "support/temporary_folder.h"

namespace tp100::record {
namespace {

using testing::HasSubstr;

class RecorderTest : public testing::Test {
 protected:
  RecordingSettings settings(const std::string& name = "run.mcap") const {
    return {.path = folder_.file(name), .clock = {0, 0}};
  }
  static RunFacts facts() {
    RunFacts facts;
    facts.run_context = messages::example_subject();
    facts.run_context.version = "9.8.7";
    facts.facts = {{"course", "example"}, {"seed", "7"}};
    facts.files = {
        {.name = "robot.toml", .media_type = "application/toml", .log_ns = 0, .data = "x = 1\n"}};
    return facts;
  }
  static void feed(Recorder& recorder, std::uint64_t from, std::uint64_t to) {
    for (std::uint64_t i = from; i <= to; ++i) recorder.take(*random_record(i));
  }
  static std::uint64_t steps_in(const Recording& recording) {
    std::uint64_t steps = 0;
    recording.visit({.step = [&](const StepRecord&) { ++steps; }});
    return steps;
  }
  static std::vector<std::uint64_t> steps_before(const std::string& path) {
    std::vector<std::uint64_t> steps;
    Recording(path).visit({.before = [&](const StepRecord& r) { steps.push_back(r.step); }});
    return steps;
  }
  static std::vector<std::uint64_t> numbers(std::uint64_t first, std::uint64_t last) {
    std::vector<std::uint64_t> all;
    for (; first <= last; ++first) all.push_back(first);
    return all;
  }
  test::TemporaryFolder folder_;
};

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
  small.max_bytes = 1'000'000;
  Recorder recorder({.blocking = true});
  recorder.begin(small, facts());
  feed(recorder, 1, 4000);
  recorder.end();
  const RecordingStatus status = recorder.status();
  EXPECT_FALSE(status.active);
  EXPECT_THAT(status.warning, HasSubstr("record.max_mb, 1 MB, is reached; the file is whole"));
  EXPECT_LE(status.bytes, 1'000'000u);
  EXPECT_GT(status.bytes, 500'000u);
  const Recording recording(folder_.file("run.mcap"));
  EXPECT_TRUE(recording.whole());
  EXPECT_GT(steps_in(recording), 150u);
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
    const bool said =
        status.warning.find("the disk is full; the file is whole") != std::string::npos;
    std::_Exit(said && !status.active && Recording(settings().path).whole() ? 0 : 1);
  };
  EXPECT_EXIT(record_beyond_a_limit(), testing::ExitedWithCode(0), "");
}

TEST_F(RecorderTest, AFileThatCannotBeWrittenIsAnErrorOfOneLine) {
  RecordingSettings bad = settings();
  bad.path = "/dev/full";
  const auto told = [](const RecordingSettings& s) -> std::string {
    try {
      Recorder recorder;
      recorder.begin(s, facts());
    } catch (const SetupError& error) {
      return error.what();
    }
    return {};
  };
  EXPECT_THAT(told(bad), HasSubstr("No space left on device"));
  bad.path = "/proc/none/run.mcap";
  EXPECT_THAT(told(bad), HasSubstr("cannot create the folder"));
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

TEST_F(RecorderTest, WhatWentInBeforeItBeganIsInARecordingFirst) {
  Recorder recorder(
      {.history = HistorySettings{.folder = folder_.path().string(), .memory_bytes = 200'000},
       .blocking = true});
  feed(recorder, 1, 2000);
  recorder.begin(settings("first.mcap"), facts());
  feed(recorder, 2001, 2100);
  recorder.end();
  feed(recorder, 2101, 2200);
  recorder.begin(settings("second.mcap"), facts());
  feed(recorder, 2201, 2300);
  recorder.end();
  EXPECT_EQ(recorder.status().warning, "");
  for (const auto& [name, begun, ended] :
       {std::tuple("first.mcap", 2000u, 2100u), std::tuple("second.mcap", 2200u, 2300u)}) {
    std::uint64_t step = 0, before = 0;
    Recording(folder_.file(name))
        .visit({.before =
                    [&](const StepRecord& record) {
                      ++before;
                      Bytes is, was;
                      encode_inputs(record, is);
                      encode_inputs(*random_record(++step), was);
                      ASSERT_EQ(is, was) << step;
                    },
                .step = [&](const StepRecord& record) { ASSERT_EQ(record.step, ++step); }});
    EXPECT_EQ(before, begun) << name;
    EXPECT_EQ(step, ended) << name;
  }
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder_.path()), {}), 2)
      << "the file of the history must be anonymous";
}

TEST_F(RecorderTest, ALateRecordingWithoutThemSaysSo) {
  Recorder recorder({.history = HistorySettings{.max_bytes = 100'000}});
  feed(recorder, 1, 2000);
  recorder.begin(settings("ended.mcap"), facts());
  recorder.end();
  recorder.begin(settings(), facts());
  feed(recorder, 2001, 2100);
  recorder.end();
  EXPECT_THAT(recorder.status().warning, HasSubstr("it cannot be replayed"));
  EXPECT_THAT(recorder.status().warning, HasSubstr("more than 0 MB"));
  const Recording recording(folder_.file("run.mcap"));
  EXPECT_TRUE(recording.whole());
  EXPECT_EQ(steps_in(recording), 100u);
}

TEST_F(RecorderTest, AHistoryThatCannotBeWrittenIsReportedByTheRecording) {
  Recorder recorder({.history = HistorySettings{.folder = "/proc/none", .memory_bytes = 100'000}});
  feed(recorder, 1, 2000);
  recorder.begin(settings(), facts());
  feed(recorder, 2001, 2010);
  recorder.end();
  EXPECT_THAT(recorder.status().warning, HasSubstr("it cannot be replayed"));
  EXPECT_THAT(recorder.status().warning, HasSubstr("/proc/none"));
}

// What replay needs: where the step restarted, everything before it is left out.
TEST_F(RecorderTest, AHistoryBeginsWhereTheStepBeganAnew) {
  Recorder recorder({.history = HistorySettings{}, .blocking = true});
  feed(recorder, 1, 999);
  recorder.take(*random_record(1000, true));
  feed(recorder, 1001, 1100);
  recorder.begin(settings(), facts());
  feed(recorder, 1101, 1200);
  recorder.end();
  EXPECT_EQ(recorder.status().warning, "");
  EXPECT_EQ(steps_before(folder_.file("run.mcap")), numbers(1000, 1100));
}

TEST_F(RecorderTest, ARecordingLooksBackWithAllThatLedThere) {
  // 2 s are the last 400 steps and the newest; the history goes back to the step before.
  for (const std::uint64_t anew : {300U, 599U, 600U, 601U, 900U}) {
    Recorder recorder(
        {.history = HistorySettings{.folder = folder_.path().string(), .memory_bytes = 100'000},
         .look_back_ns = 2 * kNsPerS,
         .blocking = true});
    feed(recorder, 1, 99);
    recorder.take(*random_record(100, true));
    for (std::uint64_t i = 101; i <= 1000; ++i) recorder.take(*random_record(i, i == anew));
    RecordingStatus status;
    const std::string name = std::to_string(anew);
    const std::uint64_t number = recorder.ask_look_back(
        [&] { return std::make_unique<RecordingWriter>(settings(name), facts()); },
        [&](const RecordingStatus& ended) { status = ended; });
    EXPECT_NE(number, 0U);
    EXPECT_EQ(recorder.number(), 0U) << "nobody else sees it";
    feed(recorder, 1001, 1200);
    recorder.ask_end(number, [](const std::string&) {});
    recorder.end();
    EXPECT_EQ(status.path, folder_.file(name));
    EXPECT_EQ(status.warning, "");
    EXPECT_EQ(to_s(status.last_ns - status.first_ns), 3.0);
    EXPECT_EQ(recorder.status().path, "");
    EXPECT_EQ(steps_before(folder_.file(name)), numbers(anew <= 600 ? anew : 100, 599));
    EXPECT_EQ(steps_in(Recording(folder_.file(name))), 601U);
  }
}

TEST_F(RecorderTest, TwoThatLookBackShareNoStep) {
  Recorder recorder({.history = HistorySettings{}, .look_back_ns = kNsPerS, .blocking = true});
  std::uint64_t next = 1;
  for (const char* name : {"first.mcap", "second.mcap"}) {
    const std::uint64_t number = recorder.ask_look_back(
        [this, name] { return std::make_unique<RecordingWriter>(settings(name), facts()); },
        [](const RecordingStatus& status) { EXPECT_EQ(status.warning, ""); });
    feed(recorder, next, next + 99);
    recorder.ask_end(number, [](const std::string&) {});
    feed(recorder, next + 100, next + 149);
    next += 150;
  }
  recorder.end();
  EXPECT_EQ(steps_in(Recording(folder_.file("first.mcap"))), 100U);
  EXPECT_EQ(steps_in(Recording(folder_.file("second.mcap"))), 150U) << "50 of them before it";
}

TEST_F(RecorderTest, ARecordingThatLooksBackMakesWay) {
  Recorder recorder({.look_back_ns = kNsPerS, .blocking = true});
  feed(recorder, 1, 100);
  std::vector<std::string> ended;
  const auto look_back = [&](const std::string& name) {
    return recorder.ask_look_back(
        [this, name] { return std::make_unique<RecordingWriter>(settings(name), facts()); },
        [&](const RecordingStatus& status) { ended.push_back(status.path + status.warning); });
  };
  EXPECT_NE(look_back("first.mcap"), 0U);
  EXPECT_EQ(look_back("second.mcap"), 0U);
  EXPECT_THAT(ended, testing::ElementsAre(HasSubstr("running already")));
  recorder.ask_end(0, [](const std::string& why) { EXPECT_NE(why, ""); });
  recorder.begin(settings(), facts());
  feed(recorder, 101, 200);
  recorder.end();
  EXPECT_THAT(ended, testing::ElementsAre(testing::_, HasSubstr("first.mcap")));
  EXPECT_EQ(steps_in(Recording(folder_.file("first.mcap"))), 100U);
  EXPECT_EQ(steps_in(Recording(folder_.file("run.mcap"))), 100U);
}

TEST_F(RecorderTest, RemovingARecordingLeavesNothing) {
  Recorder recorder({.blocking = true});
  recorder.begin(settings("sub/run.mcap"), facts());
  feed(recorder, 1, 10);
  recorder.end();
  remove_recording(recorder.status().path);
  EXPECT_TRUE(std::filesystem::is_empty(folder_.path()));
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

TEST_F(RecorderTest, AfterAFileThatCannotBeMadeTheNextOneMay) {
  Recorder recorder;
  EXPECT_THROW(recorder.begin([]() -> std::unique_ptr<RecordingWriter> { throw SetupError("no"); }),
               SetupError);
  EXPECT_EQ(recorder.number(), 0U);
  recorder.begin(settings(), facts());
  EXPECT_NE(recorder.number(), 0U);
}

// The course has changed: its step cannot be replayed from inputs of the step before.
TEST_F(RecorderTest, WhatIsForgottenIsInNoLaterRecording) {
  Recorder recorder({.history = HistorySettings{}, .look_back_ns = kNsPerS, .blocking = true});
  feed(recorder, 1, 100);
  recorder.forget(101);
  feed(recorder, 101, 120);
  recorder.begin(settings("later.mcap"), facts());
  feed(recorder, 121, 130);
  ASSERT_TRUE(recorder.end());
  EXPECT_EQ(steps_before(folder_.file("later.mcap")), numbers(101, 120));

  recorder.forget(131);
  feed(recorder, 131, 140);
  recorder.ask_look_back(
      [&] { return std::make_unique<RecordingWriter>(settings("box.mcap"), facts()); },
      [](const RecordingStatus&) {});
  feed(recorder, 141, 150);
  ASSERT_TRUE(recorder.end());
  std::vector<std::uint64_t> steps;
  Recording(folder_.file("box.mcap")).visit({.step = [&](const StepRecord& record) {
    steps.push_back(record.step);
  }});
  EXPECT_EQ(steps, numbers(131, 150));
  EXPECT_EQ(steps_before(folder_.file("box.mcap")), numbers(1, 0));
}

TEST_F(RecorderTest, ARecordingMayBeginRightAfterWhatIsForgotten) {
  Recorder recorder({.history = HistorySettings{}, .blocking = true});
  feed(recorder, 1, 100);
  recorder.forget(101);
  recorder.begin(settings(), facts());
  feed(recorder, 101, 110);
  ASSERT_TRUE(recorder.end());
  EXPECT_EQ(recorder.status().warning, "");
  EXPECT_EQ(steps_in(Recording(folder_.file("run.mcap"))), 10u);
  EXPECT_EQ(steps_before(folder_.file("run.mcap")), numbers(1, 0));
}

}  // namespace
}  // namespace tp100::record
