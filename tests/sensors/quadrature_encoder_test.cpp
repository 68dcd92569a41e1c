#include "sim/sensors/quadrature_encoder.h"

#include <gtest/gtest.h>

#include <random>
#include <vector>

#include "firmware/quadrature.h"

namespace tp100::sim {
namespace {

TEST(QuadratureEncoder, EdgesDecodeToTheTravelUnderAnySpeedProfile) {
  for (const std::uint64_t seed : {1u, 2u, 3u, 4u}) {
    std::mt19937_64 random(seed);
    std::uniform_real_distribution<double> speed(-0.25, 0.25);
    course::EmulatedEncoder values;
    values.phase_error = 0.3;
    QuadratureEncoder encoder(values, 2, seed);
    firmware::Quadrature counter{};
    double travel = 0.0;
    std::int64_t last_ns = 0;
    for (int ms = 0; ms < 3000; ++ms) {
      const double step_m = speed(random) * 1e-3;
      travel += step_m;
      std::vector<EncoderEdge> edges;
      encoder.move(step_m, ms * 1'000'000LL, (ms + 1) * 1'000'000LL, edges);
      for (const EncoderEdge& edge : edges) {
        ASSERT_GE(edge.at_ns, last_ns);
        ASSERT_LE(edge.at_ns, (ms + 1) * 1'000'000LL);
        ASSERT_GE(edge.channel, 2);
        last_ns = edge.at_ns;
        const unsigned bit = 1U << edge.channel % 2U;
        ASSERT_NE((counter.phase & bit) != 0, edge.level) << "an edge must change its level";
        firmware::take_edge<1>(counter, static_cast<std::uint8_t>(counter.phase ^ bit));
      }
    }
    EXPECT_EQ(firmware::extended_counts(counter), encoder.counts());
    EXPECT_NEAR(static_cast<double>(encoder.counts()), travel * values.counts_per_metre, 1.5);
  }
}

TEST(QuadratureEncoder, ForwardIsALeadingB) {
  QuadratureEncoder encoder({}, 0, 1);
  std::vector<EncoderEdge> edges;
  encoder.move(4.0 / 11140.0, 0, 1'000'000, edges);
  ASSERT_EQ(edges.size(), 4u);
  EXPECT_EQ(edges[0].channel, 0);
  EXPECT_TRUE(edges[0].level);
  EXPECT_EQ(edges[1].channel, 1);
  EXPECT_TRUE(edges[1].level);
}

}  // namespace
}  // namespace tp100::sim
