// Tests of `tp100d run` against a scripted robot on a pty, both in this process.
#include <fcntl.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <atomic>
#include <cmath>
#include <csignal>
#include <fstream>
#include <functional>
#include <memory>
#include <sstream>
#include <thread>
#include <vector>

#include "../server/web_client.h"
#include "../support/frozen_disk.h"
#include "../support/notify_socket.h"
#include "../support/temporary_folder.h"
#include "../support/weight.h"
#include "app/commands.h"
#include "core/error.h"
#include "link/transport.h"
#include "live_command.h"
#include "pty_robot.h"

namespace tp100::live {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;
using namespace std::chrono_literals;

class Run : public ::testing::Test {
 protected:
  Run() {
    robot_ = std::make_unique<PtyRobot>(port());
    // Scheduling is ordinary because other tests run on the machine at the same time.
    std::ofstream(folder_.path() / "config.toml")
        << "[loop]\npriority = 0\nlock_memory = false\nspin_us = 0\n"
           "[link]\nfirst_frame_timeout_ms = 700\n"
           "[server]\nlisten = \"127.0.0.1:0\"\n"
           "[record]\nblack_box_directory = \""
        << folder_.file("boxes") << "\"\n";
    options_.config = folder_.file("config.toml");
    options_.port = port().string();
    options_.stats = stats_path().string();
    options_.duration_s = 60.0;
  }
  ~Run() override { robot_.reset(); }

  std::filesystem::path port() const { return folder_.path() / "robot"; }
  std::filesystem::path stats_path() const { return folder_.path() / "stats.json"; }

  // Runs the command while `script` runs in parallel; afterwards SIGTERM ends the command.
  int run(const std::function<void()>& script = {}) {
    std::thread beside([&] {
      if (!script) return;
      script();
      ::kill(::getpid(), SIGTERM);
    });
    testing::internal::CaptureStderr();
    int status = -1;
    try {
      status = app::run_run(options_);
    } catch (const SetupError& error) {
      message_ = error.what();
    }
    beside.join();
    log_ = testing::internal::GetCapturedStderr();
    return status;
  }
  std::string stats() const { return content_of(stats_path().string()); }
  // Port of the page; waits until it is served.
  std::string page() const {
    std::string served = page_of(stats_path().string());
    if (served.empty()) throw std::runtime_error("no page is served");
    return served;
  }
  // Expects that the statistics file contains `word`.
  void says_of_itself(const std::string& word) const {
    EXPECT_TRUE(soon([&] { return stats().find(word) != std::string::npos; }))
        << word << " is not in " << stats();
  }
  bool eventually(const std::function<bool(const ScriptedRobot&)>& condition) {
    const bool happened = soon([&] { return robot_->with(condition); });
    EXPECT_TRUE(happened) << "the condition did not become true";
    return happened;
  }
  /// Waits until the robot has received `more` further commands, so that a forbidden reaction would
  /// be seen.
  void commanded_again(std::size_t more) {
    const std::size_t before =
        robot_->with([](const ScriptedRobot& robot) { return robot.received.commands.size(); });
    eventually([&](const ScriptedRobot& robot) {
      return robot.received.commands.size() >= before + more;
    });
  }
  /// Number of recordings. Expects that each repeats its run bit for bit.
  int replayed_recordings() const {
    int replayed = 0;
    for (const auto& run : std::filesystem::directory_iterator(options_.record)) {
      testing::internal::CaptureStdout();
      EXPECT_EQ(
          app::run_replay(
              {.in = run.path(), .out = folder_.file("poses.csv"), .config = {}, .model = {}}),
          0);
      EXPECT_THAT(testing::internal::GetCapturedStdout(), HasSubstr("bit for bit"));
      ++replayed;
    }
    return replayed;
  }
  static bool commanded(const ScriptedRobot& robot) { return robot.received.commands.size() > 20; }

  static bool driven(const ScriptedRobot& robot) {
    return commanded(robot) && robot.received.commands.back().speed_mps > 0.0F;
  }

