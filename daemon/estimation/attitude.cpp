#include "estimation/attitude.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/arithmetic.h"

namespace tp100::estimation {
namespace {

double roll_of(const AttitudeFilter::Vector& a) { return std::atan2(a[1], a[2]); }
double pitch_of(const AttitudeFilter::Vector& a) {
  return std::atan2(-a[0], magnitude(a[1], a[2]));
}
// 80 mg, the worst case of the MPU6050's data sheet; a steeper standstill is a slope.
constexpr double kWorstOffsetRad = 4.6 * kRadPerDeg;
// Faster than this, the robot is being tilted.
constexpr double kTiltingRadps = 0.05;
constexpr double kFirstS = 0.2;
// Gravity counts over longer times, the gyro over shorter ones; a deviation beyond this share of
// gravity is not gravity. Offsets are learned over kLevelS.
constexpr double kGravityS = 0.7, kSteadyShare = 0.1, kLevelS = 5.0;
// Near the vertical the heading is undefined.
constexpr double kMinCosPitch = 0.2;

constexpr AttitudeFilter::Vector kUpright{0.0, 0.0, kStandardGravityMps2};

double norm(const AttitudeFilter::Vector& a) { return magnitude(a[0], a[1], a[2]); }

// A slope begins and ends at these angles, once that has lasted.
constexpr double kEnterSlopeRad = 4.0 * kRadPerDeg, kLeaveSlopeRad = 2.5 * kRadPerDeg;
constexpr double kSlopeLastsS = 0.12;

// A body tilted by less counts as level: noise and offset of the pitch.
constexpr double kLevelRad = 2.0 * kRadPerDeg;
// Steeper than a ramp of 34 deg, less steep than any riser and edge climbed so far.
constexpr double kStepSine = 0.56;
// After this distance uphill a ramp is certain.
constexpr double kJudgedM = 0.04;
// Greatest distance over the top of an obstacle, from the end of its up side to its down side.
constexpr double kTopM = 0.6;
constexpr double kMarkM = 0.001;

}  // namespace

bool AttitudeFilter::looks_level(const Vector& gyro_radps, const Vector& accel_mps2) const {
  if (std::abs(roll_of(accel_mps2)) > kWorstOffsetRad ||
      std::abs(pitch_of(accel_mps2)) > kWorstOffsetRad)
    return false;
  if (levelled_s_ < kFirstS) return true;
  return std::abs(gyro_radps[0] - gyro_offset_[0]) < kTiltingRadps &&
         std::abs(gyro_radps[1] - gyro_offset_[1]) < kTiltingRadps;
}

void AttitudeFilter::level(const Vector& gyro_radps, const Vector& accel_mps2, double dt_s) {
  if (dt_s <= 0.0 || !looks_level(gyro_radps, accel_mps2)) return;
  // A plain mean at first, then one that forgets.
  levelled_s_ = std::min(levelled_s_ + dt_s, kLevelS);
  const double share = dt_s / levelled_s_;
  for (std::size_t i = 0; i < 3; ++i) {
    gyro_offset_[i] += (gyro_radps[i] - gyro_offset_[i]) * share;
    accel_offset_[i] += (accel_mps2[i] - kUpright[i] - accel_offset_[i]) * share;
  }
}

void AttitudeFilter::resume(const CarriedAttitude& state) {
  *this = {};
  levelled_s_ = state.levelled_s;
  gyro_offset_ = state.gyro_offset_radps;
  accel_offset_ = state.accel_offset_mps2;
  roll_rad_ = state.roll_rad;
  pitch_rad_ = state.pitch_rad;
}

void AttitudeFilter::update(const Vector& gyro_radps, const Vector& accel_mps2, double dt_s) {
  const double wx = gyro_radps[0] - gyro_offset_[0];
  const double wy = gyro_radps[1] - gyro_offset_[1];
  const double wz = gyro_radps[2] - gyro_offset_[2];
  const double cr = std::cos(roll_rad_), sr = std::sin(roll_rad_);
  // Turning while tilted turns pitch into roll and back.
  body_y_radps_ = wy;
  const double pitch_rate = cr * wy - sr * wz;
  const double roll_rate = wx + std::tan(pitch_rad_) * (sr * wy + cr * wz);
  roll_rad_ += roll_rate * dt_s;
  pitch_rad_ += pitch_rate * dt_s;
  Vector force = accel_mps2;
  for (std::size_t i = 0; i < 3; ++i) force[i] -= accel_offset_[i];
  if (std::abs(norm(force) - kStandardGravityMps2) > kSteadyShare * kStandardGravityMps2) return;
  const double share = dt_s / (kGravityS + dt_s);
  roll_rad_ += (roll_of(force) - roll_rad_) * share;
  pitch_rad_ += (pitch_of(force) - pitch_rad_) * share;
}

double AttitudeFilter::yaw_rate_radps(double body_z_radps) const {
  return (std::sin(roll_rad_) * body_y_radps_ + std::cos(roll_rad_) * body_z_radps) /
         std::max(std::cos(pitch_rad_), kMinCosPitch);
}

Slope SlopeState::update(double pitch_rad, double dt_s) {
  const double steep = std::abs(pitch_rad);
  const Slope side = pitch_rad < 0.0 ? Slope::kUp : Slope::kDown;
  Slope seen = Slope::kFlat;
  if (steep > kEnterSlopeRad || (side == state_ && steep > kLeaveSlopeRad)) seen = side;
  if (seen == state_) {
    lasted_s_ = 0.0;
    candidate_ = seen;
    return state_;
  }
  lasted_s_ = seen == candidate_ ? lasted_s_ + dt_s : dt_s;
  candidate_ = seen;
  if (lasted_s_ >= kSlopeLastsS) {
    state_ = seen;
    lasted_s_ = 0.0;
  }
  return state_;
}

void ObstacleState::climb(double nose_up_rad, double distance_m) {
  since_mark_m_ += distance_m;
  if (since_mark_m_ < kMarkM) return;
  since_mark_m_ = std::fmod(since_mark_m_, kMarkM);
  const double sine = std::sin(nose_up_rad);
  double& oldest = sines_[marks_ % kMarks];
  if (marks_ >= kMarks)
    steepest_ = std::max(steepest_, axle_spacing_m_ * (sine - oldest) / (kMarks * kMarkM));
  oldest = sine;
  ++marks_;
}

ObstacleClass ObstacleState::update(double pitch_rad, Slope slope, double distance_m) {
  const double nose_up = -pitch_rad;
  level_m_ += std::abs(distance_m);
  up_m_ += std::abs(distance_m);
  if (slope == Slope::kFlat && nose_up < kLevelRad) steepest_ = 0.0;
  climb(nose_up, std::abs(distance_m));
  const Slope before = std::exchange(slope_, slope);
  if (slope == Slope::kFlat) {
    if (before != Slope::kFlat) level_m_ = 0.0;
    return state_ = ObstacleClass::kNone;
  }
  const ObstacleClass risen = steepest_ > kStepSine ? ObstacleClass::kBlock : ObstacleClass::kRamp;
  if (slope == Slope::kUp && before == Slope::kFlat) {
    up_m_ = 0.0;
    state_ = last_ = risen;
  } else if (slope == Slope::kUp && up_m_ < kJudgedM && risen == ObstacleClass::kBlock) {
    state_ = last_ = risen;
  } else if (before == Slope::kFlat) {
    state_ = level_m_ < kTopM && last_ != ObstacleClass::kNone ? last_ : ObstacleClass::kRamp;
  }
  return state_;
}

}  // namespace tp100::estimation
