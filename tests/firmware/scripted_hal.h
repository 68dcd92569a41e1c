#pragma once
// A board whose time, wires and sensors are controlled by the test.

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <limits>
#include <vector>

#include "firmware/hal.h"

namespace tp100::firmware {

inline constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
inline constexpr float kInf = std::numeric_limits<float>::infinity();

class ScriptedHal final : public Hal {
 public:
  struct Duties {
    std::int16_t left = 0;
    std::int16_t right = 0;
    bool operator==(const Duties&) const = default;
  };

  // Inputs that the test sets.
  std::uint32_t now_us = 1'000'000;
  std::size_t room = 200;  // bytes that the UART accepts, refilled by the test
  bool imu_answers = true;
  bool imu_frozen = false;           // answers with the same values again and again
  std::uint32_t i2c_timeout_us = 0;  // duration of a call on a dead bus
  std::int16_t gyro_z = 0;
  std::int16_t accel_x = 0;
  std::int16_t gyro_x = 0;
  std::int16_t gyro_y = 0;
  std::int16_t accel_y = 0;
  std::int16_t temperature = 0;
  std::int32_t left_counts = 0;
  std::int32_t right_counts = 0;
  std::uint16_t missed = 0;
  std::uint8_t waiting = 0;  // bytes that the UART has not sent yet
  std::uint16_t pack_mv = 7900;
  wire::ResetCause cause = wire::ResetCause::kPowerOn;
  std::uint32_t nonce = 0xB007;

  // Output of the firmware.
  std::deque<std::uint8_t> received;
  std::vector<std::uint8_t> sent;
  Duties duties;
  int nonzero_writes = 0;
  int i2c_calls = 0;
  int recoveries = 0;
  int kicks = 0;
  int idles = 0;
  int locks = 0;
  std::size_t most_read_in_a_row = 0;

  std::uint32_t micros() override { return now_us; }

  std::uint8_t uart_read(std::uint8_t* bytes, std::uint8_t most) override {
    std::uint8_t size = 0;
    while (size < most && !received.empty()) {
      const std::uint8_t byte = received.front();
      received.pop_front();
      bytes[size++] = byte;
      if (byte == wire::kDelimiter) break;
    }
    read_in_a_row_ += size;
    most_read_in_a_row = std::max(most_read_in_a_row, read_in_a_row_);
    return size;
  }
  std::uint8_t uart_room() override { return static_cast<std::uint8_t>(room); }
  std::uint8_t uart_waiting() override { return waiting; }
  void uart_write(const std::uint8_t* bytes, std::uint8_t size) override {
    overfilled = overfilled || size > room;
    room -= std::min<std::size_t>(room, size);
    sent.insert(sent.end(), bytes, bytes + size);
  }
  bool overfilled = false;

  bool i2c_write(std::uint8_t address, std::uint8_t reg, std::uint8_t value) override {
    if (!answers(address)) return false;
    registers_[reg & 0x7F] = value;
    return true;
  }
  bool i2c_read(std::uint8_t address, std::uint8_t reg, std::uint8_t* bytes,
                std::uint8_t size) override {
    if (!answers(address)) return false;
    registers_[0x75] = 0x68;
    if (reg == 0x3B && !imu_frozen) measure();
    for (std::uint8_t i = 0; i < size; ++i) bytes[i] = registers_[(reg + i) & 0x7F];
    return true;
  }
  void i2c_recover() override { ++recoveries; }
  std::uint8_t reg(std::uint8_t index) const { return registers_[index]; }

  void counts(std::int32_t& left, std::int32_t& right) override {
    left = left_counts;
    right = right_counts;
  }
  std::uint16_t missed_edges() override { return missed; }
  void motors(std::int16_t left, std::int16_t right) override {
    duties = {left, right};
    if (left != 0 || right != 0) ++nonzero_writes;
  }
  std::uint16_t battery_mv() override { return pack_mv; }

  void kick_watchdog() override {
    ++kicks;
    read_in_a_row_ = 0;
  }
  std::uint32_t boot_nonce() override { return nonce; }
  wire::ResetCause reset_cause() override { return cause; }
  wire::BoardType board() override { return wire::BoardType::kNative; }

  std::uint8_t lock() override { return static_cast<std::uint8_t>(locks++); }
  void unlock(std::uint8_t saved) override { locks = saved; }
  void idle() override { ++idles; }

 private:
  bool answers(std::uint8_t address) {
    ++i2c_calls;
    if (imu_answers && address == 0x68) return true;
    now_us += i2c_timeout_us;
    return false;
  }
  void put(std::size_t reg, std::int16_t value) {
    registers_[reg] = static_cast<std::uint8_t>(static_cast<std::uint16_t>(value) >> 8U);
    registers_[reg + 1] = static_cast<std::uint8_t>(value);
  }
  void measure() {
    ++burst_;
    put(0x3B, static_cast<std::int16_t>(accel_x + burst_ % 7));  // noise
    put(0x3D, accel_y);
    put(0x3F, 8192);
    put(0x41, temperature);
    put(0x43, gyro_x);
    put(0x45, gyro_y);
    put(0x47, gyro_z);
  }

  std::uint8_t registers_[128] = {};
  int burst_ = 0;
  std::size_t read_in_a_row_ = 0;
};

}  // namespace tp100::firmware
