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
  RobotRequest request = RobotRequest::kNone;    ///< to be passed to the link once
  StartRefusal refused = StartRefusal::kNone;    ///< a start was refused in this step
  StartRefusal waits_for = StartRefusal::kNone;  ///< what a start that is about to begin waits for
  bool disarming = false;  ///< the end of a run is unconfirmed, or motors are on without a request
  Snapshot snapshot{};
};

class Step {
 public:
  /// `course` may be null: then there are no runs, but poses, and the robot can be driven by hand.
  /// Throws UserError if parameters and course do not fit together.
  Step(const Parameters& parameters, std::shared_ptr<const course::Course> course);
  ~Step();
  Step(Step&&) noexcept;
  Step& operator=(Step&&) noexcept;

  /// Duration of the course at the intended speeds; 0 without a course. [s]
  double nominal_duration_s() const;

  /// Whether a restart now (StepInputs::restart) would not change later results: no run, level
  /// ground, the robot at standstill or without a session, no external world.
  bool at_rest() const;
  /// The state that a restart would carry over.
  CarriedState carried() const;

  /// Whether an operator may place the robot or change the course: no run, the robot at standstill
  /// or without a session, no external world.
  bool changeable() const;
  /// The state with which a step, this or another one, restarts after an operator's change: no
  /// progress on the course, and the robot on level ground at `at`, or at its estimated pose.
  /// Faults stay latched until the next start.
  CarriedState restart_state(const std::optional<Pose>& at, HostNs now) const;

  /// One step at host time `now`. The reference stays valid until the next call.
  const Outputs& operator()(const StepInputs& inputs, HostNs now);

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace tp100::bridge
