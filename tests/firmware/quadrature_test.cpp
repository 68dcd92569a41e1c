#include "firmware/quadrature.h"

#include <gtest/gtest.h>

#include <array>

namespace tp100::firmware {
namespace {

constexpr std::array<std::uint8_t, 4> kForward = {0, 1, 3, 2};  // A leads B

TEST(Quadrature, EveryForwardEdgeCountsUpAndEveryBackwardEdgeDown) {
  for (std::size_t i = 0; i < 4; ++i) {
    const std::uint8_t now = kForward[i];
    const std::uint8_t next = kForward[(i + 1) % 4];
    EXPECT_EQ(quadrature_step(now, next), 1);
    EXPECT_EQ(quadrature_step(next, now), -1);
    EXPECT_EQ(quadrature_step(now, now), 0);
    EXPECT_EQ(quadrature_step(now, static_cast<std::uint8_t>(now ^ 3U)), kIllegalStep);
  }
}

TEST(Quadrature, CountsFarBothWays) {
  Quadrature encoder{};
  std::size_t at = 0;
  for (int i = 0; i < 200'000; ++i) take_edge<1>(encoder, kForward[++at % 4]);
  EXPECT_EQ(encoder.counts, 200'000);
  for (int i = 0; i < 300'000; ++i) take_edge<1>(encoder, kForward[--at % 4]);
  EXPECT_EQ(encoder.counts, -100'000);
  EXPECT_EQ(encoder.illegal, 0);
}

TEST(Quadrature, AMissedEdgeIsCountedAsIllegal) {
  Quadrature encoder{};
  take_edge<1>(encoder, 3);
  EXPECT_EQ(encoder.illegal, 1);
  EXPECT_EQ(encoder.counts, 0);
}

}  // namespace
}  // namespace tp100::firmware
