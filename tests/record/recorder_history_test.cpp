// The history of the recorder: what recordings contain of the time before they began.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdint>
#include <filesystem>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "record/step_codec.h"
#include "recorder_rig.h"

namespace tp100::record {
namespace {

using testing::HasSubstr;

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

TEST_F(RecorderTest, ALateRecordingWithoutThemSaysWhy) {
  for (const auto& [history, why] :
       {std::pair{HistorySettings{.max_bytes = 100'000}, "more than 0 MB"},
        {HistorySettings{.folder = "/proc/none", .memory_bytes = 100'000}, "/proc/none"}}) {
    Recorder recorder({.history = history});
    feed(recorder, 1, 2000);
    recorder.begin(settings("ended.mcap"), facts());
    recorder.end();
    recorder.begin(settings(), facts());
    feed(recorder, 2001, 2100);
    recorder.end();
    EXPECT_THAT(recorder.status().warning,
                testing::AllOf(HasSubstr("it cannot be replayed"), HasSubstr(why)));
    EXPECT_TRUE(Recording(folder_.file("run.mcap")).whole());
    EXPECT_EQ(steps_in(), numbers(2001, 2100));
  }
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
  EXPECT_EQ(steps_before(), numbers(1000, 1100));
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
    const std::uint64_t number =
        look_back(recorder, name, [&](const RecordingStatus& ended) { status = ended; });
    EXPECT_NE(number, 0U);
    EXPECT_EQ(recorder.number(), 0U) << "nobody else sees it";
    feed(recorder, 1001, 1200);
    recorder.ask_end(number, [](const std::string&) {});
    recorder.end();
    EXPECT_EQ(status.path, folder_.file(name));
    EXPECT_EQ(status.warning, "");
    EXPECT_EQ(to_s(status.last_ns - status.first_ns), 3.0);
    EXPECT_EQ(recorder.status().path, "");
    EXPECT_EQ(steps_before(name), numbers(anew <= 600 ? anew : 100, 599));
    EXPECT_EQ(steps_in(name), numbers(600, 1200));
  }
}

TEST_F(RecorderTest, TwoThatLookBackShareNoStep) {
  Recorder recorder({.history = HistorySettings{}, .look_back_ns = kNsPerS, .blocking = true});
  std::uint64_t next = 1;
  for (const char* name : {"first.mcap", "second.mcap"}) {
    const std::uint64_t number = look_back(
        recorder, name, [](const RecordingStatus& status) { EXPECT_EQ(status.warning, ""); });
    feed(recorder, next, next + 99);
    recorder.ask_end(number, [](const std::string&) {});
    feed(recorder, next + 100, next + 149);
    next += 150;
  }
  recorder.end();
  EXPECT_EQ(steps_in("first.mcap"), numbers(1, 100));
  EXPECT_EQ(steps_in("second.mcap"), numbers(101, 250)) << "50 of them before it";
}

TEST_F(RecorderTest, ARecordingThatLooksBackMakesWay) {
  Recorder recorder({.look_back_ns = kNsPerS, .blocking = true});
  feed(recorder, 1, 100);
  std::vector<std::string> ended;
  const auto note = [&](const RecordingStatus& status) {
    ended.push_back(status.path + status.warning);
  };
  EXPECT_NE(look_back(recorder, "first.mcap", note), 0U);
  EXPECT_EQ(look_back(recorder, "second.mcap", note), 0U);
  EXPECT_THAT(ended, testing::ElementsAre(HasSubstr("running already")));
  recorder.ask_end(0, [](const std::string& why) { EXPECT_NE(why, ""); });
  recorder.begin(settings(), facts());
  feed(recorder, 101, 200);
  recorder.end();
  EXPECT_THAT(ended, testing::ElementsAre(testing::_, HasSubstr("first.mcap")));
  EXPECT_EQ(steps_in("first.mcap"), numbers(1, 100));
  EXPECT_EQ(steps_in(), numbers(101, 200));
}

// The course has changed: its step cannot be replayed from inputs of the step before.
TEST_F(RecorderTest, WhatIsForgottenIsInNoLaterRecording) {
  Recorder recorder({.history = HistorySettings{}, .look_back_ns = kNsPerS, .blocking = true});
  feed(recorder, 1, 100);
  recorder.forget(101);
  recorder.begin(settings("at-once.mcap"), facts());
  feed(recorder, 101, 110);
  ASSERT_TRUE(recorder.end());
  EXPECT_EQ(recorder.status().warning, "");
  EXPECT_EQ(steps_in("at-once.mcap"), numbers(101, 110));
  EXPECT_EQ(steps_before("at-once.mcap"), numbers(1, 0));

  recorder.forget(111);
  feed(recorder, 111, 120);
  recorder.begin(settings("later.mcap"), facts());
  feed(recorder, 121, 130);
  ASSERT_TRUE(recorder.end());
  EXPECT_EQ(steps_before("later.mcap"), numbers(111, 120));

  recorder.forget(131);
  feed(recorder, 131, 140);
  look_back(recorder, "back.mcap", [](const RecordingStatus&) {});
  feed(recorder, 141, 150);
  ASSERT_TRUE(recorder.end());
  EXPECT_EQ(steps_in("back.mcap"), numbers(131, 150));
  EXPECT_EQ(steps_before("back.mcap"), numbers(1, 0));
}

}  // namespace
}  // namespace tp100::record
