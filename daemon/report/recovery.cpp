#include "report/recovery.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "core/angle.h"

namespace tp100::report {
namespace {

constexpr double kRecoveredM = 0.01;
constexpr double kRecoveredRad = 3.0 * kRadPerDeg;
constexpr double kRecoveredForS = 0.5;
// A push is noticed at the latest when a camera has seen it twice.
constexpr double kNoticedWithinS = 0.5;

/// Points of one push: from its begin to the next one's.
struct Window {
  std::size_t begin = 0, end = 0;
};

Window window_of(const std::vector<TrackPoint>& points, double begin_s, double end_s) {
  const auto before = [](const TrackPoint& point, double t_s) { return point.t_s < t_s; };
  const auto first = std::lower_bound(points.begin(), points.end(), begin_s, before);
  const auto last = std::lower_bound(first, points.end(), end_s, before);
  return {static_cast<std::size_t>(first - points.begin()),
          static_cast<std::size_t>(last - points.begin())};
}

/// First and last point of the half second inside; `window.end` twice if there is none.
Window settled(const std::vector<TrackPoint>& points, const std::vector<Deviation>& deviations,
               const Window& window, double pushed_until_s) {
  std::size_t since = window.end;
  for (std::size_t i = window.begin; i < window.end; ++i) {
    if (points[i].t_s < pushed_until_s) continue;
    if (deviations[i].cross_track_m > kRecoveredM || deviations[i].yaw_rad > kRecoveredRad) {
      since = window.end;
      continue;
    }
    if (since == window.end) since = i;
    if (points[i].t_s - points[since].t_s >= kRecoveredForS) return {since, i};
  }
  return {window.end, window.end};
}

Recovery recovery(const std::vector<TrackPoint>& points, const std::vector<Deviation>& deviations,
                  const ShoveWindow& shove, const Window& window) {
  Recovery result;
  result.begin_s = shove.begin_s;
  const Window back = settled(points, deviations, window, shove.end_s);
  if (back.begin != window.end) result.settling_s = points[back.begin].t_s - shove.end_s;

  bool pushed_left = false;
  for (std::size_t i = window.begin; i < back.begin; ++i) {
    if (points[i].recovering && !result.detection_s)
      result.detection_s = points[i].t_s - shove.begin_s;
    if (deviations[i].cross_track_m > result.peak_cross_track_m) pushed_left = deviations[i].left;
    result.peak_cross_track_m = std::max(result.peak_cross_track_m, deviations[i].cross_track_m);
    result.peak_yaw_error_rad = std::max(result.peak_yaw_error_rad, deviations[i].yaw_rad);
  }
  const std::size_t last = std::min(back.end, window.end - 1);
  double driven_m = 0.0;
  for (std::size_t i = window.begin; i <= last; ++i) {
    if (points[i].t_s > shove.end_s && deviations[i].left != pushed_left)
      result.overshoot_m = std::max(result.overshoot_m, deviations[i].cross_track_m);
    if (i > window.begin)
      driven_m += std::hypot(points[i].world.x_m - points[i - 1].world.x_m,
                             points[i].world.y_m - points[i - 1].world.y_m);
  }
  const double gained_m = points[last].progress_m - points[window.begin].progress_m;
  result.shortcut_m = std::max(0.0, gained_m - driven_m);
  return result;
}

}  // namespace

std::vector<Recovery> recoveries(const std::vector<TrackPoint>& points,
                                 const std::vector<Deviation>& deviations,
                                 const std::vector<ShoveWindow>& shoves) {
  std::vector<Recovery> result;
  for (std::size_t i = 0; i < shoves.size(); ++i) {
    const double until_s = i + 1 < shoves.size() ? shoves[i + 1].begin_s : HUGE_VAL;
    const Window window = window_of(points, shoves[i].begin_s, until_s);
    result.push_back(window.begin == window.end ? Recovery{.begin_s = shoves[i].begin_s}
                                                : recovery(points, deviations, shoves[i], window));
  }
  return result;
}

int false_alarms(const std::vector<TrackPoint>& points, const std::vector<ShoveWindow>& shoves) {
  int count = 0;
  bool before = false;
  for (const TrackPoint& point : points) {
    const bool pushed = std::any_of(shoves.begin(), shoves.end(), [&](const ShoveWindow& shove) {
      return point.t_s >= shove.begin_s && point.t_s <= shove.end_s + kNoticedWithinS;
    });
    if (point.recovering && !before && !pushed) ++count;
    before = point.recovering;
  }
  return count;
}

}  // namespace tp100::report
