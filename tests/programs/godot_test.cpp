// The engine's project sim/godot as the external world of the real programs, without a display.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <csignal>
#include <fstream>
#include <memory>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>
#include <thread>
#include <vector>

#include "process.h"
#include "support/paths.h"

namespace tp100::test {
namespace {

using ::testing::HasSubstr;

/// A display in memory.
class Screen {
 public:
  Screen() {
    // It also prints which names are taken.
    while (name_.empty() && server_.wait_for("\n")) {
      std::istringstream lines(server_.output());
      for (std::string line; std::getline(lines, line);) {
        if (!line.empty() && line.find_first_not_of("0123456789") == std::string::npos)
          name_ = ":" + line;
      }
    }
    EXPECT_FALSE(name_.empty()) << server_.output();
  }
  const std::string& name() const { return name_; }
  /// Mouse and keyboard, as xdotool has them.
  void input(std::vector<std::string> words) const {
    words.insert(words.begin(), {"/usr/bin/env", "DISPLAY=" + name_, "xdotool"});
    const Finished done = run(words);
    EXPECT_EQ(done.status, 0) << done.output;
  }

 private:
  Process server_{
      {"/usr/bin/Xvfb", "-displayfd", "1", "-screen", "0", "960x540x24", "-nolisten", "tcp"}};
  std::string name_;
};

/// Runs scripts/godot with so many robots, with a window on `screen` that looks from above, or
/// without.
class Engine {
 public:
  explicit Engine(const std::string& course, const std::string& listen = "127.0.0.1:0",
                  const Screen* screen = nullptr, int robots = 1)
      : process_(command(course, listen, screen, robots)) {
    std::size_t at = 0;
    for (int i = 0; i < robots; ++i) {
      EXPECT_TRUE(process_.wait_for("listening at 127.0.0.1:")) << process_.output();
      process_.wait_for("\n");
      const std::string& text = process_.output();
      at = text.find("127.0.0.1:", at);
      if (at == std::string::npos) return;
      addresses_.push_back(text.substr(at, text.find('\n', at) - at));
      at += addresses_.back().size();
    }
  }
  std::string address(std::size_t robot = 0) const {
    return robot < addresses_.size() ? addresses_[robot] : "127.0.0.1:1";
  }
  bool says(const std::string& text) { return process_.wait_for(text); }

 private:
  static std::vector<std::string> command(const std::string& course, const std::string& listen,
                                          const Screen* screen, int robots) {
    std::vector<std::string> words{"/usr/bin/env"};
    if (screen) words.push_back("DISPLAY=" + screen->name());
    words.insert(words.end(),
                 {TP100_SOURCE_DIR "/scripts/godot", "--course", course, "--listen", listen});
    for (int i = 0; i < robots; ++i) words.insert(words.end(), {"--robot", "end-loaded"});
    if (screen)
      words.insert(words.end(), {"--camera", "top"});
    else
      words.push_back("--headless");
    return words;
  }

