#include "sim/lab/slope_figures.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "core/arithmetic.h"

namespace tp100::sim {
namespace {

constexpr double kOnSlopeRad = 4.0 * kRadPerDeg;
constexpr double kLastsS = 0.2;
// Longest delay of a state behind the body that still belongs to the same change.
constexpr double kBelongsS = 1.0;
// Both ends of the tracks stand on a slope that differs from their ramp's by less than this.
constexpr double kOnRampRad = 0.5 * kRadPerDeg;
constexpr double kRobotM = 0.15;
// The obstacle class must be known this long after the body begins to lean.
constexpr double kClassifiedWithinS = 0.5;

Slope slope_of(const Pose& pose) {
  if (std::abs(pose.pitch_rad) <= kOnSlopeRad) return Slope::kFlat;
  return pose.pitch_rad < 0.0 ? Slope::kUp : Slope::kDown;
}

/// Whether a robot at `pose` leans on that obstacle, going by its position.
bool near(const course::Place& place, double length_m, double width_m, const Pose& pose) {
  const double c = std::cos(place.heading_rad), s = std::sin(place.heading_rad);
  const double dx = pose.x_m - place.x_m, dy = pose.y_m - place.y_m;
  return std::abs(c * dx + s * dy) <= length_m / 2.0 + kRobotM &&
         std::abs(c * dy - s * dx) <= width_m / 2.0;
}

const course::Ramp* ramp_at(const course::Terrain& terrain, const Pose& pose) {
  for (const course::Obstacle& obstacle : terrain.obstacles) {
    const auto* ramp = std::get_if<course::Ramp>(&obstacle);
    if (ramp != nullptr && near(ramp->place, ramp->length_m(), ramp->width_m, pose)) return ramp;
  }
  return nullptr;
}

std::vector<SlopeChange> changes_of(const std::vector<report::TrajectoryPoint>& points) {
  std::vector<SlopeChange> changes;
  Slope is = Slope::kFlat;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Slope to = slope_of(points[i].truth);
    if (to == is) continue;
    bool lasts = true;
    for (std::size_t k = i; k < points.size() && points[k].t_s < points[i].t_s + kLastsS; ++k)
      lasts = lasts && slope_of(points[k].truth) == to;
    if (!lasts) continue;
    changes.push_back({.at_s = points[i].t_s, .to = to, .found_s = {}});
    is = to;
  }
  return changes;
}

/// Assigns to every change the first matching state after it; counts the other states.
int match(std::vector<SlopeChange>& changes, const std::vector<report::TrajectoryPoint>& points) {
  int others = 0;
  Slope was = Slope::kFlat;
  for (const report::TrajectoryPoint& point : points) {
    if (point.slope == was) continue;
    was = point.slope;
    const auto mine = std::find_if(changes.begin(), changes.end(), [&](const SlopeChange& change) {
      return change.to == point.slope && !change.found_s && point.t_s >= change.at_s &&
             point.t_s < change.at_s + kBelongsS;
    });
    if (mine == changes.end())
      ++others;
    else
      mine->found_s = point.t_s - mine->at_s;
  }
  return others;
}

void judge_pitch(SlopeFigures& figures, const std::vector<report::TrajectoryPoint>& points,
                 const course::Terrain& terrain) {
  double squares = 0.0;
  std::size_t count = 0;
  for (const report::TrajectoryPoint& point : points) {
    const course::Ramp* ramp = ramp_at(terrain, point.truth);
    const double climb = -point.truth.pitch_rad;
    if (ramp == nullptr || (std::abs(climb - ramp->up_rad) > kOnRampRad &&
                            std::abs(climb + ramp->down_rad) > kOnRampRad))
      continue;
    const double error = std::abs(point.imu_pitch_rad - point.truth.pitch_rad);
    figures.ramp_pitch_max_error_rad = std::max(figures.ramp_pitch_max_error_rad, error);
    squares += error * error;
    ++count;
  }
  if (count > 0) figures.ramp_pitch_rms_error_rad = std::sqrt(squares / static_cast<double>(count));
}

void judge_kinds(SlopeFigures& figures, const std::vector<report::TrajectoryPoint>& points,
                 const course::Terrain& terrain) {
  for (const SlopeChange& change : figures.changes) {
    if (change.to != Slope::kUp || !change.found_s) continue;
    const auto detected =
        std::find_if(points.begin(), points.end(), [&](const report::TrajectoryPoint& point) {
          return point.t_s >= change.at_s + kClassifiedWithinS;
        });
    if (detected == points.end()) continue;
    ++figures.obstacles;
    const ObstacleClass real =
        ramp_at(terrain, detected->truth) != nullptr ? ObstacleClass::kRamp : ObstacleClass::kBlock;
    if (detected->obstacle_class != real) ++figures.mistaken;
  }
}

}  // namespace

SlopeFigures slope_figures(const std::vector<report::TrajectoryPoint>& points,
                           const course::Terrain& terrain) {
  SlopeFigures figures;
  figures.changes = changes_of(points);
  figures.false_changes = match(figures.changes, points);
  judge_pitch(figures, points, terrain);
  judge_kinds(figures, points, terrain);
  return figures;
}

}  // namespace tp100::sim
