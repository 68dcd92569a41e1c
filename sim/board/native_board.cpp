#include "sim/board/native_board.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>

#include "core/time.h"
#include "firmware/battery.h"
#include "firmware/firmware.h"
#include "firmware/quadrature.h"
#include "sim/body/seed.h"

namespace tp100::sim {
namespace {

constexpr HostNs kNever = std::numeric_limits<std::int64_t>::max();
constexpr HostNs kLoopNs = 250'000;
constexpr double kTickNs = 1e6;
constexpr HostNs kByteNs = 10'000'000'000LL / wire::kBaud;
constexpr std::size_t kUartBuffer = 64;  // one slot of the ring stays free, as in the Arduino's
// A burst of 14 registers is 17 bytes on the bus and blocks a Mega for 471 us.
constexpr HostNs kI2cByteNs = 471'000 / 17;
constexpr HostNs kI2cRecoverNs = 200'000;
constexpr double kAdcSteps = 1024.0;  // of 10 bits
constexpr int kReadingsBetweenBandgaps = 200;

wire::ResetCause wire_cause(PowerUp cause) {
  switch (cause) {
    case PowerUp::kPowerOn:
      return wire::ResetCause::kPowerOn;
    case PowerUp::kExternal:
      return wire::ResetCause::kExternal;
    case PowerUp::kBrownOut:
      return wire::ResetCause::kBrownOut;
    case PowerUp::kWatchdog:
      return wire::ResetCause::kWatchdog;
  }
  return wire::ResetCause::kUnknown;
}

// The Arduino's receive ring: bytes that find it full are lost.
class ReceiveBuffer {
 public:
  bool push(std::uint8_t byte) {
    if (size_ == kUartBuffer - 1) return false;
    bytes_[(first_ + size_++) % kUartBuffer] = byte;
    return true;
  }
  bool pop(std::uint8_t& byte) {
    if (size_ == 0) return false;
    byte = bytes_[first_];
    first_ = (first_ + 1) % kUartBuffer;
    --size_;
    return true;
  }
  void clear() { size_ = 0; }

 private:
  std::array<std::uint8_t, kUartBuffer> bytes_{};
  std::size_t first_ = 0;
  std::size_t size_ = 0;
};

// One encoder and its interrupt: levels survive a reset of the board, counts do not.
struct EncoderPins {
  std::uint8_t levels = 0;  // bit 0 is A, bit 1 is B
  firmware::Quadrature encoder{};

  void reset() {
    encoder = {};
    encoder.phase = levels;
  }
  void edge(std::uint8_t channel, bool level) {
    const unsigned mask = (channel & 1U) == 0 ? 1 : 2;
    levels = static_cast<std::uint8_t>(level ? levels | mask : levels & ~mask);
  }
  void interrupt() { firmware::take_edge<1>(encoder, levels); }
};

std::size_t side(const EncoderEdge& edge) { return (edge.channel >> 1U) & 1U; }

}  // namespace

struct NativeBoard::Machine final : firmware::Hal {
  Machine(const NativeBoardSettings& board_settings, I2cSlave* imu_slave)
      : settings(board_settings),
        tick_ns(std::llround(kTickNs / (1.0 + board_settings.clock_ppm * 1e-6))),
        imu(imu_slave) {}

  void reset(PowerUp power_up, HostNs at_ns) {
    program.reset();
    cause = wire_cause(power_up);
    ++counters.boots;
    nonce = static_cast<std::uint32_t>(mix(mix(settings.seed) + counters.boots) >> 32U);
    if (nonce == 0) nonce = 1;
    now_ns = at_ns;
    boot_ns = at_ns + settings.boot_delay_ns;
    next_loop_ns = boot_ns;
    next_tick_ns = boot_ns + tick_ns;
    received.clear();
    // Bytes not completely sent never arrive.
    while (!sent.empty() && sent.back().at_ns > at_ns) sent.pop_back();
    transmitter_free_ns = at_ns;
    duties = {};
    for (EncoderPins& pins : encoders) pins.reset();
  }

