#include "estimation/model_covariance.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <random>
#include <utility>
#include <vector>

#include "any_motion.h"
#include "core/arithmetic.h"
#include "interval.h"
#include "model/track_model.h"

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

// Half of a slip difference d over a way s turns the robot by 2 d s over the wheelbase. Gyro, edges
// and the error of the wheelbase explain a part of what is seen. Slip counts as even over 0.6 m.
TEST(FloorSlip, APieceShowsTheSlipBeyondWhatTheSensorsExplain) {
  FilterParameters noise;
  noise.wheelbase_sd = 0.05;
  noise.gyro_sd_rad_rts = 0.003;
  noise.edge_m = 1.9e-4;  // a piece has 300 edges
  FloorSlip slip(noise);
  double density = 2e-5, seen_m = 0.02;
  EXPECT_EQ(slip.slip_density_m(), density);
  for (int i = 0; i < 50; ++i) {
    const double beyond_rad = i % 4 == 3 ? 0.2 : 0.004 * (i % 4), way_m = 0.03 + 0.0005 * i;
    slip.add(0.2, way_m, 0.04, 0.04 + beyond_rad, kBaseM);
    EXPECT_EQ(slip.seen_m(), seen_m) << "too short";
    slip.add(0.3, way_m, -0.06, -0.06, kBaseM);
    const double explained =
        square(0.05 * -0.02) + square(1.9e-4 / kBaseM) / 3.0 + square(0.003) * 0.5;
    const double squares = (square(beyond_rad) - explained) * square(kBaseM / (2.0 * 2.0 * way_m));
    seen_m = std::min(seen_m + 2.0 * way_m, 2.0);
    density += (std::min(squares, square(0.02)) * 0.6 - density) * 2.0 * way_m / seen_m;
    EXPECT_NEAR(slip.seen_m(), seen_m, 1e-12);
    EXPECT_NEAR(slip.slip_density_m(), std::max(density, 0.0), 1e-12) << i;
  }
}

TEST(FloorSlip, ARobotThatPausedWithinAPieceBeginsItAnew) {
  for (const auto& [pause_s, kept] : {std::pair{3.0, true}, std::pair{3.2, false}}) {
    FloorSlip slip{FilterParameters{}};
    slip.add(0.2, 0.026, 0.0, 0.0, kBaseM);
    slip.add(pause_s, 0.001, 0.0, 0.0, kBaseM);  // 1.5 s and 27 mm at 15 mm/s are 3.3 s
    slip.add(0.2, 0.025, 0.0, 0.0, kBaseM);
    EXPECT_EQ(slip.seen_m() > 0.02, kept);
  }
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

using Errors = Eigen::Matrix<double, 5, 5>;

// The errors of x, y, yaw, slip and wheelbase move with the robot: a wrong yaw swings the way, slip
// shortens it, and a wrong wheelbase is a share of the turn.
TEST(ModelCovariance, AnIntervalMovesTheErrorsAndAddsItsNoise) {
  AnyMotion any(9);
  FilterParameters noise;
  noise.slip_s = 0.3;
  for (int i = 0; i < 300; ++i) {
    ModelCovariance covariance(uneven_tracks(), noise);
    CarriedModelCovariance carried{.slip_density_m = 3e-4, .seen_m = 0.5};
    const Errors before = any.covariance().topLeftCorner<5, 5>();
    Eigen::Map<Errors>(carried.errors.data()) = before;
    covariance.resume(carried);
    const Motion motion = any.motion(false);
    const Pose from{.x_m = 1.0, .y_m = 2.0, .yaw_rad = any.between(-7.0, 7.0)};
    const double dx = any.between(-0.03, 0.03), dy = any.between(-0.03, 0.03);
    const double turn = any.between(-0.2, 0.2), way = std::hypot(dx, dy);
    covariance.advance(from, {.x_m = 1.0 + dx, .y_m = 2.0 + dy, .yaw_rad = from.yaw_rad + turn},
                       motion, 0.0);
    const double kept = kept_slip(noise, motion);
    Errors f = Errors::Identity();
    f.topRightCorner<2, 3>() << -dy, -dx, 0.0, dx, -dy, 0.0;
    f(2, 4) = turn;
    f(3, 3) = kept;
    Errors after = f * before * f.transpose();
    const ShiftVariance shift = shift_variance(noise, way, turn, motion);
    const double ahead = from.yaw_rad + turn / 2.0;
    const Eigen::Vector2d along(std::cos(ahead), std::sin(ahead)), across(-along[1], along[0]);
    after.topLeftCorner<2, 2>() +=
        shift.along_m2 * along * along.transpose() + shift.across_m2 * across * across.transpose();
    const double wheelbase_m = MotionModel(uneven_tracks(), noise).turn_of(motion).wheelbase_m;
    after(2, 2) += square(2.0 / wheelbase_m) * 3e-4 * way;
    after(3, 3) += square(noise.slip_sd) * (1.0 - square(kept));
    const CarriedModelCovariance is = covariance.carried();
    ASSERT_LT((Eigen::Map<const Errors>(is.errors.data()) - after).cwiseAbs().maxCoeff(), 1e-12);
    ASSERT_NEAR(covariance.pose().x_yaw, after(0, 2), 1e-12);
    ASSERT_NEAR(covariance.pose().yaw_yaw, after(2, 2), 1e-12);
  }
}

TEST(ModelCovariance, OnlyUndisturbedDrivingStraightOnLevelGroundShowsTheFloor) {
  const auto seen_m = [](const Motion& motion) {
    ModelCovariance covariance(robot(), {});
    drive(covariance, {}, 0.3, motion);
    return covariance.carried().seen_m;
  };
  Motion motion{.dt_s = kDt, .tracks = {kDriveMps, kDriveMps}, .gyro_z_radps = 0.1, .gyro = true};
  EXPECT_GT(seen_m(motion), 0.2);
  motion.shape.curved = 0.59;
  EXPECT_GT(seen_m(motion), 0.2);
  motion.shape.curved = 0.61;
  EXPECT_EQ(seen_m(motion), 0.02);
  motion.shape.curved = 0.0;
  for (const auto& change : {std::function<void(Motion&)>([](Motion& m) { m.gyro = false; }),
                             {[](Motion& m) { m.disturbed = true; }},
                             {[](Motion& m) { m.ground.pitch_rad = 0.1; }}}) {
    Motion changed = motion;
    change(changed);
    EXPECT_EQ(seen_m(changed), 0.02);
  }
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
