#include "sim/board/avr_i2c.h"

#include <avr_ioport.h>
#include <avr_twi.h>
#include <sim_avr.h>

namespace tp100::sim {
namespace {

constexpr std::uint16_t kTwbr = 0xB8;
constexpr std::uint16_t kTwsr = 0xB9;
constexpr std::uint16_t kTwdr = 0xBB;
constexpr std::uint16_t kTwcr = 0xBC;
constexpr std::uint8_t kInterruptFlag = 0x80;
constexpr std::uint8_t kAcknowledge = 0x40;
constexpr std::uint8_t kStart = 0x20;
constexpr std::uint8_t kStop = 0x10;
constexpr std::uint8_t kEnable = 0x04;
constexpr std::uint8_t kStatusMask = 0xF8;

// Status codes, datasheet tables 24-2 and 24-3.
constexpr std::uint8_t kStartSent = 0x08;
constexpr std::uint8_t kRepeatedStartSent = 0x10;
constexpr std::uint8_t kNoInformation = 0xF8;

constexpr unsigned kByteBits = 9;
constexpr std::uint8_t kPortClock = 0x01;  // PD0
constexpr std::uint8_t kClocksToFree = 9;
// The MPU6050 latches its registers for the length of a burst (register map rev 4.2, 4.17).
constexpr std::size_t kBurst = 14;

}  // namespace

AvrI2c::AvrI2c(AvrCore& core, I2cSlave* slave, std::uint8_t address)
    : core_(core),
      slave_(slave),
      address_(address),
      twi_(reinterpret_cast<avr_twi_t*>(core.module("twi"))) {
  avr_t* avr = core.chip();
  // Set directly: simavr would abort if asked to replace its own handler.
  avr->io[AVR_DATA_TO_IO(kTwcr)].w = {this, on_control};
  // A plain register: nothing else handles the bytes on the bus.
  avr->io[AVR_DATA_TO_IO(kTwdr)].w = {};
  avr->io[AVR_DATA_TO_IO(kTwdr)].r = {};
  avr_irq_register_notify(
      avr_io_getirq(avr, AVR_IOCTL_IOPORT_GETIRQ('D'), IOPORT_IRQ_DIRECTION_ALL), on_pins, this);
}

void AvrI2c::set_fault(I2cFault fault) {
  fault_ = fault;
  clocks_ = 0;
}

void AvrI2c::restore() {
  state_ = State::kIdle;
  written_.clear();
  avr_cycle_timer_cancel(core_.chip(), on_done, this);
  core_.data()[kTwsr] = kNoInformation;
}

void AvrI2c::on_control(avr_t*, std::uint16_t, std::uint8_t value, void* self) {
  static_cast<AvrI2c*>(self)->control(value);
}

void AvrI2c::control(std::uint8_t value) {
  std::uint8_t& control = core_.data()[kTwcr];
  const bool flagged = (control & kInterruptFlag) != 0;
  control = static_cast<std::uint8_t>((value & ~kInterruptFlag) | (control & kInterruptFlag));
  if ((value & kEnable) == 0) {
    finish_transfer();
    avr_cycle_timer_cancel(core_.chip(), on_done, this);
    avr_clear_interrupt(core_.chip(), &twi_->twi);
    control = static_cast<std::uint8_t>(control & ~kInterruptFlag);
    return;
  }
  if ((value & kInterruptFlag) == 0) return;
  // Writing a one clears the flag, and the next step of the bus begins.
  avr_clear_interrupt(core_.chip(), &twi_->twi);
  control = static_cast<std::uint8_t>(control & ~kInterruptFlag);
  const bool begins = flagged || (value & (kStart | kStop)) != 0;
  if (begins) begin_step(value);
}

void AvrI2c::begin_step(std::uint8_t value) {
  std::uint8_t& control = core_.data()[kTwcr];
  const bool low = fault_ == I2cFault::kHeld || fault_ == I2cFault::kStuck;
  if ((value & kStop) != 0) {
    if (low) return;  // no edge of SDA: the bit stays set
    finish_transfer();
    control = static_cast<std::uint8_t>(control & ~kStop);
    core_.data()[kTwsr] = static_cast<std::uint8_t>(core_.data()[kTwsr] | kStatusMask);
  }
  if ((value & kStart) != 0) {
    if (low) return;  // the master waits for a free bus
    const bool repeated = state_ != State::kIdle;
    finish_transfer();
    state_ = State::kStarted;
    complete(1, repeated ? kRepeatedStartSent : kStartSent);
  } else if ((value & kStop) == 0) {
    next_byte(value);
  }
}

void AvrI2c::next_byte(std::uint8_t value) {
  const std::uint8_t data = core_.data()[kTwdr];
  switch (state_) {
    case State::kStarted:
      return address_byte(data);
    case State::kSending:
      written_.push_back(data);
      next_data_ = data;
      return complete(kByteBits, fault_ == I2cFault::kNone ? 0x28 : 0x30);
    case State::kReceiving:
      next_data_ = fault_ == I2cFault::kNone ? take_byte() : 0xFF;
      return complete(kByteBits, (value & kAcknowledge) != 0 ? 0x50 : 0x58);
    case State::kRefused:
    case State::kIdle:
      return;
  }
}

void AvrI2c::address_byte(std::uint8_t byte) {
  next_data_ = byte;
  const bool reads = (byte & 1U) != 0;
  if (!acknowledges(byte)) {
    state_ = State::kRefused;
    return complete(kByteBits, reads ? 0x48 : 0x20);
  }
  state_ = reads ? State::kReceiving : State::kSending;
  complete(kByteBits, reads ? 0x40 : 0x18);
}

bool AvrI2c::acknowledges(std::uint8_t byte) {
  if (slave_ == nullptr || fault_ != I2cFault::kNone || byte >> 1U != address_) return false;
  if ((byte & 1U) == 0) return slave_->write({});
  latched_.assign(kBurst, 0);
  next_latched_ = 0;
  return slave_->read(latched_);
}

std::uint8_t AvrI2c::take_byte() {
  if (next_latched_ == latched_.size()) {
    next_latched_ = 0;
    if (!slave_->read(latched_)) latched_.assign(kBurst, 0xFF);
  }
  return latched_[next_latched_++];
}

// The sensor receives all written bytes at the end of the transfer.
void AvrI2c::finish_transfer() {
  if (state_ == State::kSending && !written_.empty() && slave_ != nullptr) slave_->write(written_);
  written_.clear();
  state_ = State::kIdle;
}

void AvrI2c::complete(unsigned bits, std::uint8_t status) {
  const std::uint8_t* data = core_.data();
  const CpuCycles bit =
      16U + CpuCycles{2} * data[kTwbr] * (CpuCycles{1} << (2U * (data[kTwsr] & 3U)));
  next_status_ = status;
  avr_cycle_timer_register(core_.chip(), bits * bit, on_done, this);
}

CpuCycles AvrI2c::on_done(avr_t* avr, CpuCycles, void* self) {
  AvrI2c& i2c = *static_cast<AvrI2c*>(self);
  if (i2c.state_ != State::kStarted) avr->data[kTwdr] = i2c.next_data_;
  avr->data[kTwsr] = static_cast<std::uint8_t>((avr->data[kTwsr] & 3U) | i2c.next_status_);
  avr_raise_interrupt(avr, &i2c.twi_->twi);
  return 0;
}

void AvrI2c::on_pins(avr_irq_t*, std::uint32_t directions, void* self) {
  AvrI2c& i2c = *static_cast<AvrI2c*>(self);
  const bool low = (directions & kPortClock) != 0;
  const bool rises = i2c.clock_low_ && !low;
  i2c.clock_low_ = low;
  const bool by_hand = (i2c.core_.data()[kTwcr] & kEnable) == 0;
  if (!rises || !by_hand || i2c.fault_ != I2cFault::kHeld) return;
  if (++i2c.clocks_ >= kClocksToFree) i2c.set_fault(I2cFault::kNone);
}

}  // namespace tp100::sim
