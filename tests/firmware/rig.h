#pragma once
// A firmware on a scripted board with a host that follows the protocol and two tracks that follow
// their duties. A loop takes 250 us, and a tick comes every millisecond.

#include <algorithm>
#include <cmath>
#include <vector>

#include "../support/wire_host.h"
#include "firmware/firmware.h"
#include "scripted_hal.h"

namespace tp100::firmware {

inline std::uint16_t mask(wire::Fault fault) {
  return static_cast<std::uint16_t>(wire::fault_bit(fault));
}

class Rig : public test::WireHost {
 public:
  explicit Rig(bool boot_now = true) : WireHost(2, 20, 20) {
    if (boot_now) boot();
  }
  void boot() {
    nonce = hal.nonce;
    program.setup();
  }

  ScriptedHal hal;
  Firmware program{hal};

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

  void send_bytes(const std::vector<std::uint8_t>& bytes) override {
    hal.received.insert(hal.received.end(), bytes.begin(), bytes.end());
  }
  std::uint32_t device_us() const override { return hal.now_us; }
  /// Runs loops and ticks for `ms` milliseconds.
  void run(int ms) override {
    for (int i = 0; i < ms; ++i) {
      if (streams && ++since_command_ >= 5) {
        since_command_ = 0;
        send(command());
      }
      for (int loop = 0; loop < 4; ++loop) {
        hal.room = 200;  // bytes that the UART accepts
        program.loop();
        hal.now_us += 250;
      }
      program.tick_1khz();
      move();
      for (const std::uint8_t byte : hal.sent) receive(byte);
      hal.sent.clear();
    }
  }
  /// The main loop hangs while the timer continues.
  void hang(int ms) {
    for (int i = 0; i < ms; ++i) {
      hal.now_us += 1000;
      program.tick_1khz();
    }
  }
  bool motors_on() const { return hal.duties != ScriptedHal::Duties{}; }
  bool has(wire::Fault fault) const { return (program.faults() & wire::fault_bit(fault)) != 0; }

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
