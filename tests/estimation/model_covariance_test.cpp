#include "estimation/model_covariance.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include "core/arithmetic.h"
#include "interval.h"
#include "model/track_model.h"
#include "turned_covariance.h"

namespace tp100::estimation {
namespace {

constexpr double kDriveMps = 0.15;
constexpr double kDistancePerStepM = kDriveMps * kDt;
constexpr double kBaseM = 0.27;
constexpr double kFloorM = 0.3;

model::TrackParameters robot() {
  model::TrackParameters tracks;
  tracks.wheelbase_m = tracks.wheelbase_medium_m = tracks.wheelbase_tight_m =
      tracks.wheelbase_spin_m = kBaseM;
  return tracks;
}

/// Half the slip difference along a floor, correlated over kFloorM.
class Floor {
 public:
  Floor(double sd, std::mt19937_64& random) : sd_(sd), random_(random) { slip_ = sd_ * normal(); }
  double after(double distance_m) {
    const double kept = std::exp(-distance_m / kFloorM);
    slip_ = slip_ * kept + sd_ * std::sqrt(1.0 - kept * kept) * normal();
    return slip_;
  }

 private:
  double normal() { return normal_(random_); }

  double sd_;
  std::mt19937_64& random_;
  std::normal_distribution<double> normal_{};
  double slip_ = 0.0;
};

/// The standard deviation of a slip difference with that density, correlated over kFloorM.
double sd_of(const FloorSlip& slip) { return std::sqrt(slip.slip_density_m() / (2.0 * kFloorM)); }

/// What FloorSlip finds of a floor on a straight line. The tracks' turn is quantized by edges.
double found_sd(double floor_sd, double edge_m, double length_m, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  Floor floor(floor_sd, random);
  FilterParameters noise;
  noise.edge_m = edge_m;
  FloorSlip slip(noise);
  std::normal_distribution<double> normal;
  double left_m = 0.0005, right_m = 0.0;
  const auto counted = [edge_m](double m) {
    return edge_m > 0.0 ? edge_m * std::floor(m / edge_m) : m;
  };
  for (double driven_m = 0.0; driven_m < length_m; driven_m += kDistancePerStepM) {
    // The controller keeps the robot straight, so that the tracks turn by what the floor takes.
    const double differs_m = floor.after(kDistancePerStepM) * kDistancePerStepM;
    const double left_before_m = counted(left_m), right_before_m = counted(right_m);
    left_m += kDistancePerStepM + differs_m;
    right_m += kDistancePerStepM - differs_m;
    const double left = counted(left_m) - left_before_m, right = counted(right_m) - right_before_m;
    slip.add(kDt, (left + right) / 2.0, (right - left) / kBaseM,
             noise.gyro_sd_rad_rts * std::sqrt(kDt) * normal(random), kBaseM);
  }
  return sd_of(slip);
}

TEST(FloorSlip, FindsHowUnevenAFloorIs) {
  for (const double sd : {0.003, 0.007, 0.015}) {
    std::vector<double> found;
    for (std::uint64_t seed = 1; seed <= 40; ++seed)
      found.push_back(found_sd(sd, 1.0 / 11140.0, 4.0, seed));
    std::ranges::sort(found);
    EXPECT_NEAR(found[20], sd, 0.3 * sd);
    EXPECT_GT(found.front(), 0.3 * sd);
    EXPECT_LT(found.back(), 2.0 * sd);
  }
}

TEST(FloorSlip, FindsAnEvenFloorWithinAMetreWithFineAndCoarseEncoders) {
  for (const double edge_m : {1.0 / 11140.0, 1.0 / 300.0})
    for (std::uint64_t seed = 1; seed <= 40; ++seed)
      EXPECT_LT(found_sd(0.0, edge_m, edge_m > 0.001 ? 3.0 : 1.0, seed), 0.0025) << edge_m;
}

TEST(FloorSlip, AStandingRobotShowsNothing) {
  FloorSlip slip{FilterParameters{}};
  const double before = sd_of(slip);
  for (int i = 0; i < 1000; ++i) slip.add(kDt, 0.0, 0.0, 0.01 * kDt, kBaseM);
  for (int i = 0; i < 70; ++i) slip.add(kDt, kDistancePerStepM, 0.0, 0.0, kBaseM);
  EXPECT_LT(sd_of(slip), 0.55 * before);
}

TEST(FloorSlip, ADisturbanceDoesNotMakeAFloorRough) {
  FloorSlip slip{FilterParameters{}};
  const auto metres = [&](double length_m) {
    for (double m = 0.0; m < length_m; m += kDistancePerStepM)
      slip.add(kDt, kDistancePerStepM, 0.0, 0.0, kBaseM);
  };
  metres(2.0);
  slip.add(kDt, kDistancePerStepM, 0.0, 0.25, kBaseM);
  metres(0.1);
  EXPECT_LT(sd_of(slip), 0.004);
}

/// Share of the time that a true pose is within two standard deviations of the model's.
struct Shares {
  double position = 0.0;  ///< x and y, each counted by itself
  double yaw = 0.0;
};
/// Over robots that drive 1 m, turn left on the spot and drive 1 m.
Shares within_2_sd(double floor_sd) {
  constexpr int kRobots = 200;
  Shares shares;
  std::mt19937_64 random(7);
  std::normal_distribution<double> normal;
  const FilterParameters noise;
  for (int one = 0; one < kRobots; ++one) {
    Floor floor(floor_sd, random);
    ModelCovariance covariance(robot(), noise);
    covariance.begin();
    Pose model, truth{.x_m = noise.start_sd_m * normal(random),
                      .y_m = noise.start_sd_m * normal(random),
                      .yaw_rad = noise.start_sd_rad * normal(random)};
    const double wheelbase = 1.0 + noise.wheelbase_sd * normal(random);
    double common = noise.slip_sd * normal(random);
    const double kept = std::exp(-kDt / noise.slip_s);
    int steps = 0;
    Shares of_one;
    const auto drive = [&](double left_mps, double right_mps, double duration_s) {
      for (double s = 0.0; s < duration_s; s += kDt) {
        const double speed = (left_mps + right_mps) / 2.0;
        const double rate = (right_mps - left_mps) / kBaseM;
        const double true_rate = rate * wheelbase + 2.0 / kBaseM * speed * floor.after(speed * kDt);
        common = common * kept + noise.slip_sd * std::sqrt(1.0 - kept * kept) * normal(random);
        const Pose before = model;
        model::advance(model, {.vx_mps = speed, .yaw_rate_radps = rate}, kDt);
        model::advance(truth, {.vx_mps = speed * (1.0 - common), .yaw_rate_radps = true_rate}, kDt);
        Motion motion{.dt_s = kDt, .tracks = {left_mps, right_mps}, .gyro = true};
        motion.shape = model::turn_shape(left_mps, right_mps);
        motion.gyro_z_radps = true_rate + 0.01;
        covariance.advance(before, model, motion, 0.01);
        const PlanarCovariance p = covariance.pose();
        const auto inside = [](double error, double variance) {
          return square(error) <= 4.0 * variance ? 1.0 : 0.0;
        };
        of_one.position +=
            0.5 * (inside(model.x_m - truth.x_m, p.xx) + inside(model.y_m - truth.y_m, p.yy));
        of_one.yaw += inside(model.yaw_rad - truth.yaw_rad, p.yaw_yaw);
        ++steps;
      }
    };
    drive(kDriveMps, kDriveMps, 1.0 / kDriveMps);
    drive(-kDriveMps, kDriveMps, kPi / 2.0 * kBaseM / (2.0 * kDriveMps));
    drive(kDriveMps, kDriveMps, 1.0 / kDriveMps);
    shares.position += of_one.position / steps / kRobots;
    shares.yaw += of_one.yaw / steps / kRobots;
  }
  return shares;
}

TEST(ModelCovariance, HoldsTheTruthOnFloorsOfEveryKind) {
  for (const double floor_sd : {0.0, 0.003, 0.007, 0.012}) {
    const Shares shares = within_2_sd(floor_sd);
    EXPECT_GT(shares.position, 0.90) << floor_sd;
    EXPECT_LT(shares.position, 0.99) << floor_sd;
    EXPECT_GT(shares.yaw, 0.90) << floor_sd;
    EXPECT_LT(shares.yaw, 0.99) << floor_sd;
  }
}

/// `length_m` ahead from `start`.
void drive(ModelCovariance& covariance, const Pose& start, double length_m, const Motion& motion) {
  Pose pose = start;
  for (double m = 0.0; m < length_m; m += kDistancePerStepM) {
    const Pose before = pose;
    model::advance(pose, {.vx_mps = kDriveMps}, kDt);
    covariance.advance(before, pose, motion, 0.0);
  }
}
void drive_a_metre(ModelCovariance& covariance, const Pose& start) {
  drive(covariance, start, 1.0, {.dt_s = kDt, .tracks = {kDriveMps, kDriveMps}});
}
/// The same over a floor that turns the robot.
void drive_on_a_floor(ModelCovariance& covariance, double length_m, double gyro_z_radps) {
  drive(
      covariance, {}, length_m,
      {.dt_s = kDt, .tracks = {kDriveMps, kDriveMps}, .gyro_z_radps = gyro_z_radps, .gyro = true});
}

TEST(ModelCovariance, TurnsWithTheRobot) {
  ModelCovariance ahead(robot(), {}), left(robot(), {});
  drive_a_metre(ahead, {});
  drive_a_metre(left, {.yaw_rad = kPi / 2.0});
  const PlanarCovariance pose = ahead.pose(), turned = left.pose();
  expect_turned_left(turned, pose);
  EXPECT_GT(pose.y_yaw, 0.0);
}

TEST(ModelCovariance, AnUncertainDistanceLiesAlongTheChordOfATurn) {
  ModelCovariance covariance(robot(), {});
  const double turn_rad = 0.6;
  // Half of the turn to either side of the x axis, along which the robot thus moves.
  covariance.advance({.yaw_rad = -turn_rad / 2.0}, {.x_m = 0.1, .yaw_rad = turn_rad / 2.0},
                     {.dt_s = kDt, .ground = {.hold_slip = true}}, 0.0);
  EXPECT_GT(covariance.pose().xx, 2.0 * covariance.pose().yy);
  EXPECT_NEAR(covariance.pose().xy, 0.0, 1e-12);
}

TEST(ModelCovariance, ARunBeginsAsTheRobotIsPlacedAndAnInterruptionAddsToIt) {
  const FilterParameters noise;
  ModelCovariance covariance(robot(), noise);
  drive_a_metre(covariance, {});
  ASSERT_GT(covariance.pose().yy, 2.0 * square(noise.start_sd_m));
  covariance.begin();
  EXPECT_EQ(covariance.pose().yy, square(noise.start_sd_m));
  covariance.interrupt();
  EXPECT_EQ(covariance.pose().yy, square(noise.start_sd_m) + square(noise.disturbed_sd_m));
  EXPECT_EQ(covariance.pose().yaw_yaw, square(noise.start_sd_rad) + square(noise.disturbed_sd_rad));
}

TEST(ModelCovariance, IsCarriedFromTheStartAsARunBegins) {
  ModelCovariance begun(robot(), {}), carried(robot(), {});
  drive_a_metre(begun, {});
  drive_on_a_floor(begun, 0.03, 0.02);
  carried.resume(begun.carried_from_start());
  begun.begin();
  EXPECT_EQ(carried.carried().errors, begun.carried().errors);
  EXPECT_EQ(carried.carried().slip_density_m, begun.carried().slip_density_m);
  // What was seen of the floor just before is part of neither.
  for (ModelCovariance* covariance : {&begun, &carried}) drive_on_a_floor(*covariance, 0.06, 0.01);
  EXPECT_EQ(carried.carried().errors, begun.carried().errors);
  EXPECT_EQ(carried.carried().slip_density_m, begun.carried().slip_density_m);
}

TEST(ModelCovariance, GoesOnFromWhatWasCarried) {
  ModelCovariance covariance(robot(), {}), again(robot(), {});
  drive_on_a_floor(covariance, 0.3, 0.02);
  drive_a_metre(covariance, {});
  again.resume(covariance.carried());
  EXPECT_EQ(again.pose().yy, covariance.pose().yy);
  drive_a_metre(covariance, {.x_m = 1.0});
  drive_a_metre(again, {.x_m = 1.0});
  drive_on_a_floor(covariance, 0.1, 0.0);
  drive_on_a_floor(again, 0.1, 0.0);
  EXPECT_EQ(again.pose().yy, covariance.pose().yy);
  EXPECT_EQ(again.carried().slip_density_m, covariance.carried().slip_density_m);
}

}  // namespace
}  // namespace tp100::estimation
