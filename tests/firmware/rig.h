#pragma once
// A firmware on a scripted board with a host that follows the protocol and two tracks that follow
// their duties. A loop takes 250 us, and a tick comes every millisecond.

#include <algorithm>
#include <cmath>
#include <functional>
#include <string>
#include <vector>

#include "../support/wire_host.h"
#include "firmware/firmware.h"
#include "scripted_hal.h"

namespace tp100::firmware {

class Rig : public test::ReceivedFrames {
 public:
  explicit Rig(bool boot_now = true) {
    if (boot_now) boot();
  }
  void boot() { program.setup(); }

  ScriptedHal hal;
  Firmware program{hal};

  // The host.
  wire::Parameters parameters = test::good_parameters();
  bool streams = false;  // a command every 5 ms
  float speed_mps = 0.0f;
  float yaw_rate_radps = 0.0f;
  float yaw_rad = 0.0f;  // as the host estimates it
  float desired_yaw_rad = 0.0f;
  std::uint16_t sequence = 100;
  float bias_radps = 0.0f;
  std::uint32_t token = 10;
  std::size_t room = 200;  ///< bytes that the UART accepts per loop

  // The body.
  bool tracks_follow = false;
  bool left_blocked = false;
  bool right_blocked = false;
  double load_duty = 0.0;   ///< duty that each track loses to resistance
  double scrub_duty = 0.0;  ///< duty that a left turn takes from the right track, gives the left
  double disturbance_radps = 0.0;  ///< rotation that the tracks do not cause
  double jumped_m = 0.0;           // distance that the left encoder has counted by a jump
  double left_counted = 1.0;       ///< share of the edges that the left encoder counts
  double right_counted = 1.0;
  double left_mps = 0.0;
  double right_mps = 0.0;
  double true_yaw_rad = 0.0;
  double true_m = 0.0;  ///< distance of the middle

  template <class Message>
  void send(const Message& message) {
    const auto frame = test::frame_of(message);
    hal.received.insert(hal.received.end(), frame.begin(), frame.end());
  }

  void tick() { program.tick_1khz(); }
  /// Runs loops and ticks for `ms` milliseconds.
  void run(int ms) {
    for (int i = 0; i < ms; ++i) {
      if (streams && ++since_command_ >= 5) {
        since_command_ = 0;
        send(command());
      }
      for (int loop = 0; loop < 4; ++loop) {
        hal.room = room;
        program.loop();
        hal.now_us += 250;
      }
      tick();
      move();
      collect();
    }
  }
  /// The main loop hangs while the timer continues.
  void hang(int ms) {
    for (int i = 0; i < ms; ++i) {
      hal.now_us += 1000;
      tick();
    }
  }

  wire::Command command() {
    wire::Command c{};
    c.boot_nonce = hal.nonce;
    c.sequence = ++sequence;
    c.answers = samples.empty() ? std::uint16_t{0} : samples.back().sequence;
    c.yaw_rad = yaw_rad;
    c.desired_yaw_rad = desired_yaw_rad;
    c.yaw_rate_radps = yaw_rate_radps;
    c.speed_mps = speed_mps;
    c.gyro_bias_radps = bias_radps;
    c.expiry_us = hal.now_us + 195'000;
    return c;
  }
  wire::Arm arm_message() { return {hal.nonce, ++token, hal.now_us + 200'000}; }

  /// Begins a session: parameters are accepted and samples arrive.
  void connect() {
    send(wire::HelloRequest{wire::kProtocolVersion, wire::kSchemaHash});
    run(2);
    parameters.boot_nonce = hal.nonce;
    parameters.token = ++token;
    send(parameters);
    run(20);
  }
  wire::Acknowledge arm() {
    send(arm_message());
    run(2);
    return acknowledges.empty() ? wire::Acknowledge{} : acknowledges.back();
  }
  /// Connects, streams commands and arms; the commands request `speed`.
  void drive(float speed = 0.1f) {
    connect();
    streams = true;
    run(20);
    arm();
    speed_mps = speed;
    run(20);
  }
  bool motors_on() const { return hal.duties != ScriptedHal::Duties{}; }
  bool has(wire::Fault fault) const { return (program.faults() & wire::fault_bit(fault)) != 0; }
  int count_logs(const std::string& start) const {
    return static_cast<int>(std::count_if(logs.begin(), logs.end(), [&](const std::string& line) {
      return line.starts_with(start);
    }));
  }

  /// Adds foreign bytes to what the host receives.
  void overhear(const std::string& text) {
    for (const char byte : text) receive(static_cast<std::uint8_t>(byte));
  }
  void collect() {
    for (const std::uint8_t byte : hal.sent) receive(byte);
    hal.sent.clear();
  }

 private:
  static double follow(double mps, std::int16_t duty, double load) {
    const double size = std::abs(duty) / 1000.0 - load;
    const double wanted = std::copysign(std::max(0.0, size - 0.13) / 4.3, duty);
    return mps + (wanted - mps) * (1.0 / 80.0);
  }
  void move() {
    if (!tracks_follow) return;
    left_mps = left_blocked ? 0.0 : follow(left_mps, hal.duties.left, load_duty - scrub_duty);
    right_mps = right_blocked ? 0.0 : follow(right_mps, hal.duties.right, load_duty + scrub_duty);
    left_m_ += left_mps * 1e-3 * left_counted;
    right_m_ += right_mps * 1e-3 * right_counted;
    true_m += (left_mps * 0.84 + right_mps * 0.90) / 2.0 * 1e-3;
    hal.left_counts = static_cast<std::int32_t>(std::floor((left_m_ + jumped_m) * 11140.0));
    hal.right_counts = static_cast<std::int32_t>(std::floor(right_m_ * 11140.0));
    const double rate = (right_mps * 0.90 - left_mps * 0.84) / 0.274 + disturbance_radps;
    true_yaw_rad += rate * 1e-3;
    hal.gyro_z =
        static_cast<std::int16_t>(std::lround(rate / static_cast<double>(test::kGyroRadpsPerLsb)));
  }

  int since_command_ = 0;
  double left_m_ = 0.0;
  double right_m_ = 0.0;
};

}  // namespace tp100::firmware
