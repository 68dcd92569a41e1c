// Recordings of programs that run in real time: exported, or cut off by a kill or a full disk.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>

#include "core/error.h"
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
  RecordedPrograms() { configure(""); }
  void configure(const std::string& record) const {
    test::write_bytes(folder_.file("tp100.toml"),
                      "[loop]\npriority = 0\nlock_memory = false\n[record]\n" + record);
  }
  /// Without a course, the run continues even when a busy machine delays its cycles.
  test::Words daemon(const test::Words& more = {}) const {
    return test::joined({"tp100d", "run", "--config", folder_.file("tp100.toml"), "--port", port()},
                        more);
  }
  test::Words recording_daemon(const test::Words& more = {}) const {
    return test::joined(daemon({"--record", records()}), more);
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
    } catch (const SetupError&) {
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
    return test::run(test::joined(
        {"tp100d", "identify", "--out", folder_.file("new.toml"), "--json", "--background"}, more));
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
  test::Process bridge(recording_daemon(
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
  EXPECT_LT(happened["state: idle -> arming"], happened["state: arming -> running"]);
  EXPECT_LT(happened["state: arming -> running"], happened[end]);
  EXPECT_EQ(counts["/log"], counts["/event"]);
  for (const char* topic : {"/state", "/link", "/loop", "/parameter"}) EXPECT_GT(counts[topic], 0);
  // /state is published five times a second and at every change.
  EXPECT_LT(counts["/state"], counts["/estimate"] / 4);

  ASSERT_EQ(test::run({"tp100d", "report", file()}).status, 0);
  const std::string page =
      test::read_bytes((std::filesystem::path(file()).parent_path() / "report.html").string());
  EXPECT_THAT(page, HasSubstr("hello from an emulated board"));
  EXPECT_THAT(page, HasSubstr("run: running -&gt; " + end.substr(end.rfind(' ') + 1)));

  expect_replayed(file());
  const std::string out = folder_.file("out");
  std::filesystem::create_directory(out);
  EXPECT_EQ(test::run({"tp100d", "export", file(), "--out", out}).status, 0);
  for (const char* name : {"samples.csv", "poses.csv", "model.tum", "odometry.tum", "fused.tum"})
    EXPECT_GT(test::lines(test::read_bytes(out + "/" + name)), 10u) << name;
  EXPECT_FALSE(std::filesystem::exists(out + "/truth.tum")) << "a live run has no ground truth";
}

TEST_F(RecordedPrograms, ABlackBoxReplaysBitForBit) {
  configure("black_box_s = 3\nblack_box_directory = \"" + records() + "\"\n");
  const auto robot = test::start_robot(port(), {"--course", "1-curve"});
  test::Process bridge(daemon({"--course", "1-curve", "--duration", "12"}));
  // A busy machine may end the run by itself; then this fault is the one that is recorded.
  EXPECT_TRUE(bridge.wait_for("arming -> running"));
  std::this_thread::sleep_for(std::chrono::seconds(3));
  // The killed robot leaves its link, whose pseudo-terminal may become another test's.
  std::filesystem::remove(port());
  robot->signal(SIGKILL);
  bridge.wait();
  EXPECT_THAT(bridge.output(), HasSubstr("black box: "));
  EXPECT_THAT(bridge.output(), HasSubstr(file()));
  expect_replayed(file());
}

TEST_F(RecordedPrograms, AKilledRunIsReadableAndRecoverMakesItWhole) {
  const auto robot = test::start_robot(port());
  test::Process bridge(recording_daemon());
  ASSERT_TRUE(bridge.wait_for("state: syncing -> ready")) << bridge.output();
  // Waits until two seconds of the run are in the file.
  for (int i = 0; i < 600 && steps_in(file()) < 400; ++i)
    std::this_thread::sleep_for(std::chrono::milliseconds(100));
  const HostNs killed = std::chrono::steady_clock::now().time_since_epoch().count();
  bridge.signal(SIGKILL);
  bridge.wait();

  std::uint64_t steps = 0;
  HostNs last = 0;
  const Recording cut(file());
  EXPECT_FALSE(cut.whole());
  cut.visit({.step = [&](const StepRecord& record) {
    ++steps;
    last = record.now_ns;
  }});
  EXPECT_GE(steps, 400u);
  // The loss is less than a second unless a busy machine delays the writer.
  RecordProperty("lost_ms", std::to_string((killed - last) / kNsPerMs));
  EXPECT_LT(to_s(killed - last), 5.0);

  const test::Finished exported =
      test::run({"tp100d", "export", file(), "--out", folder_.file("out")});
  EXPECT_EQ(exported.status, 0) << exported.output;
  EXPECT_THAT(exported.output, HasSubstr("is cut off; exported everything before that"));

  const test::Finished recover = test::run({"tp100d", "recover", file()});
  EXPECT_EQ(recover.status, 0) << recover.output;
  const std::string saved = std::filesystem::path(file()).parent_path() / "run-recovered.mcap";
  const Recording whole(saved);
  EXPECT_TRUE(whole.whole());
  EXPECT_EQ(steps_in(saved), steps);
  expect_replayed(saved);
  EXPECT_THAT(test::run({"tp100d", "recover", saved}).output, HasSubstr("nothing to recover"));
}

TEST_F(RecordedPrograms, ARunGoesOnWhenTheDiskIsFull) {
  const auto robot = test::start_robot(port());
  // The limit is 600 blocks of 512 bytes.
  test::Process bridge(
      test::joined({"/bin/sh", "-c", "ulimit -f 600; exec \"$0/$@\"", build_path("bin")},
                   recording_daemon({"--duration", "10"})));
  EXPECT_EQ(bridge.wait(), 1) << bridge.output();
  EXPECT_THAT(bridge.output(),
              HasSubstr("recording stopped, the disk is full; the file is complete"));
  EXPECT_THAT(bridge.output(), HasSubstr("no course: duration after 10."));
  EXPECT_TRUE(Recording(file()).whole());
}

TEST_F(RecordedPrograms, ARunThatNeverBeganLeavesNothing) {
  EXPECT_EQ(test::run(recording_daemon()).status, 2);
  EXPECT_TRUE(std::filesystem::is_empty(records()));
}

}  // namespace
}  // namespace tp100::sim
