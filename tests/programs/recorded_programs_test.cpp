// Recordings of programs that run in real time: exported, or cut off by a kill.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>

#include "core/error.h"
#include "core/processor.h"
#include "process.h"
#include "record/recording.h"
#include "support/paths.h"

namespace tp100::sim {
namespace {

using record::Recording;
using testing::HasSubstr;
using Json = nlohmann::json;

class RecordedPrograms : public testing::Test {
 protected:
  RecordedPrograms() {
    test::write_bytes(folder_.file("tp100.toml"), "[loop]\npriority = 0\nlock_memory = false\n");
  }
  /// Without a course, the run continues even when a busy machine delays its cycles.
  test::Words daemon(const test::Words& more = {}) const {
    return test::joined({"tp100d", "run", "--config", folder_.file("tp100.toml"), "--port", port(),
                         "--record", records()},
                        more);
  }
  std::string port() const { return folder_.file("tp100"); }
  std::string records() const { return folder_.file("records"); }
  /// The file of the only run.
  std::string file() const {
    for (const auto& entry : std::filesystem::directory_iterator(records()))
      return (entry.path() / "run.mcap").string();
    return "none";
  }
  /// Number of steps that can be read so far; 0 if the file has no beginning yet.
  static std::uint64_t steps_in(const std::string& file) {
    std::uint64_t steps = 0;
    try {
      Recording(file).visit({.step = [&](const StepRecord&) { ++steps; }});
    } catch (const UserError&) {
    }
    return steps;
  }
  void expect_replayed(const std::string& file) const {
    const test::Finished replay = test::run({"tp100d", "replay", file, "--out", folder_.file("p")});
    EXPECT_EQ(replay.status, 0) << replay.output;
    EXPECT_THAT(replay.output, HasSubstr("every pose and command as recorded, bit for bit"));
    EXPECT_GT(test::lines(test::read_bytes(folder_.file("p"))), 10u);
  }
  test::TemporaryFolder folder_;
};

TEST_F(RecordedPrograms, RecordedDrivesAreIdentifiedAgainstTheirOwnRobot) {
  const auto drive = [&](const std::string& robot) {
    const test::Finished driven = test::run({"tp100-sim", "course", "calibrate-spin-left",
                                             "--robot", robot, "--camera", "--record", records()});
    EXPECT_EQ(driven.status, 0) << driven.output;
    return records() + "/calibrate-spin-left-" + robot + "-1";
  };
  const std::string worn = drive("worn");
  const auto identify = [&](const test::Words& more) {
    return test::run(
        test::joined({"tp100d", "identify", "--out", folder_.file("new.toml"), "--json"}, more));
  };
  const test::Finished found = identify({worn});
  ASSERT_EQ(found.status, 0) << found.output;
  const Json json = Json::parse(found.output);
  EXPECT_EQ(json["robot"], "worn");
  EXPECT_EQ(json["errors_after"]["runs"][0]["name"], "calibrate-spin-left-worn-1");
  EXPECT_GT(json["errors_after"]["runs"][0]["images"], 10);
  EXPECT_LE(json["errors_after"]["rms_rad"], json["errors_before"]["rms_rad"]);
  EXPECT_EQ(test::run({"tp100d", "check", folder_.file("new.toml")}).status, 0);
  const std::string other = drive("uniform");
  EXPECT_THAT(identify({worn, other}).output,
              HasSubstr("was recorded with a different robot file"));
  EXPECT_EQ(identify({worn, other, "--robot", "end-loaded"}).status, 0);
}

TEST_F(RecordedPrograms, ALiveRunHoldsWhatHappenedReplaysBitForBitAndIsExported) {
  const auto robot = test::start_robot(port());
  // The run is recorded without any viewer.
  test::Process bridge(daemon(
      {"--course", test::short_course(folder_, 0.3), "--listen", "off", "--duration", "30"}));
  // On a busy machine commands may arrive too late; then the run is aborted, and the recording says
  // so.
  const std::string end =
      bridge.wait() == 0 ? "state: running -> finished" : "state: running -> aborted";
  EXPECT_THAT(bridge.output(), HasSubstr("recording to " + file()));
  EXPECT_THAT(bridge.output(), testing::Not(HasSubstr("page:")));

  std::map<std::string, int> counts;
  std::map<std::string, std::uint64_t> happened;
  std::uint64_t first = UINT64_MAX, last = 0;
  Recording(file()).visit(
      {.message = [&](const std::string& topic, std::uint64_t unix_ns, std::string_view json) {
        ++counts[topic];
        if (topic == "/estimate") first = std::min(first, unix_ns), last = unix_ns;
        if (topic == "/event") happened[Json::parse(json)["text"]] = unix_ns;
      }});
  for (const std::string& text :
       {std::string("state: idle -> arming"), std::string("state: arming -> running"), end}) {
    ASSERT_TRUE(happened.contains(text)) << text;
    EXPECT_GE(happened[text], first) << text;
    EXPECT_LE(happened[text], last) << text;
  }
  EXPECT_EQ(counts["/log"], counts["/event"]);
  for (const char* topic : {"/state", "/link", "/loop", "/parameter"}) EXPECT_GT(counts[topic], 0);
  // /state is published five times a second and at every change.
  EXPECT_LT(counts["/state"], counts["/estimate"] / 4);

  ASSERT_EQ(test::run({"tp100d", "report", file()}).status, 0);
  EXPECT_THAT(test::read_bytes(std::filesystem::path(file()).parent_path() / "report.html"),
              HasSubstr("run: running -&gt; " + end.substr(end.rfind(' ') + 1)));
  expect_replayed(file());
  const std::string out = folder_.file("out");
  std::filesystem::create_directory(out);
  EXPECT_EQ(test::run({"tp100d", "export", file(), "--out", out}).status, 0);
  for (const char* name : {"samples.csv", "poses.csv", "model.tum", "odometry.tum", "fused.tum"})
    EXPECT_GT(test::lines(test::read_bytes(out + "/" + name)), 10u) << name;
  EXPECT_FALSE(std::filesystem::exists(out + "/truth.tum")) << "a live run has no ground truth";
}

TEST_F(RecordedPrograms, AKilledRunIsReadableAndRecoverMakesItWhole) {
  const auto robot = test::start_robot(port());
  test::Process bridge(daemon());
  ASSERT_TRUE(bridge.wait_for("state: syncing -> ready")) << bridge.output();
  // Waits until two seconds of the run are in the file.
  for (int i = 0; i < 600 && steps_in(file()) < 400; ++i)
    std::this_thread::sleep_for(std::chrono::milliseconds(100));
  const HostNs killed = std::chrono::steady_clock::now().time_since_epoch().count();
  bridge.signal(SIGKILL);
  bridge.wait();

  HostNs last = 0;
  const Recording cut(file());
  EXPECT_FALSE(cut.whole());
  cut.visit({.step = [&](const StepRecord& record) { last = record.now_ns; }});
  // The loss is less than a second unless a busy machine delays the writer.
  EXPECT_LT(to_s(killed - last), 5.0);

  const test::Finished recover = test::run({"tp100d", "recover", file()});
  EXPECT_EQ(recover.status, 0) << recover.output;
  const std::string saved = std::filesystem::path(file()).parent_path() / "run-recovered.mcap";
  const Recording whole(saved);
  EXPECT_TRUE(whole.whole());
  EXPECT_EQ(steps_in(saved), steps_in(file()));
  expect_replayed(saved);
  EXPECT_THAT(test::run({"tp100d", "recover", saved}).output, HasSubstr("nothing to recover"));
}

TEST_F(RecordedPrograms, ARunThatNeverBeganLeavesNothing) {
  EXPECT_EQ(test::run(daemon()).status, 2);
  EXPECT_TRUE(std::filesystem::is_empty(records()));
}

// The C library without FMA, as on an older processor: recordings made with it are replayed here.
TEST(Processors, ARecordingWithoutFmaIsReplayedButForRounding) {
  if (!arithmetic().starts_with("x86_64") || !arithmetic().ends_with("with FMA"))
    GTEST_SKIP() << arithmetic()
                 << ": this processor has no other choice of the C library's functions";
  const test::TemporaryFolder folder;
  const auto recorded = test::run({"/usr/bin/env", "GLIBC_TUNABLES=glibc.cpu.hwcaps=-FMA,-AVX2",
                                   build_path("bin/tp100-sim"), "course", "1-curve", "--record",
                                   folder.file("runs")});
  ASSERT_EQ(recorded.status, 0) << recorded.output;
  const auto replayed = test::run({"tp100d", "replay", folder.file("runs/1-curve-end-loaded-1"),
                                   "--out", folder.file("poses.csv")});
  EXPECT_EQ(replayed.status, 0) << replayed.output;
  EXPECT_THAT(replayed.output, HasSubstr("the largest difference is "));
  EXPECT_THAT(replayed.output, HasSubstr("without FMA, replayed on " + arithmetic()));
}

}  // namespace
}  // namespace tp100::sim
