// `tp100d run` against a scripted robot on a pty, both in this process.
#include "app/run.h"

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
#include "app/replay.h"
#include "core/error.h"
#include "link/transport.h"
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
    // Ordinary scheduling: the tests of a whole machine run at once.
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

  // The command with `script` beside it; a script ends it by SIGTERM.
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
  std::string stats() const {
    std::ostringstream text;
    text << std::ifstream(stats_path()).rdbuf();
    return text.str();
  }
  static bool soon(const std::function<bool()>& condition) {
    for (int i = 0; i < 4000; ++i) {
      if (condition()) return true;
      std::this_thread::sleep_for(5ms);
    }
    return false;
  }
  // Port of the page, once it is served.
  std::string page() const {
    static const std::string kBefore = "http://127.0.0.1:";
    std::string served;
    const bool any = soon([&] {
      const std::string text = stats();
      const std::size_t at = text.find(kBefore), end = text.find('/', at + kBefore.size());
      if (end == std::string::npos || at == std::string::npos) return false;
      served = text.substr(at + kBefore.size(), end - at - kBefore.size());
      return true;
    });
    if (!any) throw std::runtime_error("no page is served");
    return served;
  }
  // Its own figures have `word`.
  void says_of_itself(const std::string& word) const {
    EXPECT_TRUE(soon([&] { return stats().find(word) != std::string::npos; }))
        << word << " is not in " << stats();
  }
  bool eventually(const std::function<bool(const ScriptedRobot&)>& condition) {
    const bool happened = soon([&] { return robot_->with(condition); });
    EXPECT_TRUE(happened) << "did not happen";
    return happened;
  }
  /// Until the robot has got so many more commands, in which what must not happen could.
  void commanded_again(std::size_t more) {
    const std::size_t before =
        robot_->with([](const ScriptedRobot& robot) { return robot.heard.commands.size(); });
    eventually(
        [&](const ScriptedRobot& robot) { return robot.heard.commands.size() >= before + more; });
  }
  /// How many recordings there are; each repeats its run bit for bit.
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
  static bool commanded(const ScriptedRobot& robot) { return robot.heard.commands.size() > 20; }

  static bool driven(const ScriptedRobot& robot) {
    return commanded(robot) && robot.heard.commands.back().speed_mps > 0.0F;
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
  EXPECT_THAT(message_, HasSubstr("nothing that speaks like a TP100"));
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
  EXPECT_THAT(message_, HasSubstr("says no hello"));
}

TEST_F(Run, ARobotThatSpeaksAndHearsNothingIsAnErrorUnlessAskedToWait) {
  robot_->plug_in();
  robot_->with([](ScriptedRobot& robot) { robot.answers_parameters = false; });
  EXPECT_EQ(run(), -1);
  EXPECT_THAT(message_, HasSubstr("hears nothing of what is sent to it; check cable"));
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
  EXPECT_TRUE(robot_->with([](ScriptedRobot& robot) { return robot.heard.types.empty(); }));
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
  EXPECT_TRUE(robot_->with([](ScriptedRobot& robot) { return !robot.heard.disarms.empty(); }));
  EXPECT_EQ(robot_->with([](ScriptedRobot& robot) { return robot.state; }), wire::State::kDisarmed);
  EXPECT_THAT(log_, HasSubstr("state: idle -> arming"));
  EXPECT_THAT(log_, HasSubstr("state: arming -> running"));
}

