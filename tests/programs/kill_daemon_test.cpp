// The daemon is killed while viewers change files.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <filesystem>
#include <random>
#include <set>
#include <string>
#include <thread>
#include <vector>

#include "../server/web_client.h"
#include "process.h"
#include "server/service.h"

namespace tp100::test {
namespace {

namespace fs = std::filesystem;
using server::Service;

class KilledDaemon : public ::testing::Test {
 protected:
  KilledDaemon() {
    config_ = "library = \"" + folder_.file("library") +
              "\"\n[loop]\npriority = 0\nlock_memory = false\n[server]\nlisten = \"127.0.0.1:0\"\n"
              "[record]\nblack_box_s = 0\ndirectory = \"" +
              folder_.file("runs") + "\"\n";
    write_bytes(folder_.file("c.toml"), config_);
    fs::create_directories(folder_.file("runs/a"));
    write_bytes(folder_.file("runs/a/run.mcap"), "0");
  }
  /// Requests that write files, one after the other, for as long as the daemon lives.
  static void write_files(server::WebClient& viewer, int& number) {
    const std::string n = std::to_string(++number % 9 + 1);
    viewer.call(Service::kParametersSave, R"({"control.preview_s":0.0)" + n + "}");
    viewer.call(Service::kParametersRestore);
    viewer.call(Service::kRunNote, R"({"run":"a","note":")" + std::string(9000 / 9, n[0]) + "\"}");
    viewer.call(Service::kFileSave,
                R"({"kind":"course","name":"mine","replace":true,"text":"# )" + n +
                    R"(\nspeed_mps = 0.1\n[[segment]]\ntype = \"line\"\nlength_m = 0.3\n)"
                    R"([fence]\nmin_x_m = -1\nmax_x_m = 1\nmin_y_m = -1\nmax_y_m = 1\n"})");
  }
  /// All files, and folders of no files, but for those that are named.
  std::set<std::string> names() const {
    std::set<std::string> all;
    for (const auto& each : fs::recursive_directory_iterator(folder_.path()))
      if (each.is_regular_file() || each.path().filename().string().starts_with("."))
        all.insert(fs::relative(each.path(), folder_.path()).string());
    return all;
  }

  TemporaryFolder folder_;
  std::string config_;
};

// A power cut, or the kernel when memory runs out, must cost no configuration, note or course.
TEST_F(KilledDaemon, FilesAreWholeWheneverItIsKilled) {
  std::mt19937 random(std::random_device{}());
  const std::set<std::string> known = {"c.toml",
                                       "c.toml.bak",
                                       "runs/a/run.mcap",
                                       "runs/a/run.toml",
                                       "library/courses/mine.toml",
                                       "library/courses/mine.toml.bak"};
  int number = 0;
  for (int round = 0; round < 12; ++round) {
    Process daemon({"tp100d", "run", "--wait", "--stay", "--port", folder_.file("none"), "--config",
                    folder_.file("c.toml")});
    const std::string port = page_port(daemon);
    // What the last one left is gone.
    EXPECT_TRUE(eventually([&] {
      const std::set<std::string> left = names();
      return std::ranges::includes(known, left);
    })) << ::testing::PrintToString(names());
    try {
      server::WebClient viewer(port);
      const auto end =
          std::chrono::steady_clock::now() + std::chrono::microseconds(20'000 + random() % 100'000);
      while (std::chrono::steady_clock::now() < end) {
        write_files(viewer, number);
        std::this_thread::sleep_for(std::chrono::milliseconds(3));
        viewer.drain();
      }
    } catch (const std::runtime_error& error) {
      ADD_FAILURE() << error.what();
    }
    daemon.signal(SIGKILL);
    EXPECT_EQ(daemon.wait(), 128 + SIGKILL);
    const std::string config = read_bytes(folder_.file("c.toml"));
    EXPECT_TRUE(config.starts_with(config_)) << config;
    if (fs::exists(folder_.file("c.toml.bak"))) {
      const std::string kept = read_bytes(folder_.file("c.toml.bak"));
      EXPECT_TRUE(kept.starts_with(config_)) << kept;
    }
    for (const char* name : {"runs/a/run.toml", "library/courses/mine.toml"}) {
      if (!fs::exists(folder_.file(name))) continue;
      const std::string text = read_bytes(folder_.file(name));
      EXPECT_TRUE(text.size() > 90 && text.ends_with("\n")) << name << ": " << text;
    }
  }
  EXPECT_TRUE(fs::exists(folder_.file("library/courses/mine.toml.bak")));
  EXPECT_TRUE(fs::exists(folder_.file("runs/a/run.toml")));
  EXPECT_TRUE(fs::exists(folder_.file("c.toml.bak")));
}

}  // namespace
}  // namespace tp100::test
