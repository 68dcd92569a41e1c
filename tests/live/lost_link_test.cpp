// `tp100d run` whose robot is unplugged or falls silent.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <string>
#include <thread>
#include <vector>

#include "../server/web_client.h"
#include "../support/weight.h"
#include "run_rig.h"
#include "server/services.h"

namespace tp100::live {
namespace {

using ::testing::HasSubstr;
using namespace std::chrono_literals;

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
  /// Requests a start until the robot moves. A start that comes too early is refused, and a pause
  /// of the machine ends the run.
  bool start(server::WebClient& viewer) {
    const auto off = [](const ScriptedRobot& robot) {
      return robot.state == wire::State::kDisarmed || robot.state == wire::State::kFaulted;
    };
    for (int i = 0; i < 400; ++i) {
      if (i % 20 == 0 && robot_->with(off)) viewer.call(server::Service::kStart);
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

}  // namespace
}  // namespace tp100::live
