#include "estimation/model_covariance.h"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "core/arithmetic.h"

namespace tp100::estimation {
namespace {

// After those of the pose.
constexpr Eigen::Index kSlipError = kYaw + 1, kWheelbaseError = kYaw + 2;

// Slip varies along a floor, correlated over about this distance.
constexpr double kCorrelationM = 0.3;
constexpr double kPieceM = 0.05;
constexpr double kPieceEdges = 300.0;
constexpr double kForgottenM = 2.0;
// A robot that takes longer than this, and than slow driving does, has stopped in a piece.
constexpr double kPauseS = 1.5;
constexpr double kSlowestMps = 0.015;
// In tighter turns, see TurnShape::curved, the error of the wheelbase hides the slip.
constexpr double kTightest = 0.6;
// A larger difference is no floor: the robot was turned from outside.
constexpr double kMostSlip = 0.02;

static_assert(std::tuple_size_v<decltype(CarriedModelCovariance::errors)> ==
              (kWheelbaseError + 1) * (kWheelbaseError + 1));

}  // namespace

void FloorSlip::add(double dt_s, double distance_m, double turn_rad, double gyro_turn_rad,
                    double wheelbase_m) {
  piece_.duration_s += dt_s;
  piece_.distance_m += distance_m;
  piece_.turn_rad += turn_rad;
  piece_.gyro_turn_rad += gyro_turn_rad;
  // A piece begins with the first edge: a standing robot shows the error of its gyro's bias.
  if (piece_.distance_m == 0.0 || piece_.duration_s > kPauseS + piece_.distance_m / kSlowestMps)
    return skip();
  if (piece_.distance_m < std::max(kPieceM, kPieceEdges * noise_.edge_m)) return;
  // Each track begins and ends a piece between two edges.
  const double explained_rad2 = square(noise_.wheelbase_sd * piece_.turn_rad) +
                                square(noise_.edge_m / wheelbase_m) / 3.0 +
                                square(noise_.gyro_sd_rad_rts) * piece_.duration_s;
  const double mean_square = (square(piece_.gyro_turn_rad - piece_.turn_rad) - explained_rad2) *
                             square(wheelbase_m / (2.0 * piece_.distance_m));
  const double slip_density_m =
      std::min(mean_square, square(kMostSlip)) * std::max(piece_.distance_m, 2.0 * kCorrelationM);
  seen_m_ = std::min(seen_m_ + piece_.distance_m, kForgottenM);
  slip_density_m_ += (slip_density_m - slip_density_m_) * piece_.distance_m / seen_m_;
  skip();
}

ModelCovariance::ModelCovariance(const model::TrackParameters& tracks,
                                 const FilterParameters& noise)
    : model_(tracks, noise), covariance_(prior()), floor_slip_(noise) {}

ModelCovariance::Matrix ModelCovariance::prior() const {
  const FilterParameters& noise = model_.noise();
  Matrix p = Matrix::Zero();
  add_pose_variance(p, noise.start_sd_m, noise.start_sd_rad);
  p(kSlipError, kSlipError) = square(noise.slip_sd);
  p(kWheelbaseError, kWheelbaseError) = square(noise.wheelbase_sd);
  return p;
}

void ModelCovariance::begin() {
  covariance_ = prior();
  floor_slip_.skip();
}

void ModelCovariance::interrupt() {
  const FilterParameters& noise = model_.noise();
  add_pose_variance(covariance_, noise.disturbed_sd_m, noise.disturbed_sd_rad);
  floor_slip_.skip();
}

CarriedModelCovariance ModelCovariance::carry(const Matrix& covariance) const {
  CarriedModelCovariance carried;
  Eigen::Map<Matrix>(carried.errors.data()) = covariance;
  carried.slip_density_m = floor_slip_.slip_density_m();
  carried.seen_m = floor_slip_.seen_m();
  return carried;
}

CarriedModelCovariance ModelCovariance::carried() const { return carry(covariance_); }

CarriedModelCovariance ModelCovariance::carried_from_start() const { return carry(prior()); }

void ModelCovariance::resume(const CarriedModelCovariance& carried) {
  covariance_ = Eigen::Map<const Matrix>(carried.errors.data());
  floor_slip_ = FloorSlip(model_.noise(), carried.slip_density_m, carried.seen_m);
}

void ModelCovariance::compare_with_gyro(double distance_m, double turn_rad, double wheelbase_m,
                                        const Motion& motion, double gyro_bias_radps) {
  if (!motion.gyro || motion.disturbed || !shows_slip(motion.ground) ||
      motion.shape.curved > kTightest)
    return floor_slip_.skip();
  floor_slip_.add(motion.dt_s, distance_m, turn_rad,
                  (motion.gyro_z_radps - gyro_bias_radps) * motion.dt_s, wheelbase_m);
}

void ModelCovariance::advance(const Pose& before, const Pose& after, const Motion& motion,
                              double gyro_bias_radps) {
  const double dx = after.x_m - before.x_m, dy = after.y_m - before.y_m;
  const double turn_rad = after.yaw_rad - before.yaw_rad;
  const double distance_m = magnitude(dx, dy);
  const FilterParameters& noise = model_.noise();
  const double wheelbase_m = model_.turn_of(motion).wheelbase_m;
  compare_with_gyro(distance_m, turn_rad, wheelbase_m, motion, gyro_bias_radps);
  const double kept = kept_slip(noise, motion);

  // F P F^T with an F of few elements: its product with P, and that with the result transposed.
  const auto moved = [&](Matrix m) {
    m.row(kX) -= dy * m.row(kYaw) + dx * m.row(kSlipError);
    m.row(kY) += dx * m.row(kYaw) - dy * m.row(kSlipError);
    // The turn follows from the difference of the tracks, not from their common slip, whose part in
    // it is an error of the wheelbase.
    m.row(kYaw) += turn_rad * m.row(kWheelbaseError);
    m.row(kSlipError) *= kept;
    return m;
  };

  const double middle = before.yaw_rad + turn_rad / 2.0;
  const double c = std::cos(middle), s = std::sin(middle);
  Matrix& p = covariance_;
  p = moved(moved(p).transpose());
  add_shift(p, shift_variance(noise, distance_m, turn_rad, motion), c, s);
  p(kYaw, kYaw) += square(2.0 / wheelbase_m) * floor_slip_.slip_density_m() * distance_m;
  p(kSlipError, kSlipError) += square(noise.slip_sd) * (1.0 - kept * kept);
}

PlanarCovariance ModelCovariance::pose() const { return pose_part(covariance_); }

}  // namespace tp100::estimation
