#pragma once
// The firmware built for this machine, with a Mega's timing: virtual time, a 64-byte receive
// buffer, byte times, blocking I2C bursts and a clock that is off by some ppm. The same inputs give
// the same bytes.

#include <array>
#include <cstdint>
#include <deque>
#include <limits>
#include <optional>
#include <span>
#include <vector>

#include "core/time.h"
#include "firmware/battery.h"
#include "firmware/firmware.h"
#include "firmware/quadrature.h"
#include "sim/board/board.h"
#include "sim/sensors/mpu6050.h"

namespace tp100::sim {

/// One board.
struct NativeBoardSettings {
  std::uint64_t seed = 1;            ///< seed of the boot nonces
  double clock_ppm = 0.0;            ///< error of the resonator; positive runs fast
  std::uint32_t start_us = 0;        ///< device clock at each boot [us]
  HostNs boot_delay_ns = 4'000'000;  ///< from reset to setup(); bytes are lost meanwhile
};

/// Counts since construction.
struct NativeBoardCounters {
  std::uint64_t rx_overruns = 0;  ///< bytes that found the receive buffer full
  std::uint64_t rx_lost_in_boot = 0;
};

class NativeBoard final : public Board, private firmware::Hal {
 public:
  /// `imu` answers at I2C address 0x68; null: no device answers. It must outlive the board. The
  /// board has no power until the first reset().
  NativeBoard(const NativeBoardSettings& settings, I2cSlave* imu);
  NativeBoard(const NativeBoard&) = delete;
  NativeBoard& operator=(const NativeBoard&) = delete;

  void reset(PowerUp cause, HostNs now_ns) override;
  void advance(HostNs until_ns, std::span<const EncoderEdge> edges,
               std::span<const TimedByte> received) override;
  std::vector<TimedByte> take_sent() override;
  MotorDuty motor_duty() const override { return duties_; }
  void set_battery(double volts) override { battery_v_ = volts; }
  void set_supply(double volts) override { supply_v_ = volts; }

  const NativeBoardCounters& counters() const { return counters_; }

 private:
  static constexpr HostNs kNever = std::numeric_limits<std::int64_t>::max();

  /// One encoder and its interrupt: levels survive a reset of the board, counts do not.
  struct EncoderPins {
    std::uint8_t levels = 0;  // bit 0 is A, bit 1 is B
    firmware::Quadrature encoder{};

    void reset();
    void edge(std::uint8_t channel, bool level);
  };

  // The hardware as the firmware sees it.
  std::uint32_t micros() override;
  std::uint8_t uart_read(std::uint8_t* bytes, std::uint8_t most) override;
  std::uint8_t uart_room() override;
  std::uint8_t uart_waiting() override;
  void uart_write(const std::uint8_t* bytes, std::uint8_t size) override;
  bool i2c_write(std::uint8_t address, std::uint8_t reg, std::uint8_t value) override;
  bool i2c_read(std::uint8_t address, std::uint8_t reg, std::uint8_t* bytes,
                std::uint8_t size) override;
  void i2c_recover() override;
  void counts(std::int32_t& left, std::int32_t& right) override;
  std::uint16_t missed_edges() override;
  void motors(std::int16_t left, std::int16_t right) override;
  std::uint16_t battery_mv() override;
  void kick_watchdog() override {}
  std::uint32_t boot_nonce() override { return nonce_; }
  wire::ResetCause reset_cause() override { return cause_; }
  wire::BoardType board() override { return wire::BoardType::kNative; }
  // tick_1khz() never interrupts loop() here.
  std::uint8_t lock() override { return 0; }
  void unlock(std::uint8_t) override {}
  void idle() override {}

  void run_loop();
  void receive(std::uint8_t value);
  /// Time inside loop(): only blocking calls take time.
  HostNs here_ns() const { return now_ns_ + blocked_ns_; }
  bool i2c(bool answered, std::size_t bus_bytes);
  std::uint16_t converted(double volts) const;

  NativeBoardSettings settings_;
  HostNs tick_ns_;  // the timer runs from the same resonator
  I2cSlave* imu_;
  NativeBoardCounters counters_{};
  std::uint64_t boots_ = 0;
  wire::ResetCause cause_ = wire::ResetCause::kUnknown;
  std::uint32_t nonce_ = 1;

  HostNs now_ns_ = 0;
  HostNs boot_ns_ = 0;
  HostNs next_loop_ns_ = kNever;  // no power yet
  HostNs next_tick_ns_ = kNever;
  HostNs blocked_ns_ = 0;
  HostNs transmitter_free_ns_ = 0;

  std::array<EncoderPins, 2> encoders_{};
  std::deque<std::uint8_t> received_;
  std::vector<TimedByte> sent_;
  MotorDuty duties_{};
  double battery_v_ = 0.0;
  double supply_v_ = 5.0;
  firmware::Supply supply_;
  int readings_ = 0;
  std::optional<firmware::Firmware> program_;
};

}  // namespace tp100::sim
