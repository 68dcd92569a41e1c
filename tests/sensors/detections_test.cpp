#include "sim/sensors/detections.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>

#include "../support/temporary_folder.h"
#include "core/time.h"
#include "support/refusal.h"

namespace tp100::sim {
namespace {

using ::testing::HasSubstr;

class Detections : public testing::Test {
 protected:
  std::vector<CameraSample> read(const std::string& text) const {
    std::ofstream(folder_.file("found.tum")) << text;
    return read_detections(folder_.file("found.tum"));
  }
  std::string problem(const std::string& text) const {
    return test::refusal([&] { read(text); });
  }
  test::TemporaryFolder folder_;
};

TEST_F(Detections, AreSamplesAtTheTimesOfTheirImages) {
  const auto samples = read(
      "# t_s x_m y_m z_m qx qy qz qw\n0.5 1.25 -0.5 0 0 0 0 1\n"
      "0.7 1.5 -0.75 0 0 0 0.382683 0.923880\n");
  ASSERT_EQ(samples.size(), 2U);
  EXPECT_EQ(samples[0].measured_ns, 500 * kNsPerMs);
  EXPECT_EQ(samples[0].x_m, 1.25);
  EXPECT_EQ(samples[0].y_m, -0.5);
  EXPECT_EQ(samples[0].yaw_rad, 0.0);
  EXPECT_NEAR(samples[1].yaw_rad, M_PI / 4, 1e-5);
  EXPECT_GT(samples[1].sequence, samples[0].sequence);
}

TEST_F(Detections, OfAnotherKindOfFileAreRefusedWithTheLine) {
  EXPECT_THAT(problem("# nothing\n"), HasSubstr("no detection"));
  EXPECT_THAT(problem("0.5 1 2 0 0 0 0\n"), HasSubstr("found.tum:1: fewer than 8 numbers"));
  EXPECT_THAT(problem("0.5 nan 2 0 0 0 0 1\n"), HasSubstr("fewer than 8 numbers"));
  EXPECT_THAT(problem("0.5 1e9 2 0 0 0 0 1\n"), HasSubstr("out of range"));
  EXPECT_THAT(problem("1 0 0 0 0 0 0 1\n1 0 0 0 0 0 0 1\n"), HasSubstr(":2: not later"));
}

}  // namespace
}  // namespace tp100::sim
