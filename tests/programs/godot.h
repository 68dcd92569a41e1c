#pragma once
// The engine's project sim/godot, without a display or with a virtual one, and lockstep runs in it.

#include <gtest/gtest.h>

#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>

#include "../support/temporary_folder.h"
#include "process.h"
#include "support/paths.h"

namespace tp100::test {

/// A virtual display.
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
  /// Mouse and keyboard input, as arguments of xdotool.
  void input(const Words& words) const {
    const Finished done = run(joined({"/usr/bin/env", "DISPLAY=" + name_, "xdotool"}, words));
    EXPECT_EQ(done.status, 0) << done.output;
  }

 private:
  Process server_{
      {"/usr/bin/Xvfb", "-displayfd", "1", "-screen", "0", "960x540x24", "-nolisten", "tcp"}};
  std::string name_;
};

/// Runs scripts/godot, without a window or with one on `screen` that shows the scene from above.
class Engine {
 public:
  explicit Engine(const std::string& course, const std::string& listen = "127.0.0.1:0",
                  const Screen* screen = nullptr, const std::string& robot = "end-loaded")
      : process_(command(course, listen, screen, robot)),
        address_(process_.line_after("listening at ")) {}
  const std::string& address() const { return address_; }
  bool says(const std::string& text) { return process_.wait_for(text); }

 private:
  static Words command(const std::string& course, const std::string& listen, const Screen* screen,
                       const std::string& robot) {
    Words words{"/usr/bin/env", "TP100_BIN=" + build_path("bin")};
    if (screen) words.push_back("DISPLAY=" + screen->name());
    words = joined(words, {source_path("scripts/godot"), "--course", course, "--listen", listen,
                           "--robot", robot});
    return joined(words, screen ? Words{"--camera", "top"} : Words{"--headless"});
  }

  Process process_;
  std::string address_;
};

class Godot : public testing::Test {
 protected:
  void SetUp() override {
    const Finished setup = run({source_path("scripts/setup"), "godot"});
    if (setup.status != 0) GTEST_SKIP() << "Godot cannot be installed here: " << setup.output;
  }
  std::string config(const std::string& world, const std::string& name = "config") const {
    const std::string path = folder_.file(name + ".toml");
    std::ofstream(path) << "[world]\n" << world;
    return path;
  }
  /// Drives in lockstep in the engine and returns the figures; `name`: folder for the run's poses,
  /// `more`: further arguments.
  nlohmann::json drive(const Engine& engine, const std::string& course,
                       const std::string& authority, const std::string& name = "run",
                       const Words& more = {}) {
    const Finished driven = run(joined(
        {"tp100-sim", "course", course, "--json", "--world", "udp:" + engine.address(), "--config",
         config("authority = \"" + authority + "\"\n", name), "--out", folder_.file(name)},
        more));
    auto figures = nlohmann::json::parse(driven.output, nullptr, false);
    return figures.is_object() ? figures : nlohmann::json::object();
  }
  std::string poses(const std::string& name) const {
    return read_bytes(folder_.file(name + "/3-end-loaded-1.csv"));
  }
  TemporaryFolder folder_;
};

inline double number(const nlohmann::json& figures, const char* group, const char* name) {
  return figures.value(nlohmann::json::json_pointer(std::string("/") + group + "/" + name), 1e9);
}

}  // namespace tp100::test
