#include "sim/faults/sensor_faults.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>

#include "core/time.h"
#include "firmware/quadrature.h"
#include "sim/sensors/mpu6050.h"
#include "sim/sensors/quadrature_encoder.h"

namespace tp100::sim {
namespace {

struct Counts {
  int left, right;
  std::int64_t truly;
};

// What a board counts while both tracks drive at 0.1 m/s for a second.
Counts counted(const std::string& fault) {
  const course::EmulatedEncoder values{};
  QuadratureEncoder left(values, 0, 1), right(values, 2, 2);
  EncoderFaults faults({parse_fault(fault)});
  std::array<firmware::Quadrature, 2> counters{};
  std::int64_t last_ns = 0;
  for (std::int64_t ms = 0; ms < 1000; ++ms) {
    std::vector<EncoderEdge> edges;
    left.move(1e-4, ms * kNsPerMs, (ms + 1) * kNsPerMs, edges);
    right.move(1e-4, ms * kNsPerMs, (ms + 1) * kNsPerMs, edges);
    std::stable_sort(edges.begin(), edges.end(),
                     [](const EncoderEdge& a, const EncoderEdge& b) { return a.at_ns < b.at_ns; });
    faults.pass(edges, ms * kNsPerMs, 0);
    for (const EncoderEdge& edge : edges) {
      EXPECT_GE(edge.at_ns, last_ns);
      last_ns = edge.at_ns;
      firmware::Quadrature& counter = counters[edge.channel / 2U];
      const unsigned bit = 1U << edge.channel % 2U;
      const unsigned phase = edge.level ? counter.phase | bit : counter.phase & ~bit;
      firmware::take_edge<1>(counter, static_cast<std::uint8_t>(phase));
    }
  }
  EXPECT_EQ(counters[0].missed + counters[1].missed, 0) << "both phases changed at once";
  return {firmware::extended_counts(counters[0]), firmware::extended_counts(counters[1]),
          left.counts()};
}

// What the board counts of the true counts of each side.
TEST(EncoderFaults, ChangeTheCountsOfTheirSideAtTheirTime) {
  struct Case {
    std::string fault;
    double left, right, jump = 0.0;
  };
  const Case cases[] = {
      {"encoder-stuck:left@0.5", 0.5, 1.0},
      {"encoder-stuck", 0.0, 0.0},
      // A dead phase leaves a count that goes to and fro.
      {"encoder-silent:left@0.5", 0.5, 1.0},
      {"encoder-lose:left:0", 1.0, 1.0},
      {"encoder-lose:left:0.3", 0.7, 1.0},
      {"encoder-lose:left:0.95", 0.05, 1.0},
      {"encoder-lose:left:1", 0.0, 1.0},
      {"encoder-lose:0.5@0.25+0.5", 0.75, 0.75},
      {"encoder-flip:right", 1.0, -1.0},
      {"encoder-jump:left:400@0.3", 1.0, 1.0, 400.0},
      {"encoder-jump:left:-1000@0.3", 1.0, 1.0, -1000.0},
  };
  for (const Case& each : cases) {
    SCOPED_TRACE(each.fault);
    const Counts all = counted(each.fault);
    const auto truly = static_cast<double>(all.truly);
    EXPECT_NEAR(all.left, truly * each.left + each.jump, 2.0);
    EXPECT_NEAR(all.right, truly * each.right, 2.0);
  }
}

class ImuFaultsTest : public ::testing::Test {
 protected:
  std::vector<std::uint8_t> burst() {
    const std::uint8_t at = 0x3B;
    std::vector<std::uint8_t> bytes(14);
    if (!bus_.write({&at, 1}) || !bus_.read(bytes)) bytes.clear();
    return bytes;
  }
  Mpu6050 imu_{course::EmulatedImu{}, 1};
  ImuFaults bus_{imu_};
};

TEST_F(ImuFaultsTest, AMissingOneDoesNotAcknowledge) {
  EXPECT_EQ(burst().size(), 14u);
  bus_.set_missing(true);
  EXPECT_TRUE(burst().empty());
  bus_.set_missing(false);
  EXPECT_EQ(burst().size(), 14u);
}

TEST_F(ImuFaultsTest, ASaturatedOneIsAtFullScaleButForItsTemperature) {
  const std::vector<std::uint8_t> before = burst();
  bus_.set_saturated(true);
  const std::vector<std::uint8_t> after = burst();
  for (const std::size_t i : {0u, 2u, 4u, 8u, 10u, 12u}) {
    EXPECT_EQ(after[i], 0x7F) << i;
    EXPECT_EQ(after[i + 1], 0xFF) << i;
  }
  EXPECT_EQ(after[6], before[6]);
  EXPECT_EQ(after[7], before[7]);
}

}  // namespace
}  // namespace tp100::sim
