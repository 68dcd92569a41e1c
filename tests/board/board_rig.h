#pragma once
// A board with the firmware, a host that follows the protocol, a sensor at standstill and two
// tracks that follow their motors.

#include <array>
#include <cstdint>
#include <utility>
#include <vector>

#include "../support/wire_host.h"
#include "sim/board/avr_board.h"
#include "sim/board/native_board.h"
#include "sim/sensors/mpu6050.h"
#include "sim/sensors/quadrature_encoder.h"

namespace tp100::sim {

/// Times and values of bytes, for comparison.
inline auto pairs(const std::vector<TimedByte>& bytes) {
  std::vector<std::pair<std::int64_t, std::uint8_t>> all;
  for (const TimedByte& byte : bytes) all.emplace_back(byte.at_ns, byte.value);
  return all;
}

class BoardRig : public test::WireHost {
 public:
  static constexpr std::int64_t kStepNs = 1'000'000;
  static constexpr std::int64_t kByteNs = 20'000;  ///< of the wire

  explicit BoardRig(std::uint64_t seed);
  virtual Board& hardware() = 0;
  /// Bytes that found the receiver full.
  virtual std::uint64_t overruns() const = 0;

  /// Puts the bytes on the wire from now on.
  void send_bytes(const std::vector<std::uint8_t>& bytes) override;
  /// Advances time; a command is sent every 10 ms if `streams`.
  void run(int ms) override;
  /// Extrapolated from the last sample.
  std::uint32_t device_us() const override;
  /// Runs until the hello of a boot; false if none arrives within 1.5 s.
  bool boot(PowerUp cause = PowerUp::kPowerOn);

  bool moves();
  const wire::Sample& last() const { return samples.back(); }
  wire::State state() const { return static_cast<wire::State>(last().state); }
  /// Schedules a simultaneous change of both phases of an encoder: `channel` 0 left, 2 right.
  void glitch(std::uint8_t channel) { glitches_.push_back(channel); }
  /// Milliseconds until the motors are off; -1 if they are still on after `limit_ms`.
  int ms_until_off(int limit_ms);

  Mpu6050 imu;
  std::int64_t now_ns = 0;
  double battery_v = 8.0;
  // The tracks. If `forced_mps` is not 0, they run at this speed regardless of the motors.
  double forced_mps = 0.0;
  QuadratureEncoder left;
  QuadratureEncoder right;

  // Data received from the board.
  std::vector<TimedByte> bytes;
  std::vector<std::int64_t> sample_ns;

 private:
  void step();

  std::vector<TimedByte> to_board_;
  std::int64_t wire_free_ns_ = 0;
  std::vector<EncoderEdge> edges_;
  std::array<bool, 4> levels_{};
  std::vector<std::uint8_t> glitches_;
  int since_command_ = 0;
};

/// A rig with a `Hardware`, which has `Settings`.
template <class Hardware, class Settings>
class RigWith final : public BoardRig {
 public:
  explicit RigWith(const Settings& settings = {})
      : BoardRig(settings.seed), board(settings, &imu) {}
  Board& hardware() override { return board; }
  std::uint64_t overruns() const override { return board.counters().rx_overruns; }

  Hardware board;
};
/// The firmware image on an emulated Mega, and the firmware built for this machine.
using AvrRig = RigWith<AvrBoard, AvrBoardSettings>;
using NativeRig = RigWith<NativeBoard, NativeBoardSettings>;

}  // namespace tp100::sim
