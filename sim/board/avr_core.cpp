#include "sim/board/avr_core.h"

#include <avr_extint.h>
#include <avr_timer.h>
#include <sim_avr.h>

#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <string>

#include "core/error.h"

namespace tp100::sim {
namespace {

constexpr std::uint16_t kMcusr = 0x54;
constexpr std::uint8_t kExternalInterrupts = 8;
// The most cycles between two checks of simavr's timers; results do not depend on it.
constexpr std::uint32_t kRunCycleLimit = 16000;

void say_nothing(avr_t*, int, const char*, va_list) {}

// The object that owns a chip, for its callbacks: simavr's hook for such data.
AvrCore& owner(avr_t* avr) { return *static_cast<AvrCore*>(avr->custom.data); }

avr_t* make_chip() {
  avr_global_logger_set(say_nothing);
  avr_t* avr = avr_make_mcu_by_name("atmega2560");
  if (avr == nullptr) throw UserError("libsimavr: does not know the atmega2560; reinstall it");
  avr_init(avr);
  return avr;
}

}  // namespace

AvrCore::AvrCore(const AvrImage& image) : avr_(make_chip()) {
  avr_->custom.data = this;
  avr_->frequency = kHz;
  avr_->vcc = avr_->avcc = avr_->aref = 5000;
  // The default would let the host's thread sleep.
  avr_->sleep = [](avr_t*, CpuCycles) {};
  chip_reset_ = avr_->reset;
  avr_->reset = on_chip_reset;
  repair_timers();
  program(image);
}

AvrCore::~AvrCore() {
  avr_terminate(avr_);
  free_what_terminate_leaves();
  std::free(avr_);
}

void AvrCore::free_what_terminate_leaves() {
  for (auto& io : avr_->io) {
    if (io.irq != nullptr) avr_free_irq(io.irq, AVR_IOMEM_IRQ_ALL + 1);
    io.irq = nullptr;
  }
  avr_irq_pool_t& pool = avr_->irq_pool;
  for (int i = 0; i < pool.count; ++i) {
    avr_irq_t* irq = pool.irq[i];
    if (irq != nullptr && (irq->flags & IRQ_FLAG_ALLOC) == 0) avr_free_irq(irq, 1);
  }
  std::free(pool.irq);
}

void AvrCore::program(const AvrImage& image) {
  std::copy(image.flash.begin(), image.flash.end(), avr_->flash + image.begin);
  avr_->codeend = avr_->flashend;
}

void AvrCore::set_reset_address(std::uint32_t address) { avr_->reset_pc = address; }

// simavr lacks phase-correct PWM, Arduino's default: of 8 to 10 bits for the 16-bit timers, and of
// 8 bits for timer 2. Without it they would overflow every few cycles.
void AvrCore::repair_timers() {
  for (avr_io_t* io = avr_->io_port; io != nullptr; io = io->next) {
    if (std::strcmp(io->kind, "timer") != 0) continue;
    auto* timer = reinterpret_cast<avr_timer_t*>(io);
    const int modes = timer->r_tcnth != 0 ? 3 : 1;
    for (int mode = 1; mode <= modes; ++mode) {
      avr_timer_wgm_t& op = timer->wgm_op[mode];
      if (op.kind != avr_timer_wgm_none) continue;
      op.kind = avr_timer_wgm_fc_pwm;
      op.size = static_cast<std::uint32_t>(7 + mode) & 0xFFU;
    }
  }
}

void AvrCore::on_chip_reset(avr_t* avr) {
  AvrCore& core = owner(avr);
  core.was_reset_ = true;
  if (core.chip_reset_ != nullptr) core.chip_reset_(avr);
}

CpuCycles AvrCore::on_timer(avr_t* avr, CpuCycles, void* self) {
  AvrCore& core = *static_cast<AvrCore*>(self);
  const CpuCycles now = core.cycle();
  if (now >= core.next_) core.next_ = core.on_event ? core.on_event(now) : kNever;
  if (now >= core.until_) {
    core.reached_ = true;
    // A sleeping CPU would otherwise skip to the chip's next timer.
    return avr->cycle + 1;
  }
  return std::max(std::min(core.next_, core.until_) - core.offset_, avr->cycle + 1);
}

// Restores everything that a reset clears.
void AvrCore::arm() {
  avr_->run_cycle_limit = kRunCycleLimit;
  // Otherwise simavr would check a low pin in every cycle until its interrupt is configured.
  for (std::uint8_t i = 0; i < kExternalInterrupts; ++i) {
    avr_extint_set_strict_lvl_trig(avr_, i, 0);
  }
  if (on_reset) on_reset();
}

void AvrCore::reset(std::uint8_t mcusr) {
  const CpuCycles before = cycle();
  avr_reset(avr_);
  was_reset_ = false;
  offset_ = before - avr_->cycle;
  avr_->data[kMcusr] = mcusr;
  arm();
}

void AvrCore::run_until(CpuCycles until) {
  until_ = until;
  next_ = 0;
  reached_ = false;
  const auto wake = [&] { avr_cycle_timer_register(avr_, 1, on_timer, this); };
  wake();
  while (!reached_) {
    const CpuCycles before = avr_->cycle;
    avr_run(avr_);
    // simavr executes two instructions after sei before an interrupt, the chip one: in `sei, sleep,
    // cli` a pending interrupt would never run.
    if (avr_->interrupt_state > 0 && avr_->sreg[S_I] != 0) avr_service_interrupts(avr_);
    if (was_reset_) {
      was_reset_ = false;
      ++own_resets_;
      offset_ += before - std::min(before, avr_->cycle);
      arm();
      wake();
    }
    if (avr_->state == cpu_Done || avr_->state == cpu_Crashed) {
      // The core is dead until a reset: only time passes.
      const CpuCycles now = cycle();
      if (now < until_) offset_ += until_ - now;
      reached_ = true;
    }
  }
  avr_cycle_timer_cancel(avr_, on_timer, this);
}

avr_io_t* AvrCore::module(const char* kind, const std::function<bool(avr_io_t*)>& is) const {
  for (avr_io_t* io = avr_->io_port; io != nullptr; io = io->next)
    if (std::strcmp(io->kind, kind) == 0 && is(io)) return io;
  throw UserError(std::string("libsimavr: its atmega2560 lacks a ") + kind +
                  "; install libsimavr-dev 1.6");
}

CpuCycles AvrCore::cycle() const { return avr_->cycle + offset_; }
std::uint8_t* AvrCore::data() const { return avr_->data; }
std::uint8_t* AvrCore::flash() const { return avr_->flash; }
std::uint32_t AvrCore::program_counter() const { return avr_->pc; }
bool AvrCore::asleep() const { return avr_->state == cpu_Sleeping; }

}  // namespace tp100::sim
