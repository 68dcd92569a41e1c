#include <gtest/gtest.h>

#include <cstdlib>
#include <limits>

#include "link/sample_intake.h"

namespace tp100::link {
namespace {

constexpr double kDtS = 0.005;
constexpr double kMaxPerS = 6000.0;  // 30 counts per sample

TEST(EncoderCount, BeginsWithTheBoardsOwnCountAndFollowsIt) {
  EncoderCount track(kMaxPerS);
  EXPECT_TRUE(track.update(700, 0.0));
  EXPECT_EQ(track.counts(), 700);
  EXPECT_TRUE(track.update(710, kDtS));
  EXPECT_TRUE(track.update(690, kDtS));
  EXPECT_EQ(track.counts(), 690);
}

TEST(EncoderCount, GoesOnBeyondTheWrapOfTheBoards) {
  EncoderCount track(kMaxPerS);
  const std::int32_t last = std::numeric_limits<std::int32_t>::max();
  track.update(last - 3, 0.0);
  EXPECT_TRUE(track.update(std::numeric_limits<std::int32_t>::min() + 4, kDtS));
  EXPECT_EQ(track.counts(), std::int64_t{last} + 5);
}

TEST(EncoderCount, AJumpIsLeftOutAndTheTrackGoesOnAsItWent) {
  for (const std::int32_t jump : {125, -125, 500, -30000}) {
    EncoderCount track(kMaxPerS);
    std::int32_t board = 0;
    track.update(board, 0.0);
    for (int i = 0; i < 20; ++i) track.update(board += 7, kDtS);
    EXPECT_FALSE(track.update(board += 7 + jump, kDtS));
    for (int i = 0; i < 20; ++i) EXPECT_TRUE(track.update(board += 7, kDtS));
    EXPECT_EQ(track.counts(), 41 * 7);
  }
}

TEST(EncoderCount, AJumpThatComesAgainAndAgainIsAccepted) {
  for (const int every : {10, 50, 150}) {
    EncoderCount track(kMaxPerS);
    std::int32_t board = 0;
    track.update(board, 0.0);
    for (int i = 1; i <= 400; ++i) track.update(board += 7 + (i % every == 0 ? 40 : 0), kDtS);
    const std::int64_t accepted = (track.counts() - std::int64_t{400 * 7}) / 40;
    EXPECT_GE(accepted, 400 / every / 2) << every;
    EXPECT_LT(accepted, 400 / every) << every;
  }
}

TEST(EncoderCount, RareJumpsAreLeftOutAndSoIsTheirWayBack) {
  EncoderCount track(kMaxPerS);
  std::int32_t board = 0;
  track.update(board, 0.0);
  for (int i = 1; i <= 2000; ++i) {
    const int jump = i % 210 == 0 ? 500 : i % 210 == 5 && i > 5 ? -500 : 0;
    EXPECT_EQ(track.update(board += 7 + jump, kDtS), jump == 0) << i;
  }
}

TEST(EncoderCount, WhatLastsIsAccepted) {
  EncoderCount track(kMaxPerS);
  std::int32_t board = 0;
  track.update(board, 0.0);
  int held = 0;
  for (int i = 0; i < 100; ++i) held += track.update(board += 90, kDtS) ? 0 : 1;
  EXPECT_EQ(held, EncoderCount::kHeldInRow);
  EXPECT_EQ(track.counts(), 90 * (100 - EncoderCount::kHeldInRow));
}

TEST(EncoderCount, AfterAGapMoreIsPossibleAndNothingIsMadeUp) {
  EncoderCount track(kMaxPerS);
  track.update(0, 0.0);
  track.update(20, kDtS);
  EXPECT_TRUE(track.update(20 + 500, 0.1));
  EXPECT_FALSE(track.update(20 + 500 + 20000, 2.0));
  EXPECT_EQ(track.counts(), 520);
}

TEST(EncoderCount, TheTimeBetweenTwoSamplesLimitsTheirCounts) {
  LinkCounters counters{};
  SampleIntake intake(counters, kMaxPerS);
  intake.begin(true);
  wire::Sample sample{};
  const auto push = [&](int step) {
    ++sample.sequence;
    sample.left_counts += step;
    intake.push(sample, 5000 * sample.sequence, ClockState{}, 0);
    return counters.implausible;
  };
  push(0);
  EXPECT_EQ(push(30), 0U);
  EXPECT_EQ(push(40), 1U);
}

TEST(EncoderCount, WithoutALimitEverythingIsAccepted) {
  EncoderCount track(0.0);
  track.update(0, 0.0);
  EXPECT_TRUE(track.update(1'000'000, kDtS));
  EXPECT_EQ(track.counts(), 1'000'000);
}

}  // namespace
}  // namespace tp100::link
