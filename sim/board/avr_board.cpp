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
#include "sim/board/avr_core.h"
#include "sim/board/avr_pins.h"
#include "sim/board/avr_uart.h"
#include "sim/body/seed.h"

namespace tp100::sim {
namespace {

constexpr std::uint32_t kBootloaderAddress = 0x3E000;
constexpr std::uint16_t kSramBegin = 0x200;
constexpr std::uint16_t kTimsk0 = 0x6E;
constexpr std::uint32_t kTimerOverflowUs = 1024;  // timer 0: prescaler 64, 256 steps

std::uint8_t mcusr(PowerUp cause) {
  switch (cause) {
    case PowerUp::kPowerOn:
      return 0x01;
    case PowerUp::kExternal:
      return 0x02;
    case PowerUp::kBrownOut:
      return 0x04;
    case PowerUp::kWatchdog:
      return 0x08;
  }
  return 0;
}

}  // namespace

struct AvrBoard::Machine {
  Machine(const AvrBoardSettings& board_settings, I2cSlave* imu)
      : settings(board_settings),
        image(settings.blank
                  ? AvrImage{}
                  : read_avr_image(settings.image.empty() ? built_firmware() : settings.image)),
        core(image, settings.run_cycle_limit),
        uart(core),
        encoders(core),
        i2c(core, imu, Mpu6050::kAddress),
        adc(core, mix(settings.seed ^ 0xADCU)),
        cycles_per_ns(AvrCore::kHz * 1e-9 * (1.0 + settings.clock_ppm * 1e-6)) {
    if (settings.bootloader) {
      core.program(read_avr_image(stock_bootloader()));
      core.set_reset_address(kBootloaderAddress);
    }
    core.on_event = [this](CpuCycles at) { return deliver(at); };
    core.on_reset = [this] { restore(); };
    fill_eeprom();
    if (settings.start_us != 0) preset_clock();
  }

  // A boot counter that other robots do not share.
  void fill_eeprom() {
    std::array<std::uint8_t, 4> counter{};
    const std::uint64_t value = mix(settings.seed) >> 40U;
    for (std::size_t i = 0; i < counter.size(); ++i) {
      counter[i] = static_cast<std::uint8_t>(value >> (8U * i));
    }
    avr_eeprom_desc_t description{counter.data(), 0, static_cast<std::uint32_t>(counter.size())};
    avr_ioctl(core.chip(), AVR_IOCTL_EEPROM_SET, &description);
  }

  // The Arduino core's overflow count, as soon as it starts the timer behind micros().
  void preset_clock() {
    const auto symbol = image.symbols.find("timer0_overflow_count");
    if (symbol == image.symbols.end()) {
      throw SetupError(image.path + ": no symbol timer0_overflow_count; give an ELF file");
    }
    overflow_count = static_cast<std::uint16_t>(symbol->second & 0xFFFFU);
    avr_irq_register_notify(
        avr_iomem_getirq(core.chip(), kTimsk0, nullptr, AVR_IOMEM_IRQ_ALL),
        [](avr_irq_t*, std::uint32_t, void* self) { static_cast<Machine*>(self)->set_clock(); },
        this);
  }
  void set_clock() {
    if (clock_is_set) return;
    clock_is_set = true;
    const std::uint32_t overflows = settings.start_us / kTimerOverflowUs;
    for (unsigned i = 0; i < 4; ++i) {
      core.data()[overflow_count + i] = static_cast<std::uint8_t>(overflows >> (8U * i));
    }
  }

  void reset(PowerUp cause, HostNs now_ns) {
    take_stamped(now_ns);
    powered = true;
    now = now_ns;
    begin_ns = now_ns + settings.reset_hold_ns;
    if (cause == PowerUp::kPowerOn || cause == PowerUp::kBrownOut) scramble();
    core.reset(mcusr(cause));
    begin_cycle = core.cycle();
  }

  // Contents of the SRAM at power-on.
  void scramble() {
    std::uint64_t random = mix(settings.seed + 0x5CAB1EU + ++power_ups);
    std::uint8_t* data = core.data();
    for (std::uint32_t i = kSramBegin; i <= core.chip()->ramend; ++i) {
      random = mix(random);
      data[i] = static_cast<std::uint8_t>(random);
    }
  }

  void restore() {
    encoders.restore();
    i2c.restore();
    uart.restore();
    clock_is_set = false;
    let_go();
  }

  CpuCycles cycle_at(HostNs at_ns) const {
    if (at_ns <= begin_ns) return begin_cycle;
    return begin_cycle + static_cast<CpuCycles>(
                             std::llround(static_cast<double>(at_ns - begin_ns) * cycles_per_ns));
  }
  HostNs time_at(CpuCycles cycle) const {
    return begin_ns + std::llround(static_cast<double>(cycle - begin_cycle) / cycles_per_ns);
  }

