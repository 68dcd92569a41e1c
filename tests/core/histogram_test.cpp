#include "core/histogram.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <vector>

namespace tp100 {
namespace {

TEST(Histogram, PercentilesAreWithinOneBucketOfTheExactOnes) {
  std::mt19937_64 random(3);
  for (const double mean : {10.0, 1e3, 50e3, 5e6}) {
    Histogram histogram;
    std::vector<std::int64_t> values;
    std::exponential_distribution<> draw(1.0 / mean);
    for (int i = 0; i < 20000; ++i) {
      values.push_back(static_cast<std::int64_t>(draw(random)));
      histogram.add(values.back());
    }
    std::sort(values.begin(), values.end());
    for (const double p : {0.0, 0.5, 0.9, 0.99, 0.999}) {
      const double exact = static_cast<double>(
          values[static_cast<std::size_t>(p * static_cast<double>(values.size()))]);
      const auto got = static_cast<double>(histogram.percentile(p));
      ASSERT_GE(got, exact) << mean << " " << p;
      ASSERT_LE(got, exact * 1.0626 + 1) << mean << " " << p;
    }
    EXPECT_EQ(histogram.percentile(1.0), static_cast<std::uint64_t>(values.back()));
    EXPECT_EQ(histogram.max(), static_cast<std::uint64_t>(values.back()));
    EXPECT_EQ(histogram.count(), values.size());
  }
}

TEST(Histogram, TakesTheExtremes) {
  Histogram histogram;
  EXPECT_EQ(histogram.percentile(0.5), 0u);
  histogram.add(-5);
  EXPECT_EQ(histogram.percentile(0.5), 0u);
  histogram.add(std::int64_t{1} << 62);
  EXPECT_EQ(histogram.max(), std::uint64_t{1} << 62);
  EXPECT_EQ(histogram.count(), 2u);
}

}  // namespace
}  // namespace tp100
