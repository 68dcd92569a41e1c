#pragma once
// How far along the path the robot is: which segment, and where in it.

#include <cstddef>

#include "course/path.h"

namespace tp100::control {

/// Never decreases, except by reproject(). Searches the nearest point within a window, so that a
/// path that returns close to itself is not cut short. No allocation; safe in the real-time thread.
class Progress {
 public:
  /// `path` must outlive this.
  explicit Progress(const course::Path& path) : path_(path) {}

  void restart();
  /// Moves to `s_m` along the path. At a turn on the spot `yaw_rad` decides whether it is still to
  /// be made.
  void resume(double s_m, double yaw_rad);
  const course::PathSegment& segment() const { return path_.segments()[index_]; }
  /// Moves to the next segment; false at the last one.
  bool next();
  /// Moves to the nearest point ahead, across joints between segments but not across a turn on the
  /// spot.
  void advance(double x_m, double y_m);
  /// Moves to the nearest point at most `window_m` before or after; not across a turn on the spot.
  void reproject(double x_m, double y_m, double window_m);

  /// Where the robot is, on a line or arc.
  course::PathPoint here() const { return path_.at(index_, offset_m_); }
  /// The point `distance_m` further on. Beyond the next stop the path is extended straight.
  course::PathPoint ahead(double distance_m) const;
  /// Index of the turn on the spot that is next or under way; the number of segments if there is
  /// none.
  std::size_t next_turn() const;
  /// Distance to the next turn on the spot or to the end.
  double left_m() const;

 private:
  bool joined(std::size_t index) const;

  const course::Path& path_;
  std::size_t index_ = 0;
  double offset_m_ = 0.0;
};

}  // namespace tp100::control
