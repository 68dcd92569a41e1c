#include "sim/campaign/summary.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

namespace tp100::sim {
namespace {

TEST(Summary, OfHundredNumbersIsWhatTablesSay) {
  std::vector<double> values;
  for (int i = 100; i >= 1; --i) values.push_back(i);
  const Summary of = summarise(values);
  EXPECT_EQ(of.count, 100u);
  EXPECT_DOUBLE_EQ(of.mean, 50.5);
  EXPECT_NEAR(of.sd, 29.0115, 1e-4);
  EXPECT_EQ(of.least, 1.0);
  EXPECT_EQ(of.most, 100.0);
  ASSERT_EQ(of.percentiles.size(), 4u);
  EXPECT_DOUBLE_EQ(of.percentiles[1].value, 50.5);
  // Order statistics 40 and 61 are the textbook interval of the median of 100 values.
  ASSERT_TRUE(of.percentiles[1].interval.has_value());
  EXPECT_EQ(*of.percentiles[1].interval, std::pair(40.0, 61.0));
  // t(99) = 1.984.
  ASSERT_TRUE(of.mean_interval.has_value());
  EXPECT_NEAR(of.mean_interval->first, 50.5 - 1.984 * 2.90115, 1e-3);
  // A hundred runs are too few for an interval of the 99th percentile.
  EXPECT_FALSE(of.percentiles[3].interval.has_value());
}

TEST(Summary, IntervalsHoldTheTruthAsOftenAsTheySay) {
  std::mt19937 random(7);
  std::exponential_distribution<double> draw(1.0);
  int median_held = 0, p95_held = 0;
  constexpr int kCampaigns = 600;
  for (int i = 0; i < kCampaigns; ++i) {
    std::vector<double> values(200);
    for (double& value : values) value = draw(random);
    const Summary of = summarise(values);
    const auto held = [&](std::size_t at, double truth) {
      return of.percentiles[at].interval->first <= truth &&
             truth <= of.percentiles[at].interval->second;
    };
    median_held += held(1, std::log(2.0)) ? 1 : 0;
    p95_held += held(2, std::log(20.0)) ? 1 : 0;
  }
  EXPECT_GE(median_held, 0.93 * kCampaigns);
  EXPECT_GE(p95_held, 0.93 * kCampaigns);
  EXPECT_LE(median_held, 0.985 * kCampaigns);
}

TEST(Summary, OfNothingAndOfOneClaimsNothing) {
  EXPECT_EQ(summarise({}).count, 0u);
  const Summary one = summarise({3.0});
  EXPECT_EQ(one.mean, 3.0);
  EXPECT_FALSE(one.mean_interval.has_value());
  EXPECT_FALSE(one.percentiles[1].interval.has_value());
}

TEST(Summary, WhatNeverHappenedIsTheLargest) {
  const Summary of = summarise({1.0, std::numeric_limits<double>::infinity(), 2.0});
  EXPECT_FALSE(std::isfinite(of.most));
  EXPECT_EQ(of.percentiles[1].value, 2.0);
  EXPECT_FALSE(of.mean_interval.has_value());
}

TEST(Summary, SharesAreClopperAndPearsons) {
  EXPECT_NEAR(share_interval(8, 10).first, 0.4439, 1e-4);
  EXPECT_NEAR(share_interval(8, 10).second, 0.9748, 1e-4);
  EXPECT_NEAR(share_interval(0, 20).second, 0.1684, 1e-4);
  EXPECT_EQ(share_interval(0, 20).first, 0.0);
  EXPECT_EQ(share_interval(20, 20).second, 1.0);
}

TEST(RankCorrelation, SeesOrderAndNothingElse) {
  EXPECT_NEAR(*rank_correlation({1, 2, 3, 4}, {1, 8, 27, 64}), 1.0, 1e-12);
  EXPECT_NEAR(*rank_correlation({1, 2, 3, 4}, {9, 5, 2, -7}), -1.0, 1e-12);
  EXPECT_NEAR(*rank_correlation({1, 2, 3, 4, 5}, {2, 1, 4, 3, 5}), 0.8, 1e-12);
  EXPECT_FALSE(rank_correlation({1, 2, 3}, {5, 5, 5}).has_value());
  EXPECT_FALSE(rank_correlation({1, 2}, {1, 2}).has_value());
}

}  // namespace
}  // namespace tp100::sim
