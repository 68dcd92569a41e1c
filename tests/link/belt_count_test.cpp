#include "link/belt_count.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <limits>

namespace tp100::link {
namespace {

constexpr double kDtS = 0.005;
constexpr double kMaxPerS = 6000.0;  // 30 counts a sample

TEST(BeltCount, BeginsWithTheBoardsOwnCountAndFollowsIt) {
  BeltCount belt(kMaxPerS);
  EXPECT_TRUE(belt.update(700, 0.0));
  EXPECT_EQ(belt.counts(), 700);
  EXPECT_TRUE(belt.update(710, kDtS));
  EXPECT_TRUE(belt.update(690, kDtS));
  EXPECT_EQ(belt.counts(), 690);
}

TEST(BeltCount, GoesOnBeyondTheWrapOfTheBoards) {
  BeltCount belt(kMaxPerS);
  const std::int32_t last = std::numeric_limits<std::int32_t>::max();
  belt.update(last - 3, 0.0);
  EXPECT_TRUE(belt.update(std::numeric_limits<std::int32_t>::min() + 4, kDtS));
  EXPECT_EQ(belt.counts(), std::int64_t{last} + 5);
}

TEST(BeltCount, AJumpIsLeftOutAndTheBeltGoesOnAsItWent) {
  for (const std::int32_t jump : {125, -125, 500, -30000}) {
    BeltCount belt(kMaxPerS);
    std::int32_t board = 0;
    belt.update(board, 0.0);
    for (int i = 0; i < 20; ++i) belt.update(board += 7, kDtS);
    EXPECT_FALSE(belt.update(board += 7 + jump, kDtS));
    for (int i = 0; i < 20; ++i) EXPECT_TRUE(belt.update(board += 7, kDtS));
    EXPECT_EQ(belt.counts(), 41 * 7);
  }
}

TEST(BeltCount, AJumpThatComesAgainAndAgainIsBelieved) {
  for (const int every : {10, 50, 150}) {
    BeltCount belt(kMaxPerS);
    std::int32_t board = 0;
    belt.update(board, 0.0);
    for (int i = 1; i <= 400; ++i) belt.update(board += 7 + (i % every == 0 ? 40 : 0), kDtS);
    const std::int64_t believed = (belt.counts() - std::int64_t{400 * 7}) / 40;
    EXPECT_GE(believed, 400 / every / 2) << every;
    EXPECT_LT(believed, 400 / every) << every;
  }
}

TEST(BeltCount, RareJumpsAreLeftOutAndSoIsTheirWayBack) {
  BeltCount belt(kMaxPerS);
  std::int32_t board = 0;
  belt.update(board, 0.0);
  for (int i = 1; i <= 2000; ++i) {
    const int jump = i % 210 == 0 ? 500 : i % 210 == 5 && i > 5 ? -500 : 0;
    EXPECT_EQ(belt.update(board += 7 + jump, kDtS), jump == 0) << i;
  }
}

TEST(BeltCount, WhatLastsIsBelieved) {
  BeltCount belt(kMaxPerS);
  std::int32_t board = 0;
  belt.update(board, 0.0);
  int held = 0;
  for (int i = 0; i < 100; ++i) held += belt.update(board += 90, kDtS) ? 0 : 1;
  EXPECT_EQ(held, BeltCount::kHeldInRow);
  EXPECT_EQ(belt.counts(), 90 * (100 - BeltCount::kHeldInRow));
}

TEST(BeltCount, AfterAGapMoreIsPossibleAndNothingIsMadeUp) {
  BeltCount belt(kMaxPerS);
  belt.update(0, 0.0);
  belt.update(20, kDtS);
  EXPECT_TRUE(belt.update(20 + 500, 0.1));
  EXPECT_FALSE(belt.update(20 + 500 + 20000, 2.0));
  EXPECT_EQ(belt.counts(), 520);
}

TEST(BeltCount, WithoutALimitEverythingIsBelieved) {
  BeltCount belt(0.0);
  belt.update(0, 0.0);
  EXPECT_TRUE(belt.update(1'000'000, kDtS));
  EXPECT_EQ(belt.counts(), 1'000'000);
}

}  // namespace
}  // namespace tp100::link
