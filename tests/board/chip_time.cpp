#include "chip_time.h"

#include <avr_watchdog.h>
#include <sim_avr.h>
#include <sim_interrupts.h>

#include <cstring>

namespace tp100::sim {
namespace {

constexpr CpuCycles kReturnCycles = 5;  // simavr counts them after its notification

// The C callbacks carry no pointer to their owner.
LoopTime* g_loop_time = nullptr;

}  // namespace

InterruptTime::InterruptTime(AvrCore& core, std::uint8_t vector) : core_(core) {
  avr_irq_t* irq = avr_get_interrupt_irq(core.chip(), vector);
  avr_irq_register_notify(irq + AVR_INT_IRQ_RUNNING, on_running, this);
}

void InterruptTime::on_running(avr_irq_t*, std::uint32_t running, void* self) {
  InterruptTime& time = *static_cast<InterruptTime*>(self);
  const CpuCycles now = time.core_.cycle();
  if (running != 0) {
    time.began_ = now;
    return;
  }
  if (time.began_ == 0) return;
  time.longest_ = std::max(time.longest_, now - time.began_ + kEntryCycles + kReturnCycles);
  time.began_ = 0;
  ++time.runs_;
}

LoopTime::LoopTime(AvrCore& core) : core_(core) {
  for (avr_io_t* io = core.chip()->io_port; io != nullptr; io = io->next)
    if (std::strcmp(io->kind, "watchdog") == 0) watchdog_ = io;
  if (watchdog_ == nullptr) return;
  g_loop_time = this;
  sleep_ = core.chip()->sleep;
  core.chip()->sleep = on_sleep;
  next_ = watchdog_->ioctl;
  watchdog_->ioctl = on_ioctl;
}

LoopTime::~LoopTime() {
  if (watchdog_ == nullptr) return;
  core_.chip()->sleep = sleep_;
  watchdog_->ioctl = next_;
  g_loop_time = nullptr;
}

int LoopTime::on_ioctl(avr_io_t* io, std::uint32_t control, void* parameter) {
  if (control == AVR_IOCTL_WATCHDOG_RESET) g_loop_time->kicked();
  return g_loop_time->next_(io, control, parameter);
}

void LoopTime::on_sleep(avr_t*, CpuCycles cycles) { g_loop_time->slept_ += cycles + 1; }

void LoopTime::kicked() {
  const CpuCycles awake = core_.cycle() - slept_;
  if (began_ != 0) longest_ = std::max(longest_, awake - began_);
  began_ = awake;
}

}  // namespace tp100::sim
