#include "sim/board/native_board.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "core/time.h"
#include "sim/body/seed.h"

namespace tp100::sim {
namespace {

constexpr HostNs kLoopNs = 250'000;
constexpr double kTickNs = 1e6;
constexpr HostNs kByteNs = 10'000'000'000LL / wire::kBaud;
constexpr std::size_t kUartBuffer = 64;  // one slot of the ring stays free, as in the Arduino's
// A burst of 14 registers is 17 bytes on the bus and blocks a Mega for 471 us.
constexpr HostNs kI2cByteNs = 471'000 / 17;
constexpr HostNs kI2cRecoverNs = 200'000;
constexpr double kAdcSteps = 1024.0;  // of 10 bits
constexpr int kReadingsBetweenBandgaps = 200;

std::size_t side(const EncoderEdge& edge) { return (edge.channel >> 1U) & 1U; }

}  // namespace

void NativeBoard::EncoderPins::reset() {
  encoder = {};
  encoder.phase = levels;
}

void NativeBoard::EncoderPins::edge(std::uint8_t channel, bool level) {
  const unsigned mask = (channel & 1U) == 0 ? 1 : 2;
  levels = static_cast<std::uint8_t>(level ? levels | mask : levels & ~mask);
}

NativeBoard::NativeBoard(const NativeBoardSettings& settings, I2cSlave* imu)
    : settings_(settings),
      tick_ns_(std::llround(kTickNs / (1.0 + settings.clock_ppm * 1e-6))),
      imu_(imu) {}

void NativeBoard::reset(PowerUp cause, HostNs now_ns) {
  program_.reset();
  cause_ = cause;
  nonce_ = static_cast<std::uint32_t>(mix(mix(settings_.seed) + ++boots_) >> 32U);
  if (nonce_ == 0) nonce_ = 1;
  now_ns_ = now_ns;
  boot_ns_ = now_ns + settings_.boot_delay_ns;
  next_loop_ns_ = boot_ns_;
  next_tick_ns_ = boot_ns_ + tick_ns_;
  received_.clear();
  // Bytes not completely sent never arrive.
  while (!sent_.empty() && sent_.back().at_ns > now_ns) sent_.pop_back();
  transmitter_free_ns_ = now_ns;
  duties_ = {};
  for (EncoderPins& pins : encoders_) pins.reset();
}

void NativeBoard::advance(HostNs until_ns, std::span<const EncoderEdge> edges,
                          std::span<const TimedByte> received) {
  auto edge = edges.begin();
  auto byte = received.begin();
  for (;;) {
    const HostNs edge_ns = edge != edges.end() ? edge->at_ns : kNever;
    const HostNs byte_ns = byte != received.end() ? byte->at_ns : kNever;
    const HostNs next_ns = std::min({edge_ns, byte_ns, next_tick_ns_, next_loop_ns_});
    if (next_ns > until_ns) break;
    now_ns_ = next_ns;
    if (next_ns == edge_ns) {
      EncoderPins& pins = encoders_[side(*edge)];
      pins.edge(edge->channel, edge->level);
      const auto before = edge++;
      // Edges at the same instant raise one interrupt, which sees the last level.
      const bool more =
          edge != edges.end() && edge->at_ns == before->at_ns && side(*edge) == side(*before);
      if (!more) firmware::take_edge<1>(pins.encoder, pins.levels);
    } else if (next_ns == byte_ns) {
      receive(byte->value);
      ++byte;
    } else if (next_ns == next_tick_ns_) {
      program_->tick_1khz();
      next_tick_ns_ += tick_ns_;
    } else {
      run_loop();
    }
  }
  now_ns_ = until_ns;
}

void NativeBoard::run_loop() {
  blocked_ns_ = 0;
  if (!program_) {
    for (EncoderPins& pins : encoders_) pins.reset();
    supply_ = {};
    readings_ = 0;
    program_.emplace(static_cast<Hal&>(*this));
    program_->setup();
    next_tick_ns_ = now_ns_ + tick_ns_;
  } else {
    program_->loop();
  }
  next_loop_ns_ = now_ns_ + kLoopNs + blocked_ns_;
  blocked_ns_ = 0;
}

void NativeBoard::receive(std::uint8_t value) {
  if (!program_) {
    ++counters_.rx_lost_in_boot;
  } else if (received_.size() == kUartBuffer - 1) {
    ++counters_.rx_overruns;
  } else {
    received_.push_back(value);
  }
}

std::vector<TimedByte> NativeBoard::take_sent() {
  const auto on_wire = std::find_if(sent_.begin(), sent_.end(),
                                    [&](const TimedByte& byte) { return byte.at_ns > now_ns_; });
  std::vector<TimedByte> taken(sent_.begin(), on_wire);
  sent_.erase(sent_.begin(), on_wire);
  return taken;
}

std::uint32_t NativeBoard::micros() {
  const HostNs run_ns = here_ns() - boot_ns_;
  const auto error_ns =
      static_cast<std::int64_t>(static_cast<double>(run_ns) * settings_.clock_ppm * 1e-6);
  return settings_.start_us + static_cast<std::uint32_t>((run_ns + error_ns) / 1000);
}

std::uint8_t NativeBoard::uart_read(std::uint8_t* bytes, std::uint8_t most) {
  std::uint8_t size = 0;
  while (size < most && !received_.empty()) {
    const std::uint8_t byte = received_.front();
    received_.pop_front();
    bytes[size++] = byte;
    if (byte == wire::kDelimiter) break;
  }
  return size;
}

std::uint8_t NativeBoard::uart_waiting() {
  const HostNs left_ns = transmitter_free_ns_ - here_ns();
  return left_ns <= 0 ? std::uint8_t{0}
                      : static_cast<std::uint8_t>((left_ns + kByteNs - 1) / kByteNs);
}

std::uint8_t NativeBoard::uart_room() {
  const std::uint8_t waiting = uart_waiting();
  const std::size_t buffered = waiting == 0 ? 0U : waiting - 1U;  // one is in the shift register
  return static_cast<std::uint8_t>(kUartBuffer - 1 - buffered);
}

void NativeBoard::uart_write(const std::uint8_t* bytes, std::uint8_t size) {
  transmitter_free_ns_ = std::max(transmitter_free_ns_, here_ns());
  for (std::size_t i = 0; i < size; ++i) {
    transmitter_free_ns_ += kByteNs;
    sent_.push_back({transmitter_free_ns_, bytes[i]});
  }
}

bool NativeBoard::i2c(bool answered, std::size_t bus_bytes) {
  blocked_ns_ += kI2cByteNs * static_cast<std::int64_t>(answered ? bus_bytes : 1);
  return answered;
}

bool NativeBoard::i2c_write(std::uint8_t address, std::uint8_t reg, std::uint8_t value) {
  const std::array<std::uint8_t, 2> bytes = {reg, value};
  return i2c(imu_ != nullptr && address == Mpu6050::kAddress && imu_->write(bytes), 3);
}

bool NativeBoard::i2c_read(std::uint8_t address, std::uint8_t reg, std::uint8_t* bytes,
                           std::uint8_t size) {
  const std::array<std::uint8_t, 1> pointer = {reg};
  const bool good = imu_ != nullptr && address == Mpu6050::kAddress && imu_->write(pointer) &&
                    imu_->read(std::span(bytes, size));
  return i2c(good, size + std::size_t{3});
}

void NativeBoard::i2c_recover() { blocked_ns_ += kI2cRecoverNs; }

void NativeBoard::counts(std::int32_t& left, std::int32_t& right) {
  left = firmware::extended_counts(encoders_[0].encoder);
  right = firmware::extended_counts(encoders_[1].encoder);
}

std::uint16_t NativeBoard::missed_edges() {
  return static_cast<std::uint16_t>(encoders_[0].encoder.missed + encoders_[1].encoder.missed);
}

void NativeBoard::motors(std::int16_t left, std::int16_t right) {
  duties_ = {static_cast<double>(left) / wire::kFullDuty,
             static_cast<double>(right) / wire::kFullDuty};
}

std::uint16_t NativeBoard::battery_mv() {
  if (readings_++ % kReadingsBetweenBandgaps == 0)
    supply_.update(converted(firmware::kBandgapMv * 1e-3));
  return supply_.battery_mv(converted(battery_v_ / firmware::kDivider));
}

std::uint16_t NativeBoard::converted(double volts) const {
  const double steps = std::floor(volts / supply_v_ * kAdcSteps);
  return static_cast<std::uint16_t>(std::clamp(steps, 0.0, kAdcSteps - 1.0));
}

}  // namespace tp100::sim
