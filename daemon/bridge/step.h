#pragma once
// The step: samples in, pose and command out. The same object runs live, in lockstep and in replay.
// Pure: no clock, no port, no file; no allocation after construction; safe in the real-time thread.

#include <memory>
#include <optional>

#include "bridge/parameters.h"
#include "core/step_record.h"
#include "course/course.h"

namespace tp100::bridge {

/// Results of the step.
struct Outputs {
  bool command_valid = false;  ///< false: send nothing (no session, no sample yet)
  Command command{};
  RobotRequest request = RobotRequest::kNone;  ///< hand to the link once
  StartRefusal refused = StartRefusal::kNone;  ///< a start was refused in this step
  bool disarming = false;  ///< the end of a run is not confirmed yet, or motors are on unasked
  Snapshot snapshot{};
};

class Step {
 public:
  /// `course` may be null: poses only, the robot stands still. Throws SetupError if parameters and
  /// course do not fit together.
  Step(const Parameters& parameters, std::shared_ptr<const course::Course> course);
  ~Step();
  Step(Step&&) noexcept;
  Step& operator=(Step&&) noexcept;

  /// Duration of the course at the intended speeds; 0 without a course. [s]
  double nominal_duration_s() const;

  /// The step may begin anew (StepInputs::restart) and goes on all the same: no run, the robot at
  /// standstill on level ground or not there, no external world.
  bool at_rest() const;
  /// What it would have to begin anew with.
  CarriedState carried() const;

  /// An operator may place the robot, or change the course: no run, the robot at standstill or not
  /// there, no external world.
  bool changeable() const;
  /// What a step begins anew with, possibly another one, after the operator has changed something:
  /// nothing of the course is driven, and the robot is on level ground at `at`, or where it is
  /// believed to be. Faults stay latched until the next start.
  CarriedState carried_anew(const std::optional<Pose>& at, HostNs now) const;

  /// One step at host time `now`. The reference stays valid until the next call.
  const Outputs& operator()(const StepInputs& inputs, HostNs now);

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace tp100::bridge
