// Quadrature decoding, four counts a period. Shared by the interrupt routines of the Mega, the
// emulated board and the tests. Forward: A leads B (A rises while B is low).
#ifndef TP100_FIRMWARE_QUADRATURE_H
#define TP100_FIRMWARE_QUADRATURE_H

#include <stdint.h>

namespace tp100 {
namespace firmware {

const int8_t kIllegalStep = 2;

/// Step from phase `before` to phase `now` (bit 0: A, bit 1: B): -1, 0, 1, or kIllegalStep if both
/// changed, which means that an edge was missed. Pure; a table look-up.
inline int8_t quadrature_step(uint8_t before, uint8_t now) {
  // 00 -> 01 (A rises) -> 11 (B rises) -> 10 (A falls) -> 00 is forward.
  static const int8_t steps[16] = {
      0, 1,  -1,           kIllegalStep, -1, 0, kIllegalStep, 1, 1, kIllegalStep,
      0, -1, kIllegalStep, -1,           1,  0};
  return steps[static_cast<uint8_t>(before << 2) | now];
}

/// One encoder. Plain state, so that an interrupt routine compiles to a few loads and stores.
struct Quadrature {
  volatile int32_t counts;
  volatile uint8_t phase;     ///< last seen: bit 0 A, bit 1 B
  volatile uint16_t illegal;  ///< missed edges; the count is unknown by two for each
};

/// Takes the phase that an edge left behind. Called with interrupts off. kSign -1 for an encoder
/// whose A and B lie on the port the other way round. At most 90 cycles on an ATmega2560.
template <int8_t kSign>
inline void take_edge(Quadrature& encoder, uint8_t phase) {
  const int8_t step = quadrature_step(encoder.phase, phase);
  encoder.phase = phase;
  if (step == kIllegalStep) {
    encoder.illegal = static_cast<uint16_t>(encoder.illegal + 1);
  } else if (step == kSign) {
    encoder.counts = encoder.counts + 1;
  } else if (step != 0) {
    encoder.counts = encoder.counts - 1;
  }
}

}  // namespace firmware
}  // namespace tp100

#endif
