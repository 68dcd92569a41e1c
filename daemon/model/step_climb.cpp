#include "model/step_climb.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/arithmetic.h"

namespace tp100::model {
namespace {

constexpr double kFallStepS = 2.5e-4;
constexpr double kMaxFallSteps = 2000.0;
constexpr int kContactHalvings = 40;
constexpr double kTouchRad = 1e-9;
constexpr int kMaxPhases = 24;
constexpr double kEver = std::numeric_limits<double>::infinity();

PlaneVector along(const PlaneVector& from, double forward, double up, double angle) {
  const double s = std::sin(angle), c = std::cos(angle);
  return {from.x + forward * c - up * s, from.z + forward * s + up * c};
}

}  // namespace

StepClimb::StepClimb(const ClimbGeometry& geometry, const BlockShape& block)
    : curve_(geometry, block), gyration_squared_m2_(gyration_squared_m2(geometry)) {
  begin(0.0);
}

void StepClimb::begin(double distance_m) {
  phase_ = ClimbPhase::kApproach;
  travel_m_ = -distance_m;
  fall_ = {0.0, 0.0};
  publish();
}

double StepClimb::touch_x_m() const {
  return curve_.approach(0.0).rear_axle.x + curve_.geometry().axle_spacing_m / 2.0;
}

const ClimbState& StepClimb::advance(double travel_m, double dt_s) {
  if (!(dt_s > 0.0) || !std::isfinite(dt_s) || !std::isfinite(travel_m)) return state_;
  const double speed = travel_m / dt_s;
  if (!std::isfinite(speed)) return state_;
  double time = dt_s;
  for (int i = 0; i < kMaxPhases && time > 0.0; ++i) time = run(speed, time);
  publish();
  return state_;
}

// Runs the present phase for up to `time`; returns the time left when the next phase has begun.
double StepClimb::run(double speed, double time) {
  const ClimbMarks& marks = curve_.marks();
  using enum ClimbPhase;
  switch (phase_) {
    case kApproach:
      return follow(speed, time, -kEver, 0.0, kApproach, marks.riser_end > 0.0 ? kRiser : kWrap);
    case kRiser:
      return follow(speed, time, 0.0, marks.riser_end, kApproach, kWrap);
    case kWrap:
      return follow(speed, time, marks.riser_end, marks.wrap_end,
                    marks.riser_end > 0.0 ? kRiser : kApproach, kCross);
    case kCross:
      return follow(speed, time, marks.wrap_end, cross_end_m(speed, time), kWrap, kTip);
    case kTip:
      return fall(speed, time, Edge::kNear);
    case kFlat:
      return follow(speed, time, marks.flat_begin, marks.flat_end, kTip, kTipOff);
    case kTipOff:
      return fall(speed, time, Edge::kFar);
    case kNose:
      return follow(speed, time, marks.nose_begin, marks.nose_end, kTipOff, kSlideOff);
    case kSlideOff:
      return follow(speed, time, marks.nose_end, marks.slide_end, kNose, kDown);
    case kDown:
      return follow(speed, time, marks.slide_end, kEver, kDown, kDown);
  }
  return 0.0;
}

double StepClimb::follow(double speed, double time, double begin, double end, ClimbPhase before,
                         ClimbPhase after) {
  const double to = travel_m_ + speed * time;
  const bool past_end = speed > 0.0 && to >= end;
  const bool past_begin = speed < 0.0 && to <= begin;
  if (!past_end && !past_begin) {
    travel_m_ = std::clamp(to, begin, end);
    return 0.0;
  }
  const ClimbPhase next = past_end ? after : before;
  const double mark = past_end ? end : begin;
  if (next == phase_) {
    travel_m_ = mark;
    return 0.0;
  }
  const double left = time - (mark - travel_m_) / speed;
  travel_m_ = mark;
  const Lean here = lean();
  // The fall begins with the angle and the rate at the end of the curve.
  fall_ = {here.angle_rad, here.rate_radpm * speed};
  phase_ = next;
  return std::clamp(left, 0.0, time);
}

// True if the rear contact would have to pull to keep the moving body on the curve. It releases a
// little before the centre of mass has passed the edge, at standstill exactly there.
bool StepClimb::lifts_off(double travel_m, double speed) const {
  const double height = curve_.geometry().com_height_m;
  const Lean at = curve_.cross(travel_m);
  const double q = curve_.past_near_edge_m(travel_m);
  const double ahead = q * std::cos(at.angle_rad) - height * std::sin(at.angle_rad);
  const double inertia = gyration_squared_m2_ + q * q + height * height;
  return kStandardGravityMps2 * ahead +
             speed * speed * (2.0 * q * at.rate_radpm + inertia * curve_.cross_bend(travel_m)) >=
         0.0;
}

double StepClimb::cross_end_m(double speed, double time) const {
  const double end = curve_.marks().cross_end;
  const double to = std::min(travel_m_ + speed * time, end);
  if (!(speed > 0.0) || !lifts_off(to, speed)) return end;
  double low = travel_m_, high = to;
  if (lifts_off(low, speed)) return low;
  for (int i = 0; i < kContactHalvings; ++i) {
    const double middle = (low + high) / 2.0;
    (lifts_off(middle, speed) ? high : low) = middle;
  }
  return high;
}

double StepClimb::arm_m(Edge edge) const {
  return edge == Edge::kNear ? curve_.past_near_edge_m(travel_m_)
                             : curve_.past_far_edge_m(travel_m_);
}

// One step of the body's rotation about an edge over which its flat moves: fourth-order
// Runge-Kutta.
StepClimb::Fall StepClimb::fallen(const Fall& from, double arm, double speed, double time) const {
  const double height = curve_.geometry().com_height_m;
  const auto slope = [&](const Fall& y, double at) {
    const double q = arm + speed * at;
    const double ahead = q * std::cos(y.angle) - height * std::sin(y.angle);
    return Fall{y.rate, -(kStandardGravityMps2 * ahead + 2.0 * q * speed * y.rate) /
                            (gyration_squared_m2_ + q * q + height * height)};
  };
  const auto moved = [&](const Fall& k, double h) {
    return Fall{from.angle + h * k.angle, from.rate + h * k.rate};
  };
  const Fall a = slope(from, 0.0);
  const Fall b = slope(moved(a, time / 2.0), time / 2.0);
  const Fall c = slope(moved(b, time / 2.0), time / 2.0);
  const Fall d = slope(moved(c, time), time);
  return {from.angle + time / 6.0 * (a.angle + 2.0 * (b.angle + c.angle) + d.angle),
          from.rate + time / 6.0 * (a.rate + 2.0 * (b.rate + c.rate) + d.rate)};
}

// The phase in which the falling body has landed; the phase of the fall itself while it is in the
// air.
ClimbPhase StepClimb::landed(const Fall& fall, double travel_m, Edge edge) const {
  const ClimbMarks& marks = curve_.marks();
  if (edge == Edge::kNear) {
    if (fall.angle <= 0.0 && fall.rate < 0.0) return ClimbPhase::kFlat;
    const bool back =
        travel_m <= marks.cross_end && fall.angle > curve_.cross(travel_m).angle_rad + kTouchRad;
    return back ? ClimbPhase::kCross : ClimbPhase::kTip;
  }
  if (fall.angle >= 0.0 && fall.rate > 0.0) return ClimbPhase::kFlat;
  const bool ahead = travel_m >= marks.nose_begin && fall.angle <= curve_.nose(travel_m).angle_rad;
  return ahead ? ClimbPhase::kNose : ClimbPhase::kTipOff;
}

// The body may lift off the ground contact but not sink in: where the centre of mass has passed the
// edge but the body still rotates the other way, it stays on its curve until it lifts off.
StepClimb::Fall StepClimb::held_up(const Fall& fall, double travel_m, double speed,
                                   Edge edge) const {
  const bool near = edge == Edge::kNear;
  const Lean curve = near ? curve_.cross(travel_m) : curve_.nose(travel_m);
  const bool sunk = near ? fall.angle > curve.angle_rad : fall.angle < curve.angle_rad;
  return sunk ? Fall{curve.angle_rad, curve.rate_radpm * speed} : fall;
}

double StepClimb::fall(double speed, double time, Edge edge) {
  const ClimbMarks& marks = curve_.marks();
  // Tracks that would carry the edge off the flat spin instead. Forward over the near edge, the
  // edge may leave the flat: the body is about to land on the block.
  const double first =
      edge == Edge::kNear ? marks.wrap_end : marks.wrap_end + curve_.block().depth_m;
  const double last = edge == Edge::kNear ? kEver : marks.nose_end;
  const double step = std::max(kFallStepS, time / kMaxFallSteps);
  while (time > 0.0) {
    const double h = std::min(step, time);
    const double to = travel_m_ + speed * h;
    const double carried = to < first || to > last ? 0.0 : speed;
    const double arm = arm_m(edge);
    const Fall next = fallen(fall_, arm, carried, h);
    if (landed(next, travel_m_ + carried * h, edge) == phase_) {
      travel_m_ += carried * h;
      fall_ = held_up(next, travel_m_, carried, edge);
      time -= h;
      continue;
    }
    double before = 0.0, after = h;
    for (int i = 0; i < kContactHalvings; ++i) {
      const double middle = (before + after) / 2.0;
      const bool still =
          landed(fallen(fall_, arm, carried, middle), travel_m_ + carried * middle, edge) == phase_;
      (still ? before : after) = middle;
    }
    fall_ = fallen(fall_, arm, carried, after);
    travel_m_ += carried * after;
    land(landed(fall_, travel_m_, edge));
    return time - after;
  }
  return 0.0;
}

void StepClimb::land(ClimbPhase phase) {
  const ClimbMarks& marks = curve_.marks();
  const bool from_near = phase_ == ClimbPhase::kTip;
  phase_ = phase;
  if (phase == ClimbPhase::kFlat && from_near && travel_m_ > marks.flat_end) {
    // A block so short that the body lands beyond it swings on: angular momentum about the far
    // edge is kept.
    const double height = curve_.geometry().com_height_m;
    const double near = arm_m(Edge::kNear), far = arm_m(Edge::kFar);
    const double common = gyration_squared_m2_ + height * height;
    fall_ = {0.0, fall_.rate * (common + near * far) / (common + far * far)};
    phase_ = ClimbPhase::kTipOff;
    return;
  }
  if (phase == ClimbPhase::kFlat) {
    travel_m_ = std::clamp(travel_m_, marks.flat_begin, marks.flat_end);
  }
  fall_ = {0.0, 0.0};
}

Lean StepClimb::lean() const {
  using enum ClimbPhase;
  switch (phase_) {
    case kApproach:
      return curve_.approach(travel_m_);
    case kRiser:
      return curve_.riser(travel_m_);
    case kWrap:
      return curve_.wrap(travel_m_);
    case kCross:
      return curve_.cross(travel_m_);
    case kTip:
      return curve_.about_near_edge(travel_m_, fall_.angle);
    case kFlat:
      return curve_.about_near_edge(travel_m_, 0.0);
    case kTipOff:
      return curve_.about_far_edge(travel_m_, fall_.angle);
    case kNose:
      return curve_.nose(travel_m_);
    case kSlideOff:
      return curve_.slide(travel_m_);
    case kDown:
      break;
  }
  return curve_.down(travel_m_);
}

void StepClimb::publish() {
  const ClimbGeometry& geometry = curve_.geometry();
  const Lean at = lean();
  state_.phase = phase_;
  state_.travel_m = travel_m_;
  state_.pitch_rad = at.angle_rad == 0.0 ? 0.0 : -at.angle_rad;
  state_.reference_m =
      along(at.rear_axle, geometry.axle_spacing_m / 2.0, -geometry.wheel_radius_m, at.angle_rad);
}

}  // namespace tp100::model
