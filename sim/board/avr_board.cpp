#include "sim/board/avr_board.h"

#include <avr_eeprom.h>
#include <sim_avr.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>

#include "core/error.h"
#include "core/time.h"
#include "sim/body/seed.h"

namespace tp100::sim {
namespace {

constexpr std::uint32_t kBootloaderAddress = 0x3E000;
constexpr std::uint16_t kSramBegin = 0x200;
constexpr std::uint16_t kTimsk0 = 0x6E;
constexpr std::uint32_t kTimerOverflowUs = 1024;  // timer 0: prescaler 64, 256 steps

/// The bit of MCUSR: PORF, EXTRF, BORF, WDRF.
std::uint8_t mcusr(PowerUp cause) {
  return static_cast<std::uint8_t>((1U << static_cast<unsigned>(cause)) >> 1U);
}

}  // namespace

AvrBoard::AvrBoard(const AvrBoardSettings& settings, I2cSlave* imu)
    : settings_(settings),
      image_(settings.blank
                 ? AvrImage{}
                 : read_avr_image(settings.image.empty() ? built_firmware() : settings.image)),
      core_(image_),
      uart_(core_),
      encoders_(core_),
      i2c_(core_, imu, Mpu6050::kAddress),
      adc_(core_, mix(settings.seed ^ 0xADCU)),
      cycles_per_ns_(AvrCore::kHz * 1e-9 * (1.0 + settings.clock_ppm * 1e-6)) {
  if (settings_.bootloader) {
    core_.program(read_avr_image(stock_bootloader()));
    core_.set_reset_address(kBootloaderAddress);
  }
  core_.on_event = [this](CpuCycles at) { return deliver(at); };
  core_.on_reset = [this] { restore(); };
  fill_eeprom();
  if (settings_.start_us != 0) preset_clock();
}

// A boot counter that other robots do not share.
void AvrBoard::fill_eeprom() {
  std::array<std::uint8_t, 4> counter{};
  const std::uint64_t value = mix(settings_.seed) >> 40U;
  for (std::size_t i = 0; i < counter.size(); ++i) {
    counter[i] = static_cast<std::uint8_t>(value >> (8U * i));
  }
  avr_eeprom_desc_t description{counter.data(), 0, static_cast<std::uint32_t>(counter.size())};
  avr_ioctl(core_.chip(), AVR_IOCTL_EEPROM_SET, &description);
}

// The Arduino core's overflow count, as soon as it starts the timer behind micros().
void AvrBoard::preset_clock() {
  const auto symbol = image_.symbols.find("timer0_overflow_count");
  if (symbol == image_.symbols.end()) {
    throw UserError(image_.path + ": no symbol timer0_overflow_count; give an ELF file");
  }
  overflow_count_ = static_cast<std::uint16_t>(symbol->second & 0xFFFFU);
  avr_irq_register_notify(
      avr_iomem_getirq(core_.chip(), kTimsk0, nullptr, AVR_IOMEM_IRQ_ALL),
      [](avr_irq_t*, std::uint32_t, void* self) { static_cast<AvrBoard*>(self)->set_clock(); },
      this);
}

void AvrBoard::set_clock() {
  if (clock_is_set_) return;
  clock_is_set_ = true;
  const std::uint32_t overflows = settings_.start_us / kTimerOverflowUs;
  for (unsigned i = 0; i < 4; ++i) {
    core_.data()[overflow_count_ + i] = static_cast<std::uint8_t>(overflows >> (8U * i));
  }
}

void AvrBoard::reset(PowerUp cause, HostNs now_ns) {
  stamp(now_ns);
  powered_ = true;
  now_ns_ = now_ns;
  begin_ns_ = now_ns + settings_.reset_hold_ns;
  if (cause == PowerUp::kPowerOn || cause == PowerUp::kBrownOut) scramble();
  core_.reset(mcusr(cause));
  begin_cycle_ = core_.cycle();
}

// Contents of the SRAM at power-on.
void AvrBoard::scramble() {
  std::uint64_t random = mix(settings_.seed + 0x5CAB1EU + ++power_ups_);
  std::uint8_t* data = core_.data();
  for (std::uint32_t i = kSramBegin; i <= core_.chip()->ramend; ++i) {
    random = mix(random);
    data[i] = static_cast<std::uint8_t>(random);
  }
}

void AvrBoard::restore() {
  encoders_.restore();
  i2c_.restore();
  uart_.restore();
  clock_is_set_ = false;
  let_go();
}

CpuCycles AvrBoard::cycle_at(HostNs at_ns) const {
  if (at_ns <= begin_ns_) return begin_cycle_;
  return begin_cycle_ + static_cast<CpuCycles>(
                            std::llround(static_cast<double>(at_ns - begin_ns_) * cycles_per_ns_));
}

HostNs AvrBoard::time_at(CpuCycles cycle) const {
  return begin_ns_ + std::llround(static_cast<double>(cycle - begin_cycle_) / cycles_per_ns_);
}

CpuCycles AvrBoard::deliver(CpuCycles at) {
  while (!edges_.empty() && cycle_at(edges_.front().at_ns) <= at) {
    encoders_.set(edges_.front().channel, edges_.front().level);
    edges_ = edges_.subspan(1);
  }
  while (!bytes_.empty() && cycle_at(bytes_.front().at_ns) <= at) {
    uart_.receive(bytes_.front().value);
    bytes_ = bytes_.subspan(1);
  }
  if (hang_wanted_ && core_.asleep()) hang();
  CpuCycles next = AvrCore::kNever;
  if (!edges_.empty()) next = std::min(next, cycle_at(edges_.front().at_ns));
  if (!bytes_.empty()) next = std::min(next, cycle_at(bytes_.front().at_ns));
  if (hang_wanted_) next = std::min(next, at + 16);
  return next;
}

void AvrBoard::advance(HostNs until_ns, std::span<const EncoderEdge> edges,
                       std::span<const TimedByte> received) {
  edges_ = edges;
  bytes_ = received;
  now_ns_ = until_ns;
  if (!powered_ || until_ns <= begin_ns_) {
    for (const EncoderEdge& edge : edges_) encoders_.set(edge.channel, edge.level);
    return;
  }
  core_.run_until(cycle_at(until_ns));
  // The last instruction may have ended just before these.
  deliver(AvrCore::kNever);
}

void AvrBoard::hang() {
  hang_wanted_ = false;
  hung_at_ = core_.program_counter();
  std::uint8_t* flash = core_.flash();
  hung_code_ = {flash[hung_at_], flash[hung_at_ + 1]};
  flash[hung_at_] = 0xFF;  // rjmp .
  flash[hung_at_ + 1] = 0xCF;
  hung_ = true;
}

void AvrBoard::let_go() {
  hang_wanted_ = false;
  if (!std::exchange(hung_, false)) return;
  core_.flash()[hung_at_] = hung_code_[0];
  core_.flash()[hung_at_ + 1] = hung_code_[1];
}

// Bytes that have left by `until_ns`.
void AvrBoard::stamp(HostNs until_ns) {
  std::vector<SentByte>& sent = uart_.sent();
  auto byte = sent.begin();
  for (; byte != sent.end(); ++byte) {
    const HostNs at_ns = time_at(byte->at);
    if (at_ns > until_ns) break;
    stamped_.push_back({at_ns, byte->value});
  }
  sent.erase(sent.begin(), byte);
}

std::vector<TimedByte> AvrBoard::take_sent() {
  stamp(now_ns_);
  return std::exchange(stamped_, {});
}

}  // namespace tp100::sim