  Process process_;
  std::vector<std::string> addresses_;
};

class Godot : public testing::Test {
 protected:
  void SetUp() override {
    const Finished setup = run({TP100_SOURCE_DIR "/scripts/setup", "godot"});
    if (setup.status != 0) GTEST_SKIP() << "Godot cannot be installed here: " << setup.output;
  }
  std::string config(const std::string& world, const std::string& name = "config") const {
    const std::string path = folder_.file(name + ".toml");
    std::ofstream(path) << "[world]\n" << world;
    return path;
  }
  /// The figures of a lockstep run in the engine; `name` is the folder for the run's poses.
  nlohmann::json drive(const Engine& engine, const std::string& course,
                       const std::string& authority, const std::string& name = "run",
                       std::size_t robot = 0) {
    const Finished driven =
        run({"tp100-sim", "course", course, "--json", "--world", "udp:" + engine.address(robot),
             "--config", config("authority = \"" + authority + "\"\n", name), "--out",
             folder_.file(name)});
    auto figures = nlohmann::json::parse(driven.output, nullptr, false);
    return figures.is_object() ? figures : nlohmann::json::object();
  }
  std::string poses(const std::string& name) const {
    std::ifstream file(folder_.file(name + "/3-end-loaded-1.csv"));
    return {std::istreambuf_iterator<char>(file), {}};
  }
  TemporaryFolder folder_;
};

double number(const nlohmann::json& figures, const char* group, const char* name) {
  return figures.value(nlohmann::json::json_pointer(std::string("/") + group + "/" + name), 1e9);
}

class GodotCourses : public Godot, public testing::WithParamInterface<const char*> {
 protected:
  void expect_driven(const std::string& course, const std::string& authority, double most_m) {
    const Engine engine(course);
    const nlohmann::json figures = drive(engine, course, authority);
    EXPECT_TRUE(figures.value("completed", false)) << figures;
    EXPECT_LE(number(figures, "odometry", "max_position_error_m"), most_m);
    EXPECT_LE(number(figures, "tracking", "max_cross_track_m"), most_m);
    EXPECT_EQ(number(figures, "loop", "world_missing"), 0);
  }
};

TEST_P(GodotCourses, AreDrivenOverTheEnginesRays) { expect_driven(GetParam(), "bridge", 0.05); }

// What the tracks do on the real floor and in the engine differs by the friction, so the bounds are
// wider.
TEST_P(GodotCourses, AreDrivenByTheEnginesPhysics) { expect_driven(GetParam(), "world", 0.08); }

INSTANTIATE_TEST_SUITE_P(Papers, GodotCourses,
                         testing::Values("1-straight", "1-curve", "1-sharp", "2", "3"),
                         [](const auto& param) {
                           std::string name = param.param;
                           for (char& letter : name)
                             if (letter == '-') letter = '_';
                           return name;
                         });

TEST_F(Godot, GivesTheSamePosesToTheBitEveryTime) {
  const Engine engine("3");
  drive(engine, "3", "bridge", "first");
  drive(engine, "3", "bridge", "second");
  EXPECT_FALSE(poses("first").empty());
  EXPECT_TRUE(poses("first") == poses("second"));
}

class GodotRobots : public Godot, public testing::WithParamInterface<const char*> {};

// The robots have one course, which each can only drive if the other does not stand on it.
TEST_P(GodotRobots, AreObstaclesToEachOther) {
  const Engine engine("1-straight", "127.0.0.1:0", nullptr, 2);
  const nlohmann::json first = drive(engine, "1-straight", GetParam(), "first", 0);
  EXPECT_TRUE(first.value("completed", false)) << first;
  const nlohmann::json second = drive(engine, "1-straight", GetParam(), "second", 1);
  EXPECT_EQ(second.value("cause", ""), "immobilised") << second;
  const nlohmann::json again = drive(engine, "1-straight", GetParam(), "again", 0);
  EXPECT_EQ(again.value("cause", ""), "immobilised") << again;
}

// Half a metre apart, at the same time, each by a program that knows nothing of the other.
TEST_P(GodotRobots, DriveSideBySideAsEachDoesAlone) {
  const std::string beside = folder_.file("beside.toml");
  std::ofstream(beside) << "[start]\ny_m = 0.5\n[[segment]]\ntype = \"line\"\nlength_m = 1.0\n"
                           "[fence]\nmin_x_m = -0.2\nmax_x_m = 1.2\nmin_y_m = 0.2\nmax_y_m = 0.8\n";
  const auto cross_track_m = [&](const Engine& engine, std::size_t robot, const char* name) {
    const nlohmann::json figures =
        drive(engine, robot == 0 ? "1-straight" : beside, GetParam(), name, robot);
    EXPECT_TRUE(figures.value("completed", false)) << figures;
    return number(figures, "tracking", "max_cross_track_m");
  };
  const Engine both("1-straight", "127.0.0.1:0", nullptr, 2), alone("1-straight"), other(beside);
  double right = 0.0;
  std::thread second([&] { right = cross_track_m(both, 1, "right"); });
  const double left = cross_track_m(both, 0, "left");
  second.join();
  EXPECT_NEAR(left, cross_track_m(alone, 0, "left-alone"), 1e-6);
  EXPECT_NEAR(
      right,
      number(drive(other, beside, GetParam(), "right-alone"), "tracking", "max_cross_track_m"),
      1e-6);
}

INSTANTIATE_TEST_SUITE_P(Authorities, GodotRobots, testing::Values("bridge", "world"),
                         [](const auto& param) { return std::string(param.param); });

/// A person at the window of a world that owns the pose, while course 1-straight is driven.
class GodotWindow : public Godot {
 protected:
  // Seen from above, in pixels: the course's middle, and the robot where the course ends.
  static constexpr const char* kMiddle[] = {"480", "270"};
  static constexpr const char* kEnd[] = {"480", "73"};

