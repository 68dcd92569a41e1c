// The external world scripts/world with the real programs: in lockstep and over a pseudo-terminal.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <memory>
#include <regex>
#include <thread>

#include "process.h"
#include "record/recording.h"
#include "support/paths.h"

namespace tp100::test {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

Words script(const Words& words) {
  return joined({"/usr/bin/env", "TP100_BIN=" + build_path("bin")}, words);
}

/// Runs scripts/world on its own port; with a `fault`, false_world.
class PythonWorld {
 public:
  explicit PythonWorld(const std::string& fault = "")
      : process_(
            joined(script(fault.empty() ? Words{source_path("scripts/world")}
                                        : Words{source_path("tests/programs/false_world"), fault}),
                   {"--listen", "127.0.0.1:0"})),
        address_("udp:" + process_.line_after("listening at ")) {}
  const std::string& address() const { return address_; }

 private:
  Process process_;
  std::string address_;
};

class Worlds : public testing::Test {
 protected:
  std::string config(const std::string& world) const {
    const std::string path = folder_.file("config.toml");
    std::ofstream(path) << "[world]\n" << world;
    return path;
  }
  TemporaryFolder folder_;
};

std::string without_timings(const std::string& json) {
  static const std::regex timings(
      R"re("(realtime_factor|[a-z_]*time[a-z_]*)":[-0-9.e+]+|"loop":\{[^}]*\})re");
  return std::regex_replace(json, timings, "");
}

TEST_F(Worlds, CourseThreeInLockstepGivesTheSameNumbersEveryTimeAndReplays) {
  PythonWorld world;
  const auto drive = [&](const std::string& record) {
    const Finished driven = run({"tp100-sim", "course", "3", "--json", "--world", world.address(),
                                 "--record", folder_.file(record), "--config",
                                 config("authority = \"world\"\nframe = \"unreal\"\n")});
    EXPECT_EQ(driven.status, 0) << driven.output;
    return without_timings(driven.output);
  };
  const std::string first = drive("first");
  EXPECT_THAT(first, HasSubstr("\"completed\":true"));
  EXPECT_THAT(first, Not(HasSubstr("\"world_answered\":0")));
  EXPECT_EQ(drive("second"), first);
  const Finished replayed = run({"tp100d", "replay", folder_.file("first/3-end-loaded-1/run.mcap"),
                                 "--out", folder_.file("poses.csv")});
  EXPECT_EQ(replayed.status, 0) << replayed.output;
  EXPECT_THAT(replayed.output, HasSubstr("bit for bit"));
}

class WorldFaults : public Worlds,
                    public testing::WithParamInterface<std::pair<const char*, const char*>> {};

// Each fault begins one second into the run. A slow world is only found in real time.
TEST_P(WorldFaults, EndTheRunWithItsCause) {
  const auto& [fault, cause] = GetParam();
  const PythonWorld world(fault);
  const Finished finished = run({"tp100-sim", "course", "1-straight", "--world", world.address()});
  EXPECT_EQ(finished.status, 1) << finished.output;
  EXPECT_THAT(finished.output, HasSubstr(cause));
}

INSTANTIATE_TEST_SUITE_P(
    Faults, WorldFaults,
    testing::Values(std::pair{"silence", "world_lost"}, std::pair{"freeze", "world_lost"},
                    std::pair{"garbage", "world_lost"}, std::pair{"version", "world_lost"},
                    std::pair{"back", "world_lost"}, std::pair{"estop", "stop_requested"}),
    [](const auto& param) { return std::string(param.param.first); });

/// Runs the daemon, the emulated robot and the world as three processes.
class LiveWorlds : public Worlds {
 protected:
  Words daemon(const std::string& course, const std::string& world, int timeout_ms = 2000) const {
    const std::string settings = config("timeout_ms = " + std::to_string(timeout_ms) + "\n");
    return joined({"tp100d", "run", "--port", folder_.file("tp100"), "--course", course, "--world"},
                  {world, "--config", settings, "--stats", folder_.file("stats.json")});
  }
  std::unique_ptr<Process> robot_ = start_robot(folder_.file("tp100"));
};

// The course ends behind its step, which is that of course 3.
constexpr const char* kCourse = R"(description = "step"
speed_mps = 0.1
[[segment]]
type = "line"
length_m = 0.55
[[block]]
x_m = 0.35
y_m = 0.0
heading_deg = 0.0
height_m = 0.037
depth_m = 0.1
width_m = 0.4
[fence]
min_x_m = -0.5
max_x_m = 2.0
min_y_m = -0.5
max_y_m = 0.5
)";