TEST_F(Run, SigtermEndsItInEveryState) {
  // Nobody there, or nobody who speaks.
  options_.wait = true;
  for (const bool silent : {false, true}) {
    if (silent) robot_->plug_in();
    robot_->with([&](ScriptedRobot& robot) { robot.silent = silent; });
    std::filesystem::remove(stats_path());
    EXPECT_EQ(run([&] { says_of_itself(silent ? "\"listening\"" : "\"closed\""); }), 1);
    EXPECT_EQ(log_.find("-> ready"), std::string::npos) << log_;
  }
  robot_->with([](ScriptedRobot& robot) { robot.silent = false; });
  // Ready.
  EXPECT_EQ(run([&] { eventually(commanded); }), 1);
  EXPECT_TRUE(robot_->with([](ScriptedRobot& robot) { return robot.heard.arms.empty(); }));
  EXPECT_FALSE(robot_->with([](ScriptedRobot& robot) { return robot.heard.disarms.empty(); }));
  // Arming: the robot has not answered yet.
  options_.course = "1-straight";
  robot_->with([](ScriptedRobot& robot) {
    robot.heard = {};
    robot.answers_requests = false;
  });
  EXPECT_EQ(run([&] {
              eventually([](const ScriptedRobot& robot) { return !robot.heard.arms.empty(); });
              robot_->with([](ScriptedRobot& robot) { robot.answers_requests = true; });
            }),
            1);
  EXPECT_FALSE(robot_->with([](ScriptedRobot& robot) { return robot.heard.disarms.empty(); }));
  EXPECT_EQ(robot_->with([](ScriptedRobot& robot) { return robot.state; }), wire::State::kDisarmed);
  // After a run, waiting for the next one.
  options_.stay = true;
  EXPECT_EQ(run([&] {
              eventually(driven);
              eventually([](const ScriptedRobot& robot) {
                return robot.heard.commands.back().speed_mps == 0.0F;
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
              // Asked for after 50, 150 and 350 ms.
              std::this_thread::sleep_for(500ms);
              held.reset();
              eventually(commanded);
            }),
            1);
  EXPECT_THAT(log_, HasSubstr("port is busy"));
  EXPECT_EQ(log_.find("port is busy"), log_.rfind("port is busy")) << "said once: " << log_;
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
              robot_->with([](ScriptedRobot& robot) { robot.heard = {}; });
              robot_->plug_in();
              commanded_again(160);
            }),
            1);
  EXPECT_TRUE(robot_->with([](ScriptedRobot& robot) { return robot.heard.arms.empty(); }));
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
          robot.heard = {};
        });
        eventually(commanded);
      }),
      1);
  EXPECT_TRUE(robot_->with([](ScriptedRobot& robot) { return robot.heard.arms.empty(); }));
  EXPECT_THAT(log_, HasSubstr("link_lost"));
  EXPECT_THAT(log_, HasSubstr("SIGTERM")) << "it waits until somebody ends it";
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
  EXPECT_EQ(run([&] {
              eventually(driven);
              robot_->with([](ScriptedRobot& robot) {
                robot.heard = {};
                robot.samples = false;
              });
              eventually([](const ScriptedRobot& robot) { return !robot.heard.disarms.empty(); });
              robot_->with([](ScriptedRobot& robot) {
                robot.heard = {};
                robot.samples = true;
              });
              eventually(commanded);
            }),
            1);
  EXPECT_THAT(log_, HasSubstr("link_lost: the link broke, or no sample came for 200 ms"));
  EXPECT_TRUE(robot_->with([](ScriptedRobot& robot) { return robot.heard.arms.empty(); }));
}

