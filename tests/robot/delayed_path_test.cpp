// Driving an emulated robot by hand, in lockstep, over a path that delays.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <deque>
#include <functional>
#include <random>
#include <string>

#include "hand_driven.h"

namespace tp100::sim {
namespace {

constexpr std::uint32_t kViewer = 1;

/// Delays of a path, each way; the one to the daemon grows from `grows_after` on, until `longest`.
struct Path {
  HostNs up_ns = 0, down_ns = 0;
  HostNs grows_after_ns = 0;  ///< since the client has the token
  double growth = 0.0;        ///< seconds a second
  HostNs longest_ns = 0;

  HostNs up(HostNs since_token_ns) const {
    const HostNs growing_ns = std::max<HostNs>(0, since_token_ns - grows_after_ns);
    return std::min(up_ns + static_cast<HostNs>(growth * static_cast<double>(growing_ns)),
                    std::max(up_ns, longest_ns));
  }
};

/// A person who holds a key from the token on for a while, and then releases it.
struct Drive {
  std::string refused{};      ///< the daemon's reason
  double moved_after_ms = 0;  ///< the last command to move came so long after the release
  bool moved = false;
  double stutter_ms = 0;  ///< commanded to stand between two commands to move
};

Drive drive_over(const Path& path, HostNs held_ns, HostNs period_ns, HandDriven& robot) {
  // Whatever is under way arrives.
  const HostNs watch_ns = std::max(path.up_ns, path.longest_ns) + kNsPerS / 2;
  std::deque<std::pair<HostNs, std::function<void()>>> to_daemon;
  std::string token;
  HostNs has_token_ns = 0, next_ns = 0;
  Drive out;
  const auto send = [&](HostNs arrives_ns, std::function<void()> call) {
    // The path keeps the order, as TCP does.
    if (!to_daemon.empty()) arrives_ns = std::max(arrives_ns, to_daemon.back().first);
    to_daemon.emplace_back(arrives_ns, std::move(call));
  };
  send(robot.now() + path.up_ns, [&] {
    const nlohmann::json answer = robot.call(kViewer, "drive_take");
    token = answer.value("token", "");
    has_token_ns = next_ns = robot.now() + path.down_ns;
  });
  robot.before_step = [&](HostNs now) {
    while (!to_daemon.empty() && to_daemon.front().first <= now) {
      to_daemon.front().second();
      to_daemon.pop_front();
    }
    if (token.empty() || now < next_ns) return;
    next_ns += period_ns;
    const bool held = now - has_token_ns < held_ns;
    send(now + path.up(now - has_token_ns),
         [&robot, &out, token, held, input_ms = to_s(now) * 1e3] {
           const nlohmann::json answer = robot.call(kViewer, "drive",
                                                    {{"token", token},
                                                     {"speed_mps", held ? 0.15 : 0.0},
                                                     {"yaw_rate_radps", held ? 0.3 : 0.0},
                                                     {"input_ms", input_ms}});
           if (out.refused.empty()) out.refused = answer.value("refused", "");
         });
  };
  HostNs moved_ns = 0;
  robot.after_step = [&](const StepRecord& record) {
    const Command& command = record.snapshot.command;
    if (!record.command_valid || (command.speed_mps == 0.0 && command.yaw_rate_radps == 0.0))
      return;
    if (out.moved) out.stutter_ms += to_s(record.now_ns - moved_ns - HandDriven::kPeriodNs) * 1e3;
    moved_ns = record.now_ns;
    out.moved = true;
  };
  robot.step_until([&] { return !token.empty() && robot.now() > has_token_ns; }, 10.0);
  robot.step_for(to_s(held_ns + watch_ns));
  robot.before_step = {};
  robot.after_step = {};
  robot.request(OperatorRequest::kHold);
  robot.step_until([&] { return !under_way(robot.state()); }, 1.0);
  if (out.moved) out.moved_after_ms = to_s(moved_ns - has_token_ns - held_ns) * 1e3;
  return out;
}

class DelayedPath : public ::testing::Test {
 protected:
  HostNs between(HostNs low, HostNs high) {
    return std::uniform_int_distribution<HostNs>(low, high)(random_);
  }
  Drive drive_over(const Path& path, HostNs held_ns, HostNs period_ns) {
    EXPECT_TRUE(robot_.wait_until_ready());
    robot_.step_for(to_s(between(0, 100 * kNsPerMs)));
    return sim::drive_over(path, held_ns, period_ns, robot_);
  }

