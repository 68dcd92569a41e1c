#include "identify/manoeuvres.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>
#include <variant>

#include "core/arithmetic.h"
#include "text/format.h"

namespace tp100::identify {
namespace {

using course::Arc;
using course::Line;
using course::OtherPath;
using course::Pivot;

// Candidates. Radii in parts of the wheelbase, so that the slower track has 0.1, 0.3, 0.45, 0.6 and
// 0.8 of the faster one's speed.
constexpr std::array kRadii = {0.65, 0.95, 1.3, 2.0, 4.0};
constexpr std::array kArcDeg = {45.0, 90.0, 180.0};
constexpr std::array kSpinDeg = {180.0, 360.0};
constexpr std::array kLengthsM = {0.4, 0.8, 1.2};
constexpr double kBackM = 0.6;
constexpr double kSlowMps = 0.10, kFastMps = 0.15;
constexpr std::array kLeadDeg = {0.0, 45.0, -45.0, 90.0, -90.0, 135.0, -135.0, 180.0};
constexpr double kLongestArcM = 2.0;

// How the tracking controller drives them, as far as it matters here.
constexpr double kAccelerationMps2 = 0.15;
constexpr double kPivotRadps = 0.6, kPivotRadps2 = 1.5;
constexpr double kBetweenS = 0.4;  // between segments with a pivot
constexpr double kQuietS = 0.6;    // before the tracks move, so that the gyro's bias is known

/// Segments one after the other, in a name's words.
void add(std::vector<OtherPath>& all, const std::string& name, double speed_mps,
         std::vector<course::Segment> path) {
  OtherPath& other = all.emplace_back();
  other.name = name;
  other.speed_mps = speed_mps;
  other.identifies = true;
  other.path = std::move(path);
}

std::vector<OtherPath> without_lead(double wheelbase_m) {
  std::vector<OtherPath> all;
  for (const double length_m : kLengthsM)
    for (const double mps : {kSlowMps, kFastMps})
      add(all, text::format("straight-%.1fm-%.2fmps", length_m, mps), mps, {Line{length_m}});
  add(all, "out-and-back", kSlowMps, {Line{kBackM}, Pivot{kPi}, Line{kBackM}});
  for (const double parts : kRadii) {
    const double radius_m = std::round(parts * wheelbase_m * 100.0) / 100.0;
    for (const double deg : kArcDeg) {
      const double rad = deg * kRadPerDeg;
      if (radius_m * rad > kLongestArcM) continue;
      for (const double side : {1.0, -1.0}) {
        const char* const to = side > 0.0 ? "left" : "right";
        add(all, text::format("arc-%.2fm-%.0fdeg-%s", radius_m, deg, to), kSlowMps,
            {Arc{radius_m, side * rad}});
        add(all, text::format("bends-%.2fm-%.0fdeg-%s", radius_m, deg, to), kSlowMps,
            {Arc{radius_m, side * rad}, Arc{radius_m, -side * rad}});
      }
    }
  }
  return all;
}

bool on_the_spot(const course::Segment& segment) { return std::holds_alternative<Pivot>(segment); }

}  // namespace

std::vector<OtherPath> candidate_manoeuvres(double wheelbase_m) {
  std::vector<OtherPath> all;
  for (const double deg : kSpinDeg)
    for (const double side : {1.0, -1.0})
      add(all, text::format("spin-%.0fdeg-%s", deg, side > 0.0 ? "left" : "right"), kSlowMps,
          {Pivot{side * deg * kRadPerDeg}});
  const std::vector<OtherPath> base = without_lead(wheelbase_m);
  for (const double deg : kLeadDeg) {
    for (OtherPath other : base) {
      if (deg != 0.0) {
        other.name = text::format("turn-%.0fdeg-", deg) + other.name;
        other.path.insert(other.path.begin(), Pivot{deg * kRadPerDeg});
      }
      all.push_back(std::move(other));
    }
  }
  return all;
}

ManoeuvreMotion::ManoeuvreMotion(double speed_mps, const std::vector<course::Segment>& path)
    : speed_mps_(speed_mps) {
  still(kQuietS);
  for (std::size_t i = 0; i < path.size(); ++i) {
    const bool from_rest = i == 0 || on_the_spot(path[i]) || on_the_spot(path[i - 1]);
    const bool to_rest = i + 1 == path.size() || on_the_spot(path[i]) || on_the_spot(path[i + 1]);
    if (i > 0 && from_rest) still(kBetweenS);
    along(path[i], from_rest, to_rest);
  }
  moving_s_ = static_cast<double>(steps_.size()) * kStepS - kQuietS;
  still(kQuietS);
}

void ManoeuvreMotion::still(double duration_s) {
  steps_.insert(steps_.end(), static_cast<std::size_t>(std::lround(duration_s / kStepS)), {});
}

// Speed is a trapezoid over the length; the steps add up to the length.
void ManoeuvreMotion::along(const course::Segment& segment, bool from_rest, bool to_rest) {
  double length = length_of(segment), most = speed_mps_, acceleration = kAccelerationMps2;
  MotionStep unit{1.0, 0.0};
  if (const auto* pivot = std::get_if<Pivot>(&segment)) {
    length = std::abs(pivot->angle_rad);
    most = kPivotRadps;
    acceleration = kPivotRadps2;
    unit = {0.0, std::copysign(1.0, pivot->angle_rad)};
  } else if (const auto* arc = std::get_if<Arc>(&segment)) {
    unit.radps = std::copysign(1.0 / arc->radius_m, arc->angle_rad);
  }
  double done = 0.0;
  while (length - done > 1e-9) {
    const double up =
        from_rest ? std::sqrt(2.0 * acceleration * done) + acceleration * kStepS : most;
    const double down =
        to_rest ? std::max(std::sqrt(2.0 * acceleration * (length - done)), 0.1 * most) : most;
    const double speed = std::min({most, up, down, (length - done) / kStepS});
    steps_.push_back({unit.mps * speed, unit.radps * speed});
    done += speed * kStepS;
  }
}

}  // namespace tp100::identify