  test::TemporaryFolder folder_;
  std::unique_ptr<PtyRobot> robot_;
  app::RunOptions options_;
  std::string message_;
  std::string log_;
};

TEST_F(Run, AMissingPortIsAnErrorOfOneLine) {
  EXPECT_EQ(run(), -1);
  EXPECT_THAT(message_, HasSubstr("robot: no such port"));
  EXPECT_EQ(log_, "");
  EXPECT_FALSE(std::filesystem::exists(stats_path()));
}

TEST_F(Run, ABusyPortIsAnErrorOfOneLine) {
  robot_->plug_in();
  const link::Port held = link::open_port(port().string(), {});
  EXPECT_EQ(run(), -1);
  EXPECT_THAT(message_, HasSubstr("port is busy"));
}

TEST_F(Run, ASilentPortIsAnErrorUnlessAskedToWait) {
  robot_->plug_in();
  robot_->with([](ScriptedRobot& robot) { robot.silent = true; });
  EXPECT_EQ(run(), -1);
  EXPECT_THAT(message_, HasSubstr("no answer from a TP100"));
}

TEST_F(Run, FramesWithoutAHelloAreAnErrorUnlessAskedToWait) {
  robot_->plug_in();
  robot_->with([](ScriptedRobot& robot) { robot.silent = true; });
  std::atomic<bool> over{false};
  std::thread chatter([&] {
    while (!over) {
      robot_->with([](ScriptedRobot& robot) { robot.say(wire::Log{}); });
      std::this_thread::sleep_for(10ms);
    }
  });
  EXPECT_EQ(run(), -1);
  over = true;
  chatter.join();
  EXPECT_THAT(message_, HasSubstr("but no hello"));
}

TEST_F(Run, ARobotThatSpeaksAndHearsNothingIsAnErrorUnlessAskedToWait) {
  robot_->plug_in();
  robot_->with([](ScriptedRobot& robot) { robot.answers_parameters = false; });
  EXPECT_EQ(run(), -1);
  EXPECT_THAT(message_, HasSubstr("sends hello but receives nothing; check cable"));
  options_.wait = true;
  EXPECT_EQ(run([&] {
              says_of_itself("\"unanswered\": 1");
              robot_->with([](ScriptedRobot& robot) { robot.answers_parameters = true; });
              eventually(commanded);
            }),
            1);
  EXPECT_THAT(log_, HasSubstr("no answer from the robot (state parameters)"));
}

TEST_F(Run, AWrongVersionIsRefusedWithBothVersions) {
  robot_->plug_in();
  robot_->with([](ScriptedRobot& robot) { robot.protocol = 77; });
  EXPECT_EQ(run(), -1);
  EXPECT_THAT(message_, HasSubstr("robot has protocol 77"));
  EXPECT_THAT(message_, HasSubstr("needs protocol 1"));
  EXPECT_THAT(message_, HasSubstr("flash"));
  EXPECT_TRUE(robot_->with([](ScriptedRobot& robot) { return robot.received.types.empty(); }));
}

TEST_F(Run, WaitsForAPortThatComesLater) {
  options_.wait = true;
  EXPECT_EQ(run([&] {
              says_of_itself("\"closed\"");
              robot_->plug_in();
              eventually(commanded);
            }),
            1);
  EXPECT_THAT(log_, HasSubstr("state: closed -> listening"));
  EXPECT_THAT(log_, HasSubstr("state: syncing -> ready"));
}

TEST_F(Run, EndsWithStatus1WhenItsTimeIsOver) {
  options_.duration_s = 0.5;
  robot_->plug_in();
  EXPECT_EQ(run(), 1);
  EXPECT_THAT(stats(), HasSubstr("\"result\": \"duration\""));
}

TEST_F(Run, SigtermDisarmsFirst) {
  options_.course = "1-straight";
  robot_->plug_in();
  EXPECT_EQ(run([&] { eventually(driven); }), 1);
  EXPECT_TRUE(robot_->with([](ScriptedRobot& robot) { return !robot.received.disarms.empty(); }));
  EXPECT_EQ(robot_->with([](ScriptedRobot& robot) { return robot.state; }), wire::State::kDisarmed);
  EXPECT_THAT(log_, HasSubstr("state: idle -> arming"));
  EXPECT_THAT(log_, HasSubstr("state: arming -> running"));
}

TEST_F(Run, SigtermEndsItInEveryState) {
  // There is no robot, or a silent one.
  options_.wait = true;
  for (const bool silent : {false, true}) {
    if (silent) robot_->plug_in();
    robot_->with([&](ScriptedRobot& robot) { robot.silent = silent; });
    std::filesystem::remove(stats_path());
    EXPECT_EQ(run([&] { says_of_itself(silent ? "\"listening\"" : "\"closed\""); }), 1);
    EXPECT_EQ(log_.find("-> ready"), std::string::npos) << log_;
  }
  robot_->with([](ScriptedRobot& robot) { robot.silent = false; });
  // The daemon is ready.
  EXPECT_EQ(run([&] { eventually(commanded); }), 1);
  EXPECT_TRUE(robot_->with([](ScriptedRobot& robot) { return robot.received.arms.empty(); }));
  EXPECT_FALSE(robot_->with([](ScriptedRobot& robot) { return robot.received.disarms.empty(); }));
  // The daemon is arming; the robot has not answered yet.
  options_.course = "1-straight";
  robot_->with([](ScriptedRobot& robot) {
    robot.received = {};
    robot.answers_requests = false;
  });
  EXPECT_EQ(run([&] {
              eventually([](const ScriptedRobot& robot) { return !robot.received.arms.empty(); });
              robot_->with([](ScriptedRobot& robot) { robot.answers_requests = true; });
            }),
            1);
  EXPECT_FALSE(robot_->with([](ScriptedRobot& robot) { return robot.received.disarms.empty(); }));
  EXPECT_EQ(robot_->with([](ScriptedRobot& robot) { return robot.state; }), wire::State::kDisarmed);
  // A run has ended; the daemon waits for the next one.
  options_.stay = true;
  EXPECT_EQ(run([&] {
              eventually(driven);
              eventually([](const ScriptedRobot& robot) {
                return robot.received.commands.back().speed_mps == 0.0F;
              });
            }),
            1);
  EXPECT_THAT(log_, HasSubstr("state: running -> aborted"));
  EXPECT_EQ(robot_->with([](ScriptedRobot& robot) { return robot.state; }), wire::State::kDisarmed);
}

TEST_F(Run, APortThatIsRefusedAgainAndAgainIsTakenOnceItIsFree) {
  options_.wait = true;
  robot_->plug_in();
  auto held = std::make_unique<link::Port>(link::open_port(port().string(), {}));
  EXPECT_EQ(run([&] {
              // The daemon tries to open the port after 50, 150 and 350 ms.
              std::this_thread::sleep_for(500ms);
              held.reset();
              eventually(commanded);
            }),
            1);
  EXPECT_THAT(log_, HasSubstr("port is busy"));
  EXPECT_EQ(log_.find("port is busy"), log_.rfind("port is busy"))
      << "the message must appear once: " << log_;
  EXPECT_THAT(log_, HasSubstr("state: syncing -> ready"));
}

TEST_F(Run, ARobotThatNeverMovesAbortsTheRun) {
  options_.course = "1-straight";
  robot_->plug_in();
  EXPECT_EQ(run(), 1);
  EXPECT_THAT(log_, HasSubstr("state: running -> aborted"));
  EXPECT_THAT(stats(), HasSubstr("\"result\": \"aborted\""));
}

TEST_F(Run, ReconnectsByItselfAndStaysDisarmed) {
  options_.course = "1-straight";
  robot_->plug_in();
  EXPECT_EQ(run([&] {
              eventually(driven);
              robot_->unplug();
              says_of_itself("\"closed\"");
              robot_->with([](ScriptedRobot& robot) { robot.received = {}; });
              robot_->plug_in();
              commanded_again(160);
            }),
            1);
  EXPECT_TRUE(robot_->with([](ScriptedRobot& robot) { return robot.received.arms.empty(); }));
  EXPECT_THAT(stats(), HasSubstr("\"reconnects\": 1"));
  EXPECT_THAT(log_, HasSubstr("link_lost"));
  EXPECT_THAT(log_, HasSubstr("press Enter to start"));
}

TEST_F(Run, ARobotThatFallsSilentIsALostLinkAndIsWaitedFor) {
  options_.course = "1-straight";
  robot_->plug_in();
  EXPECT_EQ(
      run([&] {
        eventually(driven);
        robot_->with([](ScriptedRobot& robot) { robot.samples = robot.answers_sync = false; });
        says_of_itself("\"silences\": 1");
        robot_->with([](ScriptedRobot& robot) {
          robot.samples = robot.answers_sync = true;
          robot.received = {};
        });
        eventually(commanded);
      }),
      1);
  EXPECT_TRUE(robot_->with([](ScriptedRobot& robot) { return robot.received.arms.empty(); }));
  EXPECT_THAT(log_, HasSubstr("link_lost"));
  EXPECT_THAT(log_, HasSubstr("SIGTERM")) << "it must run until a signal ends it";
  EXPECT_THAT(log_, HasSubstr("s around link_lost are in " + folder_.file("boxes")));
}

TEST_F(Run, WithGoALostLinkEndsItToo) {
  options_.course = "1-straight";
  options_.go = options_.wait = true;
  robot_->plug_in();
  std::thread hand([&] {
    eventually(driven);
    robot_->unplug();
  });
  EXPECT_EQ(run(), 1);
  hand.join();
  EXPECT_THAT(log_, HasSubstr("link_lost"));
  EXPECT_THAT(stats(), HasSubstr("\"result\": \"aborted\""));
}

TEST_F(Run, AnswersToClockRequestsAreNoSamples) {
  options_.course = "1-straight";
  robot_->plug_in();
  EXPECT_EQ(
      run([&] {
        eventually(driven);
        robot_->with([](ScriptedRobot& robot) {
          robot.received = {};
          robot.samples = false;
        });
        eventually([](const ScriptedRobot& robot) { return !robot.received.disarms.empty(); });
        robot_->with([](ScriptedRobot& robot) {
          robot.received = {};
          robot.samples = true;
        });
        eventually(commanded);
      }),
      1);
  EXPECT_THAT(log_, HasSubstr("link_lost: the link broke, or no sample arrived for 200 ms"));
  EXPECT_TRUE(robot_->with([](ScriptedRobot& robot) { return robot.received.arms.empty(); }));
}

TEST_F(Run, MotorsThatAreOnUnaskedAreStoppedAndEndIt) {
  robot_->plug_in();
  for (const bool obeys : {true, false}) {
    robot_->with([&](ScriptedRobot& robot) {
      robot.received = {};
      robot.answers_requests = obeys;
      if (robot.state == wire::State::kRunning) robot.state = wire::State::kDisarmed;
    });
    std::thread oddity([&] {
      eventually(commanded);
      robot_->with([](ScriptedRobot& robot) { robot.state = wire::State::kRunning; });
    });
    EXPECT_EQ(run(), 1);
    oddity.join();
    EXPECT_THAT(log_, HasSubstr("moves_unasked"));
    EXPECT_THAT(stats(), HasSubstr("moves_unasked"));
    robot_->with([](ScriptedRobot& robot) { EXPECT_FALSE(robot.received.stops.empty()); });
  }
}

TEST_F(Run, WhoStaysStopsMotorsThatComeOnAgainAndAgain) {
  options_.stay = true;
  robot_->plug_in();
  EXPECT_EQ(run([&] {
              eventually(commanded);
              // The robot acknowledges the stop but keeps its motors on.
              EXPECT_TRUE(soon([&] {
                return robot_->with([](ScriptedRobot& robot) {
                  robot.state = wire::State::kRunning;
                  return robot.received.stops.size() > 4;
                });
              }));
            }),
            1);
  EXPECT_THAT(log_, HasSubstr("moves_unasked"));
}

TEST_F(Run, NoMotionFollowsAnArmThatWasNotAccepted) {
  options_.course = "1-straight";
  robot_->plug_in();
  for (const bool refuses : {true, false}) {
    robot_->with([&](ScriptedRobot& robot) {
      robot.received = {};
      robot.arms_anyway = true;
      robot.answers_arms = refuses;
      if (refuses) robot.arm_result = wire::Result::kOutOfRange;
    });
    EXPECT_EQ(run(), 1);
    EXPECT_THAT(log_, HasSubstr("not_acknowledged"));
    EXPECT_THAT(log_, HasSubstr(refuses ? "arm refused by the robot: its expiry is out of range"
                                        : "arm not acknowledged"));
    EXPECT_EQ(log_.find("counts_per_metre"), std::string::npos);
    EXPECT_EQ(log_.find("-> running"), std::string::npos);
    robot_->with([](ScriptedRobot& robot) {
      EXPECT_FALSE(robot.received.arms.empty());
      EXPECT_FALSE(robot.received.disarms.empty());
      EXPECT_EQ(robot.state, wire::State::kDisarmed);
      for (const wire::Command& command : robot.received.commands)
        ASSERT_EQ(command.speed_mps, 0.0F);
    });
  }
}

TEST_F(Run, AStartThatCannotBeginIsRefusedAndNotKept) {
  options_.course = "1-straight";
  // The robot is held by hand and its tracks turn.
  robot_->with([](ScriptedRobot& robot) { robot.metres_per_s = 0.1; });
  robot_->plug_in();
  EXPECT_EQ(run([&] {
              says_of_itself("\"run\": \"arming\"");
              says_of_itself("\"run\": \"idle\"");
              // The robot is put down.
              robot_->with([](ScriptedRobot& robot) { robot.metres_per_s = 0.0; });
              commanded_again(400);
            }),
            1);
  EXPECT_THAT(log_, HasSubstr("start refused: the gyro is not still"));
  EXPECT_THAT(log_, HasSubstr("state: arming -> idle"));
  EXPECT_TRUE(robot_->with([](ScriptedRobot& robot) { return robot.received.arms.empty(); }));
  options_.go = true;
  robot_->with([](ScriptedRobot& robot) { robot.metres_per_s = 0.1; });
  EXPECT_EQ(run(), 1) << "with --go it must not wait";
  EXPECT_THAT(stats(), HasSubstr("\"result\": \"refused\""));
}

TEST_F(Run, ACourseIsCompletedOnceTheRobotHasConfirmedItsEnd) {
  std::ofstream(folder_.path() / "short.toml")
      << "speed_mps = 0.1\n[[segment]]\ntype = \"line\"\nlength_m = 0.1\n"
         "[fence]\nmin_x_m = -1.0\nmax_x_m = 1.0\nmin_y_m = -1.0\nmax_y_m = 1.0\n";
  options_.course = folder_.file("short.toml");
  options_.setup = "stand";
  options_.go = true;
  robot_->plug_in();
  for (const bool confirms : {true, false}) {
    int status = -1;
    // On a busy machine the robot may not be scheduled for 200 ms, which ends the run early; the
    // test then tries again.
    for (int i = 0; i < 10 && log_.find("running -> finished") == std::string::npos; ++i) {
      robot_->with([&](ScriptedRobot& robot) {
        robot.drives = true;
        robot.received = {};
        robot.answers_requests = true;
      });
      std::atomic<bool> over{false};
      std::thread deaf([&] {
        soon([&] { return over || robot_->with(driven); });
        robot_->with([&](ScriptedRobot& robot) { robot.answers_requests = confirms; });
      });
      status = run();
      over = true;
      deaf.join();
    }
    EXPECT_EQ(status, confirms ? 0 : 1) << log_;
    EXPECT_THAT(log_, HasSubstr("state: running -> finished"));
    EXPECT_THAT(stats(),
                HasSubstr(confirms ? "\"result\": \"completed\"" : "\"result\": \"aborted\""));
    EXPECT_EQ(log_.find("not_acknowledged") == std::string::npos, confirms) << log_;
    log_.clear();
  }
}

TEST_F(Run, AHelloWithoutABootNumberIsAnErrorOfOneLine) {
  robot_->plug_in();
  robot_->with([](ScriptedRobot& robot) { robot.boot_nonce = 0; });
  EXPECT_EQ(run(), -1);
  EXPECT_THAT(message_, HasSubstr("its boot number is 0; flash the board"));
}

TEST_F(Run, AFaultReportBeyondTheRobotsBitsIsNotTheDaemons) {
  robot_->plug_in();
  EXPECT_EQ(run([&] {
              eventually(commanded);
              robot_->with([](ScriptedRobot& robot) {
                robot.received = {};
                robot.say(wire::FaultReport{.device_us = 0, .fault = 29, .faults = 0, .detail = 0});
              });
              eventually(commanded);
            }),
            1);
  EXPECT_THAT(log_, HasSubstr("robot fault unknown (29)"));
  EXPECT_EQ(log_.find("immobilised"), std::string::npos);
}

TEST_F(Run, SurvivesManyUnpluggings) {
  robot_->plug_in();
  EXPECT_EQ(run([&] {
              for (int i = 0; i < 5; ++i) {
                robot_->with([](ScriptedRobot& robot) { robot.received = {}; });
                if (!eventually(commanded)) return;
                robot_->unplug();
                robot_->plug_in();
              }
              robot_->with([](ScriptedRobot& robot) { robot.received = {}; });
              eventually(commanded);
            }),
            1);
  EXPECT_THAT(stats(), HasSubstr("\"reconnects\": 5"));
}

/// Unplugs a moving robot and starts it again, many times.
class Unplugging : public Run {
 protected:
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
  static constexpr int kCycles = 15;
  // A sanitizer's own memory hides growth of the program.
  static constexpr bool kWeighed = false;
#else
  static constexpr int kCycles = 50;
  static constexpr bool kWeighed = true;
#endif
  static constexpr long kGrowthKib = 4096;
  // Until then histories and pools still fill.
  static constexpr int kSettled = kCycles / 2;
  static constexpr double kMaxMps2 = 0.15, kMaxRadps = 1.5;

