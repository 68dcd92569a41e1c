#pragma once
// The manoeuvres from which an identification that drives itself chooses, and how they are driven.

#include <vector>

#include "course/course.h"
#include "course/goal.h"

namespace tp100::identify {

/// Turns on the spot, straight runs at two speeds, out and back, arcs of several radii and bends
/// both ways, each also after a turn on the spot to where there is room. Without starts. Always in
/// the same order. Pure.
std::vector<course::OtherPath> candidate_manoeuvres(double wheelbase_m);

/// Motion during ManoeuvreMotion::kStepS.
struct MotionStep {
  double mps, radps;
};

/// Speed ahead and turn rate over time, about as the tracking controller drives a path, with
/// standstill before and after.
class ManoeuvreMotion {
 public:
  static constexpr double kStepS = 0.04;

  ManoeuvreMotion(double speed_mps, const std::vector<course::Segment>& path);

  const std::vector<MotionStep>& steps() const { return steps_; }
  /// From the first motion to the last one.
  double moving_s() const { return moving_s_; }

 private:
  void still(double duration_s);
  void along(const course::Segment& segment, bool from_rest, bool to_rest);

  double speed_mps_;
  std::vector<MotionStep> steps_;
  double moving_s_ = 0.0;
};

}  // namespace tp100::identify
