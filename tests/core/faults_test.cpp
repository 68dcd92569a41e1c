#include "core/faults.h"

#include <gtest/gtest.h>

namespace tp100 {
namespace {

TEST(Faults, EveryFaultHasNameCauseAndFix) {
  FaultMask all = 0;
#define TP100_ALL(bit, name, cause, fix) all |= fault_bit(Fault::name);
  TP100_ROBOT_FAULTS(TP100_ALL)
  TP100_DAEMON_FAULTS(TP100_ALL)
#undef TP100_ALL
  EXPECT_FALSE(first_fault(0));
  for (FaultMask rest = all; rest != 0; rest &= rest - 1) {
    const FaultText& text = describe(*first_fault(rest));
    EXPECT_NE(text.name, "unknown");
    EXPECT_FALSE(text.cause.empty());
    EXPECT_FALSE(text.fix.empty());
  }
}

TEST(Faults, TheRobotsFaultsFitItsSixteenBits) {
#define TP100_LOW(bit, name, cause, fix) static_assert(bit < 16);
  TP100_ROBOT_FAULTS(TP100_LOW)
#undef TP100_LOW
#define TP100_HIGH(bit, name, cause, fix) static_assert(bit >= 16 && bit < 64);
  TP100_DAEMON_FAULTS(TP100_HIGH)
#undef TP100_HIGH
}

TEST(Faults, ABitThatThisVersionDoesNotKnowIsNamedUnknown) {
  for (const FaultMask bit : {FaultMask{1} << 13, FaultMask{1} << 15, FaultMask{1} << 63})
    EXPECT_EQ(describe(*first_fault(bit)).name, "unknown");
}

}  // namespace
}  // namespace tp100
