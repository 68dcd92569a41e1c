#include "core/time.h"

#include <gtest/gtest.h>

#include <limits>

#include "core/link_state.h"

namespace tp100 {
namespace {

constexpr std::int64_t kMax = std::int64_t{1} << 61;

TEST(Seconds, NoNumberOfSecondsFromAFileOrMessageOverflowsATime) {
  EXPECT_EQ(from_s(1.5), 1'500'000'000);
  EXPECT_EQ(from_s(1e300), kMax);
  EXPECT_EQ(from_s(-1e300), -kMax);
  EXPECT_EQ(from_s(std::numeric_limits<double>::quiet_NaN()), -kMax);
}

TEST(ClockState, ConvertsBackAndForthAndNeverOverflows) {
  const ClockState clock{.valid = true,
                         .reference_host_ns = 7'000'000'000'123,
                         .reference_us = 5'000'000,
                         .drift = 40e-6};
  EXPECT_EQ(clock.to_host(5'000'000), clock.reference_host_ns);
  EXPECT_NEAR(static_cast<double>(clock.to_device(clock.to_host(9'000'000))), 9e6, 1.0);
  constexpr std::int64_t kWild[] = {std::numeric_limits<std::int64_t>::min(), -kMax, -1, 0, 1, kMax,
                                    std::numeric_limits<std::int64_t>::max()};
  for (const std::int64_t host : kWild) {
    for (const std::int64_t device : kWild) {
      for (const double drift : {-1e300, -1.0, 0.0, 0.5, 1e300}) {
        const ClockState wild{
            .valid = true, .reference_host_ns = host, .reference_us = device, .drift = drift};
        for (const std::int64_t time : kWild) {
          EXPECT_LE(wild.to_host(time), kMax);
          EXPECT_LE(wild.to_device(time), kMax);
        }
      }
    }
  }
}

}  // namespace
}  // namespace tp100