  void advance(HostNs until_ns, std::span<const EncoderEdge> edges,
               std::span<const TimedByte> bytes) {
    auto edge = edges.begin();
    auto byte = bytes.begin();
    for (;;) {
      const HostNs edge_ns = edge != edges.end() ? edge->at_ns : kNever;
      const HostNs byte_ns = byte != bytes.end() ? byte->at_ns : kNever;
      const HostNs next_ns = std::min({edge_ns, byte_ns, next_tick_ns, next_loop_ns});
      if (next_ns > until_ns) break;
      now_ns = next_ns;
      if (next_ns == edge_ns) {
        EncoderPins& pins = encoders[side(*edge)];
        pins.edge(edge->channel, edge->level);
        const auto before = edge++;
        // Edges at the same instant raise one interrupt, which sees the last level.
        const bool more =
            edge != edges.end() && edge->at_ns == before->at_ns && side(*edge) == side(*before);
        if (!more) pins.interrupt();
      } else if (next_ns == byte_ns) {
        receive(byte->value);
        ++byte;
      } else if (next_ns == next_tick_ns) {
        program->tick_1khz();
        next_tick_ns += tick_ns;
      } else {
        run_loop();
      }
    }
    now_ns = until_ns;
  }

  void run_loop() {
    blocked_ns = 0;
    if (!program) {
      for (EncoderPins& pins : encoders) pins.reset();
      supply = {};
      readings = 0;
      program.emplace(*this);
      program->setup();
      next_tick_ns = now_ns + tick_ns;
    } else {
      program->loop();
      ++counters.loops;
    }
    next_loop_ns = now_ns + kLoopNs + blocked_ns;
    blocked_ns = 0;
  }

  void receive(std::uint8_t value) {
    if (!program) {
      ++counters.rx_lost_in_boot;
    } else if (!received.push(value)) {
      ++counters.rx_overruns;
    }
  }

  std::uint32_t device_us(HostNs at_ns) const {
    const HostNs run_ns = at_ns - boot_ns;
    const auto error_ns =
        static_cast<std::int64_t>(static_cast<double>(run_ns) * settings.clock_ppm * 1e-6);
    return settings.start_us + static_cast<std::uint32_t>((run_ns + error_ns) / 1000);
  }

  // Time inside loop(): only blocking calls take time.
  HostNs here_ns() const { return now_ns + blocked_ns; }

  std::uint32_t micros() override { return device_us(here_ns()); }

  bool uart_read(std::uint8_t& byte) override { return received.pop(byte); }
  std::uint8_t uart_waiting() override {
    const HostNs left_ns = transmitter_free_ns - here_ns();
    return left_ns <= 0 ? std::uint8_t{0}
                        : static_cast<std::uint8_t>((left_ns + kByteNs - 1) / kByteNs);
  }
  std::uint8_t uart_room() override {
    const std::uint8_t waiting = uart_waiting();
    const std::size_t buffered = waiting == 0 ? 0U : waiting - 1U;  // one is in the shift register
    return static_cast<std::uint8_t>(kUartBuffer - 1 - buffered);
  }
  void uart_write(const std::uint8_t* bytes, std::uint8_t size) override {
    transmitter_free_ns = std::max(transmitter_free_ns, here_ns());
    for (std::size_t i = 0; i < size; ++i) {
      transmitter_free_ns += kByteNs;
      sent.push_back({transmitter_free_ns, bytes[i]});
    }
  }

  bool i2c(std::uint8_t address, std::size_t bus_bytes, bool answered) {
    const bool present = imu != nullptr && address == Mpu6050::kAddress;
    blocked_ns += kI2cByteNs * static_cast<std::int64_t>(present && answered ? bus_bytes : 1);
    return present && answered;
  }
  bool i2c_write(std::uint8_t address, std::uint8_t reg, std::uint8_t value) override {
    const std::array<std::uint8_t, 2> bytes = {reg, value};
    const bool good = imu != nullptr && address == Mpu6050::kAddress && imu->write(bytes);
    return i2c(address, 3, good);
  }
  bool i2c_read(std::uint8_t address, std::uint8_t reg, std::uint8_t* bytes,
                std::uint8_t size) override {
    const std::array<std::uint8_t, 1> pointer = {reg};
    const bool good = imu != nullptr && address == Mpu6050::kAddress && imu->write(pointer) &&
                      imu->read(std::span(bytes, size));
    return i2c(address, size + std::size_t{3}, good);
  }
  void i2c_recover() override { blocked_ns += kI2cRecoverNs; }