  nlohmann::json course(const std::string& record) {
    const Finished driven =
        run({"tp100-sim", "course", "1-straight", "--json", "--world", "udp:" + engine_.address(),
             "--config", config("authority = \"world\"\n"), "--record", folder_.file(record)});
    auto figures = nlohmann::json::parse(driven.output, nullptr, false);
    EXPECT_TRUE(figures.is_object()) << driven.output;
    return figures.is_object() ? figures : nlohmann::json::object();
  }
  void expect_replayed(const std::string& record) {
    const Finished replayed =
        run({"tp100d", "replay", folder_.file(record + "/1-straight-end-loaded-1/run.mcap"),
             "--out", folder_.file("poses.csv")});
    EXPECT_THAT(replayed.output, HasSubstr("bit for bit"));
  }

  Screen screen_;
  Engine engine_{"1-straight", "127.0.0.1:0", &screen_};
};

TEST_F(GodotWindow, AnObstacleEndsARunUntilItIsTakenAway) {
  screen_.input({"mousemove", kMiddle[0], kMiddle[1], "click", "1"});
  ASSERT_TRUE(engine_.says("obstacle: "));
  EXPECT_EQ(course("blocked").value("cause", ""), "immobilised");
  expect_replayed("blocked");
  screen_.input({"click", "1"});
  ASSERT_TRUE(engine_.says("taken away"));
  EXPECT_TRUE(course("free").value("completed", false));
}

TEST_F(GodotWindow, DraggingTheRobotPushesItAside) {
  const nlohmann::json free = course("free");
  ASSERT_TRUE(free.value("completed", false)) << free;
  screen_.input({"mousemove", kEnd[0], kEnd[1], "mousedown", "1", "mousemove", "440", kEnd[1]});
  ASSERT_TRUE(engine_.says("robot: held"));
  const nlohmann::json pushed = course("pushed");
  EXPECT_GT(number(pushed, "tracking", "max_cross_track_m"),
            3 * number(free, "tracking", "max_cross_track_m"));
  expect_replayed("pushed");
}

TEST_F(GodotWindow, SpaceIsStopUntilR) {
  screen_.input({"key", "space"});
  ASSERT_TRUE(engine_.says("STOP: pressed"));
  EXPECT_FALSE(course("stopped").value("completed", true));
  screen_.input({"key", "r"});
  ASSERT_TRUE(engine_.says("STOP: released"));
  EXPECT_TRUE(course("free").value("completed", false));
}

TEST_F(Godot, NamesACourseThatIsNotThere) {
  Process engine({TP100_SOURCE_DIR "/scripts/godot", "--headless", "--course", "nowhere"});
  EXPECT_EQ(engine.wait(), 2);
  EXPECT_THAT(engine.output(), HasSubstr("give a file or a name in config/courses"));
}

TEST_F(Godot, LostEndsTheRunAndANewOneIsWelcome) {
  Process robot({"tp100-sim", "robot", "--link", folder_.file("tp100")});
  ASSERT_TRUE(robot.wait_for("linked from")) << robot.output();
  auto engine = std::make_unique<Engine>("1-straight");
  const std::string address = engine->address();
  Process bridge({"tp100d", "run", "--port", folder_.file("tp100"), "--course", "1-straight",
                  "--world", "udp:" + address, "--config", config("timeout_ms = 1000\n")});
  ASSERT_TRUE(bridge.wait_for("world: welcomed by sim/godot")) << bridge.output();
  ASSERT_TRUE(bridge.wait_for("state: arming -> running")) << bridge.output();
  engine.reset();
  ASSERT_TRUE(bridge.wait_for("state: running -> aborted")) << bridge.output();
  EXPECT_TRUE(robot.wait_for("motors off")) << robot.output();
  const Engine anew("1-straight", address);
  EXPECT_TRUE(bridge.wait_for("world: welcomed")) << bridge.output();
  EXPECT_THAT(bridge.output(), HasSubstr("world_lost"));
}

}  // namespace
}  // namespace tp100::test
