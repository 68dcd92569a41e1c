// `tp100d run` whose robot is unplugged or falls silent.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <string>
#include <thread>
#include <vector>

#include "../support/weight.h"
#include "run_rig.h"

namespace tp100::live {
namespace {

using ::testing::HasSubstr;
using namespace std::chrono_literals;

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

  /// Without a request, the robot must stay as it is.
  void expect_rest(int cycle) {
    EXPECT_EQ(arms(), 0U) << "cycle " << cycle << ": it armed without a request";
    EXPECT_GE(state(), wire::State::kDisarmed);
    for (const wire::Command& command : received().commands) {
      ASSERT_EQ(command.speed_mps, 0.0F) << "cycle " << cycle;
      ASSERT_EQ(command.yaw_rate_radps, 0.0F) << "cycle " << cycle;
      ASSERT_EQ(command.desired_yaw_rad, command.yaw_rad) << "cycle " << cycle;
    }
  }
  /// From standstill on, the commanded values grow no faster than the time between commands allows.
  void expect_no_jump(int cycle) {
    const std::vector<wire::Command> all = received().commands;
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
    forget();
    robot_->plug_in();
    ASSERT_TRUE(eventually(commanded)) << "cycle " << number << ": not ready again";
    expect_rest(number);
    ASSERT_TRUE(start(viewer)) << "cycle " << number << ": it does not start again";
    expect_no_jump(number);
    robot_->unplug();
  }
};

TEST_F(Unplugging, AgainAndAgainLeavesNothingBehindAndMovesNothingUnasked) {
  options_.course = "1-straight";
  options_.daemon.stay = true;
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