  void counts(std::int32_t& left, std::int32_t& right) override {
    left = firmware::extended_counts(encoders[0].encoder);
    right = firmware::extended_counts(encoders[1].encoder);
  }
  std::uint16_t missed_edges() override {
    return static_cast<std::uint16_t>(encoders[0].encoder.missed + encoders[1].encoder.missed);
  }
  void motors(std::int16_t left, std::int16_t right) override {
    duties = {static_cast<double>(left) / wire::kFullDuty,
              static_cast<double>(right) / wire::kFullDuty};
  }
  std::uint16_t battery_mv() override {
    if (readings++ % kReadingsBetweenBandgaps == 0)
      supply.update(converted(firmware::kBandgapMv * 1e-3));
    return supply.battery_mv(converted(battery_v / firmware::kDivider));
  }
  std::uint16_t converted(double volts) const {
    const double steps = std::floor(volts / supply_v * kAdcSteps);
    return static_cast<std::uint16_t>(std::clamp(steps, 0.0, kAdcSteps - 1.0));
  }

  void kick_watchdog() override {}
  std::uint32_t boot_nonce() override { return nonce; }
  wire::ResetCause reset_cause() override { return cause; }
  wire::BoardType board() override { return wire::BoardType::kNative; }

  // tick_1khz() never interrupts loop() here.
  std::uint8_t lock() override { return 0; }
  void unlock(std::uint8_t) override {}
  void idle() override {}

  NativeBoardSettings settings;
  HostNs tick_ns;  // the timer runs from the same resonator
  I2cSlave* imu;
  NativeBoardCounters counters{};
  wire::ResetCause cause = wire::ResetCause::kUnknown;
  std::uint32_t nonce = 1;

  HostNs now_ns = 0;
  HostNs boot_ns = 0;
  HostNs next_loop_ns = kNever;  // no power yet
  HostNs next_tick_ns = kNever;
  HostNs blocked_ns = 0;
  HostNs transmitter_free_ns = 0;

  std::array<EncoderPins, 2> encoders{};
  ReceiveBuffer received;
  std::vector<TimedByte> sent;
  MotorDuty duties{};
  double battery_v = 0.0;
  double supply_v = 5.0;
  firmware::Supply supply;
  int readings = 0;
  std::optional<firmware::Firmware> program;
};

NativeBoard::NativeBoard(const NativeBoardSettings& settings, I2cSlave* imu)
    : machine_(std::make_unique<Machine>(settings, imu)) {}
NativeBoard::~NativeBoard() = default;
NativeBoard::NativeBoard(NativeBoard&&) noexcept = default;
NativeBoard& NativeBoard::operator=(NativeBoard&&) noexcept = default;

void NativeBoard::reset(PowerUp cause, HostNs now_ns) { machine_->reset(cause, now_ns); }

void NativeBoard::advance(HostNs until_ns, std::span<const EncoderEdge> edges,
                          std::span<const TimedByte> received) {
  machine_->advance(until_ns, edges, received);
}

std::vector<TimedByte> NativeBoard::take_sent() {
  std::vector<TimedByte>& sent = machine_->sent;
  const auto on_wire = std::find_if(sent.begin(), sent.end(), [&](const TimedByte& byte) {
    return byte.at_ns > machine_->now_ns;
  });
  std::vector<TimedByte> taken(sent.begin(), on_wire);
  sent.erase(sent.begin(), on_wire);
  return taken;
}

MotorDuty NativeBoard::motor_duty() const { return machine_->duties; }

void NativeBoard::set_battery(double volts) { machine_->battery_v = volts; }
void NativeBoard::set_supply(double volts) { machine_->supply_v = volts; }

NativeBoardCounters NativeBoard::counters() const { return machine_->counters; }
std::uint32_t NativeBoard::device_us() const { return machine_->device_us(machine_->now_ns); }

}  // namespace tp100::sim
