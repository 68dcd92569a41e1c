#pragma once
// A board with the firmware, a host that follows the protocol, a sensor at standstill and two
// tracks that follow their motors.

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "../support/wire_host.h"
#include "course/robot_file.h"
#include "sim/board/board.h"
#include "sim/sensors/mpu6050.h"
#include "sim/sensors/quadrature_encoder.h"

namespace tp100::sim {

class BoardRig : public test::ReceivedFrames {
 public:
  static constexpr std::int64_t kStepNs = 1'000'000;

  explicit BoardRig(std::uint64_t seed);
  BoardRig(const BoardRig&) = delete;
  BoardRig& operator=(const BoardRig&) = delete;
  virtual ~BoardRig();
  virtual Board& hardware() = 0;

  /// Puts the bytes on the wire from now on, one every 20 us.
  void send_bytes(const std::vector<std::uint8_t>& bytes);
  template <class Message>
  void send(const Message& message) {
    send_bytes(test::frame_of(message));
  }
  /// Advances time; a command is sent every 10 ms if `streams`.
  void run(int ms);
  /// Runs until the hello of a boot; false if none arrives within 1.5 s.
  bool boot(PowerUp cause = PowerUp::kPowerOn);

  wire::Parameters parameters() const;
  wire::Command command();
  wire::Arm arm_message();
  /// Begins a session: parameters are accepted and samples arrive.
  void connect();
  wire::Acknowledge arm();
  /// Connects, arms and drives at `speed`.
  void drive(float speed = 0.15f);
  bool moves();
  const wire::Sample& last() const { return samples.back(); }
  wire::State state() const { return static_cast<wire::State>(last().state); }
  /// Schedules a simultaneous change of both phases of an encoder: `channel` 0 left, 2 right.
  void glitch(std::uint8_t channel) { glitches_.push_back(channel); }
  /// Milliseconds until the motors are off; -1 if they are still on after `limit_ms`.
  int ms_until_off(int limit_ms);
  /// Present time of the device clock, extrapolated from the last sample. [us]
  std::uint32_t device_us() const;

  Mpu6050 imu;
  std::int64_t now_ns = 0;

  // The host.
  bool streams = false;
  float speed_mps = 0.0f;
  std::uint16_t sequence = 100;
  std::uint32_t token = 10;
  std::uint32_t nonce = 0;

  // The tracks. If `forced_mps` is not 0, they run at this speed regardless of the motors.
  double forced_mps = 0.0;
  QuadratureEncoder left;
  QuadratureEncoder right;

  double battery_v = 8.0;

  // Data received from the board.
  std::vector<TimedByte> bytes;
  std::vector<std::int64_t> sample_ns;

 private:
  void step();
  void collect();

  std::vector<TimedByte> to_board_;
  std::int64_t wire_free_ns_ = 0;
  std::vector<EncoderEdge> edges_;
  std::array<bool, 4> levels_{};
  std::vector<std::uint8_t> glitches_;
  int since_command_ = 0;
};

}  // namespace tp100::sim
