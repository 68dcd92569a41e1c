#include "isr_monitor.h"

#include <sim_avr.h>
#include <sim_interrupts.h>

namespace tp100::sim {
namespace {

constexpr CpuCycles kReturnCycles = 5;  // simavr counts them after its notification

}  // namespace

IsrMonitor::IsrMonitor(AvrCore& core, std::uint8_t vector) : core_(core) {
  avr_irq_t* irq = avr_get_interrupt_irq(core.chip(), vector);
  avr_irq_register_notify(irq + AVR_INT_IRQ_RUNNING, on_running, this);
}

void IsrMonitor::on_running(avr_irq_t*, std::uint32_t running, void* self) {
  IsrMonitor& watch = *static_cast<IsrMonitor*>(self);
  const CpuCycles now = watch.core_.cycle();
  if (running != 0) {
    watch.began_ = now;
    return;
  }
  if (watch.began_ == 0) return;
  const CpuCycles took = now - watch.began_ + kEntryCycles + kReturnCycles;
  watch.began_ = 0;
  watch.longest_ = std::max(watch.longest_, took);
  watch.sum_ += took;
  ++watch.runs_;
}

}  // namespace tp100::sim
