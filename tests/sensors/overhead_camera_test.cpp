#include "sim/sensors/overhead_camera.h"

#include <gtest/gtest.h>

#include <cmath>
#include <sstream>
#include <vector>

#include "core/arithmetic.h"

namespace tp100::sim {
namespace {

struct Taken {
  CameraSample sample;
  std::int64_t arrived_ns;
};

std::vector<Taken> watch(const course::EmulatedCamera& values, const Pose& pose, double duration_s,
                         std::uint64_t seed = 1) {
  OverheadCamera camera(values, 0.0, 0.0, seed);
  std::vector<Taken> taken;
  for (std::int64_t now = 0; now < from_s(duration_s); now += kNsPerMs) {
    camera.look(pose, now);
    while (const auto sample = camera.take(now)) taken.push_back({*sample, now});
  }
  return taken;
}

course::EmulatedCamera perfect() {
  course::EmulatedCamera values;
  values.noise_m = values.noise_rad = values.bias_m = values.dropped = values.stamp_error_s = 0.0;
  return values;
}

TEST(OverheadCamera, SeesARobotOnTheFloorWhereItIs) {
  const Pose pose{.x_m = 0.7, .y_m = -0.4, .yaw_rad = 2.0};
  const Taken taken = watch(perfect(), pose, 1.0).back();
  EXPECT_NEAR(taken.sample.x_m, 0.7, 1e-12);
  EXPECT_NEAR(taken.sample.y_m, -0.4, 1e-12);
  EXPECT_NEAR(taken.sample.yaw_rad, 2.0, 1e-12);
}

TEST(OverheadCamera, ALensErrorGrowsWithTheCubeOfTheDistance) {
  course::EmulatedCamera values = perfect();
  values.distortion = 0.02;
  const double near_m = watch(values, {.x_m = 0.5}, 1.0).back().sample.x_m - 0.5;
  EXPECT_NEAR(near_m, 0.02 * 0.5 * (0.5 * 0.5) / (2.5 * 2.5), 1e-9);
  EXPECT_NEAR(watch(values, {.x_m = 1.0}, 1.0).back().sample.x_m - 1.0, 8.0 * near_m, 1e-9);
}

TEST(OverheadCamera, SeesNothingOutsideItsViewAndStampsTooLate) {
  course::EmulatedCamera values = perfect();
  values.view_m = 1.0;
  EXPECT_TRUE(watch(values, {.x_m = 1.01}, 1.0).empty());
  const std::vector<Taken> punctual = watch(values, {.x_m = 0.99}, 1.0);
  ASSERT_FALSE(punctual.empty());
  values.stamp_lag_s = 0.02;
  EXPECT_EQ(watch(values, {.x_m = 0.99}, 1.0).at(0).sample.measured_ns,
            punctual.at(0).sample.measured_ns + from_s(0.02));
}

TEST(OverheadCamera, ReportsAtItsRateLateInOrderAndWithGaps) {
  const std::vector<Taken> taken = watch({}, {}, 100.0);
  EXPECT_NEAR(static_cast<double>(taken.size()), 3300 * 0.97, 40.0);
  double delay_s = 0.0;
  for (std::size_t i = 0; i < taken.size(); ++i) {
    delay_s += to_s(taken[i].arrived_ns - taken[i].sample.measured_ns);
    if (i > 0) {
      EXPECT_GT(taken[i].sample.sequence, taken[i - 1].sample.sequence);
    }
  }
  EXPECT_NEAR(delay_s / static_cast<double>(taken.size()), 0.060, 0.002);
}

TEST(OverheadCamera, HasTheNoiseAndTheLastingErrorThatItsValuesSay) {
  const std::vector<Taken> taken = watch({}, {}, 200.0);
  const auto n = static_cast<double>(taken.size());
  double x = 0, y = 0, xx = 0, yaw = 0, yaw2 = 0;
  for (const Taken& t : taken) {
    x += t.sample.x_m;
    y += t.sample.y_m;
    xx += t.sample.x_m * t.sample.x_m;
    yaw += t.sample.yaw_rad;
    yaw2 += t.sample.yaw_rad * t.sample.yaw_rad;
  }
  EXPECT_NEAR(std::hypot(x, y) / n, 0.0015, 0.0002);
  EXPECT_NEAR(std::sqrt(xx / n - x * x / n / n), 0.0015, 0.0001);
  EXPECT_NEAR(std::sqrt(yaw2 / n) * kDegPerRad, 0.4, 0.02);
  EXPECT_NEAR(yaw / n, 0.0, 1e-3);
}

TEST(OverheadCamera, APitchedMarkerFallsBackAndARaisedOneLooksFurtherOut) {
  const Pose tilted{.pitch_rad = -28.0 * kRadPerDeg};
  EXPECT_NEAR(watch(perfect(), tilted, 0.5).back().sample.x_m, -0.028, 0.0005);
  const Pose raised{.x_m = 1.2, .z_m = 0.08};
  EXPECT_NEAR(watch(perfect(), raised, 0.5).back().sample.x_m, 1.2 * 2.44 / 2.36, 1e-9);
  const Pose rolled{.roll_rad = 10.0 * kRadPerDeg};
  EXPECT_LT(watch(perfect(), rolled, 0.5).back().sample.y_m, -0.010);
}

// The front of a marker that is pitched down is further from the camera than its back, so that
// beside the camera's axis the marker seems turned.
TEST(OverheadCamera, APitchedMarkerBesideTheAxisSeemsTurned) {
  const course::EmulatedCamera values = perfect();
  const Pose pose{.x_m = 0.8, .y_m = 0.6, .pitch_rad = 20.0 * kRadPerDeg};
  const double up_m = values.marker_height_m, to_floor_m = values.height_m - up_m;
  const auto image = [&](double ahead_m) {
    const double s = std::sin(pose.pitch_rad), c = std::cos(pose.pitch_rad);
    const double stretch = to_floor_m / (values.height_m + s * ahead_m - c * up_m);
    return std::pair{(pose.x_m + c * ahead_m + s * up_m) * stretch, pose.y_m * stretch};
  };
  const auto [front_x, front_y] = image(values.marker_size_m / 2.0);
  const auto [back_x, back_y] = image(-values.marker_size_m / 2.0);
  const double yaw_rad = std::atan2(front_y - back_y, front_x - back_x);
  EXPECT_GT(std::abs(yaw_rad), 0.02);
  EXPECT_NEAR(watch(values, pose, 0.5).back().sample.yaw_rad, yaw_rad, 1e-9);
}

TEST(OverheadCamera, OutliersAreFarOff) {
  course::EmulatedCamera values = perfect();
  values.outliers = 0.1;
  int far = 0;
  const std::vector<Taken> taken = watch(values, {}, 60.0);
  for (const Taken& t : taken) far += std::hypot(t.sample.x_m, t.sample.y_m) > 0.01;
  EXPECT_NEAR(static_cast<double>(far) / static_cast<double>(taken.size()), 0.1, 0.03);
}

TEST(OverheadCamera, TheSameSeedGivesTheSameImages) {
  const auto text = [](std::uint64_t seed) {
    std::ostringstream out;
    out.precision(17);
    for (const Taken& t : watch({}, {}, 2.0, seed))
      out << t.sample.x_m << ' ' << t.sample.measured_ns << ' ' << t.arrived_ns << '\n';
    return out.str();
  };
  EXPECT_EQ(text(1), text(1));
  EXPECT_NE(text(1), text(2));
}

}  // namespace
}  // namespace tp100::sim
