#include "sim/board/avr_adc.h"

#include <avr_adc.h>
#include <sim_avr.h>

#include <algorithm>
#include <cmath>

#include "sim/board/mix.h"

namespace tp100::sim {
namespace {

constexpr std::uint32_t kMost = 1023;
constexpr double kDivider = 3.0;
constexpr int kBattery = 0;
constexpr int kOpenPin = 7;

}  // namespace

AvrAdc::AvrAdc(AvrCore& core, std::uint64_t seed) : core_(core), noise_(seed) {
  avr_irq_register_notify(avr_io_getirq(core.chip(), AVR_IOCTL_ADC_GETIRQ, ADC_IRQ_OUT_TRIGGER),
                          on_conversion, this);
}

void AvrAdc::set_supply(double volts) {
  core_.chip()->avcc = static_cast<std::uint32_t>(std::lround(volts * 1e3));
}

void AvrAdc::on_conversion(avr_irq_t*, std::uint32_t, void* self) {
  AvrAdc& adc = *static_cast<AvrAdc*>(self);
  adc.noise_ = mix(adc.noise_);
  adc.put(kOpenPin, static_cast<std::uint32_t>(adc.noise_ % 64));
  const double steps = adc.volts_ / kDivider * 1024e3 / adc.core_.chip()->avcc;
  adc.put(kBattery, static_cast<std::uint32_t>(std::clamp(steps, 0.0, double{kMost})));
}

// simavr takes millivolts and scales them by 1023: this many give just `steps`.
void AvrAdc::put(int channel, std::uint32_t steps) {
  const std::uint32_t mv = (steps * core_.chip()->avcc + kMost - 1) / kMost;
  avr_raise_irq(avr_io_getirq(core_.chip(), AVR_IOCTL_ADC_GETIRQ, channel), mv);
}

}  // namespace tp100::sim
