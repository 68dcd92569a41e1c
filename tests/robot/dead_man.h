#pragma once
// Trials of each way to lose the driver, and the time until the robot is commanded to stop.

#include <cmath>
#include <random>
#include <string>
#include <vector>

#include "hand_driven.h"

namespace tp100::sim {

/// Ways to lose the driver. A process that is killed closes its socket like any other.
enum class Loss {
  kSocketClosed,  ///< or the writer is gone
  kSilence,       ///< messages end: cable cut, page hung, tab suspended
  kFrozenInput,   ///< messages continue, but the person's input does not change
  kDelayed,       ///< messages arrive a second late, all at once
  kTakenOver,     ///< another viewer takes the lease as soon as it gets it
  kReleased,
  kZeroInput,  ///< sent by a page that is hidden or loses the focus
  kStopped,    ///< another viewer presses STOP
};
inline constexpr std::array<std::pair<Loss, const char*>, 8> kLosses = {{
    {Loss::kSocketClosed, "socket closed"},
    {Loss::kSilence, "silence"},
    {Loss::kFrozenInput, "frozen input"},
    {Loss::kDelayed, "messages delayed by a second"},
    {Loss::kTakenOver, "taken over"},
    {Loss::kReleased, "released"},
    {Loss::kZeroInput, "page hidden"},
    {Loss::kStopped, "stopped by another viewer"},
}};

/// Whether the daemon is notified of the loss; else it detects it by the age of the input.
inline bool is_heard(Loss loss) {
  return loss == Loss::kSocketClosed || loss == Loss::kReleased || loss == Loss::kZeroInput ||
         loss == Loss::kStopped;
}

/// How a driver reaches the daemon.
enum class Client { kViewer, kRos2, kRos2Stamped };
inline constexpr std::array<std::pair<Client, const char*>, 3> kClients = {{
    {Client::kViewer, "viewer"},
    {Client::kRos2, "Twist"},
    {Client::kRos2Stamped, "TwistStamped"},
}};

/// Times since the last fresh input of the driver, in virtual time.
struct LossTimes {
  std::vector<double> command_ms;   ///< a command of standstill is sent, and no other follows
  std::vector<double> duty_ms;      ///< both motors have too little duty to move a track
  std::vector<double> standing_ms;  ///< the robot stands
  std::string wrong;                ///< what else went wrong; empty: nothing
};

inline bool asks_for_standstill(const StepRecord& record) {
  const Command& command = record.snapshot.command;
  return record.command_valid && command.speed_mps == 0.0 && command.yaw_rate_radps == 0.0 &&
         command.desired_yaw_rad == command.pose.yaw_rad;
}

inline LossTimes lose_driver(Loss loss, int trials, std::uint64_t seed,
                             Client client = Client::kViewer) {
  constexpr double kWatchS = 1.2;
  constexpr std::uint32_t kDriver = 1, kOther = 2;
  std::mt19937_64 random(seed);
  const auto between = [&](double low, double high) {
    return std::uniform_real_distribution<>(low, high)(random);
  };
  LossTimes out;
  HandDriven drive({.loaded = load({}), .seed = seed});
  const auto fail = [&](int trial, const std::string& what) {
    if (out.wrong.empty()) out.wrong = "trial " + std::to_string(trial) + ": " + what;
  };
  for (int trial = 0; trial < trials; ++trial) {
    if (!drive.wait_until_ready()) {
      fail(trial, "the robot never became ready");
      break;
    }
    const bool ros2 = client != Client::kViewer;
    const std::string token = ros2 ? drive.take_by_ros2() : drive.take(kDriver);
    if (drive.state() != RunState::kDriving) {
      fail(trial, "the robot never was driven: " + token);
      break;
    }
    const double speed_mps = between(0.05, 0.2) * (random() % 2 == 0 ? 1.0 : -1.0);
    const double rate_radps = between(-1.0, 1.0);
    const HostNs period_ns = static_cast<HostNs>(1 + random() % 8) * HandDriven::kPeriodNs;
    HostNs last_input_ns = 0, next_ns = 0;
    // Gives an input; true if the client learns that it was refused.
    const auto give = [&](double speed, double rate, double age_s = 0.0) {
      if (!ros2) return drive.drive(kDriver, token, speed, rate, age_s).contains("refused");
      drive.receive_velocity(speed, rate, age_s, 1, client == Client::kRos2Stamped);
      return drive.controls().driver(drive.now()).by != "ROS 2 /cmd_vel";
    };
    const auto send = [&] {
      if (drive.now() < next_ns) return;
      next_ns = drive.now() + period_ns;
      last_input_ns = drive.now();
      give(speed_mps, rate_radps);
    };
    drive.before_step = [&](HostNs) { send(); };
    drive.step_for(between(0.6, 1.2));
    if (asks_for_standstill(drive.record())) fail(trial, "the robot was not driven");

    // From here on the driver is lost.
    next_ns = 0;
    bool lost = false;
    drive.before_step = [&](HostNs now) {
      const bool first = !std::exchange(lost, true);
      switch (loss) {
        case Loss::kSocketClosed:
          if (first && !ros2) drive.disconnect(kDriver);
          if (first && ros2)
            drive.writers_gone(client == Client::kRos2Stamped ? ros2::Input::kVelocityStamped
                                                              : ros2::Input::kVelocity);
          break;
        case Loss::kSilence:
          break;
        case Loss::kFrozenInput:
          if (now >= next_ns) {
            next_ns = now + period_ns;
            give(speed_mps, rate_radps, to_s(now - last_input_ns));
          }
          break;
        case Loss::kDelayed:
          if (now - last_input_ns >= kNsPerS && next_ns == 0) {
            next_ns = now;
            for (HostNs age_ns = 990 * kNsPerMs; age_ns > kFreshInputNs; age_ns -= period_ns)
              give(speed_mps, rate_radps, to_s(age_ns));
          }
          break;
        case Loss::kTakenOver:
          if (next_ns == 0 && drive.call(kOther, "drive_take").contains("token")) next_ns = now;
          if (next_ns != 0 && !give(speed_mps, rate_radps)) fail(trial, "two drivers at once");
          break;
        case Loss::kReleased:
          if (first && ros2) drive.receive_drive(false);
          if (first && !ros2) drive.call(kDriver, "drive_release", {{"token", token}});
          break;
        case Loss::kZeroInput:
          if (first) give(0.0, 0.0);
          break;
        case Loss::kStopped:
          if (first) drive.call(kOther, "stop");
      }
    };
    double command_ms = -1.0, duty_ms = -1.0, standing_ms = -1.0;
    drive.after_physics = [&] {
      const double since_ms = to_s(drive.now() - last_input_ns) * 1e3;
      const MotorDuty duty = drive.robot().motor_duty();
      const bool off = std::abs(duty.left) < 0.15 && std::abs(duty.right) < 0.15;
      if (!off) duty_ms = -1.0;
      if (off && duty_ms < 0.0) duty_ms = since_ms;
      const auto& velocity_mps = drive.robot().truth().velocity_mps;
      const bool stands = std::hypot(velocity_mps[0], velocity_mps[1]) < 0.002;
      if (!stands) standing_ms = -1.0;
      if (stands && standing_ms < 0.0) standing_ms = since_ms;
    };
    drive.after_step = [&](const StepRecord& record) {
      const bool zero = asks_for_standstill(record);
      if (!zero) command_ms = -1.0;
      if (zero && command_ms < 0.0) command_ms = to_s(drive.now() - last_input_ns) * 1e3;
    };
    drive.step_for(kWatchS);
    drive.after_step = {};
    drive.after_physics = {};
    drive.before_step = {};
    if (command_ms < 0.0) fail(trial, "the robot was never told to stop");
    out.command_ms.push_back(command_ms);
    out.duty_ms.push_back(duty_ms);
    out.standing_ms.push_back(standing_ms);
    drive.request(OperatorRequest::kHold);
    drive.step_until([&] { return !under_way(drive.state()); }, 1.0);
    drive.step_for(0.5);
  }
  return out;
}

}  // namespace tp100::sim
