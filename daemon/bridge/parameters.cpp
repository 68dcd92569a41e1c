#include "bridge/parameters.h"

#include <cmath>
#include <limits>
#include <string>

#include "core/error.h"
#include "core/sample.h"

namespace tp100::bridge {
bool apply(const ParameterChange& change, bool under_way, Parameters& parameters) {
  if (!std::isfinite(change.value) || change.value < 0.0) return false;
  if (change.parameter == LiveParameter::kSteering) {
    for (const PoseSource steering : kPoseSources) {
      if (under_way || change.value != static_cast<double>(steering)) continue;
      parameters.steering = steering;
      return true;
    }
    return false;
  }
  const auto number = static_cast<std::size_t>(change.parameter);
  if (number >= kLiveKeys.size()) return false;
  parameters.control.*kLiveKeys[number].field = change.value;
  return true;
}

StepInputs::Changes live_values(const Parameters& parameters) {
  StepInputs::Changes values;
  for (std::size_t i = 0; i < kLiveKeys.size(); ++i) {
    const auto field = kLiveKeys[i].field;
    values.push({static_cast<LiveParameter>(i), field == nullptr
                                                    ? static_cast<double>(parameters.steering)
                                                    : parameters.control.*field});
  }
  return values;
}

void require_consistent(const Parameters& parameters, const course::Course* course) {
  if (course != nullptr && course->speed_mps > parameters.drive.max_track_mps) {
    throw UserError("course " + course->name + ": speed_mps " + std::to_string(course->speed_mps) +
                    " is above this robot's drive.max_track_mps " +
                    std::to_string(parameters.drive.max_track_mps) +
                    "; lower the course's speed or use another robot");
  }
  if (parameters.world.owns_pose && parameters.world.kind != WorldKind::kInternal &&
      parameters.setup == Setup::kTerrain) {
    throw UserError(
        "world.authority = \"world\": on set-up terrain the real floor determines the pose; use "
        "flat or stand, or authority = \"bridge\"");
  }
}

control::DriveModel drive_of(const Parameters& parameters, double speed_mps) {
  // If the steering pose is computed without a turning centre, none is used for steering either.
  const bool by_paper = parameters.paper_model && parameters.steering == PoseSource::kModel;
  return {.speed_mps = speed_mps,
          .slip_angle_rad = parameters.model.slip_angle_straight_rad,
          .tracks = by_paper ? paper_parameters(parameters.model) : parameters.model,
          .limits = {.wheelbase_m = parameters.model.wheelbase_m,
                     .slip_left = parameters.model.slip_left,
                     .slip_right = parameters.model.slip_right,
                     .max_track_mps = parameters.drive.max_track_mps,
                     .yaw_kp = parameters.drive.yaw_kp,
                     .max_yaw_radps = parameters.drive.max_yaw_radps}};
}

course::Fence fence_of(const course::Course* course) {
  constexpr double kFar = std::numeric_limits<double>::infinity();
  return course == nullptr ? course::Fence{-kFar, kFar, -kFar, kFar} : course->fence;
}

control::MonitoredRobot monitored_robot(const Parameters& parameters,
                                        const course::Course* course) {
  return {.motor = {.dead_band = parameters.drive.dead_band,
                    .feed_forward = parameters.drive.feed_forward,
                    .stall_s = parameters.drive.stall_s},
          .wheelbase_m = parameters.model.wheelbase_m,
          .identified = course == nullptr || !course->identifies,
          .max_counts_per_s =
              max_counts_per_s(parameters.drive.max_track_mps, parameters.drive.counts_per_metre)};
}

}  // namespace tp100::bridge
