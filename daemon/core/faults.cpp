#include "core/faults.h"

#include <array>
#include <bit>

namespace tp100 {

namespace {

constexpr auto kTexts = std::to_array<FaultText>({
#define TP100_TEXT(bit, name, cause, fix) {Fault::name, #name, cause, fix},
    TP100_ROBOT_FAULTS(TP100_TEXT) TP100_DAEMON_FAULTS(TP100_TEXT)
#undef TP100_TEXT
});

constexpr FaultText kUnknown{Fault{255}, "unknown", "a fault that this version does not know",
                             "update the daemon"};

}  // namespace

const FaultText& describe(Fault fault) {
  for (const FaultText& text : kTexts) {
    if (text.fault == fault) return text;
  }
  return kUnknown;
}

std::optional<Fault> first_fault(FaultMask mask) {
  if (mask == 0) return std::nullopt;
  return static_cast<Fault>(std::countr_zero(mask));
}

}  // namespace tp100