  void plug_in() {
    robot_->with([](ScriptedRobot& robot) { robot.received = {}; });
    robot_->plug_in();
  }
  std::vector<wire::Command> commands() {
    return robot_->with([](ScriptedRobot& robot) { return robot.received.commands; });
  }
  bool armed() {
    return robot_->with([](ScriptedRobot& robot) { return !robot.received.arms.empty(); });
  }
  static bool under_way(const ScriptedRobot& robot) {
    return commanded(robot) && robot.received.commands.back().speed_mps > 0.02F;
  }
  /// Requests a start until the robot moves. A start that comes too early is refused, and a machine
  /// that stood still ends the run that it began.
  bool start(server::WebClient& viewer) {
    const auto off = [](const ScriptedRobot& robot) {
      return robot.state == wire::State::kDisarmed || robot.state == wire::State::kFaulted;
    };
    for (int i = 0; i < 400; ++i) {
      if (i % 20 == 0 && robot_->with(off)) viewer.call(1);
      if (armed() && robot_->with(under_way)) return true;
      std::this_thread::sleep_for(25ms);
      viewer.drain();
    }
    return false;
  }
  /// Without a request, the robot must stay as it is.
  void expect_rest(int cycle) {
    EXPECT_FALSE(armed()) << "cycle " << cycle << ": it armed without a request";
    EXPECT_GE(robot_->with([](ScriptedRobot& robot) { return robot.state; }),
              wire::State::kDisarmed);
    for (const wire::Command& command : commands()) {
      ASSERT_EQ(command.speed_mps, 0.0F) << "cycle " << cycle;
      ASSERT_EQ(command.yaw_rate_radps, 0.0F) << "cycle " << cycle;
      ASSERT_EQ(command.desired_yaw_rad, command.yaw_rad) << "cycle " << cycle;
    }
  }
  /// From standstill on, the commanded values grow no faster than the time between commands allows.
  void expect_no_jump(int cycle) {
    const std::vector<wire::Command> all = commands();
    for (std::size_t i = 1; i < all.size(); ++i) {
      const double later_s =
          1e-6 * static_cast<std::int32_t>(all[i].expiry_us - all[i - 1].expiry_us);
      const auto turn_rad = [](const wire::Command& command) {
        return std::abs(command.desired_yaw_rad - command.yaw_rad);
      };
      ASSERT_LE(all[i].speed_mps - all[i - 1].speed_mps, kMaxMps2 * later_s + 0.005)
          << "cycle " << cycle << ", command " << i;
      ASSERT_LE(turn_rad(all[i]) - turn_rad(all[i - 1]), kMaxRadps * later_s + 0.005)
          << "cycle " << cycle << ", command " << i;
      ASSERT_LE(std::abs(all[i].yaw_rate_radps), 0.05F)
          << "cycle " << cycle << ": turn rate on a line";
    }
  }
  /// Resources of this process, once they are at most `most` or after ten seconds.
  static test::Weight weigh_at_most(const test::Weight& most) {
    test::Weight now = test::weigh("self");
    for (int i = 0; i < 200; ++i) {
      if (now.descriptors <= most.descriptors && now.threads <= most.threads) break;
      std::this_thread::sleep_for(50ms);
      now = test::weigh("self");
    }
    return now;
  }
  void cycle(int number, server::WebClient& viewer) {
    plug_in();
    ASSERT_TRUE(eventually(commanded)) << "cycle " << number << ": not ready again";
    expect_rest(number);
    ASSERT_TRUE(start(viewer)) << "cycle " << number << ": it does not start again";
    expect_no_jump(number);
    robot_->unplug();
  }
};

TEST_F(Unplugging, AgainAndAgainLeavesNothingBehindAndMovesNothingUnasked) {
  options_.course = "1-straight";
  options_.stay = true;
  robot_->plug_in();
  test::Weight settled, after;
  // A signal ends the command regularly, either during the last run (1) or after its link was lost
  // (0).
  EXPECT_THAT(run([&] {
                if (!eventually(driven)) return;
                server::WebClient viewer(page());
                robot_->unplug();
                for (int i = 1; i <= kCycles && !HasFatalFailure(); ++i) {
                  cycle(i, viewer);
                  if (i == kSettled) settled = test::weigh("self");
                }
                after = weigh_at_most(settled);
              }),
              ::testing::AnyOf(0, 1))
      << message_;
  EXPECT_THAT(stats(), HasSubstr("\"reconnects\": " + std::to_string(kCycles)));
  EXPECT_LE(after.descriptors, settled.descriptors);
  EXPECT_LE(after.threads, settled.threads);
  if (kWeighed) {
    EXPECT_LE(after.resident_kib - settled.resident_kib, kGrowthKib);
  }
  RecordProperty("grown_kib", static_cast<int>(after.resident_kib - settled.resident_kib));
}

TEST_F(Run, AViewerWatchesStopsAndStartsAgain) {
  options_.course = "1-straight";
  options_.stay = true;
  robot_->plug_in();
  std::string pose, stopped, started;
  EXPECT_EQ(run([&] {
              eventually(driven);
              server::WebClient viewer(page());
              viewer.subscribe(messages::pose_channel(PoseSource::kOdometry));
              pose = viewer.read_until("\"frame_id\"");
              robot_->with([](ScriptedRobot& robot) { robot.received = {}; });
              viewer.call(3);
              stopped = viewer.read_until("\"acknowledged\"");
              viewer.subscribe(messages::Channel::kState);
              viewer.read_until("\"can\":{\"start\":true");
              commanded_again(40);
              // Commands alone never arm the robot again; only a start does.
              EXPECT_TRUE(robot_->with([](ScriptedRobot& robot) {
                return !robot.received.stops.empty() && robot.received.arms.empty();
              }));
              viewer.call(1);
              started = viewer.read_until("\"accepted\"");
              eventually([](const ScriptedRobot& robot) { return !robot.received.arms.empty(); });
            }),
            1);
  EXPECT_THAT(pose, HasSubstr("\"world\""));
  EXPECT_THAT(stopped, HasSubstr("\"acknowledged\":true"));
  EXPECT_THAT(started, HasSubstr("true"));
  EXPECT_THAT(log_, HasSubstr("stop acknowledged"));
}

TEST_F(Run, AViewerEndsARecordingAndBeginsAnother) {
  options_.record = folder_.file("runs");
  robot_->plug_in();
  std::string refused, ended, began, runs;
  EXPECT_EQ(run([&] {
              eventually(commanded);
              const std::string port = page();
              server::WebClient viewer(port);
              viewer.call(4);
              refused = viewer.read_until("serviceCallFailure");
              viewer.call(5);
              ended = viewer.read_until("\"bytes\"");
              viewer.call(4);
              began = viewer.read_until("\"run\"");
              runs = server::http_get(port, "GET /api/runs HTTP/1.0\r\nHost: localhost\r\n\r\n");
            }),
            1);
  EXPECT_THAT(refused, HasSubstr("running already"));
  EXPECT_THAT(ended, HasSubstr("-poses"));
  EXPECT_THAT(began, HasSubstr("-poses"));
  EXPECT_THAT(runs, HasSubstr("\"kind\":\"recording\""));
  EXPECT_THAT(runs, HasSubstr("\"active\":true"));
  EXPECT_THAT(runs, HasSubstr("\"active\":false"));
  // The second recording begins in the middle of the run.
  EXPECT_EQ(replayed_recordings(), 2);
}

TEST_F(Run, WhoStaysRecordsRunByRun) {
  options_.course = "1-straight";
  options_.stay = true;
  options_.record = folder_.file("runs");
  robot_->plug_in();
  EXPECT_THAT(run([&] {
                eventually(driven);
                server::WebClient viewer(page());
                says_of_itself("\"active\": true");
                viewer.call(3);
                says_of_itself("\"active\": false");
                robot_->with([](ScriptedRobot& robot) { robot.received = {}; });
                EXPECT_TRUE(soon([&] {
                  viewer.call(1);
                  std::this_thread::sleep_for(100ms);
                  viewer.drain();
                  return robot_->with(driven);
                }));
                says_of_itself("\"active\": true");
              }),
              ::testing::AnyOf(0, 1))
      << message_;
  EXPECT_EQ(replayed_recordings(), 2);
}

// Records on a disk that a test can freeze.
class RunBesideADisk : public Run {
 protected:
  void SetUp() override {
    if (!disk_.available()) GTEST_SKIP() << "no file system can be frozen here (root, loop device)";
    std::filesystem::create_directory(disk_.path() + "/runs");
    options_.record = disk_.path() + "/runs";
    options_.course = "1-straight";
    options_.stay = true;
    robot_->plug_in();
  }
  // On a busy machine the link may be lost before a run has begun; then the start is repeated.
  void drives(server::WebClient& viewer) {
    EXPECT_TRUE(soon([&] {
      viewer.call(1);
      std::this_thread::sleep_for(100ms);
      viewer.drain();
      return robot_->with(driven);
    }));
  }
  void drives_and_records(server::WebClient& viewer) {
    drives(viewer);
    says_of_itself("\"active\": true");
  }

