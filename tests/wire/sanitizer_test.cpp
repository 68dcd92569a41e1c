// The undefined-behaviour sanitizer must also check code in headers.
#ifdef TP100_SANITIZES_UNDEFINED

#include <gtest/gtest.h>

#include "wire/faults.h"

namespace tp100::wire {
namespace {

TEST(SanitizerDeathTest, SeesWhatAHeaderDoes) {
  volatile std::uint8_t no_fault = 70;
  const auto undefined = [&] { return fault_bit(static_cast<Fault>(no_fault)); };
  EXPECT_DEATH(static_cast<void>(undefined()), "faults.h.*runtime error: shift exponent 70");
}

}  // namespace
}  // namespace tp100::wire

#endif
