// Quadrature decoding, four counts per period. Shared by the interrupt routines of the Mega, the
// emulated board and the tests. Forward: A leads B (A rises while B is low).
#ifndef TP100_FIRMWARE_QUADRATURE_H
#define TP100_FIRMWARE_QUADRATURE_H

#include <stdint.h>

#include "shared/number.h"

namespace tp100 {
namespace firmware {

const int8_t kIllegalStep = 2;

/// Step from phase `before` to phase `now` (bit 0: A, bit 1: B): -1, 0, 1, or kIllegalStep if both
/// changed, which means that an edge was missed. Pure, and without a table: an interrupt routine
/// that needs no pointer saves the fewest registers.
inline int8_t quadrature_step(uint8_t before, uint8_t now) {
  const uint8_t changed = static_cast<uint8_t>(before ^ now);
  if (changed == 3) return kIllegalStep;
  if (changed == 0) return 0;
  // 00 -> 01 (A rises) -> 11 (B rises) -> 10 (A falls) -> 00 is forward: A before is B after.
  const uint8_t b_after = static_cast<uint8_t>(now >> 1);
  const uint8_t differ = static_cast<uint8_t>(before ^ b_after);
  return (differ & 1) == 0 ? 1 : -1;
}

/// One encoder. Plain state, so that an interrupt routine compiles to a few loads and stores. It
/// counts in 16 bits; extended_counts() extends them to 32.
struct Quadrature {
  volatile uint16_t steps;   ///< forward less backward, wraps
  volatile uint8_t phase;    ///< last seen: bit 0 A, bit 1 B
  volatile uint16_t missed;  ///< number of times both phases changed at once, wraps
  int32_t counts;            ///< as of the last extended_counts()
};

/// Takes the phase after an edge. Called with interrupts off. kSign is -1 for an encoder whose A
/// and B are swapped on the port.
template <int8_t kSign>
inline void take_edge(Quadrature& encoder, uint8_t phase) {
  const uint8_t before = encoder.phase;
  encoder.phase = phase;
  const int8_t step = quadrature_step(before, phase);
  if (step == kIllegalStep) {
    encoder.missed = static_cast<uint16_t>(encoder.missed + 1);
  } else if (step == kSign) {
    encoder.steps = static_cast<uint16_t>(encoder.steps + 1);
  } else if (step == -kSign) {
    encoder.steps = static_cast<uint16_t>(encoder.steps - 1);
  }
}

/// The count extended to 32 bits. Called with interrupts off, at least once per 32767 edges.
inline int32_t extended_counts(Quadrature& encoder) {
  const uint16_t last = static_cast<uint16_t>(encoder.counts);
  const int16_t moved = shared::wrapped_difference(encoder.steps, last);
  encoder.counts = static_cast<int32_t>(static_cast<uint32_t>(encoder.counts) +
                                        static_cast<uint32_t>(static_cast<int32_t>(moved)));
  return encoder.counts;
}

}  // namespace firmware
}  // namespace tp100

#endif
