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

static_assert(std::tuple_size_v<decltype(CarriedModelCovariance::errors)> ==
              (kWheelbaseError + 1) * (kWheelbaseError + 1));

}  // namespace

ModelCovariance::ModelCovariance(const model::TrackParameters& tracks,
                                 const FilterParameters& noise)
    : model_(tracks, noise), covariance_(prior()) {}

ModelCovariance::Matrix ModelCovariance::prior() const {
  const FilterParameters& noise = model_.noise();
  Matrix p = Matrix::Zero();
  add_pose_variance(p, noise.start_sd_m, noise.start_sd_rad);
  p(kSlipError, kSlipError) = square(noise.slip_sd);
  p(kWheelbaseError, kWheelbaseError) = square(noise.wheelbase_sd);
  return p;
}

void ModelCovariance::begin() { covariance_ = prior(); }

void ModelCovariance::interrupt() {
  const FilterParameters& noise = model_.noise();
  add_pose_variance(covariance_, noise.disturbed_sd_m, noise.disturbed_sd_rad);
}

CarriedModelCovariance ModelCovariance::carry(const Matrix& covariance) {
  CarriedModelCovariance carried;
  Eigen::Map<Matrix>(carried.errors.data()) = covariance;
  return carried;
}

CarriedModelCovariance ModelCovariance::carried() const { return carry(covariance_); }

CarriedModelCovariance ModelCovariance::carried_from_start() const { return carry(prior()); }

void ModelCovariance::resume(const CarriedModelCovariance& carried) {
  covariance_ = Eigen::Map<const Matrix>(carried.errors.data());
}

void ModelCovariance::advance(const Pose& before, const Pose& after, const Motion& motion,
                              double slip_variance) {
  const double dx = after.x_m - before.x_m, dy = after.y_m - before.y_m;
  const double turn_rad = after.yaw_rad - before.yaw_rad;
  const double distance_m = magnitude(dx, dy);
  const FilterParameters& noise = model_.noise();
  const double wheelbase_m = model_.turn_of(motion).wheelbase_m;
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
  p(kYaw, kYaw) += square(2.0 / wheelbase_m) * 2.0 * kCorrelationM * slip_variance * distance_m;
  p(kSlipError, kSlipError) += square(noise.slip_sd) * (1.0 - kept * kept);
}

PlanarCovariance ModelCovariance::pose() const { return pose_part(covariance_); }

}  // namespace tp100::estimation
