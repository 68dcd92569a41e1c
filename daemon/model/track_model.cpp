#include "model/track_model.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <span>

#include "core/arithmetic.h"

namespace tp100::model {
namespace {

// Difference of the tracks' speeds relative to the faster one, where friction begins to saturate
// and where it is saturated.
constexpr double kWideTurn = 0.45, kTightTurn = 0.65;
// The same where the wheelbase begins to drift, in arcs of medium and tight curvature, and where
// the drift ends.
constexpr double kWideArc = 0.1, kMediumArc = 0.35, kTightArc = 0.65, kSpin = 1.3;

double between(double value, double low, double high) {
  return std::clamp((value - low) / (high - low), 0.0, 1.0);
}

// Steepness of the straight line through the rows.
constexpr double kLeftPerDeg = 0.00222, kRightPerDeg = 0.00362;

Slip interpolated(double deg) {
  std::size_t upper = 1;
  while (upper + 1 < kSlipRows.size() && kSlipRows[upper].slope_deg < deg) ++upper;
  const SlipRow& low = kSlipRows[upper - 1];
  const SlipRow& high = kSlipRows[upper];
  const double share = (deg - low.slope_deg) / (high.slope_deg - low.slope_deg);
  return {std::lerp(low.left, high.left, share), std::lerp(low.right, high.right, share)};
}

/// The robot's own added_slips, at least one.
AddedSlip own_added_slip(const TrackParameters& parameters, double slope_rad) {
  const std::span rows = std::span(parameters.added_slips).first(parameters.slopes);
  const bool one_sided = rows.front().slope_rad * rows.back().slope_rad > 0.0;
  const bool other_side = one_sided && slope_rad * rows.front().slope_rad < 0.0;
  const double slope = other_side ? -slope_rad : slope_rad;
  const AddedSlip level{};
  const AddedSlip *below = nullptr, *above = nullptr;
  const auto take = [&](const AddedSlip& row) {
    if (row.slope_rad <= slope && (below == nullptr || row.slope_rad > below->slope_rad))
      below = &row;
    if (row.slope_rad >= slope && (above == nullptr || row.slope_rad < above->slope_rad))
      above = &row;
  };
  take(level);
  for (const AddedSlip& row : rows) take(row);
  if (below == nullptr && above == nullptr) return level;
  if (below == nullptr) below = above;
  if (above == nullptr) above = below;
  const double share =
      above == below ? 0.0 : (slope - below->slope_rad) / (above->slope_rad - below->slope_rad);
  const double sign = other_side ? -1.0 : 1.0;
  return {slope_rad, sign * std::lerp(below->left, above->left, share),
          sign * std::lerp(below->right, above->right, share)};
}

}  // namespace

TurnShape turn_shape(double left_mps, double right_mps) {
  const double faster = std::max(std::abs(left_mps), std::abs(right_mps));
  if (!(faster > 0.0)) return {};
  const double difference = (right_mps - left_mps) / faster;
  const double turn = std::abs(difference);
  const double creeping = 1.0 - between(turn, kWideTurn, kTightTurn);
  return {std::clamp(difference / kWideTurn, -1.0, 1.0) * creeping,
          between(turn, kWideArc, kMediumArc), between(turn, kMediumArc, kTightArc),
          between(turn, kTightArc, kSpin),
          std::abs(right_mps - left_mps) / (std::abs(left_mps) + std::abs(right_mps))};
}

TurnShape TurnShapeFilter::update(double left_mps, double right_mps, double dt_s) {
  const double share = started_ ? 1.0 - std::exp(-dt_s / lag_s_) : 1.0;
  started_ = true;
  left_mps_ += (left_mps - left_mps_) * share;
  right_mps_ += (right_mps - right_mps_) * share;
  return turn_shape(left_mps_, right_mps_);
}

Slip slip_at_slope(double slope_rad, SlipCurve curve) {
  const double deg = slope_rad * kDegPerRad;
  const double first = kSlipRows.front().slope_deg, last = kSlipRows.back().slope_deg;
  const bool downhill = curve == SlipCurve::kTableDownhill || curve == SlipCurve::kFitDownhill;
  const bool table = curve == SlipCurve::kTable || curve == SlipCurve::kTableDownhill;
  const double lowest = downhill ? -last : first;
  const double held = std::isnan(deg) ? first : std::clamp(deg, lowest, last);
  if (!table) return {0.1557 + kLeftPerDeg * held, 0.1534 + kRightPerDeg * held};
  if (held >= first) return interpolated(held);
  return {kSlipRows[0].left + kLeftPerDeg * held, kSlipRows[0].right + kRightPerDeg * held};
}

AddedSlip added_slip(const TrackParameters& parameters, double slope_rad) {
  if (parameters.slopes > 0) return own_added_slip(parameters, slope_rad);
  const Slip level = slip_at_slope(0.0, parameters.slip_curve);
  const Slip here = slip_at_slope(slope_rad, parameters.slip_curve);
  return {slope_rad, here.left - level.left, here.right - level.right};
}

Slip slip_on(const TrackParameters& parameters, Mode mode, const Incline& incline) {
  Slip slip{parameters.slip_left, parameters.slip_right};
  if (mode == Mode::kPaper || (incline.slope_rad == 0.0 && incline.slip_offset == 0.0)) return slip;
  const AddedSlip added = added_slip(parameters, incline.slope_rad);
  return {std::min(slip.left + added.left + incline.slip_offset, kMaxSlip),
          std::min(slip.right + added.right + incline.slip_offset, kMaxSlip)};
}

Turn turn_of(const TrackParameters& p, Mode mode, const TurnShape& shape) {
  if (mode == Mode::kPaper) return {p.wheelbase_m, 0.0, 0.0, p.slip_angle_turning_rad};
  const double spin_m = p.wheelbase_spin_m == 0.0 ? p.wheelbase_m : p.wheelbase_spin_m;
  const double tight_m = p.wheelbase_tight_m == 0.0 ? spin_m : p.wheelbase_tight_m;
  const double medium_m = p.wheelbase_medium_m == 0.0 ? p.wheelbase_m : p.wheelbase_medium_m;
  const double arc_m =
      std::lerp(std::lerp(p.wheelbase_m, medium_m, shape.medium), tight_m, shape.arc);
  return {std::lerp(arc_m, spin_m, shape.spin), p.x_icr_m + p.x_icr_spin_shift_m * shape.spin,
          p.turn_slip * shape.wide + p.turn_loss * shape.curved, p.slip_angle_turning_rad};
}

double slip_angle_rad(const TrackParameters& parameters, const Turn& turn, double yaw_rate_radps) {
  const bool turning = std::abs(yaw_rate_radps) > parameters.turning_threshold_radps;
  return turning ? turn.slip_angle_rad : parameters.slip_angle_straight_rad;
}

namespace {

// Eqs 2 and 5.
Twist twist_of(const TrackParameters& parameters, Mode mode, const TrackSpeeds& ground,
               const TurnShape& shape) {
  const auto [left, right] = ground;
  const Turn turn = turn_of(parameters, mode, shape);
  Twist twist;
  twist.vx_mps = (right + left) / 2.0 * (1.0 - turn.slip);
  twist.yaw_rate_radps = shared::turn_of<double>({left, right}, turn.wheelbase_m);
  const double slip_angle = slip_angle_rad(parameters, turn, twist.yaw_rate_radps);
  twist.vy_mps = twist.vx_mps * std::tan(slip_angle) - turn.x_icr_m * twist.yaw_rate_radps;
  return twist;
}

}  // namespace

Twist body_twist(const TrackParameters& parameters, Mode mode, double left_mps, double right_mps,
                 const Incline& incline) {
  const TrackSpeeds ground = over_ground({left_mps, right_mps}, slip_on(parameters, mode, incline));
  return twist_of(parameters, mode, ground, turn_shape(ground.left_mps, ground.right_mps));
}

Twist body_twist(const TrackParameters& parameters, Mode mode, double left_mps, double right_mps,
                 const Incline& incline, const TurnShape& shape) {
  return twist_of(parameters, mode,
                  over_ground({left_mps, right_mps}, slip_on(parameters, mode, incline)), shape);
}

void advance(Pose& pose, const Twist& twist, double dt_s, const Incline& incline) {
  const double turn = twist.yaw_rate_radps * dt_s;
  double along = 1.0;
  double across = 0.0;
  if (std::abs(turn) < 1e-4) {
    along = 1.0 - turn * turn / 6.0;
    across = turn / 2.0;
  } else {
    along = std::sin(turn) / turn;
    across = (1.0 - std::cos(turn)) / turn;
  }
  const double forward = twist.vx_mps * incline.horizontal_fraction;
  const double dx = (forward * along - twist.vy_mps * across) * dt_s;
  const double dy = (forward * across + twist.vy_mps * along) * dt_s;
  const double c = std::cos(pose.yaw_rad);
  const double s = std::sin(pose.yaw_rad);
  pose.x_m += c * dx - s * dy;
  pose.y_m += s * dx + c * dy;
  pose.z_m += twist.vx_mps * std::sin(incline.slope_rad) * dt_s;
  pose.pitch_rad = incline.slope_rad == 0.0 ? 0.0 : -incline.slope_rad;
  pose.yaw_rad += turn;
}

const Twist& TrackModel::advance(double left_mps, double right_mps, double dt_s,
                                 const Incline& incline) {
  const Incline under = mode_ == Mode::kPaper ? Incline{} : incline;
  slip_ = slip_on(parameters_, mode_, under);
  const TrackSpeeds ground = over_ground({left_mps, right_mps}, slip_);
  const TurnShape shape = turn_shape_filter_.update(ground.left_mps, ground.right_mps, dt_s);
  twist_ = twist_of(parameters_, mode_, ground, shape);
  model::advance(pose_, twist_, dt_s, under);
  return twist_;
}

}  // namespace tp100::model