  CpuCycles deliver(CpuCycles at) {
    while (!edges.empty() && cycle_at(edges.front().at_ns) <= at) {
      encoders.set(edges.front().channel, edges.front().level);
      edges = edges.subspan(1);
    }
    while (!bytes.empty() && cycle_at(bytes.front().at_ns) <= at) {
      uart.receive(bytes.front().value);
      bytes = bytes.subspan(1);
    }
    if (hang_wanted && core.asleep()) hang();
    CpuCycles next = AvrCore::kNever;
    if (!edges.empty()) next = std::min(next, cycle_at(edges.front().at_ns));
    if (!bytes.empty()) next = std::min(next, cycle_at(bytes.front().at_ns));
    if (hang_wanted) next = std::min(next, at + 16);
    return next;
  }

  void advance(HostNs until_ns, std::span<const EncoderEdge> new_edges,
               std::span<const TimedByte> new_bytes) {
    edges = new_edges;
    bytes = new_bytes;
    now = until_ns;
    if (!powered || until_ns <= begin_ns) {
      for (const EncoderEdge& edge : edges) encoders.set(edge.channel, edge.level);
      lost_in_reset += bytes.size();
      return;
    }
    core.run_until(cycle_at(until_ns));
    // The last instruction may have ended just before these.
    deliver(AvrCore::kNever);
  }

  void hang() {
    hang_wanted = false;
    hung_at = core.program_counter();
    std::uint8_t* flash = core.flash();
    hung_code = {flash[hung_at], flash[hung_at + 1]};
    flash[hung_at] = 0xFF;  // rjmp .
    flash[hung_at + 1] = 0xCF;
    hung = true;
  }
  void let_go() {
    hang_wanted = false;
    if (!std::exchange(hung, false)) return;
    core.flash()[hung_at] = hung_code[0];
    core.flash()[hung_at + 1] = hung_code[1];
  }

  // Bytes that have left by `until_ns`.
  void take_stamped(HostNs until_ns) {
    std::vector<SentByte>& sent = uart.sent();
    auto byte = sent.begin();
    for (; byte != sent.end(); ++byte) {
      const HostNs at_ns = time_at(byte->at);
      if (at_ns > until_ns) break;
      stamped.push_back({at_ns, byte->value});
    }
    sent.erase(sent.begin(), byte);
  }

  AvrBoardSettings settings;
  AvrImage image;
  AvrCore core;
  AvrUart uart;
  AvrEncoderPins encoders;
  AvrI2c i2c;
  AvrAdc adc;
  double cycles_per_ns;

  bool powered = false;
  HostNs now = 0;
  HostNs begin_ns = 0;
  CpuCycles begin_cycle = 0;
  std::span<const EncoderEdge> edges;
  std::span<const TimedByte> bytes;
  std::vector<TimedByte> stamped;
  std::uint64_t lost_in_reset = 0;
  std::uint64_t power_ups = 0;

  std::uint16_t overflow_count = 0;
  bool clock_is_set = false;

  bool hang_wanted = false;
  bool hung = false;
  std::uint32_t hung_at = 0;
  std::array<std::uint8_t, 2> hung_code{};
};

AvrBoard::AvrBoard(const AvrBoardSettings& settings, I2cSlave* imu)
    : machine_(std::make_unique<Machine>(settings, imu)) {}
AvrBoard::~AvrBoard() = default;
AvrBoard::AvrBoard(AvrBoard&&) noexcept = default;
AvrBoard& AvrBoard::operator=(AvrBoard&&) noexcept = default;

void AvrBoard::reset(PowerUp cause, HostNs now_ns) { machine_->reset(cause, now_ns); }

void AvrBoard::advance(HostNs until_ns, std::span<const EncoderEdge> edges,
                       std::span<const TimedByte> received) {
  machine_->advance(until_ns, edges, received);
}

std::vector<TimedByte> AvrBoard::take_sent() {
  machine_->take_stamped(machine_->now);
  return std::exchange(machine_->stamped, {});
}

MotorDuty AvrBoard::motor_duty() const {
  return machine_->powered ? motor_drive(machine_->core) : MotorDuty{};
}

void AvrBoard::set_battery(double volts) { machine_->adc.set_battery(volts); }
void AvrBoard::set_supply(double volts) { machine_->adc.set_supply(volts); }
void AvrBoard::set_i2c_fault(I2cFault fault) { machine_->i2c.set_fault(fault); }
void AvrBoard::hang_main_loop() { machine_->hang_wanted = true; }

AvrBoardCounters AvrBoard::counters() const {
  const Machine& m = *machine_;
  return {.rx_overruns = m.uart.overruns(),
          .rx_while_off = m.uart.while_off() + m.lost_in_reset,
          .watchdog_resets = m.core.own_resets(),
          .cycles = m.core.cycle(),
          .slept_cycles = m.core.slept(),
          .i2c_bytes = m.i2c.bytes()};
}

CpuCycles AvrBoard::longest_i2c_transfer() const { return machine_->i2c.longest_transfer(); }
AvrCore& AvrBoard::core() { return machine_->core; }
const AvrImage& AvrBoard::image() const { return machine_->image; }

}  // namespace tp100::sim
