#include "loop_monitor.h"

#include <avr_watchdog.h>
#include <sim_avr.h>

#include <cstring>

namespace tp100::sim {
namespace {

// The C callback carries no pointer to its owner.
LoopMonitor* g_monitor = nullptr;

}  // namespace

LoopMonitor::LoopMonitor(AvrCore& core) : core_(core) {
  for (avr_io_t* io = core.chip()->io_port; io != nullptr; io = io->next) {
    if (std::strcmp(io->kind, "watchdog") == 0) watchdog_ = io;
  }
  if (watchdog_ == nullptr) return;
  g_monitor = this;
  next_ = watchdog_->ioctl;
  watchdog_->ioctl = on_ioctl;
}

LoopMonitor::~LoopMonitor() {
  if (watchdog_ != nullptr) watchdog_->ioctl = next_;
  g_monitor = nullptr;
}

int LoopMonitor::on_ioctl(avr_io_t* io, std::uint32_t control, void* parameter) {
  if (control == AVR_IOCTL_WATCHDOG_RESET) g_monitor->cycle();
  return g_monitor->next_(io, control, parameter);
}

void LoopMonitor::cycle() {
  const CpuCycles awake = core_.cycle() - core_.slept();
  if (began_ != 0) longest_ = std::max(longest_, awake - began_);
  began_ = awake;
  ++cycles_;
}

}  // namespace tp100::sim
