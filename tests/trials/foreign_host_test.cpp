// Hosts of other makes, which know firmware/PROTOCOL.md alone, start gently or with a step of
// speed: the monitors of the robot itself find an encoder that fails, and stop no healthy drive.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "bridge/cycle.h"
#include "core/arithmetic.h"
#include "sim/robot/emulated_robot.h"
#include "sim/robot/options.h"
#include "support/wire_host.h"

namespace tp100::sim {
namespace {

/// How a host estimates the yaw that it sends.
enum class Steering { kByCounts, kByGyro };

struct Drive {
  std::string_view robot;
  std::string_view fault;  ///< as for --fault; empty: none
  double fault_s = 0.0;    ///< after the first command that asks for motion
  float mps = 0.1F;
  float mps2 = 0.1F;  ///< of the host's ramp; it allows the robot as much
  Steering steering{};
  BoardKind board{};
};

std::string told(const Drive& drive) {
  return std::string(drive.robot) + ", " + std::string(drive.fault) + " after " +
         std::to_string(drive.fault_s) + " s, " + std::to_string(drive.mps) + " m/s, " +
         std::to_string(drive.mps2) + " m/s2, by " +
         (drive.steering == Steering::kByGyro ? "gyro" : "counts") + ", " + to_string(drive.board);
}

constexpr int kRestMs = 500;

/// Drives straight on.
class ForeignHost : public test::WireHost {
 public:
  explicit ForeignHost(const Drive& drive) : WireHost(10, 300, kRestMs), drive_(drive) {
    Options options;
    options.robot = drive.robot;
    const Loaded loaded = load(options);
    parameters = bridge::session_settings(loaded.configuration.parameters).parameters;
    parameters.max_track_mps2 = drive.mps2;
    EmulatedRobotSettings settings{.values = loaded.robot.emulated, .board = drive.board};
    if (!drive.fault.empty()) {
      settings.faults = {parse_fault(drive.fault)};
      settings.faults[0].begin_ns = from_s(drive.fault_s);
    }
    robot_ = std::make_unique<EmulatedRobot>(settings);
    robot_->reset(PowerUp::kPowerOn);
    for (int ms = 0; ms < 3000 && hellos.empty(); ++ms) run(1);
    be_ready();
    EXPECT_EQ(arm().result, static_cast<std::uint8_t>(wire::Result::kAccepted)) << told(drive);
    run(kRestMs);
    yaw_rad = 0.0F;
    start_ = robot_->truth().pose;
  }

  void send_bytes(const std::vector<std::uint8_t>& bytes) override {
    robot_->receive(bytes, robot_->now_ns());
  }
  std::uint32_t device_us() const override {
    if (samples.empty()) return 0;
    return samples.back().device_us +
           static_cast<std::uint32_t>((robot_->now_ns() - sample_ns_) / kNsPerUs) + 1000;
  }
  void run(int ms) override {
    for (const HostNs until_ns = robot_->now_ns() + ms * kNsPerMs; robot_->now_ns() < until_ns;) {
      if (streams && robot_->now_ns() >= next_command_ns_) {
        next_command_ns_ = robot_->now_ns() + 10 * kNsPerMs;
        send(command());
      }
      for (const TimedByte& byte : robot_->advance()) {
        const std::optional<wire::Type> type = receive(byte.value);
        if (type == wire::Type::kHello) nonce = hellos.back().boot_nonce;
        if (type == wire::Type::kSample) take_sample(byte.at_ns);
      }
    }
  }
  /// Drives until the robot reports a fault or for `seconds`; times of faults count from here.
  void drive_for(double seconds) {
    robot_->opened();
    for (int ms = 0; ms < seconds * 1e3 && samples.back().faults == 0; ms += 10) {
      speed_mps = std::min(drive_.mps, speed_mps + drive_.mps2 * 0.01F);
      run(10);
    }
  }

  double turned_rad() const {
    return std::abs(wrap_angle(robot_->truth().pose.yaw_rad - start_.yaw_rad));
  }
  double driven_m() const {
    return magnitude(robot_->truth().pose.x_m - start_.x_m, robot_->truth().pose.y_m - start_.y_m);
  }
  bool motors_on() const {
    return robot_->motor_duty().left != 0.0 || robot_->motor_duty().right != 0.0;
  }