  std::mt19937_64 random_{1};
  HandDriven robot_{{.loaded = load({})}};
};

// The robot would drive on for more than a second after the person has let go, and a metre with it.
TEST_F(DelayedPath, ADelayThatIsThereFromTheStartIsRefused) {
  for (const HostNs delay_ns : {300 * kNsPerMs, 400 * kNsPerMs, 1200 * kNsPerMs, 3 * kNsPerS}) {
    for (const double share_up : {0.0, 0.5, 1.0}) {
      const auto up_ns = static_cast<HostNs>(share_up * static_cast<double>(delay_ns));
      const Drive drive = drive_over({.up_ns = up_ns, .down_ns = delay_ns - up_ns},
                                     between(0, 2 * kNsPerS), 40 * kNsPerMs);
      // After 2 s without an input it is disarmed anyhow.
      EXPECT_THAT(drive.refused, ::testing::AnyOf(::testing::HasSubstr("less than 0.3 s"),
                                                  ::testing::HasSubstr("does not hold")));
      EXPECT_FALSE(drive.moved) << to_s(delay_ns) << " s, share to the daemon " << share_up;
      EXPECT_FALSE(under_way(robot_.state()));
    }
  }
}

// The same when a modem's queue fills up only while the robot drives.
TEST_F(DelayedPath, TheRobotIsToldToStopSoonAfterTheKeyIsReleased) {
  int moved = 0;
  for (int trial = 0; trial < 200; ++trial) {
    const HostNs round_trip_ns = between(0, 350 * kNsPerMs);
    Path path{.up_ns = between(0, round_trip_ns)};
    path.down_ns = round_trip_ns - path.up_ns;
    if (trial % 4 != 0) {
      constexpr std::array<HostNs, 3> kLongest = {400 * kNsPerMs, 1200 * kNsPerMs, 3 * kNsPerS};
      path.longest_ns = kLongest.at(static_cast<std::size_t>(trial % 3));
      path.growth =
          std::exp(std::uniform_real_distribution<>(std::log(0.03), std::log(20.0))(random_));
      path.grows_after_ns = between(0, kNsPerS);
    }
    const Drive drive =
        drive_over(path, between(0, 3 * kNsPerS), between(20 * kNsPerMs, 50 * kNsPerMs));
    moved += drive.moved ? 1 : 0;
    // A step later at most; a delay's growth of 1 ms a second is not seen.
    EXPECT_LE(drive.moved_after_ms, 300.0 + 5.0 + 4.0)
        << "trial " << trial << ": " << to_s(path.up_ns) << " and " << to_s(path.down_ns)
        << " s, growing by " << path.growth << " from " << to_s(path.grows_after_ns) << " to "
        << to_s(path.longest_ns);
  }
  EXPECT_GT(moved, 100) << "the robot must really be driven";
}

// Somebody in the next building, over a wireless network or a relay.
TEST_F(DelayedPath, APathOfAQuarterOfASecondDrivesWithoutStutter) {
  for (HostNs round_trip_ns = 0; round_trip_ns <= 250 * kNsPerMs; round_trip_ns += 50 * kNsPerMs) {
    for (const double share_up : {0.0, 0.5, 1.0}) {
      const auto up_ns = static_cast<HostNs>(share_up * static_cast<double>(round_trip_ns));
      const Drive drive =
          drive_over({.up_ns = up_ns, .down_ns = round_trip_ns - up_ns}, kNsPerS, 50 * kNsPerMs);
      EXPECT_EQ(drive.refused, "");
      EXPECT_TRUE(drive.moved);
      EXPECT_NEAR(drive.stutter_ms, 0.0, 1e-6)
          << to_s(round_trip_ns) << " s, share to the daemon " << share_up;
    }
  }
}

}  // namespace
}  // namespace tp100::sim
