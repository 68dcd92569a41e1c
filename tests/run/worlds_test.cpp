// An external world, scripts/world, with the real programs: in lockstep and over a pseudo-terminal.

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <csignal>
#include <fstream>
#include <memory>
#include <ostream>
#include <regex>
#include <sstream>

#include "process.h"

namespace tp100::test {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

/// scripts/world at a port of its own.
class PythonWorld {
 public:
  explicit PythonWorld(std::vector<std::string> more = {}) : process_(arguments(std::move(more))) {
    EXPECT_TRUE(process_.wait_for("listening at 127.0.0.1:")) << process_.output();
    // The number follows, in the same line.
    process_.wait_for("\n");
    const std::string& text = process_.output();
    port_ = std::stoi(text.substr(text.find("127.0.0.1:") + 10));
  }
  std::string address() const { return "udp:127.0.0.1:" + std::to_string(port_); }

 private:
  static std::vector<std::string> arguments(std::vector<std::string> more) {
    std::vector<std::string> out = {TP100_SOURCE_DIR "/scripts/world", "--listen", "127.0.0.1:0"};
    out.insert(out.end(), more.begin(), more.end());
    return out;
  }
  Process process_;
  int port_ = 0;
};

std::string read(const std::string& path) {
  std::stringstream text;
  text << std::ifstream(path).rdbuf();
  return text.str();
}

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

TEST_F(Worlds, CourseThreeInLockstepGivesTheSameNumbersEveryTime) {
  PythonWorld world;
  const std::vector<std::string> arguments = {"tp100-sim", "course",  "3",
                                              "--json",    "--world", world.address()};
  const Finished first = run(arguments);
  EXPECT_EQ(first.status, 0) << first.output;
  EXPECT_THAT(first.output, HasSubstr("\"completed\":true"));
  EXPECT_THAT(first.output, Not(HasSubstr("\"world_answered\":0")));
  EXPECT_EQ(without_timings(run(arguments).output), without_timings(first.output));
}

TEST_F(Worlds, TheControllerSteersByTheWorldsPoseAndTheRecordingReplays) {
  PythonWorld world;
  const Finished driven = run({"tp100-sim", "course", "3", "--json", "--world", world.address(),
                               "--record", folder_.path().string(), "--config",
                               config("authority = \"world\"\nframe = \"unreal\"\n")});
  EXPECT_EQ(driven.status, 0) << driven.output;
  const Finished replayed = run({"tp100d", "replay", folder_.file("3-end-loaded-1/run.mcap"),
                                 "--out", folder_.file("poses.csv")});
  EXPECT_EQ(replayed.status, 0) << replayed.output;
  EXPECT_THAT(replayed.output, HasSubstr("bit for bit"));
}

TEST_F(Worlds, NobodyThereIsAnErrorOfOneLine) {
  // A port that was free a moment ago: the world at it has gone.
  std::string address;
  {
    PythonWorld gone;
    address = gone.address();
  }
  const Finished finished = run({"tp100-sim", "course", "3", "--world", address});
  EXPECT_EQ(finished.status, 2);
  EXPECT_THAT(finished.output, HasSubstr("no welcome"));
}

TEST_F(Worlds, ASilentWorldEndsALockstepRunWithItsCause) {
  PythonWorld world({"--fault", "silence@1"});
  const Finished finished = run({"tp100-sim", "course", "3", "--world", world.address()});
  EXPECT_EQ(finished.status, 1) << finished.output;
  EXPECT_THAT(finished.output, HasSubstr("world_lost"));
}

/// The daemon, the emulated robot and the world as three processes.
class LiveWorlds : public Worlds {
 protected:
  LiveWorlds() : robot_({"tp100-sim", "robot", "--link", folder_.file("tp100")}) {
    EXPECT_TRUE(robot_.wait_for("linked from")) << robot_.output();
  }
  std::vector<std::string> daemon(const std::string& course, const std::string& world,
                                  int timeout_ms = 2000) {
    return {"tp100d",   "run",
            "--port",   folder_.file("tp100"),
            "--course", course,
            "--world",  world,
            "--config", config("timeout_ms = " + std::to_string(timeout_ms) + "\n"),
            "--stats",  folder_.file("stats.json")};
  }
  Process robot_;
};

// Shorter than course 3, with a step and a ramp like its.
constexpr const char* kCourse = R"(description = "step and ramp"
speed_mps = 0.1
[[segment]]
type = "line"
length_m = 1.0
[[block]]
x_m = 0.35
y_m = 0.0
heading_deg = 0.0
height_m = 0.037
depth_m = 0.1
width_m = 0.4
[[ramp]]
x_m = 0.75
y_m = 0.0
heading_deg = 0.0
height_m = 0.03
up_deg = 28.0
top_m = 0.05
down_deg = 28.0
width_m = 0.4
[fence]
min_x_m = -0.5
max_x_m = 2.0
min_y_m = -0.5
max_y_m = 0.5
)";