  test::FrozenDisk disk_;
};

TEST_F(RunBesideADisk, StopAndWatchdogDoNotWaitForADiskThatStandsStill) {
  const std::string name = "@tp100-run-test-" + std::to_string(::getpid());
  const test::NotifySocket manager(name);
  ::setenv("NOTIFY_SOCKET", name.c_str(), 1);
  ::setenv("WATCHDOG_USEC", "2000000", 1);
  EXPECT_THAT(
      run([&] {
        server::WebClient viewer(page());
        drives_and_records(viewer);
        robot_->with([](ScriptedRobot& robot) { robot.received = {}; });
        ASSERT_TRUE(disk_.freeze());
        viewer.call(5);
        viewer.call(3);
        eventually([](const ScriptedRobot& robot) { return !robot.received.stops.empty(); });
        manager.received();
        EXPECT_TRUE(manager.hears("WATCHDOG=1", 60s));
        // The same must hold during another run, whose recording also waits for the disk.
        robot_->with([](ScriptedRobot& robot) { robot.received = {}; });
        drives(viewer);
        viewer.call(3);
        eventually([](const ScriptedRobot& robot) { return !robot.received.stops.empty(); });
        manager.received();
        EXPECT_TRUE(manager.hears("WATCHDOG=1", 60s));
        viewer.drain();
        for (const std::string& message : viewer.take())
          EXPECT_THAT(message, Not(HasSubstr("\"bytes\"")));
        ASSERT_TRUE(disk_.thaw());
        EXPECT_THAT(viewer.read_until("\"bytes\""), HasSubstr("-1-straight"));
      }),
      ::testing::AnyOf(0, 1))
      << message_;
  ::unsetenv("NOTIFY_SOCKET");
  ::unsetenv("WATCHDOG_USEC");
  EXPECT_GE(replayed_recordings(), 2);
}

TEST_F(RunBesideADisk, SigtermDisarmsWhileADiskStandsStill) {
  std::thread thaw;
  EXPECT_EQ(
      run([&] {
        server::WebClient viewer(page());
        drives_and_records(viewer);
        robot_->with([](ScriptedRobot& robot) { robot.received = {}; });
        ASSERT_TRUE(disk_.freeze());
        thaw = std::thread([&] {
          eventually([](const ScriptedRobot& robot) { return !robot.received.disarms.empty(); });
          disk_.thaw();
        });
      }),
      1);
  if (thaw.joinable()) thaw.join();
  EXPECT_GE(replayed_recordings(), 1) << "the recording must contain the end of the run";
}

TEST_F(Run, ItsFiguresHoldUpNobodyWhereTheyCannotBeWritten) {
  ASSERT_EQ(::mkfifo(stats_path().c_str(), 0600), 0);
  robot_->plug_in();
  // The first statistics are read, so that the run begins; the next writer blocks in open().
  std::thread first([this] { stats(); });
  std::atomic<bool> over{false};
  std::thread reader;
  EXPECT_EQ(
      run([&] {
        eventually(commanded);
        std::this_thread::sleep_for(1500ms);
        reader = std::thread([&] {
          eventually([](const ScriptedRobot& robot) { return !robot.received.disarms.empty(); });
          const int pipe = ::open(stats_path().c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC);
          char text[4096];
          while (!over)
            if (::read(pipe, text, sizeof text) <= 0) std::this_thread::sleep_for(1ms);
          ::close(pipe);
        });
      }),
      1);
  over = true;
  first.join();
  if (reader.joinable()) reader.join();
}

TEST_F(Run, APageThatCannotBeServedIsAnErrorOfOneLine) {
  robot_->plug_in();
  options_.listen = "203.0.113.1:8765";
  EXPECT_EQ(run(), -1);
  EXPECT_THAT(message_, HasSubstr("--listen 203.0.113.1:8765"));
}

TEST_F(Run, AStatsFileThatCannotBeWrittenIsAnError) {
  robot_->plug_in();
  options_.stats = (folder_.path() / "none" / "stats.json").string();
  EXPECT_EQ(run(), -1);
  EXPECT_THAT(message_, HasSubstr("stats.json: cannot be written"));
}

TEST_F(Run, BadOptionsAreErrors) {
  options_.setup = "moon";
  EXPECT_EQ(run(), -1);
  EXPECT_THAT(message_, HasSubstr("use stand, flat or terrain"));
  options_.setup = "stand";
  options_.course = "no-such";
  EXPECT_EQ(run(), -1);
  EXPECT_THAT(message_, HasSubstr("no such course"));
}

}  // namespace
}  // namespace tp100::live