TEST_F(Run, MotorsThatAreOnUnaskedAreStoppedAndEndIt) {
  robot_->plug_in();
  for (const bool obeys : {true, false}) {
    robot_->with([&](ScriptedRobot& robot) {
      robot.heard = {};
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
    robot_->with([](ScriptedRobot& robot) { EXPECT_FALSE(robot.heard.stops.empty()); });
  }
}

TEST_F(Run, WhoStaysStopsMotorsThatComeOnAgainAndAgain) {
  options_.stay = true;
  robot_->plug_in();
  EXPECT_EQ(run([&] {
              eventually(commanded);
              // It acknowledges, and goes on all the same.
              EXPECT_TRUE(soon([&] {
                return robot_->with([](ScriptedRobot& robot) {
                  robot.state = wire::State::kRunning;
                  return robot.heard.stops.size() > 4;
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
      robot.heard = {};
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
      EXPECT_FALSE(robot.heard.arms.empty());
      EXPECT_FALSE(robot.heard.disarms.empty());
      EXPECT_EQ(robot.state, wire::State::kDisarmed);
      for (const wire::Command& command : robot.heard.commands) ASSERT_EQ(command.speed_mps, 0.0F);
    });
  }
}

TEST_F(Run, AStartThatCannotBeginIsRefusedAndNotKept) {
  options_.course = "1-straight";
  // In somebody's hands: its tracks turn.
  robot_->with([](ScriptedRobot& robot) { robot.metres_per_s = 0.1; });
  robot_->plug_in();
  EXPECT_EQ(run([&] {
              says_of_itself("\"run\": \"arming\"");
              says_of_itself("\"run\": \"idle\"");
              // And put down.
              robot_->with([](ScriptedRobot& robot) { robot.metres_per_s = 0.0; });
              commanded_again(400);
            }),
            1);
  EXPECT_THAT(log_, HasSubstr("start refused: the gyro is not still"));
  EXPECT_THAT(log_, HasSubstr("state: arming -> idle"));
  EXPECT_TRUE(robot_->with([](ScriptedRobot& robot) { return robot.heard.arms.empty(); }));
  options_.go = true;
  robot_->with([](ScriptedRobot& robot) { robot.metres_per_s = 0.1; });
  EXPECT_EQ(run(), 1) << "who gave --go does not wait";
  EXPECT_THAT(stats(), HasSubstr("\"result\": \"refused\""));
}

TEST_F(Run, ACourseIsCompletedOnceTheRobotHasConfirmedItsEnd) {
  std::ofstream(folder_.path() / "short.toml")
      << "speed_mps = 0.1\n[[segment]]\ntype = \"line\"\nlength_m = 0.1\n"
         "[fence]\nmin_x_m = -1.0\nmax_x_m = 1.0\nmin_y_m = -1.0\nmax_y_m = 1.0\n";
  options_.course = folder_.file("short.toml");
  options_.setup = "bench";
  options_.go = true;
  robot_->plug_in();
  for (const bool confirms : {true, false}) {
    int status = -1;
    // A machine that lets the robot sleep for 200 ms ends the run sooner.
    for (int i = 0; i < 10 && log_.find("running -> finished") == std::string::npos; ++i) {
      robot_->with([&](ScriptedRobot& robot) {
        robot.drives = true;
        robot.heard = {};
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
                robot.heard = {};
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
                robot_->with([](ScriptedRobot& robot) { robot.heard = {}; });
                if (!eventually(commanded)) return;
                robot_->unplug();
                robot_->plug_in();
              }
              robot_->with([](ScriptedRobot& robot) { robot.heard = {}; });
              eventually(commanded);
            }),
            1);
  EXPECT_THAT(stats(), HasSubstr("\"reconnects\": 5"));
}

/// Pulls the plug of a driving robot and starts it anew, again and again.
class Unplugging : public Run {
 protected:
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
  static constexpr int kCycles = 15;
  // What a sanitizer sets aside hides our growth.
  static constexpr bool kWeighed = false;
#else
  static constexpr int kCycles = 50;
  static constexpr bool kWeighed = true;
#endif
  static constexpr long kGrowthKib = 4096;
  static constexpr int kSettled = 10;
  static constexpr double kMaxMps2 = 0.15, kMaxRadps = 1.5;

  void plug_in() {
    robot_->with([](ScriptedRobot& robot) { robot.heard = {}; });
    robot_->plug_in();
  }
  std::vector<wire::Command> commands() {
    return robot_->with([](ScriptedRobot& robot) { return robot.heard.commands; });
  }
  bool armed() {
    return robot_->with([](ScriptedRobot& robot) { return !robot.heard.arms.empty(); });
  }
  static bool under_way(const ScriptedRobot& robot) {
    return commanded(robot) && robot.heard.commands.back().speed_mps > 0.02F;
  }
  /// Presses start until it is under way. A start that comes too early is refused.
  bool start(server::WebClient& viewer) {
    for (int i = 0; i < 400; ++i) {
      if (i % 20 == 0 && !armed()) viewer.call(1);
      if (armed() && robot_->with(under_way)) return true;
      std::this_thread::sleep_for(25ms);
      viewer.drain();
    }
    return false;
  }
  /// Nobody asked for anything: the robot may stand as it stands.
  void expect_rest(int cycle) {
    EXPECT_FALSE(armed()) << "cycle " << cycle << ": it armed by itself";
    EXPECT_GE(robot_->with([](ScriptedRobot& robot) { return robot.state; }),
              wire::State::kDisarmed);
    for (const wire::Command& command : commands()) {
      ASSERT_EQ(command.speed_mps, 0.0F) << "cycle " << cycle;
      ASSERT_EQ(command.yaw_rate_radps, 0.0F) << "cycle " << cycle;
      ASSERT_EQ(command.desired_yaw_rad, command.yaw_rad) << "cycle " << cycle;
    }
  }
  /// From rest on, each command asks at most what the time since the last one allows.
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
      ASSERT_LE(std::abs(all[i].yaw_rate_radps), 0.05F) << "cycle " << cycle << ": on a line";
    }
  }
  /// What this process holds, once nothing more than `most` is in flight or ten seconds are over.
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
  // Ended by a signal in its last drive (1) or once that was lost (0), but in order.
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
              viewer.subscribe(messages::Channel::kPoseOdometry);
              pose = viewer.read_until("\"frame_id\"");
              robot_->with([](ScriptedRobot& robot) { robot.heard = {}; });
              viewer.call(3);
              stopped = viewer.read_until("\"acknowledged\"");
              viewer.subscribe(messages::Channel::kState);
              viewer.read_until("\"can\":{\"start\":true");
              commanded_again(40);
              // A stream of commands never arms again; only a start does.
              EXPECT_TRUE(robot_->with([](ScriptedRobot& robot) {
                return !robot.heard.stops.empty() && robot.heard.arms.empty();
              }));
              viewer.call(1);
              started = viewer.read_until("\"accepted\"");
              eventually([](const ScriptedRobot& robot) { return !robot.heard.arms.empty(); });
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
  // The second began in the middle.
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
                robot_->with([](ScriptedRobot& robot) { robot.heard = {}; });
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

// With recordings on a disk that stands still when a test wants it to.
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
  // On a busy machine the link may be lost before a run has begun.
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
  EXPECT_THAT(run([&] {
                server::WebClient viewer(page());
                drives_and_records(viewer);
                robot_->with([](ScriptedRobot& robot) { robot.heard = {}; });
                ASSERT_TRUE(disk_.freeze());
                viewer.call(5);
                viewer.call(3);
                eventually([](const ScriptedRobot& robot) { return !robot.heard.stops.empty(); });
                manager.heard();
                EXPECT_TRUE(manager.hears("WATCHDOG=1", 60s));
                // The same during another run, whose recording waits for the disk as well.
                robot_->with([](ScriptedRobot& robot) { robot.heard = {}; });
                drives(viewer);
                viewer.call(3);
                eventually([](const ScriptedRobot& robot) { return !robot.heard.stops.empty(); });
                manager.heard();
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
  EXPECT_EQ(run([&] {
              server::WebClient viewer(page());
              drives_and_records(viewer);
              robot_->with([](ScriptedRobot& robot) { robot.heard = {}; });
              ASSERT_TRUE(disk_.freeze());
              thaw = std::thread([&] {
                eventually([](const ScriptedRobot& robot) { return !robot.heard.disarms.empty(); });
                disk_.thaw();
              });
            }),
            1);
  if (thaw.joinable()) thaw.join();
  EXPECT_GE(replayed_recordings(), 1) << "what happened last is in it";
}

TEST_F(Run, ItsFiguresHoldUpNobodyWhereTheyCannotBeWritten) {
  ASSERT_EQ(::mkfifo(stats_path().c_str(), 0600), 0);
  robot_->plug_in();
  // The first figures are read, so that it begins; whoever writes the next waits in open().
  std::thread first([this] { stats(); });
  std::atomic<bool> over{false};
  std::thread reader;
  EXPECT_EQ(run([&] {
              eventually(commanded);
              std::this_thread::sleep_for(1500ms);
              reader = std::thread([&] {
                eventually([](const ScriptedRobot& robot) { return !robot.heard.disarms.empty(); });
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
  EXPECT_THAT(message_, HasSubstr("use bench, flat or terrain"));
  options_.setup = "bench";
  options_.course = "no-such";
  EXPECT_EQ(run(), -1);
  EXPECT_THAT(message_, HasSubstr("no such course"));
}

}  // namespace
}  // namespace tp100::live