TEST_F(LiveWorlds, DriveAStepAndARampInRealTime) {
  std::ofstream(folder_.file("course.toml")) << kCourse;
  PythonWorld world({"--course", folder_.file("course.toml")});
  Process bridge(daemon(folder_.file("course.toml"), world.address()));
  EXPECT_EQ(bridge.wait(), 0) << bridge.output();
  EXPECT_THAT(bridge.output(), HasSubstr("world: welcomed by scripts/world"));
  const std::string stats = read(folder_.file("stats.json"));
  EXPECT_THAT(stats, HasSubstr("\"kind\": \"udp\""));
  EXPECT_THAT(stats, HasSubstr("\"missing\": 0,"));
}

TEST_F(LiveWorlds, NothingBeginsBeforeTheWelcome) {
  std::string address;
  {
    PythonWorld gone;
    address = gone.address();
  }
  Process bridge(daemon("1-straight", address));
  ASSERT_TRUE(bridge.wait_for("state: idle -> arming")) << bridge.output();
  usleep(700'000);
  Process world({TP100_SOURCE_DIR "/scripts/world", "--listen", address.substr(4)});
  ASSERT_TRUE(bridge.wait_for("world: welcomed")) << bridge.output();
  EXPECT_THAT(bridge.output().substr(0, bridge.output().find("world: welcomed")),
              Not(HasSubstr("-> running")));
  EXPECT_TRUE(bridge.wait_for("state: arming -> running")) << bridge.output();
}

struct Trouble {
  const char* name;
  const char* cause;
};

void PrintTo(const Trouble& trouble, std::ostream* out) { *out << trouble.name; }

class TroubledWorlds : public LiveWorlds, public testing::WithParamInterface<Trouble> {};

// Each begins a second into the run and ends it, with the robot's motors off.
TEST_P(TroubledWorlds, EndTheRunSafelyAndTheCauseIsNamed) {
  PythonWorld world({"--fault", std::string(GetParam().name) + "@1"});
  Process bridge(daemon("1-straight", world.address(), 1000));
  ASSERT_TRUE(bridge.wait_for("state: running -> aborted")) << bridge.output();
  EXPECT_TRUE(robot_.wait_for("motors off")) << robot_.output();
  bridge.signal(SIGTERM);
  EXPECT_EQ(bridge.wait(), 1);
  EXPECT_THAT(bridge.output(), HasSubstr(GetParam().cause));
}

INSTANTIATE_TEST_SUITE_P(
    Faults, TroubledWorlds,
    testing::Values(Trouble{"silence", "world_lost"}, Trouble{"freeze", "world_lost"},
                    Trouble{"garbage", "world_lost"}, Trouble{"version", "world_lost"},
                    Trouble{"back", "world_lost"}, Trouble{"slow", "world_lost"},
                    Trouble{"estop", "stop_requested"}),
    [](const auto& param) { return std::string(param.param.name); });

TEST_F(LiveWorlds, AKilledWorldEndsTheRunAndANewOneIsWelcome) {
  auto world = std::make_unique<PythonWorld>();
  const std::string address = world->address();
  Process bridge(daemon("1-straight", address, 1000));
  ASSERT_TRUE(bridge.wait_for("state: arming -> running")) << bridge.output();
  world.reset();
  ASSERT_TRUE(bridge.wait_for("state: running -> aborted")) << bridge.output();
  Process anew({TP100_SOURCE_DIR "/scripts/world", "--listen", address.substr(4)});
  EXPECT_TRUE(bridge.wait_for("world: welcomed")) << bridge.output();
  EXPECT_THAT(bridge.output(), HasSubstr("world_lost"));
}

TEST_F(LiveWorlds, LosingAThirdOfTheAnswersIsNoTrouble) {
  PythonWorld world({"--fault", "loss"});
  std::vector<std::string> arguments = daemon("1-straight", world.address());
  arguments.insert(arguments.end(), {"--duration", "5"});
  EXPECT_EQ(run(arguments).status, 1);
  const std::string stats = read(folder_.file("stats.json"));
  EXPECT_THAT(stats, HasSubstr("\"result\": \"duration\""));
  EXPECT_THAT(stats, Not(HasSubstr("\"missing\": 0,")));
}

}  // namespace
}  // namespace tp100::test
