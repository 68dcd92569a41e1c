// The emulated overhead camera, and detections of a real one.

#include "sim/sensors/overhead_camera.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <fstream>
#include <vector>

#include "../support/temporary_folder.h"
#include "core/arithmetic.h"
#include "core/time.h"
#include "sim/sensors/detections.h"
#include "support/refusal.h"

namespace tp100::sim {
namespace {

struct Taken {
  CameraSample sample;
  std::int64_t arrived_ns;
};

std::vector<Taken> watch(const course::EmulatedCamera& values, const Pose& pose,
                         double duration_s) {
  OverheadCamera camera(values, 0.0, 0.0, 1);
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

// The front of a marker that is pitched down is further from the camera than its back, so that
// beside the camera's axis the marker seems turned.
TEST(OverheadCamera, SeesTheMarkerOfARaisedAndTiltedRobotInPerspective) {
  const course::EmulatedCamera values = perfect();
  const double up_m = values.marker_height_m, to_floor_m = values.height_m - up_m;
  for (const double roll : {0.0, 0.17}) {
    for (const double pitch : {0.0, -0.49, 0.35}) {
      const Pose pose{.x_m = 0.8,
                      .y_m = 0.6,
                      .z_m = 0.08,
                      .roll_rad = roll,
                      .pitch_rad = pitch,
                      .yaw_rad = 2.0};
      const Eigen::Vector3d at(pose.x_m, pose.y_m, pose.z_m);
      const Eigen::Matrix3d turned = (Eigen::AngleAxisd(2.0, Eigen::Vector3d::UnitZ()) *
                                      Eigen::AngleAxisd(pitch, Eigen::Vector3d::UnitY()) *
                                      Eigen::AngleAxisd(roll, Eigen::Vector3d::UnitX()))
                                         .toRotationMatrix();
      const auto image = [&](double ahead_m) -> Eigen::Vector2d {
        const Eigen::Vector3d point = at + turned * Eigen::Vector3d(ahead_m, 0.0, up_m);
        return point.head<2>() * to_floor_m / (values.height_m - point.z());
      };
      const Eigen::Vector2d along =
          image(values.marker_size_m / 2.0) - image(-values.marker_size_m / 2.0);
      const CameraSample seen = watch(values, pose, 0.5).back().sample;
      EXPECT_NEAR(seen.x_m, image(0.0).x(), 1e-9) << roll << ' ' << pitch;
      EXPECT_NEAR(seen.y_m, image(0.0).y(), 1e-9) << roll << ' ' << pitch;
      EXPECT_NEAR(seen.yaw_rad, std::atan2(along.y(), along.x()), 1e-9) << roll << ' ' << pitch;
    }
  }
}

TEST(OverheadCamera, OutliersAreFarOff) {
  course::EmulatedCamera values = perfect();
  values.outliers = 0.1;
  int far = 0;
  const std::vector<Taken> taken = watch(values, {}, 60.0);
  for (const Taken& t : taken) far += std::hypot(t.sample.x_m, t.sample.y_m) > 0.01;
  EXPECT_NEAR(static_cast<double>(far) / static_cast<double>(taken.size()), 0.1, 0.03);
}

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
  EXPECT_THAT(problem("# nothing\n"), HasSubstr("expected"));
  EXPECT_THAT(problem("0.5 1 2 0 0 0 0\n"), HasSubstr("found.tum:1: 7 values in 8 columns"));
  EXPECT_THAT(problem("0.5 nan 2 0 0 0 0 1\n"), HasSubstr("tx_m is 'nan'"));
  EXPECT_THAT(problem("0.5 1e9 2 0 0 0 0 1\n"), HasSubstr("farther than 1000 m"));
  EXPECT_THAT(problem("1.7e9 0 0 0 0 0 0 1\n"), HasSubstr("times from the start"));
  EXPECT_THAT(problem("1 0 0 0 0 0 0 1\n1 0 0 0 0 0 0 1\n"), HasSubstr(":2: t_s is 1, not after"));
}

TEST_F(Detections, WithARotationThatIsNoneOrHasWFirstAreRefused) {
  for (const char* rotation : {"0 0 0 0", "0 0 0 2", "1 0 0 0", "0.924 0 0 0.383"})
    EXPECT_THAT(problem("0.5 1 2 0 " + std::string(rotation) + "\n"),
                HasSubstr("found.tum:1: the quaternion has not length 1, or turns the robot over"))
        << rotation;
}

TEST_F(Detections, OfOtherProgramsAreRead) {
  for (const char* text :
       {"\xef\xbb\xbf"
        "0.5 1 2 0 0 0 0 1\r\n",
        "0.5,1,2,0,0,0,0,1\n", "timestamp tx ty tz qx qy qz qw\n0.5 1 2 0 0 0 0 1\n",
        "0,5;1,0;2,0;0;0;0;0;1\n", "#timestamp [s],tx,ty\n0.5\t1\t2\t0\t0\t0\t0\t1\n"})
    EXPECT_EQ(read(text).at(0).y_m, 2.0) << text;
}

}  // namespace
}  // namespace tp100::sim