TEST_F(LiveWorlds, ASlowWorldEndsTheRunSafelyAndTheCauseIsNamed) {
  const PythonWorld world("slow");
  Process bridge(daemon("1-straight", world.address(), 1000));
  ASSERT_TRUE(bridge.wait_for("state: running -> aborted")) << bridge.output();
  EXPECT_TRUE(robot_->wait_for("motors off")) << robot_->output();
  bridge.signal(SIGTERM);
  EXPECT_EQ(bridge.wait(), 1);
  EXPECT_THAT(bridge.output(), HasSubstr("world_lost"));
}

/// A world behind two text files, as in the paper: it receives track speeds and has authority over
/// the pose.
class FileWorlds : public LiveWorlds {
 protected:
  FileWorlds() { write_bytes(folder_.file("course.toml"), kCourse); }
  Words world() const {
    return script({source_path("scripts/world"), "--files", folder_.path().string(), "--course",
                   folder_.file("course.toml")});
  }
  Words files_daemon(int timeout_ms) const {
    const Words out = daemon(folder_.file("course.toml"), "files");
    config("authority = \"world\"\nframe = \"unreal\"\ntimeout_ms = " + std::to_string(timeout_ms) +
           "\nencoder_file = \"" + folder_.file("Encoder.txt") +
           "\"\nencoder_template = \"{seq} {t_s} {left} {right} {mode}\"\norientation_file = \"" +
           folder_.file("Orientation.txt") + "\"\n");
    return out;
  }
};

TEST_F(FileWorlds, BeginWhereTheCourseBegins) {
  std::ofstream(folder_.file("course.toml"))
      << kCourse << "\n[start]\nx_m = -0.2\ny_m = -0.1\nyaw_deg = 30.0\n";
  Process unreal(world());
  ASSERT_TRUE(unreal.wait_for("reading")) << unreal.output();
  std::ofstream(folder_.file("Encoder.txt")) << "1 0.5 0.0 0.0 running\n";
  std::string text;
  EXPECT_TRUE(
      eventually([&] { return !(text = read_bytes(folder_.file("Orientation.txt"))).empty(); }));
  EXPECT_THAT(text, ::testing::StartsWith("X=-20.000 Y=10.000 Z=0.000\n"));
  EXPECT_THAT(text, HasSubstr("Y=-30.000000"));
}

TEST_F(FileWorlds, DriveAStep) {
  Process unreal(world());
  ASSERT_TRUE(unreal.wait_for("reading")) << unreal.output();
  Process bridge(joined(files_daemon(2000), {"--record", folder_.file("runs")}));
  EXPECT_EQ(bridge.wait(), 0) << bridge.output();

  const std::string stats = read_bytes(folder_.file("stats.json"));
  EXPECT_THAT(stats, HasSubstr("\"kind\": \"files\""));
  EXPECT_THAT(stats, HasSubstr("\"write_errors\": 0"));
  EXPECT_THAT(stats, HasSubstr("\"rejected\": 0"));

  std::string run;
  for (const auto& entry : std::filesystem::directory_iterator(folder_.file("runs")))
    run = entry.path();
  double highest_m = 0.0, steepest_rad = 0.0;
  record::Recording(run).visit({.step = [&](const StepRecord& record) {
    highest_m = std::max(highest_m, record.snapshot.world.z_m);
    steepest_rad = std::max(steepest_rad, std::abs(record.snapshot.world.pitch_rad));
  }});
  EXPECT_GT(highest_m, 0.015) << "the robot must have climbed the step";
  EXPECT_GT(steepest_rad, 0.15);
}

// The last good value must not be used for longer than the time-out.
TEST_F(FileWorlds, AWorldWhoseFileNoLongerChangesOrIsGarbageEndsTheRunSafely) {
  for (const char* last : {"", "P=nowhere\n"}) {
    SCOPED_TRACE(last);
    Process unreal(world());
    ASSERT_TRUE(unreal.wait_for("reading")) << unreal.output();
    Process bridge(files_daemon(1000));
    ASSERT_TRUE(bridge.wait_for("-> running")) << bridge.output();
    std::this_thread::sleep_for(std::chrono::seconds(1));
    unreal.signal(SIGKILL);
    unreal.wait();
    if (*last != '\0') write_bytes(folder_.file("Orientation.txt"), last);
    ASSERT_TRUE(bridge.wait_for("running -> aborted")) << bridge.output();
    EXPECT_TRUE(robot_->wait_for("motors off")) << robot_->output();
    bridge.signal(SIGTERM);
    EXPECT_EQ(bridge.wait(), 1);
    EXPECT_THAT(bridge.output(), HasSubstr("world_lost: the external world is silent"));
  }
}

}  // namespace
}  // namespace tp100::test
