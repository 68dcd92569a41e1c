#include "server/budget.h"

#include <gtest/gtest.h>

namespace tp100::server {
namespace {

constexpr HostNs kBegin = 1000 * kNsPerS;

// A client that asks for more than its share would slow down everything that the others see.
TEST(Budget, GivesItsUnitsAndNoMoreAtAnyRateOfAsking) {
  for (const double asked_per_s : {10.0, 90.0, 110.0, 400.0, 50'000.0}) {
    for (const double units : {0.5, 1.0, 30.0}) {
      Budget budget(100.0);
      double given = 0.0;
      const auto every_ns = static_cast<HostNs>(1e9 * units / asked_per_s);
      for (HostNs at = 0; at < 20 * kNsPerS; at += every_ns)
        if (budget.charge(units, kBegin + at)) given += units;
      if (asked_per_s <= 100.0) {
        EXPECT_GE(given, 20.0 * asked_per_s - units);
      } else {
        EXPECT_LE(given, 21.0 * 100.0 + units) << asked_per_s << " a second";
      }
    }
  }
}

TEST(Budget, ComesBackWithinTwoSecondsWhateverWasSpent) {
  Budget budget(100.0);
  EXPECT_FALSE(budget.charge(1e9, kBegin));
  EXPECT_FALSE(budget.charge(1.0, kBegin + kNsPerS / 2));
  EXPECT_FALSE(budget.full(kBegin + kNsPerS));
  EXPECT_TRUE(budget.full(kBegin + 3 * kNsPerS));
  EXPECT_TRUE(budget.charge(1.0, kBegin + 3 * kNsPerS));
}

// Forty connections of one address must not get forty times as much; a connection that is closed
// and opened again nothing anew.
TEST(Budgets, AnAddressHasOneHoweverOftenItConnects) {
  Budgets budgets;
  EXPECT_EQ(budgets.of("10.0.0.1"), budgets.of("10.0.0.1"));
  EXPECT_NE(budgets.of("10.0.0.1"), budgets.of("10.0.0.2"));
  budgets.of("10.0.0.1")->charge(1e9, kBegin);
  budgets.tick(kBegin);
  EXPECT_FALSE(budgets.of("10.0.0.1")->charge(1.0, kBegin));
  budgets.tick(kBegin + 5 * kNsPerS);
  EXPECT_TRUE(budgets.of("10.0.0.1")->charge(1.0, kBegin + 5 * kNsPerS));
}

}  // namespace
}  // namespace tp100::server
