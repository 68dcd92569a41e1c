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

template <std::int8_t kSign>
std::int32_t counts_after(int forward, int backward) {
  Quadrature encoder{};
  std::size_t at = 0;
  for (int i = 0; i < forward + backward; ++i) {
    at = i < forward ? at + 1 : at - 1;
    take_edge<kSign>(encoder, kForward[at % 4]);
    if (i % 30'000 == 0) extended_counts(encoder);
  }
  EXPECT_EQ(encoder.missed, 0);
  return extended_counts(encoder);
}

TEST(Quadrature, CountsFarBothWays) {
  EXPECT_EQ(counts_after<1>(200'000, 0), 200'000);
  EXPECT_EQ(counts_after<1>(200'000, 300'000), -100'000);
  EXPECT_EQ(counts_after<-1>(200'000, 300'000), 100'000);
}

TEST(Quadrature, WhatChangesBothPhasesIsAMissedEdgeAndNotCounted) {
  Quadrature encoder{};
  take_edge<1>(encoder, 3);
  take_edge<1>(encoder, 0);
  EXPECT_EQ(encoder.missed, 2);
  EXPECT_EQ(extended_counts(encoder), 0);
}

}  // namespace
}  // namespace tp100::firmware
