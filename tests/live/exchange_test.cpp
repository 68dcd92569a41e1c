// Choosing another course and robot while the daemon runs: everything that keeps something of what
// is in force changes with the same step, whichever learns of it first.

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <filesystem>
#include <functional>
#include <future>
#include <nlohmann/json.hpp>
#include <random>
#include <set>
#include <string>
#include <thread>

#include "core/clock.h"
#include "course/bundled_files.h"
#include "course/robot_file.h"
#include "live/daemon_parts.h"
#include "record/recording.h"
#include "support/temporary_folder.h"

namespace tp100::live {
namespace {

using course::Bundled;
using namespace std::chrono_literals;

config::LoadedRun straight_run(const std::string& runs_folder) {
  config::LoadedRun run;
  run.files.configuration = {
      "tp100.toml",
      "[loop]\nlock_memory = false\nhold_cpu_latency = false\npriority = 0\n"
      "[server]\nlisten = \"off\"\n[record]\nblack_box_s = 0\ndirectory = \"" +
          runs_folder + "\"\n"};
  run.files.robot = course::read_bundled(Bundled::kRobots, "uniform");
  run.files.course = course::read_bundled(Bundled::kCourses, "1-straight");
  run.setup = config::parse_run(run.files);
  return run;
}

/// Steps the parts without a loop and a robot.
class Stepped {
 public:
  Stepped(const std::string& runs_folder, std::uint64_t seed)
      : parts_(straight_run(runs_folder), {}), listeners_(parts_.listeners(true)) {
    std::shuffle(listeners_.begin(), listeners_.end(), std::mt19937_64(seed));
    parts_.server.start();
    parts_.recording.begin();
  }
  ~Stepped() {
    parts_.server.flush();
    parts_.recording.finish(std::chrono::steady_clock::now() + 60s);
  }

  void step() {
    const HostNs now = monotonic_now();
    parts_.cycle.step(now);
    parts_.cycle.after_write(now);
    const StepRecord& record = *parts_.cycle.front_record();
    if (const auto made = parts_.setup.take(record)) {
      // Viewers hear of the change while the others are still told.
      for (const ExchangeListener& listener : listeners_) {
        if (!made->exchange) break;
        listener(*made->exchange);
        parts_.server.flush();
      }
      parts_.setup.finish();
    }
    parts_.recording.take(record);
    parts_.server.take(record);
    parts_.cycle.release_record();
  }
  /// The refusal; empty: it is in force.
  std::string choose(const server::SetupChoice& choice) {
    return wait_for([&](const server::Answer& answer) { parts_.setup.choose(choice, answer); });
  }
  std::string place(const Pose& at) {
    return wait_for([&](const server::Answer& answer) { parts_.setup.place(at, answer); });
  }
  void busy_until(const std::shared_future<void>& done) {
    parts_.disk.post([done] { done.wait(); }, {});
  }
  SetupChanger& setup() { return parts_.setup; }

 private:
  std::string wait_for(const std::function<void(const server::Answer&)>& ask) {
    std::string refused;
    std::atomic<bool> answered = false;
    ask([&](const std::string& why, const std::string&) {
      refused = why;
      answered = true;
    });
    while (!answered) {
      step();
      parts_.setup.tick();
      std::this_thread::sleep_for(1ms);
    }
    return refused;
  }

  DaemonParts parts_;
  std::vector<ExchangeListener> listeners_;
};

/// Courses, robots and wheelbases of which anything in a recording speaks.
std::set<std::string> names_in(const std::string& run) {
  const record::Recording recording(run);
  const course::Robot robot = course::parse_robot(recording.file("robot.toml"), "robot.toml");
  std::set<std::string> names{recording.fact("course"), recording.fact("robot"),
                              std::to_string(robot.model.wheelbase_m)};
  bool told = false;
  recording.visit({.message = [&](const std::string& topic, std::uint64_t, std::string_view json) {
    if (topic != "/parameter") return;
    told = true;
    const auto parameters = nlohmann::json::parse(json).at("parameters");
    for (const auto& each : parameters)
      if (each.at("name") == "robot.model.wheelbase_m")
        names.insert(std::to_string(each.at("value").get<double>()));
  }});
  EXPECT_TRUE(told);
  return names;
}

// A recording that begins with the new course but shows the old robot's parameters, or the other
// way round, would be judged by the wrong figures.
TEST(Exchange, AllThatIsInForceChangesWithOneStepWhoeverHearsOfItFirst) {
  std::set<std::set<std::string>> seen;
  for (std::uint64_t seed = 0; seed < 8; ++seed) {
    const test::TemporaryFolder folder;
    {
      Stepped daemon(folder.file("runs"), seed);
      for (int i = 0; i < 5; ++i) daemon.step();
      ASSERT_EQ(daemon.choose({.course = "2", .robot = "worn"}), "");
      EXPECT_EQ(daemon.setup().in_force()->course(), "2");
      for (int i = 0; i < 5; ++i) daemon.step();
    }
    std::vector<std::string> runs;
    for (const auto& run : std::filesystem::directory_iterator(folder.file("runs")))
      if (run.is_directory()) runs.push_back(run.path());
    ASSERT_EQ(runs.size(), 2U) << "seed " << seed;
    std::ranges::sort(runs, {}, [](const std::string& run) {
      return record::Recording(run).fact("course") == "2";
    });
    seen.insert(names_in(runs[1]));
    std::uint64_t steps = 0;
    record::Recording(runs[1]).visit({.step = [&](const StepRecord& record) {
      EXPECT_TRUE(steps++ > 0 || !record.inputs.restart.empty()) << "seed " << seed;
    }});
    EXPECT_GE(steps, 6U) << "seed " << seed;
  }
  ASSERT_EQ(seen.size(), 1U) << "the new recording depends on who hears first";
  EXPECT_TRUE(seen.begin()->contains("2"));
  EXPECT_TRUE(seen.begin()->contains("worn"));
  EXPECT_EQ(seen.begin()->size(), 3U) << "its files and its parameters are those of one robot";
}

// A run that is being deleted on a slow card must not keep a robot from being placed and started.
TEST(Exchange, ADiskThatIsBusyHoldsUpNeitherAPlaceNorAStart) {
  const test::TemporaryFolder folder;
  Stepped daemon(folder.file("runs"), 0);
  daemon.step();
  std::promise<void> done;
  daemon.busy_until(done.get_future().share());
  EXPECT_EQ(daemon.choose({.course = "2"}), Worker::kBusy);
  EXPECT_FALSE(daemon.setup().changing()) << "then a start is possible again";
  EXPECT_EQ(daemon.place({.x_m = 0.1}), "");
  done.set_value();
  EXPECT_EQ(daemon.choose({.course = "2"}), "");
}

}  // namespace
}  // namespace tp100::live