 private:
  void take_sample(HostNs at_ns) {
    sample_ns_ = at_ns;
    if (samples.size() < 2) return;
    const wire::Sample &before = samples[samples.size() - 2], &now = samples.back();
    const float dt_s = static_cast<float>(now.device_us - before.device_us) * 1e-6F;
    if (now.state < static_cast<std::uint8_t>(wire::State::kArmed))
      bias_lsb_ += (static_cast<float>(now.gyro[2]) - bias_lsb_) * 0.1F;
    const float left_m =
        static_cast<float>(now.left_counts - before.left_counts) * (1.0F - parameters.slip_left);
    const float right_m =
        static_cast<float>(now.right_counts - before.right_counts) * (1.0F - parameters.slip_right);
    yaw_rad +=
        drive_.steering == Steering::kByGyro
            ? (static_cast<float>(now.gyro[2]) - bias_lsb_) * parameters.gyro_z_radps_per_lsb * dt_s
            : (right_m - left_m) / parameters.counts_per_metre / parameters.wheelbase_m;
  }

  Drive drive_;
  std::unique_ptr<EmulatedRobot> robot_;
  Pose start_{};
  HostNs sample_ns_ = 0, next_command_ns_ = 0;
  float bias_lsb_ = 0.0F;
};

constexpr std::string_view kDrivenRobots[] = {"end-loaded", "uniform", "worn"};
constexpr float kDrivenMps[] = {0.05F, 0.1F, 0.2F};
constexpr float kStarts[] = {0.1F, 0.6F, 2.0F, 20.0F};

const std::vector<std::string_view> kFailing = {"encoder-lose:0.4:left", "encoder-lose:0.4:right",
                                                "encoder-stuck:left", "encoder-flip:right"};

/// Every failure from every start and at every speed, with the rest in turn; of these every
/// `step`th one.
std::vector<Drive> drives(BoardKind board, const std::vector<std::string_view>& faults,
                          std::size_t step) {
  std::vector<Drive> all;
  std::size_t number = 0;
  for (const std::string_view fault : faults)
    for (const float mps2 : kStarts)
      for (const float mps : kDrivenMps)
        for (const Steering steering : {Steering::kByCounts, Steering::kByGyro}) {
          ++number;
          if (number % step != 0) continue;
          all.push_back({.robot = kDrivenRobots[(number + number / 6) % std::size(kDrivenRobots)],
                         .fault = fault,
                         .fault_s = number / 2 % 2 == 0 ? 0.0 : 2.0,
                         .mps = mps,
                         .mps2 = mps2,
                         .steering = steering,
                         .board = board});
        }
  return all;
}

void expect_found(const std::vector<Drive>& failing) {
  double most_rad = 0.0;
  for (const Drive& drive : failing) {
    ForeignHost host(drive);
    host.drive_for(15.0);
    EXPECT_NE(host.samples.back().faults, 0) << told(drive);
    EXPECT_FALSE(host.motors_on()) << told(drive);
    EXPECT_LT(host.turned_rad() * kDegPerRad, 35.0) << told(drive);
    most_rad = std::max(most_rad, host.turned_rad());
  }
  std::printf("turned by at most %.1f deg\n", most_rad * kDegPerRad);
}

void expect_none(const std::vector<Drive>& healthy) {
  for (const Drive& drive : healthy) {
    ForeignHost host(drive);
    host.drive_for(8.0);
    EXPECT_EQ(host.samples.back().faults, 0) << told(drive);
    EXPECT_GT(host.driven_m(), 0.3) << told(drive);
  }
}

TEST(ForeignHost, AnEncoderThatFailsIsFoundHoweverTheRobotStarts) {
  expect_found(drives(BoardKind::kNative, kFailing, 1));
}

TEST(ForeignHost, AHealthyRobotIsNotStoppedHoweverItStarts) {
  expect_none(drives(BoardKind::kNative, {""}, 1));
}

#ifdef TP100_HAS_IMAGE
TEST(ForeignHost, AnEncoderThatFailsIsFoundOnTheChip) {
  expect_found(drives(BoardKind::kAvr, kFailing, 7));
}

TEST(ForeignHost, AHealthyRobotIsNotStoppedOnTheChip) {
  expect_none(drives(BoardKind::kAvr, {""}, 7));
}
#endif

}  // namespace
}  // namespace tp100::sim
